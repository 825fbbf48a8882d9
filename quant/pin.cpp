#include "quant/pin.h"

#include <charconv>

#include "quant/lut.h"

namespace sir::quant {

bool parse_pin(std::string_view text, Pin& pin) {
  Pin read;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto read_number = [&](std::size_t& number) {
    const auto [stop, failure] = std::from_chars(at, end, number);
    at = stop;
    return failure == std::errc{} && number < kLutEntries;
  };
  std::size_t number = 0;
  if (!read_number(number)) return false;
  if (at != end && *at == '=') {
    read.index = number;
    ++at;
    if (!read_number(number)) return false;
  }
  for (std::uint8_t& code : read.code) {
    if (&code != read.code.data() && (at == end || *at++ != ',' || !read_number(number)))
      return false;
    code = static_cast<std::uint8_t>(number);
  }
  if (at != end) return false;
  pin = read;
  return true;
}

std::string pin_text(const Pin& pin) {
  return (pin.index ? std::to_string(*pin.index) + "=" : "") + std::to_string(pin.code[0]) + "," +
         std::to_string(pin.code[1]) + "," + std::to_string(pin.code[2]);
}

}  // namespace sir::quant
