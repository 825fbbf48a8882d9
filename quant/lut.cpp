#include "quant/lut.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tracer/atomic_file.h"
#include "tracer/text_file.h"

namespace sir::quant {
namespace {

constexpr std::string_view kDacKeyword = "DAC";

std::string words_found(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " word found" : " words found");
}

/// The DAC of a file that names one in its first line, else the MA120's.
DacBits read_dac(TextFile& file) {
  if (file.at_end()) return {};
  file.next();
  const auto words = split_tokens(file.line());
  if (fold_keyword(words[0]) != fold_keyword(kDacKeyword)) {
    file.put_back();
    return {};
  }
  if (words.size() != 4)
    file.fail("DAC: the bits of three primaries expected, " + words_found(words.size() - 1));
  DacBits dac;
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t bits = 0;
    if (!parse_count(words[i + 1], bits) || bits < 1 || bits > 8)
      file.fail("DAC: " + in_quotes(words[i + 1]) + " is not a number of bits from 1 to 8");
    dac.bits[i] = static_cast<int>(bits);
  }
  return dac;
}

DacCode read_entry(const TextFile& file, const DacBits& dac, const std::string& what) {
  const auto words = split_tokens(file.line());
  if (words.size() != 3)
    file.fail(what + ": three integers expected, " + words_found(words.size()));
  DacCode entry{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t level = 0;
    if (!parse_count(words[i], level) || level > dac.max_code(i))
      file.fail(what + ": " + in_quotes(words[i]) + " is not an integer from 0 to " +
                std::to_string(dac.max_code(i)));
    entry[i] = static_cast<std::uint8_t>(level);
  }
  return entry;
}

}  // namespace

Lut make_lut(std::span<const DacCode> colours, const DacBits& dac) {
  if (colours.empty() || colours.size() > kLutEntries)
    throw std::invalid_argument("a LUT of " + std::to_string(colours.size()) + " colours");
  if (!dac.valid()) throw std::invalid_argument("a LUT for a DAC of impossible bits");
  for (const DacCode& code : colours)
    for (std::size_t c = 0; c < 3; ++c)
      if (code[c] > dac.max_code(c)) throw std::invalid_argument("a code that the DAC has not");
  Lut lut;
  lut.chosen = colours.size();
  lut.dac = dac;
  lut.entry.fill(colours.back());
  std::copy(colours.begin(), colours.end(), lut.entry.begin());
  return lut;
}

std::string lut_text(const Lut& lut) {
  std::string text;
  if (const auto& bits = lut.dac.bits; lut.dac != DacBits{})
    text = std::string(kDacKeyword) + " " + std::to_string(bits[0]) + " " +
           std::to_string(bits[1]) + " " + std::to_string(bits[2]) + "\n";
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
  return read_lut(file);
}

Lut read_lut(TextFile& file) {
  Lut lut;
  lut.dac = read_dac(file);
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    const std::string what = "entry " + std::to_string(i) + " of 0 to 255";
    file.expect(what);
    lut.entry[i] = read_entry(file, lut.dac, what);
  }
  if (file.next()) file.fail("more than 256 entries");
  lut.chosen = kLutEntries;
  while (lut.chosen > 1 && lut.entry[lut.chosen - 2] == lut.entry.back()) --lut.chosen;
  return lut;
}

}  // namespace sir::quant
