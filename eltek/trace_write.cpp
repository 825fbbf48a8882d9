#include <functional>
#include <string>
#include <string_view>

#include "eltek/trace_text.h"
#include "tracer/atomic_file.h"

namespace sir::eltek {
namespace {

std::string bits(const quant::DacBits& dac) {
  std::string text;
  for (const int one : dac.bits) text += " " + std::to_string(one);
  return text;
}

class Writer {
 public:
  Writer(const Trace& trace, std::string& text) : trace_(trace), text_(text) {}

  void operator()(const PortWrite& write) {
    text_ += name(write.port);
    put_value(write.port, write.value);
  }
  void operator()(const PortRead& read) {
    text_.append("read ").append(name(read.port));
    if (read.value) put_value(read.port, *read.value);
    else text_ += " ?";
  }
  void operator()(const PixelWrite& pixels) { put_runs("pixel", pixels); }
  void operator()(const PixelRead& pixels) { put_runs("read pixel", pixels); }
  void operator()(const Wait& wait) { text_ += "wait " + std::to_string(wait.line); }
  void operator()(const PowerCycle& power) { text_ += "power" + bits(power.dac); }

 private:
  void put_value(Port port, int value) {
    if (port == Port::blank) text_ += value != 0 ? " on" : " off";
    else text_ += " " + std::to_string(value);
  }

  void put_runs(std::string_view what, const PixelRuns& pixels) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    text_ += what;
    for (const PixelRun& run : trace_.runs(pixels)) {
      text_ += ' ';
      if (const auto index = run.index()) {
        text_ += kDigits[*index >> 4];
        text_ += kDigits[*index & 0xF];
      } else {
        text_ += '?';
      }
      if (run.count() > 1) text_ += "*" + std::to_string(run.count());
    }
  }

  const Trace& trace_;
  std::string& text_;
};

// Hands the text over in pieces that keep memory small.
void write_pieces(const Trace& trace, const std::function<void(std::string_view)>& put) {
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  std::string text = "MA120 trace 1 dac" + bits(trace.dac()) + "\n";
  for (const TraceRecord& record : trace.records()) {
    std::visit(Writer(trace, text), record);
    text += '\n';
    if (text.size() < kPiece) continue;
    put(text);
    text.clear();
  }
  put(text + "end " + std::to_string(trace.records().size()) + "\n");
}

}  // namespace

std::string trace_text(const Trace& trace) {
  std::string whole;
  write_pieces(trace, [&](std::string_view piece) { whole += piece; });
  return whole;
}

void write_trace(AtomicFile& file, const Trace& trace) {
  write_pieces(trace, [&](std::string_view piece) { file.write(piece); });
}

void write_trace(const std::filesystem::path& path, const Trace& trace) {
  AtomicFile file(path);
  write_trace(file, trace);
  file.commit();
}

}  // namespace sir::eltek
