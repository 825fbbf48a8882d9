#include "quant/lut.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "tracer/atomic_file.h"
#include "tracer/text_file.h"

namespace sir::quant {
namespace {

DacCode read_entry(const TextFile& file, const std::string& what) {
  const auto words = split_tokens(file.line());
  if (words.size() != 3)
    file.fail(what + ": three integers expected, " + std::to_string(words.size()) +
              (words.size() == 1 ? " word found" : " words found"));
  DacCode entry{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t level = 0;
    if (!parse_count(words[i], level) || level > kMaxCode)
      file.fail(what + ": " + in_quotes(words[i]) + " is not an integer from 0 to 63");
    entry[i] = static_cast<std::uint8_t>(level);
  }
  return entry;
}

}  // namespace

Lut make_lut(std::span<const DacCode> colours, const DacBits& dac) {
  if (colours.empty() || colours.size() > kLutEntries)
    throw std::invalid_argument("a LUT of " + std::to_string(colours.size()) + " colours");
  Lut lut;
  lut.chosen = colours.size();
  lut.dac = dac;
  lut.entry.fill(colours.back());
  std::copy(colours.begin(), colours.end(), lut.entry.begin());
  return lut;
}

std::string lut_text(const Lut& lut) {
  std::string text;
  for (const DacCode& entry : lut.entry)
    text += std::to_string(entry[0]) + " " + std::to_string(entry[1]) + " " +
            std::to_string(entry[2]) + "\n";
  return text;
}

void write_lut(const std::filesystem::path& path, const Lut& lut) {
  write_file_atomically(path, lut_text(lut));
}

Lut read_lut(const std::filesystem::path& path) {
  TextFile file(path);
  Lut lut;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    const std::string what = "entry " + std::to_string(i) + " of 0 to 255";
    file.expect(what);
    lut.entry[i] = read_entry(file, what);
  }
  if (file.next()) file.fail("more than 256 entries");
  lut.chosen = kLutEntries;
  while (lut.chosen > 1 && lut.entry[lut.chosen - 2] == lut.entry.back()) --lut.chosen;
  return lut;
}

}  // namespace sir::quant
