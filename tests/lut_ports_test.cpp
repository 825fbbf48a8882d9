#include "eltek/lut_ports.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <stdexcept>

namespace sir::eltek {
namespace {

using quant::DacCode;

void send(LutPorts& ports, std::initializer_list<int> codes) {
  for (const int code : codes) ports.write_data(static_cast<std::uint8_t>(code));
}

DacCode receive(LutPorts& ports) {
  DacCode codes{};
  for (auto& code : codes) code = ports.read_data();
  return codes;
}

TEST(LutPorts, StartsBlackWithAnOpenMask) {
  LutPorts ports;
  EXPECT_EQ(ports.pixel_mask(), 0xFF);
  for (int i = 0; i < 256; ++i) EXPECT_EQ(ports.look_up(static_cast<std::uint8_t>(i)), DacCode{});
}

TEST(LutPorts, CommitsOnTheThirdByte) {
  LutPorts ports;
  ports.write_address(7);
  send(ports, {10, 20});
  EXPECT_EQ(ports.look_up(7), DacCode{});
  send(ports, {30});
  EXPECT_EQ(ports.look_up(7), (DacCode{10, 20, 30}));
}

TEST(LutPorts, AddressAdvancesByItselfAndWraps) {
  LutPorts ports;
  ports.write_address(254);
  send(ports, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  EXPECT_EQ(ports.look_up(254), (DacCode{1, 2, 3}));
  EXPECT_EQ(ports.look_up(255), (DacCode{4, 5, 6}));
  EXPECT_EQ(ports.look_up(0), (DacCode{7, 8, 9}));
}

TEST(LutPorts, KeepsTheLowSixBits) {
  LutPorts ports;
  ports.write_address(0);
  send(ports, {64, 63, 255});
  EXPECT_EQ(ports.look_up(0), (DacCode{0, 63, 63}));
}

TEST(LutPorts, KeepsTheBitsOfTheDacThatIsFitted) {
  LutPorts ports(quant::DacBits{{5, 8, 1}});
  EXPECT_EQ(ports.dac(), (quant::DacBits{{5, 8, 1}}));
  ports.write_address(0);
  send(ports, {33, 254, 2, 31, 255, 3});
  EXPECT_EQ(ports.look_up(0), (DacCode{1, 254, 0}));
  EXPECT_EQ(ports.look_up(1), (DacCode{31, 255, 1}));
  EXPECT_EQ(LutPorts().dac(), quant::DacBits{});
  EXPECT_THROW(LutPorts(quant::DacBits{{6, 9, 6}}), std::invalid_argument);
}

TEST(LutPorts, AnAddressResetsThePhase) {
  LutPorts ports;
  ports.write_address(3);
  send(ports, {1, 1, 1});
  ports.write_address(3);
  send(ports, {50, 51});
  ports.write_address(3);
  EXPECT_EQ(ports.look_up(3), (DacCode{1, 1, 1}));  // the half entry is forgotten
  send(ports, {5, 6, 7});
  EXPECT_EQ(ports.look_up(3), (DacCode{5, 6, 7}));

  ports.write_address(3);
  send(ports, {60});
  ports.read_address(3);  // so does the other address
  EXPECT_EQ(receive(ports), (DacCode{5, 6, 7}));
}

TEST(LutPorts, ReadsBackWithTheSameAdvance) {
  LutPorts ports;
  ports.write_address(0);
  for (int i = 0; i < 256; ++i) send(ports, {i % 64, i / 4, 63 - i % 64});
  ports.read_address(255);
  EXPECT_EQ(receive(ports), (DacCode{63, 63, 0}));
  EXPECT_EQ(receive(ports), (DacCode{0, 0, 63}));
  EXPECT_EQ(receive(ports), (DacCode{1, 0, 62}));

  ports.read_address(9);
  ports.read_data();
  ports.read_address(9);
  EXPECT_EQ(receive(ports), (DacCode{9, 2, 54}));
}

TEST(LutPorts, ReadingChangesNothing) {
  LutPorts ports;
  ports.write_address(0);
  send(ports, {1, 2, 3, 4, 5, 6});
  ports.read_address(0);
  receive(ports);
  receive(ports);
  EXPECT_EQ(ports.look_up(0), (DacCode{1, 2, 3}));
  EXPECT_EQ(ports.look_up(1), (DacCode{4, 5, 6}));
}

TEST(LutPorts, PixelMaskGuardsTheLookupNotThePorts) {
  LutPorts ports;
  ports.write_address(0);
  for (int i = 0; i < 256; ++i) send(ports, {i % 64, i / 64, 0});
  ports.write_pixel_mask(0x0F);
  EXPECT_EQ(ports.look_up(0xF5), (DacCode{5, 0, 0}));
  ports.read_address(0xF5);
  EXPECT_EQ(receive(ports), (DacCode{0xF5 % 64, 3, 0}));
  ports.write_pixel_mask(0xFF);
  EXPECT_EQ(ports.look_up(0xF5), (DacCode{0xF5 % 64, 3, 0}));
}

}  // namespace
}  // namespace sir::eltek
