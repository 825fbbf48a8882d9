// make_pages PROSE DIR DATE: writes the manual pages of `sir` and of its subcommands, sir.1 and
// sir-COMMAND.1, and the completion for bash, `sir.bash`, into the folder DIR. The prose of each
// page is PROSE/sir.roff or PROSE/COMMAND.roff; one that is missing is an error. Runs when the
// program is built.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "cli/command_line.h"
#include "cli/completion_script.h"
#include "cli/man_page.h"
#include "cli/version_text.h"

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text << std::flush;
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

void make(const fs::path& prose, const fs::path& folder, const sir::cli::Edition& edition) {
  CLI::App app("", "sir");
  sir::cli::Session session;
  sir::cli::Action action;
  add_all(app, session, action);
  const auto page = [&](const CLI::App& command, const std::string& name) {
    const fs::path source = prose / (command.get_name() + ".roff");
    try {
      write(folder / name, sir::cli::man_page(command, read(source), edition));
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(source.string() + ": " + error.what());
    }
  };
  fs::create_directories(folder);
  page(app, "sir.1");
  for (const CLI::App* sub : sir::cli::subcommands(app))
    page(*sub, "sir-" + sub->get_name() + ".1");
  write(folder / "sir.bash", sir::cli::completion_script(app));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: make_pages PROSE DIR DATE\n", stderr);
    return 2;
  }
  try {
    make(argv[1], argv[2], {argv[3], sir::cli::version()});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_pages: %s\n", error.what());
    return 1;
  }
}
