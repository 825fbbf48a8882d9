// The lookup table: 256 colours for the monitor, and its file (thesis 3.6.5).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "quant/dac_code.h"
#include "tracer/text_file.h"

namespace sir::quant {

/// Number of entries of the monitor's LUT.
inline constexpr std::size_t kLutEntries = 256;

/// Artifact of the choice: 256 entries. Where fewer colours were chosen the
/// last one is repeated to the end, so that a search over all 256 never gains
/// by the rest.
struct Lut {
  std::array<DacCode, kLutEntries> entry{};
  std::size_t chosen = 1;  ///< 1 to 256
  DacBits dac;             ///< the DAC that the entries are codes of

  /// The colour as which an entry is seen.
  Rgb8 seen(std::size_t index) const { return quant::seen(entry[index], dac); }
  friend bool operator==(const Lut&, const Lut&) = default;
};

/// The LUT of 1 to 256 chosen colours in their order; std::invalid_argument
/// for another number of them, for a DAC that is not valid and for codes that
/// it does not have.
Lut make_lut(std::span<const DacCode> colours, const DacBits& dac = {});

/// The file's text: 256 lines `r g b`, 0 to 63 (3.6.5). Only a LUT for another
/// DAC than the MA120's says so, in a line before those: `DAC 5 6 5`, the bits
/// of r, g and b, with codes in that DAC's ranges. A program that knows the 256
/// lines alone refuses that line, which is better than showing all colours
/// too dark or too bright.
std::string lut_text(const Lut& lut);

/// Writes lut_text(). Throws FileError.
void write_lut(const std::filesystem::path& path, const Lut& lut);

/// Reads what write_lut writes, the keyword in upper or lower case; `DAC 6 6 6`
/// may stand or not. `chosen` ends where the last entry's repetition begins.
/// Throws FileError, with the line, for other than 1 to 8 bits, fewer or more
/// than 256 entries, other than three words in a line, and for anything but
/// integers from 0 to the largest code of the primary, 63 on the MA120.
Lut read_lut(const std::filesystem::path& path);

/// The same of a text that is read, to its end.
Lut read_lut(TextFile& file);

}  // namespace sir::quant
