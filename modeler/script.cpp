#include "modeler/script.h"

#include <utility>

#include "modeler/command_error.h"
#include "tracer/error.h"

namespace sir::modeler {

Script::Script(Interpreter& interpreter, std::string name,
               std::function<void(const Reply& reply)> hear)
    : interpreter_(interpreter), name_(std::move(name)), hear_(std::move(hear)) {}

bool Script::line(std::string_view text, std::size_t number) {
  Reply reply;
  try {
    reply = interpreter_.execute(text);
  } catch (const CommandError& error) {
    throw FileError(name_, number, error.what());
  } catch (const FileError& error) {
    throw FileError(name_, number, error.what());
  }
  hear_(reply);
  return !reply.quit;
}

void run_script(TextFile& file, Interpreter& interpreter,
                const std::function<void(const Reply& reply)>& hear) {
  Script script(interpreter, file.name(), hear);
  while (file.next())
    if (!script.line(file.line(), file.line_number())) return;
}

}  // namespace sir::modeler
