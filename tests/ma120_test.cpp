#include "eltek/ma120.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "eltek/dac.h"

namespace sir::eltek {
namespace {

constexpr int kWidth = 1024, kHeight = 780;

std::uint8_t pattern(int column, int row) {
  return static_cast<std::uint8_t>(column * 7 + row * 13 + column * row / 50);
}

quant::DacCode entry(int index) {
  const auto code = [](int value) { return static_cast<std::uint8_t>(value % 64); };
  return {code(index), code(index * 5 + 1), code(63 * 256 - index * 3)};
}

Ma120 with_pattern() {
  Ma120 monitor;
  monitor.lut_ports.write_address(0);
  for (int i = 0; i < 256; ++i)
    for (const std::uint8_t code : entry(i)) monitor.lut_ports.write_data(code);
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column)
      monitor.frame_buffer.write(column, row, pattern(column, row));
  return monitor;
}

TEST(Ma120, HasTheThesisNumbers) {
  EXPECT_EQ(Ma120::kSize, (ImageSize{1024, 780}));
  EXPECT_EQ(FrameBuffer::kPlanes, 8);
  EXPECT_EQ(Ma120().palette().size(), 256u);
}

TEST(Ma120, IsBlackAfterPowerOn) {
  const Screen screen = Ma120().scan_out();
  EXPECT_EQ(screen.size, Ma120::kSize);
  ASSERT_EQ(screen.pixels.size(), Ma120::kSize.pixels());
  for (const Rgb8 pixel : screen.pixels) ASSERT_EQ(pixel, Rgb8{});
}

TEST(Ma120, ScansOutEveryPixelThroughLutAndDac) {
  const Screen screen = with_pattern().scan_out();
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column)
      ASSERT_EQ(screen.at(column, row), dac_colour(entry(pattern(column, row))))
          << column << "," << row;
}

// A golden value of the whole path: FNV-1a over the bytes of the screen.
TEST(Ma120, ScanoutOfTheKnownPatternKeepsItsHash) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const Rgb8 pixel : with_pattern().scan_out().pixels)
    for (const std::uint8_t byte : {pixel.r, pixel.g, pixel.b})
      hash = (hash ^ byte) * 0x100000001B3u;
  EXPECT_EQ(hash, 0x20C21E1AD2563DBDu);
}

TEST(Ma120, ALineIsARowOfTheScreen) {
  const Ma120 monitor = with_pattern();
  const Screen screen = monitor.scan_out();
  std::array<Rgb8, kWidth> line;
  for (const int row : {0, 1, 400, 779}) {
    monitor.scan_line(row, line);
    for (int column = 0; column < kWidth; ++column)
      ASSERT_EQ(line[static_cast<std::size_t>(column)], screen.at(column, row));
  }
  EXPECT_THROW(monitor.scan_line(780, line), std::out_of_range);
}

TEST(Ma120, SeenIsEachIndexPastMaskLutDacAndBlanking) {
  Ma120 monitor = with_pattern();
  for (const std::uint8_t mask : {std::uint8_t{0xFF}, std::uint8_t{0x3C}}) {
    monitor.lut_ports.write_pixel_mask(mask);
    for (int i = 0; i < 256; ++i)
      EXPECT_EQ(monitor.seen()[static_cast<std::size_t>(i)], dac_colour(entry(i & mask))) << i;
  }
  monitor.blanked = true;
  for (const Rgb8 colour : monitor.seen()) EXPECT_EQ(colour, Rgb8{});
}

TEST(Ma120, WordsAreTheSamePixels) {
  const auto word = [](Rgb8 c) { return 0xFF000000u + c.r * 65536u + c.g * 256u + c.b; };
  Ma120 monitor = with_pattern();
  constexpr std::size_t kStride = 1030;
  constexpr std::uint32_t kUntouched = 0x12345678;
  for (const bool blanked : {false, true})
    for (const std::uint8_t mask : {std::uint8_t{0xFF}, std::uint8_t{0x3C}}) {
      monitor.blanked = blanked;
      monitor.lut_ports.write_pixel_mask(mask);
      std::array<std::uint32_t, 256> table;
      for (std::size_t i = 0; i < table.size(); ++i) table[i] = word(monitor.seen()[i]);
      std::vector<std::uint32_t> words(kStride * 779 + 1024, kUntouched);
      monitor.scan_out_words({0, 0, Ma120::kSize}, table, words, kStride);
      const Screen screen = monitor.scan_out();
      for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t row = i / kStride, column = i % kStride;
        if (column >= 1024) {
          ASSERT_EQ(words[i], kUntouched);
          continue;
        }
        ASSERT_EQ(words[i], word(screen.pixels[row * 1024 + column])) << i;
      }
    }
}

TEST(Ma120, AnAreaIsScannedOutByAnyTable) {
  const Ma120 monitor = with_pattern();
  std::array<std::uint32_t, 256> table;
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint32_t>(i * 7919);
  const IndexedScreen whole = monitor.capture();
  for (const Area& area : {Area{0, 0, {1024, 780}}, Area{3, 5, {70, 20}}, Area{8, 779, {1016, 1}},
                           Area{1023, 0, {1, 780}}, Area{500, 300, {64, 2}}, Area{7, 7, {3, 0}}}) {
    const std::size_t stride = static_cast<std::size_t>(area.size.width) + 2;
    std::vector<std::uint32_t> words(stride * static_cast<std::size_t>(area.size.height), 1);
    monitor.scan_out_words(area, table, words, stride);
    const IndexedScreen part = crop(whole, area);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::size_t row = i / stride, column = i % stride;
      const auto width = static_cast<std::size_t>(area.size.width);
      ASSERT_EQ(words[i], column < width ? table[part.indices[row * width + column]] : 1u) << i;
    }
  }
  std::vector<std::uint32_t> words(100);
  for (const Area& area : {Area{-1, 0, {5, 5}}, Area{1020, 0, {5, 5}}, Area{0, 776, {5, 5}},
                           Area{0, -1, {5, 5}}, Area{0, 0, {-1, 5}}, Area{0, 0, {1025, 1}}})
    EXPECT_THROW(monitor.scan_out_words(area, table, words, 20), std::out_of_range);
  const Area fits{0, 0, {10, 10}};
  EXPECT_NO_THROW(monitor.scan_out_words(fits, table, words, 10));
  EXPECT_THROW(monitor.scan_out_words(fits, table, words, 11), std::invalid_argument);
  EXPECT_THROW(monitor.scan_out_words(fits, table, std::span(words).first(99), 10),
               std::invalid_argument);
  EXPECT_THROW(monitor.scan_out_words({0, 0, {10, 11}}, table, words, 10), std::invalid_argument);
  EXPECT_THROW(monitor.scan_out_words({0, 0, {10, 2}}, table, words, 9), std::invalid_argument);
}

TEST(Ma120, ALutWriteShowsAtTheNextScan) {
  Ma120 monitor = with_pattern();
  monitor.lut_ports.write_address(pattern(5, 5));
  for (const int code : {63, 0, 63}) monitor.lut_ports.write_data(static_cast<std::uint8_t>(code));
  EXPECT_EQ(monitor.scan_out().at(5, 5), (Rgb8{255, 0, 255}));
}

TEST(Ma120, PixelMaskActsOnTheWayOut) {
  Ma120 monitor = with_pattern();
  const Screen before = monitor.scan_out();
  monitor.lut_ports.write_pixel_mask(0b11110000);
  const Screen masked = monitor.scan_out();
  for (int row = 0; row < kHeight; row += 7)
    for (int column = 0; column < kWidth; ++column)
      ASSERT_EQ(masked.at(column, row), dac_colour(entry(pattern(column, row) & 0xF0)));
  monitor.lut_ports.write_pixel_mask(0xFF);
  EXPECT_EQ(monitor.scan_out(), before);  // the planes kept their bits
}

TEST(Ma120, CaptureIsTheScreenBeforeTheLut) {
  Ma120 monitor = with_pattern();
  monitor.lut_ports.write_pixel_mask(0x7F);
  const IndexedScreen capture = monitor.capture();
  const Screen screen = monitor.scan_out();
  EXPECT_EQ(capture.palette[200], dac_colour(entry(200)));  // whatever the mask
  ASSERT_EQ(capture.indices.size(), screen.pixels.size());
  for (std::size_t i = 0; i < screen.pixels.size(); ++i) {
    ASSERT_LT(capture.indices[i], 0x80);
    ASSERT_EQ(capture.palette[capture.indices[i]], screen.pixels[i]);
  }
}

TEST(Ma120, ShowsThroughTheDacThatIsFitted) {
  const quant::DacBits dac{{5, 6, 5}};
  Ma120 monitor(dac);
  EXPECT_EQ(monitor.dac(), dac);
  EXPECT_EQ(Ma120().dac(), quant::DacBits{});
  monitor.lut_ports.write_address(9);
  for (const int code : {12, 12, 11}) monitor.lut_ports.write_data(static_cast<std::uint8_t>(code));
  monitor.frame_buffer.write(3, 4, 9);
  const Rgb8 seen{99, 49, 90};
  EXPECT_EQ(monitor.scan_out().at(3, 4), seen);
  EXPECT_EQ(monitor.palette()[9], seen);
  EXPECT_EQ(monitor.seen()[9], seen);
  const IndexedScreen capture = monitor.capture();
  EXPECT_EQ(capture.palette[9], seen);
  EXPECT_EQ(capture.dac, dac);
  EXPECT_EQ(crop(capture, {1, 1, {5, 5}}).dac, dac);
  EXPECT_THROW(Ma120(quant::DacBits{{0, 6, 6}}), std::invalid_argument);
}

TEST(Screen, CropTakesTheArea) {
  const Ma120 monitor = with_pattern();
  const Area area{1000, 700, {24, 80}};
  const Screen whole = monitor.scan_out(), part = crop(whole, area);
  const IndexedScreen indexed = crop(monitor.capture(), area);
  EXPECT_EQ(part.size, area.size);
  ASSERT_EQ(part.pixels.size(), 24u * 80u);
  for (int row = 0; row < 80; ++row)
    for (int column = 0; column < 24; ++column) {
      ASSERT_EQ(part.at(column, row), whole.at(1000 + column, 700 + row));
      ASSERT_EQ(indexed.indices[part.offset(column, row)], pattern(1000 + column, 700 + row));
    }
  EXPECT_EQ(crop(whole, {0, 0, Ma120::kSize}), whole);
}

TEST(Screen, CropStaysOnTheScreen) {
  const Screen whole = Ma120().scan_out();
  for (const Area& area : {Area{-1, 0, {5, 5}}, Area{0, -1, {5, 5}}, Area{1020, 0, {5, 5}},
                           Area{0, 776, {5, 5}}, Area{0, 0, {-1, 5}}})
    EXPECT_THROW(crop(whole, area), std::out_of_range);
}

TEST(Screen, SplitsIntoPlanes) {
  const Screen screen{{2, 1}, {{1, 2, 3}, {4, 5, 6}}};
  const Planes planes = to_planes(screen);
  EXPECT_EQ(planes.size, (ImageSize{2, 1}));
  EXPECT_EQ(planes.at(0), (Rgb8{1, 2, 3}));
  EXPECT_EQ(planes.at(1), (Rgb8{4, 5, 6}));
}

}  // namespace
}  // namespace sir::eltek
