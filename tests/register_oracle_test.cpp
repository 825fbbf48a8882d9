// Random sessions at the registers, against a plain model of the machine.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "eltek/bus.h"
#include "eltek/trace_player.h"
#include "eltek/trace_recorder.h"
#include "eltek/trace_text.h"
#include "tests/cases.h"
#include "tests/ma120_model.h"

namespace sir::eltek {
namespace {

const unsigned kSessions = static_cast<unsigned>(test::cases(20));
constexpr int kSteps = 250;

// Machine, bus and recorder on one side, the model on the other.
class Session {
 public:
  explicit Session(unsigned seed) : random_(seed) {
    const quant::DacBits dac{{below(8) + 1, 6, below(8) + 1}};
    machine = Ma120(dac);
    model = test::PlainMa120(dac);
    recorder = TraceRecorder(dac);
    bus.add_listener(recorder);
  }

  // True where both sides read the same, or nothing was read.
  bool step() {
    switch (below(14)) {
      case 0: return write(Port::lut_write, below(256));
      case 1: return write(Port::lut_read, below(256));
      case 2:
      case 3: return write_lut();
      case 4: return read(Port::lut_data);
      case 5: return write(Port::pixel_mask, below(3) > 0 ? 0xFF : below(256));
      case 6: return write(Port::plane_mask, below(2) > 0 ? 0xFF : below(256));
      case 7: return place();
      case 8: return burst();
      case 9: return fill();
      case 10: return read_back();
      case 11: return write(Port::blank, below(8) == 0 ? 1 : 0);
      case 12: return read(kPorts[static_cast<std::size_t>(below(9))]);
      default: return rare();
    }
  }

  Ma120 machine;
  Raster raster{machine};
  Bus bus{machine, &raster};
  test::PlainMa120 model;
  TraceRecorder recorder;

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

  bool write(Port port, int value) {
    bus.write(port, static_cast<std::uint16_t>(value));
    model.write(port, value);
    return true;
  }

  bool read(Port port) { return bus.read(port) == model.read(port); }

  bool write_lut() {
    for (int left = below(800); left > 0; --left) write(Port::lut_data, below(256));
    return true;
  }

  // Often where rows and the screen end.
  bool place() {
    write(Port::column, below(2) > 0 ? 1024 - below(5) - 1 : below(1024));
    return write(Port::row, below(4) == 0 ? 776 + below(248) : below(780));
  }

  bool burst() {
    std::vector<std::uint8_t> indices(static_cast<std::size_t>(below(4000)));
    const int variety = below(2) > 0 ? 256 : 2;
    for (auto& index : indices) index = static_cast<std::uint8_t>(below(variety));
    bus.write_pixels(indices);
    for (const int index : indices) model.write(Port::pixel, index);
    return true;
  }

  bool fill() {
    const int index = below(256), count = below(20) == 0 ? below(2'000'000) : below(3000);
    bus.fill_pixels(static_cast<std::uint8_t>(index), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) model.write(Port::pixel, index);
    return true;
  }

  bool read_back() {
    std::vector<std::uint8_t> indices(static_cast<std::size_t>(below(3000)));
    bus.read_pixels(indices);
    bool equal = true;
    for (const int index : indices) equal = model.read(Port::pixel) == index && equal;
    return equal;
  }

  bool rare() {
    if (below(20) == 0) {
      const quant::DacBits dac{{below(8) + 1, below(8) + 1, 6}};
      bus.power_cycle(dac);
      model.power(dac);
      return true;
    }
    const int line = below(816);
    bus.wait(line);
    model.wait(line);
    return true;
  }

  std::mt19937 random_;
};

TEST(RegisterOracle, RandomSessionsMatchThePlainModel) {
  for (unsigned seed = 0; seed < kSessions; ++seed) {
    Session session(seed);
    for (int step = 0; step < kSteps; ++step) ASSERT_TRUE(session.step()) << seed << ":" << step;
    ASSERT_EQ(session.raster.position().line(), session.model.line()) << seed;
    ASSERT_TRUE(session.machine.scan_out() == session.model.scan()) << seed;
    ASSERT_TRUE(session.raster.tube() == session.model.tube()) << seed;
    ASSERT_TRUE(session.raster.frame() == session.model.frame()) << seed;
  }
}

// Recorded, written, read and replayed, a session ends in the same state.
TEST(RegisterOracle, RecordedSessionsReplayTheSame) {
  for (unsigned seed = 100; seed < 100 + kSessions; ++seed) {
    Session session(seed);
    for (int step = 0; step < kSteps; ++step) session.step();
    ASSERT_FALSE(session.recorder.full());
    const std::string text = trace_text(session.recorder.trace());
    const Trace trace = parse_trace("T", text);
    ASSERT_TRUE(trace == session.recorder.trace()) << seed;
    ASSERT_EQ(trace_text(trace), text) << seed;
    TracePlayer player(trace);
    player.seek(player.count());
    ASSERT_FALSE(player.difference()) << seed << ": record " << player.difference()->record;
    ASSERT_TRUE(player.machine().scan_out() == session.machine.scan_out()) << seed;
    ASSERT_TRUE(player.raster().tube() == session.raster.tube()) << seed;
    ASSERT_TRUE(player.raster().frame() == session.raster.frame()) << seed;
    ASSERT_TRUE(player.machine().pixel_address == session.machine.pixel_address) << seed;
    player.seek(player.count() / 2);
    player.seek(player.count());
    ASSERT_TRUE(player.raster().frame() == session.raster.frame()) << seed;
  }
}

}  // namespace
}  // namespace sir::eltek
