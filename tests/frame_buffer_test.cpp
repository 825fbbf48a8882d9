#include "eltek/frame_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace sir::eltek {
namespace {

std::vector<std::uint8_t> noise(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(count);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

TEST(FrameBuffer, StartsAtZeroWithAllPlanesWritable) {
  const FrameBuffer memory;
  EXPECT_EQ(memory.write_mask(), 0xFF);
  for (int p = 0; p < FrameBuffer::kPlanes; ++p)
    for (const std::uint8_t byte : memory.plane(p)) ASSERT_EQ(byte, 0);
}

TEST(FrameBuffer, PlanesArePackedBits) {
  FrameBuffer memory;
  EXPECT_EQ(memory.plane(0).size(), 1024u * 780u / 8u);
  memory.write(0, 0, 0b00000001);
  memory.write(7, 0, 0b10000001);
  memory.write(9, 2, 0b00100000);
  EXPECT_EQ(memory.plane(0)[0], 0b10000001);  // leftmost pixel highest
  EXPECT_EQ(memory.plane(7)[0], 0b00000001);
  EXPECT_EQ(memory.plane(5)[2 * 128 + 1], 0b01000000);
  EXPECT_EQ(memory.plane(1)[0], 0);
}

TEST(FrameBuffer, ReadsBackEveryIndexAndCorner) {
  FrameBuffer memory;
  for (int index = 0; index < 256; ++index) {
    memory.write(index * 3, index, static_cast<std::uint8_t>(index));
    EXPECT_EQ(memory.read(index * 3, index), index);
  }
  for (const auto& [column, row] : {std::pair{0, 0}, {1023, 0}, {0, 779}, {1023, 779}}) {
    memory.write(column, row, 0xA5);
    EXPECT_EQ(memory.read(column, row), 0xA5);
  }
}

TEST(FrameBuffer, WriteMaskProtectsPlanes) {
  FrameBuffer memory;
  memory.write(100, 50, 0b11001100);
  memory.set_write_mask(0b00001111);
  memory.write(100, 50, 0b00110011);
  EXPECT_EQ(memory.read(100, 50), 0b11000011);
  memory.set_write_mask(0);
  memory.write(100, 50, 0xFF);
  EXPECT_EQ(memory.read(100, 50), 0b11000011);
}

// The row of pixels is eight at a time; one by one is the definition.
TEST(FrameBuffer, RowsEqualSinglePixelsAtEveryAlignmentAndMask) {
  for (const unsigned mask : {0xFFu, 0x0Fu, 0x81u, 0x00u})
    for (int column = 0; column < 10; ++column)
      for (const std::size_t count : {0u, 1u, 5u, 8u, 17u, 40u, 1014u}) {
        FrameBuffer plain, fast;
        const auto old = noise(1024, 1), indices = noise(count, 2 + mask);
        for (auto* memory : {&plain, &fast}) {
          for (int i = 0; i < 1024; ++i) memory->write(i, 779, old[static_cast<std::size_t>(i)]);
          memory->set_write_mask(static_cast<std::uint8_t>(mask));
        }
        for (std::size_t i = 0; i < count; ++i)
          plain.write(column + static_cast<int>(i), 779, indices[i]);
        fast.write_row(column, 779, indices);

        std::vector<std::uint8_t> read(count);
        fast.read_row(column, 779, read);
        for (std::size_t i = 0; i < count; ++i)
          ASSERT_EQ(read[i], plain.read(column + static_cast<int>(i), 779));
        for (int p = 0; p < FrameBuffer::kPlanes; ++p)
          ASSERT_TRUE(std::ranges::equal(plain.plane(p), fast.plane(p))) << p;
      }
}

TEST(FrameBuffer, RefusesPlacesOutsideTheScreen) {
  FrameBuffer memory;
  std::array<std::uint8_t, 2> two{};
  EXPECT_THROW(memory.write(1024, 0, 1), std::out_of_range);
  EXPECT_THROW(memory.write(0, 780, 1), std::out_of_range);
  EXPECT_THROW(memory.read(-1, 0), std::out_of_range);
  EXPECT_THROW(memory.read(0, -1), std::out_of_range);
  EXPECT_THROW(memory.write_row(1023, 0, two), std::out_of_range);
  EXPECT_THROW(memory.read_row(1023, 0, two), std::out_of_range);
  EXPECT_THROW(memory.plane(8), std::out_of_range);
  EXPECT_NO_THROW(memory.write_row(1022, 779, two));
}

TEST(FrameBuffer, FillIsWriteForEachPixel) {
  std::mt19937 random(9);
  const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
  FrameBuffer filled, written;
  for (int i = 0; i < 300; ++i) {
    const int column = below(1024), row = below(780);
    const auto index = static_cast<std::uint8_t>(random());
    const auto mask = static_cast<std::uint8_t>(below(2) > 0 ? 0xFFu : random());
    const std::size_t left = static_cast<std::size_t>((780 - row) * 1024 - column);
    const auto count =
        std::min(static_cast<std::size_t>(below(2) > 0 ? below(20) : below(5000)), left);
    filled.set_write_mask(mask);
    written.set_write_mask(mask);
    filled.fill(column, row, count, index);
    for (std::size_t k = 0; k < count; ++k) {
      const int place = row * 1024 + column + static_cast<int>(k);
      written.write(place % 1024, place / 1024, index);
    }
  }
  for (int plane = 0; plane < 8; ++plane)
    ASSERT_TRUE(std::ranges::equal(filled.plane(plane), written.plane(plane))) << plane;
  filled.fill(1023, 779, 1, 5);
  EXPECT_THROW(filled.fill(1023, 779, 2, 5), std::out_of_range);
  EXPECT_THROW(filled.fill(1024, 5, 1, 5), std::out_of_range);
  EXPECT_THROW(filled.fill(0, -1, 0, 5), std::out_of_range);
}

}  // namespace
}  // namespace sir::eltek
