#include "viewer/sixel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace sir::viewer {
namespace {

constexpr int kBandRows = 6;
constexpr char kEmpty = '?';  // a sixel with none of its six pixels

// The bytes that terminals make of percents are rounded or cut off: how far the farther is away.
int miss(int percent, int byte) {
  const int rounded = (255 * percent + 50) / 100, cut_off = 255 * percent / 100;
  return std::max(std::abs(rounded - byte), std::abs(cut_off - byte));
}

// The better of the percents on both sides of a byte; the higher one where they are equal, for half
// way between two codes a byte counts as the lower code.
int percent(std::uint8_t byte) {
  const int below = 100 * byte / 255;
  return below < 100 && miss(below + 1, byte) <= miss(below, byte) ? below + 1 : below;
}

// A run counts where "!", a number and the sixel are shorter than the sixels themselves.
void append_run(std::string& text, std::size_t count, char sixel) {
  if (count > 3) text.append("!").append(std::to_string(count)).append(1, sixel);
  else text.append(count, sixel);
}

void append_runs(std::string& text, std::string_view sixels) {
  for (std::size_t first = 0; first < sixels.size();) {
    const std::size_t end = std::min(sixels.find_first_not_of(sixels[first], first), sixels.size());
    append_run(text, end - first, sixels[first]);
    first = end;
  }
}

// Neighbouring sixels of one register.
struct Piece {
  std::uint8_t index;
  std::string_view sixels;
};

// A band: the sixels of each register that it has.
class Band {
 public:
  void set(std::uint8_t index, std::size_t column, int row) {
    std::string& own = sixels_[index];
    if (own.empty()) used_.push_back(index);
    if (own.size() <= column) own.resize(column + 1, kEmpty);  // what is empty behind is not sent
    own[column] = static_cast<char>(own[column] + (1 << row));
  }

  // Passes from the left edge to the right, each of pieces that follow one another.
  void append_to(std::string& text) const {
    auto pieces = cut();
    while (!pieces.empty()) {
      std::size_t column = 0;
      int index = -1;
      for (auto next = pieces.begin(); next != pieces.end(); next = pieces.lower_bound(column)) {
        const auto& [left, piece] = *next;
        if (index != piece.index) text.append("#").append(std::to_string(piece.index));
        index = piece.index;
        append_run(text, left - column, kEmpty);
        append_runs(text, piece.sixels);
        column = left + piece.sixels.size();
        pieces.erase(next);
      }
      if (!pieces.empty()) text += '$';  // back to the left edge
    }
  }

 private:
  // By the columns where they begin; cut at gaps that take more bytes than a register's name.
  std::multimap<std::size_t, Piece> cut() const {
    static const std::string kGap(6, kEmpty);
    std::multimap<std::size_t, Piece> pieces;
    for (const std::uint8_t index : used_) {
      const std::string_view own = sixels_[index];
      for (auto left = own.find_first_not_of(kEmpty); left != own.npos;) {
        const auto right = std::min(own.find(kGap, left), own.size());
        pieces.emplace(left, Piece{index, own.substr(left, right - left)});
        left = own.find_first_not_of(kEmpty, right);
      }
    }
    return pieces;
  }

  std::array<std::string, 256> sixels_;
  std::vector<std::uint8_t> used_;  // in the order in which they come
};

void append_registers(std::string& text, const eltek::IndexedScreen& screen) {
  std::array<bool, 256> used{};
  for (const std::uint8_t index : screen.indices) used[index] = true;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const Rgb8 seen = screen.palette[i];
    text.append("#").append(std::to_string(i)).append(";2");  // 2: red, green, blue
    for (const std::uint8_t byte : {seen.r, seen.g, seen.b})
      text.append(";").append(std::to_string(percent(byte)));
  }
}

}  // namespace

std::string sixel(const eltek::IndexedScreen& screen) {
  const ImageSize size = screen.size;
  if (size.width < 1 || size.height < 1 || screen.indices.size() != size.pixels())
    throw std::invalid_argument("a screen without pixels");
  // Raster attributes: square pixels, the size.
  std::string text =
      "\x1bPq\"1;1;" + std::to_string(size.width) + ";" + std::to_string(size.height);
  append_registers(text, screen);
  for (int top = 0; top < size.height; top += kBandRows) {
    if (top > 0) text += '-';  // the next band
    Band band;
    const int rows = std::min(kBandRows, size.height - top);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < size.width; ++column) {
        const auto at = static_cast<std::size_t>(top + row) * static_cast<std::size_t>(size.width) +
                        static_cast<std::size_t>(column);
        band.set(screen.indices[at], static_cast<std::size_t>(column), row);
      }
    band.append_to(text);
  }
  return text + "\x1b\\";
}

}  // namespace sir::viewer
