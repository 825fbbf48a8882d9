#include "eltek/trace_describe.h"

#include <array>
#include <string_view>

#include "quant/dac_parse.h"
#include "tracer/text_file.h"

namespace sir::eltek {
namespace {

constexpr std::size_t kInterval = 4096;
constexpr std::array<std::string_view, 3> kPrimaries{"red", "green", "blue"};

// What a record does to the state.
struct Apply {
  TraceDescriber::State& state;

  void operator()(const PortWrite& write) const {
    const auto byte = static_cast<std::uint8_t>(write.value);
    switch (write.port) {
      case Port::lut_write: state.lut.write_address(byte); break;
      case Port::lut_read: state.lut.read_address(byte); break;
      case Port::lut_data: state.lut.write_data(byte); break;
      case Port::column: state.pixel.set_column(write.value); break;
      case Port::row: state.pixel.set_row(write.value); break;
      default: break;
    }
  }
  void operator()(const PortRead& read) const {
    if (read.port == Port::lut_data) state.lut.read_data();
  }
  void operator()(const PixelRuns& pixels) const { state.pixel.advance(pixels.count); }
  void operator()(const Wait& wait) const { state.raster.advance_to(wait.line); }
  void operator()(const PowerCycle& power) const {
    state.raster.restart();
    state = {LutPorts(power.dac), {}, state.raster};
  }
};

std::string planes(int mask) {
  if (mask == 0) return "no planes";
  if (mask == 0xFF) return "all planes";
  std::string text = "planes";
  for (int plane = 0; plane < FrameBuffer::kPlanes; ++plane)
    if (((mask >> plane) & 1) != 0) text += " " + std::to_string(plane + 1);
  return text;
}

std::string codes(const quant::DacCode& entry) {
  return std::to_string(entry[0]) + " " + std::to_string(entry[1]) + " " + std::to_string(entry[2]);
}

// What a record does, in words, to the state before it.
struct Say {
  const Trace& trace;
  const TraceDescriber::State& state;

  std::string operator()(const PortWrite& write) const {
    const std::string value = std::to_string(write.value);
    switch (write.port) {
      case Port::lut_write: return "LUT write address " + value;
      case Port::lut_read: return "LUT read address " + value;
      case Port::lut_data: return lut_data(write.value);
      case Port::pixel_mask: return "pixel mask " + value + ": " + planes(write.value) + " seen";
      case Port::plane_mask: return "plane mask " + value + ": " + planes(write.value) + " written";
      case Port::column: return "column " + value;
      case Port::row:
        return "row " + value + (write.value < FrameBuffer::kRows ? "" : ", where no memory is");
      case Port::blank: return write.value != 0 ? "blanked" : "no longer blanked";
      case Port::pixel: break;  // PixelWrite's
    }
    return "";
  }

  std::string operator()(const PortRead& read) const {
    std::string what(name(read.port));
    if (read.port == Port::lut_data) what = place_in_lut();
    return "reads " + what + ": " + (read.value ? std::to_string(*read.value) : "?");
  }

  std::string operator()(const PixelWrite& pixels) const { return runs(pixels); }
  std::string operator()(const PixelRead& pixels) const { return "reads " + runs(pixels); }

  std::string operator()(const Wait& wait) const {
    std::string text = "waits for line " + std::to_string(wait.line);
    if (wait.line < state.raster.line()) text += " of the next frame";
    if (wait.line >= FrameBuffer::kRows) text += ", in the vertical blanking";
    return text;
  }

  std::string operator()(const PowerCycle& power) const {
    return "off and on, with a DAC of " + quant::bits_text(power.dac) + " bits";
  }

 private:
  std::string place_in_lut() const {
    return "LUT entry " + std::to_string(state.lut.address()) + " " +
           std::string(kPrimaries[state.lut.phase()]);
  }

  std::string lut_data(std::uint16_t value) const {
    LutPorts after = state.lut;
    after.write_data(static_cast<std::uint8_t>(value));
    std::string text = place_in_lut() + " " + std::to_string(value);
    if (state.lut.phase() == 2) {
      after.write_pixel_mask(0xFF);
      text += ", now " + codes(after.look_up(state.lut.address()));
    }
    return text;
  }

  std::string runs(const PixelRuns& pixels) const {
    std::string text = counted(pixels.count, "pixel");
    if (const auto all = trace.runs(pixels); all.size() == 1 && all.front().index())
      text += " of index " + std::to_string(*all.front().index());
    text += " from column " + std::to_string(state.pixel.column()) + ", row " +
            std::to_string(state.pixel.row());
    return text + (state.pixel.on_screen() ? "" : ", where no memory is");
  }
};

}  // namespace

TraceDescriber::TraceDescriber(const Trace& trace) : trace_(trace) {
  State state{LutPorts(trace.dac()), {}, {}};
  for (std::size_t i = 0; i < trace.records().size(); ++i) {
    if (i % kInterval == 0) states_.push_back(state);
    std::visit(Apply{state}, trace.records()[i]);
  }
}

std::string TraceDescriber::operator()(std::size_t record) const {
  const TraceRecord& wanted = trace_.records().at(record);
  State state = states_[record / kInterval];
  for (std::size_t i = record / kInterval * kInterval; i < record; ++i)
    std::visit(Apply{state}, trace_.records()[i]);
  return std::visit(Say{trace_, state}, wanted);
}

}  // namespace sir::eltek
