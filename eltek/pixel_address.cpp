#include "eltek/pixel_address.h"

namespace sir::eltek {
namespace {

constexpr std::size_t kColumns = FrameBuffer::kColumns;
constexpr std::size_t kScreen = kColumns * FrameBuffer::kRows;
constexpr std::size_t kReach = kColumns << PixelAddress::kBits;

}  // namespace

std::size_t PixelAddress::before_wrap() const {
  const std::size_t here =
      static_cast<std::size_t>(row_) * kColumns + static_cast<std::size_t>(column_);
  return (on_screen() ? kScreen : kReach) - here;
}

void PixelAddress::advance(std::size_t pixels) {
  const std::size_t left = before_wrap();
  const std::size_t here = (on_screen() ? kScreen : kReach) - left;
  const std::size_t next = pixels < left ? here + pixels : (pixels - left) % kScreen;
  column_ = static_cast<int>(next % kColumns);
  row_ = static_cast<int>(next / kColumns);
}

}  // namespace sir::eltek
