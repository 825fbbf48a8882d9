// The MA120 as plainly as its registers are described, to compare the real one with.
#pragma once

#include <cstdint>
#include <vector>

#include "eltek/bus.h"
#include "eltek/screen.h"

namespace sir::test {

/// One byte a pixel, one step a pixel, nothing shared with eltek/ but the names of the ports.
class PlainMa120 {
 public:
  static constexpr int kWidth = 1024, kHeight = 780, kLines = 816;

  explicit PlainMa120(const quant::DacBits& dac = {});

  void write(eltek::Port port, int value);
  int read(eltek::Port port);
  void wait(int line);
  void power(const quant::DacBits& dac);

  /// What the machine would scan out now; the tube; the frame if nothing more is written.
  eltek::Screen scan() const;
  const eltek::Screen& tube() const { return tube_; }
  eltek::Screen frame() const;

  int line() const { return line_; }

 private:
  Rgb8 colour(int column, int row) const;
  void advance_pixel();

  quant::DacBits dac_;
  std::vector<std::uint8_t> pixels_;
  int lut_[256][3] = {};
  int waiting_[3] = {};
  int address_ = 0, phase_ = 0;
  int mask_ = 255, planes_ = 255;
  int column_ = 0, row_ = 0;
  bool blank_ = false;
  int line_ = 0;
  eltek::Screen tube_;
};

}  // namespace sir::test
