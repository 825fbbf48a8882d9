// The program: runs a command and turns what went wrong into an exit code.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/session.h"
#include "tracer/memory_hints.h"

namespace {

// One line, whatever a file's name holds.
void report(std::string_view reason) {
  std::string line = "sir: ";
  for (const char letter : reason)
    line += static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F ? '?' : letter;
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace sir::cli;
  reserve_standard_streams();
  sir::keep_freed_memory();
  install_signal_handlers();
  int code = kFailed;
  try {
    code = run(argc, argv);
    flush_output();
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "sir: out of memory\n");
    code = kFailed;
  } catch (const std::exception& error) {
    report(error.what());
    code = kFailed;
  }
  return interrupted() ? kInterrupted : code;
}
