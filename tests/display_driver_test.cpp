#include "eltek/display_driver.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "eltek/dac.h"
#include "tracer/error.h"

namespace sir::eltek {
namespace {

// Entry 77 is black; no other is.
quant::Lut some_lut() {
  quant::Lut lut;
  for (std::size_t i = 0; i < 256; ++i)
    lut.entry[i] = {static_cast<std::uint8_t>(i % 63 + 1), static_cast<std::uint8_t>(i / 4),
                    static_cast<std::uint8_t>(63 - i % 64)};
  lut.entry[77] = {0, 0, 0};
  return lut;
}

std::vector<std::uint8_t> some_indices(ImageSize size) {
  std::vector<std::uint8_t> indices(size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = static_cast<std::uint8_t>(i * 31 + i / 97);
  return indices;
}

std::string error_of(ImageSize size) {
  try {
    place("SCENE", size, Oversize::refuse);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(DisplayDriver, LoadsTheLutThroughThePorts) {
  Ma120 monitor;
  Bus bus(monitor);
  bus.write(Port::lut_write, 99);
  bus.write(Port::lut_data, 1);  // whatever state the ports are in
  load_lut(bus, some_lut());
  for (std::size_t i = 0; i < 256; ++i)
    EXPECT_EQ(monitor.lut_ports.look_up(static_cast<std::uint8_t>(i)), some_lut().entry[i]) << i;
}

TEST(DisplayDriver, RefusesALutOfAnotherDac) {
  quant::Lut lut = some_lut();
  lut.dac = {{5, 6, 5}};
  Ma120 monitor, other(lut.dac);
  Bus bus(monitor), other_bus(other);
  EXPECT_THROW(load_lut(bus, lut), std::invalid_argument);
  EXPECT_EQ(monitor.lut_ports.look_up(1), quant::DacCode{});
  EXPECT_THROW(load_lut(other_bus, some_lut()), std::invalid_argument);
  for (auto& entry : lut.entry) entry = {31, 63, 31};
  load_lut(other_bus, lut);
  EXPECT_EQ(other.lut_ports.look_up(200), (quant::DacCode{31, 63, 31}));
}

TEST(DisplayDriver, PlacesTheDefaultImageWhereTheContractSays) {
  const Placement placement = place("SCENE", {640, 480}, Oversize::refuse);
  EXPECT_EQ(placement.on_screen, (Area{192, 150, {640, 480}}));
  EXPECT_EQ(placement.image_column, 0);
  EXPECT_EQ(placement.image_row, 0);
}

TEST(DisplayDriver, CentresOddSizesByTheFloor) {
  EXPECT_EQ(place("S", {1, 1}, Oversize::refuse).on_screen, (Area{511, 389, {1, 1}}));
  EXPECT_EQ(place("S", {1023, 779}, Oversize::refuse).on_screen, (Area{0, 0, {1023, 779}}));
  EXPECT_EQ(place("S", {1024, 780}, Oversize::refuse).on_screen, (Area{0, 0, {1024, 780}}));
  EXPECT_EQ(place("S", {641, 483}, Oversize::refuse).on_screen, (Area{191, 148, {641, 483}}));
}

TEST(DisplayDriver, RefusesALargerImageAndSaysWhatToDo) {
  for (const ImageSize size : {ImageSize{1025, 780}, ImageSize{1024, 781}, ImageSize{2000, 10}}) {
    const std::string error = error_of(size);
    EXPECT_EQ(error.find("SCENE: an image of " + std::to_string(size.width) + "x"), 0u) << error;
    EXPECT_NE(error.find("1024x780"), std::string::npos) << error;
    EXPECT_NE(error.find("--crop"), std::string::npos) << error;
  }
  EXPECT_NE(error_of({0, 5}), "");
  EXPECT_EQ(error_of({1024, 780}), "");
}

TEST(DisplayDriver, CropTakesTheCentreThatFits) {
  const Placement both = place("S", {1031, 801}, Oversize::crop);
  EXPECT_EQ(both.on_screen, (Area{0, 0, {1024, 780}}));
  EXPECT_EQ(both.image_column, 3);
  EXPECT_EQ(both.image_row, 10);
  const Placement wide = place("S", {2000, 100}, Oversize::crop);
  EXPECT_EQ(wide.on_screen, (Area{0, 340, {1024, 100}}));
  EXPECT_EQ(wide.image_column, 488);
  EXPECT_EQ(wide.image_row, 0);
}

TEST(DisplayDriver, NearestToBlackIsSeenAndLowestOnTies) {
  EXPECT_EQ(nearest_to_black(some_lut()), 77);
  quant::Lut lut;
  lut.entry.fill({10, 10, 10});
  EXPECT_EQ(nearest_to_black(lut), 0);
  lut.entry[9] = {0, 0, 3};
  lut.entry[8] = {0, 3, 0};  // as near as entry 9
  lut.entry[7] = {2, 2, 2};  // 3*8*8 > 12*12
  EXPECT_EQ(nearest_to_black(lut), 8);
}

// As codes 12, 0, 0 is nearer (144 against 147), as seen 7, 7, 7 is: bytes
// 49, 0, 0 (2401) against 28, 28, 28 (2352).
TEST(DisplayDriver, NearestToBlackComparesBytesAsSeen) {
  quant::Lut lut;
  lut.entry.fill({63, 63, 63});
  lut.entry[10] = {12, 0, 0};
  lut.entry[20] = {7, 7, 7};
  EXPECT_EQ(nearest_to_black(lut), 20);
}

TEST(DisplayDriver, NearestToBlackIsSeenThroughTheLutsDac) {
  quant::Lut lut;
  lut.dac = {{4, 6, 6}};
  lut.entry.fill({15, 63, 63});
  lut.entry[10] = {1, 0, 0};  // seen as 17 0 0
  lut.entry[20] = {0, 3, 0};  // seen as 0 12 0
  EXPECT_EQ(nearest_to_black(lut), 20);
}

TEST(DisplayDriver, NearestToBlackIsNotReserved) {
  quant::Lut lut;
  lut.entry.fill({63, 63, 63});
  lut.entry[10] = lut.entry[30] = {0, 0, 0};
  lut.entry[20] = {1, 0, 0};
  EXPECT_EQ(nearest_to_black(lut, quant::IndexSet().set(10)), 30);
  EXPECT_EQ(nearest_to_black(lut, quant::IndexSet().set(10).set(30)), 20);
  EXPECT_THROW(nearest_to_black(lut, quant::IndexSet().set()), std::invalid_argument);
}

TEST(DisplayDriver, TheSurroundTakesNoReservedEntry) {
  Ma120 monitor;
  const auto indices = some_indices({10, 10});
  quant::Lut lut = some_lut();
  lut.entry[99] = {1, 0, 0};
  show_image(monitor, {"S", {10, 10}, indices}, lut, Oversize::refuse, quant::IndexSet().set(77));
  EXPECT_EQ(monitor.frame_buffer.read(0, 0), 99);
  EXPECT_EQ(monitor.frame_buffer.read(1023, 779), 99);
}

TEST(DisplayDriver, ShowsTheImageAndFillsTheRest) {
  Ma120 monitor;
  monitor.frame_buffer.set_write_mask(0x01);
  monitor.lut_ports.write_pixel_mask(0x10);
  const ImageSize size{640, 480};
  const auto indices = some_indices(size);
  const quant::Lut lut = some_lut();
  const Area area = show_image(monitor, {"SCENE", size, indices}, lut);
  EXPECT_EQ(area, (Area{192, 150, {640, 480}}));
  const Screen screen = monitor.scan_out();
  for (int row = 0; row < 780; ++row)
    for (int column = 0; column < 1024; ++column) {
      const bool inside = column >= 192 && column < 832 && row >= 150 && row < 630;
      const int index =
          inside ? indices[static_cast<std::size_t>((row - 150) * 640 + column - 192)] : 77;
      ASSERT_EQ(monitor.frame_buffer.read(column, row), index) << column << "," << row;
      ASSERT_EQ(screen.at(column, row), dac_colour(lut.entry[static_cast<std::size_t>(index)]));
    }
}

TEST(DisplayDriver, ShowsTheCentreOfALargerImage) {
  Ma120 monitor;
  const ImageSize size{1100, 700};
  const auto indices = some_indices(size);
  const Area area = show_image(monitor, {"SCENE", size, indices}, some_lut(), Oversize::crop);
  EXPECT_EQ(area, (Area{0, 40, {1024, 700}}));
  for (int row = 0; row < 780; ++row)
    for (int column = 0; column < 1024; ++column) {
      const bool inside = row >= 40 && row < 740;
      const int index =
          inside ? indices[static_cast<std::size_t>((row - 40) * 1100 + column + 38)] : 77;
      ASSERT_EQ(monitor.frame_buffer.read(column, row), index) << column << "," << row;
    }
}

TEST(DisplayDriver, TheNextImageLeavesNothingOfTheLast) {
  Ma120 monitor, fresh;
  const auto large = some_indices({1024, 780}), small = some_indices({10, 10});
  show_image(monitor, {"A", {1024, 780}, large}, some_lut());
  quant::Lut other = some_lut();
  other.entry[0] = {1, 2, 3};
  show_image(monitor, {"B", {10, 10}, small}, other);
  show_image(fresh, {"B", {10, 10}, small}, other);
  EXPECT_EQ(monitor.capture(), fresh.capture());
}

TEST(DisplayDriver, ARefusedImageLeavesTheScreenAlone) {
  Ma120 monitor;
  const auto small = some_indices({10, 10}), large = some_indices({1025, 1});
  show_image(monitor, {"A", {10, 10}, small}, some_lut());
  const IndexedScreen before = monitor.capture();
  EXPECT_THROW(show_image(monitor, {"B", {1025, 1}, large}, quant::Lut{}), FileError);
  EXPECT_THROW(show_image(monitor, {"C", {9, 9}, small}, quant::Lut{}), std::invalid_argument);
  quant::Lut high_colour;
  high_colour.dac = {{5, 6, 5}};
  EXPECT_THROW(show_image(monitor, {"D", {10, 10}, small}, high_colour), std::invalid_argument);
  EXPECT_THROW(show_image(monitor, {"E", {10, 10}, small}, quant::Lut{}, Oversize::refuse,
                          quant::IndexSet().set()),
               std::invalid_argument);
  EXPECT_EQ(monitor.capture(), before);
}

}  // namespace
}  // namespace sir::eltek
