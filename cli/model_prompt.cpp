#include "cli/model_prompt.h"

#include <cstdio>
#include <string>
#include <vector>

#include "cli/interrupt.h"
#include "cli/line_reader.h"
#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/completion.h"
#include "modeler/keeper.h"
#include "modeler/state_folder.h"
#include "tracer/error.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

constexpr std::size_t kNamed = 5;  // solids that a warning names

void complain(const std::string& reason) {
  flush_output();  // or the two would come in the wrong order
  std::fprintf(stderr, "%s\n", reason.c_str());
}

// Whether the person may go: none is unsaved, or it has been said already.
bool may_leave(const modeler::Interpreter& interpreter, bool warned) {
  const std::vector<std::string> unsaved = interpreter.unsaved();
  if (unsaved.empty() || warned) return true;
  std::string names;
  for (std::size_t i = 0; i < unsaved.size() && i < kNamed; ++i)
    names += (i > 0 ? ", " : "") + in_quotes(unsaved[i]);
  if (unsaved.size() > kNamed) names += " and " + std::to_string(unsaved.size() - kNamed) + " more";
  complain("not saved: " + names + "; quit again to leave");
  return false;
}

void tell(const modeler::Reply& reply, const Session& session) {
  print(reply.text);
  if (!reply.done.empty() && !session.quiet) print(reply.done + "\n");
  for (const std::string& warning : reply.warnings) complain("warning: " + warning);
}

// Does one line; false where it is to be the last.
bool obey(modeler::Interpreter& interpreter, const Session& session, const std::string& line) {
  TextFile text("-", line);  // in UTF-8, whatever the terminal sends
  const std::string command(text.next() ? text.line() : "");
  try {
    const modeler::Reply reply = interpreter.execute(command);
    tell(reply, session);
    return !reply.quit;
  } catch (const modeler::CommandError& error) {
    complain(error.what());
  } catch (const FileError& error) {
    complain(error.what());
  }
  return true;
}

// Before a person does anything.
modeler::Reply recovered(modeler::Interpreter& interpreter, const std::string& which) {
  try {
    return interpreter.execute(recover_line(which));
  } catch (const modeler::CommandError& error) {
    throw FileError("--recover", 0, error.what());
  }
}

}  // namespace

std::string recover_line(const std::string& which) {
  return "recover" + (which.empty() ? "" : " " + modeler::as_word(which));
}

int run_prompt(modeler::Interpreter& interpreter, const Session& session,
               const std::optional<std::string>& recover) {
  LineOptions options;
  interpreter.watch(true);
  options.prompt = "sir> ";
  options.complete = [&](std::string_view line) { return complete(interpreter, line); };
  options.history = history_file();
  auto reader = make_editing_reader(options);
  if (!reader) reader = make_plain_reader(options);
  if (!session.quiet) print("Type help for the commands, quit to leave.\n");
  modeler::Keeper keeper(interpreter, modeler::state_folder());
  if (recover) {
    tell(recovered(interpreter, *recover), session);
  } else if (const std::string offer = keeper.offer(); !offer.empty() && !session.quiet) {
    print(offer + "\n");
  }
  for (bool warned = false;;) {
    flush_output();
    const auto line = reader->read();
    if (interrupted()) return kInterrupted;
    const bool leaving = !line || !obey(interpreter, session, *line);
    if (!line) print("\n");
    if (leaving && may_leave(interpreter, warned)) {
      if (const std::string kept = keeper.end(); !kept.empty()) complain(kept);
      return kDone;
    }
    if (interrupted()) return kInterrupted;
    warned = leaving;
  }
}

}  // namespace sir::cli
