// sir show --terminal: the screen on standard output (the thesis has no terminals).
#pragma once

#include <optional>

#include "eltek/crt.h"
#include "eltek/screen.h"

namespace sir::cli {

enum class TerminalForm {
  automatic,  ///< sixel where the terminal says that it has it, or where there is no terminal
  sixel,
  blocks  ///< half blocks in 24-bit colours
};

/// What `automatic` comes to here; it may ask the terminal (viewer/terminal.h). Others stay.
TerminalForm settle(TerminalForm form);

/// Prints the screen, through the tube where there is one, and ends the line. `form` is not
/// automatic. Half blocks fit the terminal's width, or 80 characters where there is none; sixels
/// are one to one. Where a tube's effects make more than 256 colours, sixels show the 256 of the
/// method best. Throws FileError where standard output cannot be written.
void print_screen(const eltek::IndexedScreen& screen, const std::optional<eltek::Crt>& crt,
                  TerminalForm form);

}  // namespace sir::cli
