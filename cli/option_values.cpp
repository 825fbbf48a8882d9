#include "cli/option_values.h"

#include <array>
#include <charconv>
#include <limits>
#include <vector>

#include "tracer/limits.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

// Whole non-negative numbers with one separator between them.
template <std::size_t N>
bool parse_integers(std::string_view text, char separator, std::array<int, N>& values) {
  for (std::size_t i = 0; i < N; ++i) {
    const auto end = i + 1 < N ? text.find(separator) : text.size();
    if (end == std::string_view::npos) return false;
    std::int64_t value = 0;
    if (!parse_count(text.substr(0, end), value) || value > std::numeric_limits<int>::max())
      return false;
    values[i] = static_cast<int>(value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

}  // namespace

bool parse_size(std::string_view text, ImageSize& size) {
  std::array<int, 2> v{};
  if (!parse_integers(text, 'x', v) || v[0] < 1 || v[1] < 1) return false;
  const ImageSize parsed{v[0], v[1]};
  if (parsed.pixels() > kMostPixels) return false;
  size = parsed;
  return true;
}

bool parse_region(std::string_view text, Region& region) {
  std::array<int, 4> v{};
  if (!parse_integers(text, ',', v) || v[2] < 1 || v[3] < 1) return false;
  region = {v[0], v[1], v[2], v[3]};
  return true;
}

bool parse_rate(std::string_view text, double& rate) {
  constexpr double kMost = 1e15;
  double unit = 1;
  if (text.ends_with('k') || text.ends_with('K')) unit = 1e3;
  if (text.ends_with('M')) unit = 1e6;
  if (unit > 1) text.remove_suffix(1);
  double value = 0;
  if (!parse_number(text, value) || value <= 0 || value * unit > kMost) return false;
  rate = value * unit;
  return true;
}

bool parse_antialias(std::string_view text, AntialiasOptions& options) {
  AntialiasOptions parsed;
  std::vector<std::int64_t> numbers;
  const std::string_view mode = text.substr(0, text.find(':'));
  for (text.remove_prefix(mode.size()); !text.empty();) {
    text.remove_prefix(1);  // the colon
    const std::string_view part = text.substr(0, text.find(':'));
    if (!parse_count(part, numbers.emplace_back())) return false;
    text.remove_prefix(part.size());
  }
  const auto given = [&](std::size_t which, std::int64_t usual, std::int64_t most) {
    return which < numbers.size() ? std::min(numbers[which], most + 1) : usual;
  };
  constexpr int kMost = std::numeric_limits<int>::max() - 1;
  if (mode == "none" && numbers.empty()) {
    parsed.mode = Antialias::none;
  } else if (mode == "adaptive" && numbers.size() <= 2) {
    parsed.mode = Antialias::adaptive;
    parsed.threshold = static_cast<int>(given(0, parsed.threshold, kMost));
    parsed.levels = static_cast<int>(given(1, parsed.levels, kMost));
  } else if (mode == "random" && numbers.size() <= 2) {
    parsed.mode = Antialias::random;
    parsed.samples = static_cast<int>(given(0, parsed.samples, kMost));
    if (numbers.size() == 2) parsed.seed = static_cast<std::uint64_t>(numbers[1]);
  } else {
    return false;
  }
  if (!parsed.valid()) return false;
  options = parsed;
  return true;
}

bool parse_effects(std::string_view text, EffectSet& effects) {
  EffectSet parsed;
  if (text == "auto" || text == "all") {
    parsed.exhaustive = text == "all";
    effects = parsed;
    return true;
  }
  for (const std::string& name : EffectSet::names()) *parsed.find(name) = false;
  while (true) {
    const auto end = std::min(text.find(','), text.size());
    bool* member = parsed.find(text.substr(0, end));
    if (!member) return false;
    *member = true;
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  effects = parsed;
  return true;
}

std::string known_effects() {
  std::string list;
  for (const std::string& name : EffectSet::names()) list += (list.empty() ? "" : " ") + name;
  return list;
}

const char* name_of(Precision precision) {
  switch (precision) {
    case Precision::float_: return "float";
    case Precision::double_: return "double";
    case Precision::long_double: return "long-double";
  }
  return "";
}

}  // namespace sir::cli
