// The grids in which an image's colours are counted: the thesis's matrices RGB
// and FHSV (thesis 3.4.1 and 3.4.3), exact in integers of the bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "quant/dac_code.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Coordinates of a cell: (r, g, b), or (hue, saturation, value). The grey
/// plane is the one past the last hue; its saturation is 0.
using GridPoint = std::array<int, 3>;

/// The coordinates of some pixels' cells added up, and how many pixels there are.
struct PointSum {
  std::array<std::uint64_t, 3> sum{};
  std::uint64_t pixels = 0;
  void add(const GridPoint& point, std::uint64_t times);
};

/// A partition of the colours into numbered cells.
class Grid {
 public:
  virtual ~Grid() = default;

  /// Number of cells, occupied or not.
  virtual std::size_t size() const = 0;

  /// The cell of one colour: the definition.
  virtual std::size_t cell(Rgb8 colour) const = 0;

  /// The cells of the colours (r[i], g[i], b[i]), for each i of `cells`: the
  /// same as cell(), many at a time.
  virtual void locate(const std::uint8_t* r, const std::uint8_t* g, const std::uint8_t* b,
                      std::span<std::uint32_t> cells) const = 0;

  /// The coordinates of a cell.
  virtual GridPoint point(std::size_t cell) const = 0;

  /// The plane to which a cell belongs. LUT entries are shared out among
  /// planes, and boxes lie within one.
  virtual int plane(const GridPoint& point) const = 0;

  /// The mean of cells of one plane as a LUT code: floor(63 c + 1/2) of each
  /// primary c, in exact rational arithmetic, because half a code is a common
  /// result (hue 10 degrees, s = v = 1 gives 52.5). For fewer than 2^40 pixels.
  virtual DacCode code(const PointSum& mean) const = 0;
};

/// Cubes of the colours by the highest bits of their bytes: with the thesis's 5
/// bits 32 x 32 x 32 cells numbered (r * 32 + g) * 32 + b, coordinate i standing
/// for the primary i / 31; with another number of bits likewise. One plane.
class RgbGrid final : public Grid {
 public:
  static constexpr int kBits = 5, kMaxBits = 8;
  static constexpr int kLevels = 1 << kBits;

  /// Throws std::invalid_argument for other than 1 to kMaxBits bits.
  explicit RgbGrid(int bits = kBits);

  std::size_t size() const override;
  std::size_t cell(Rgb8 colour) const override;
  void locate(const std::uint8_t* r, const std::uint8_t* g, const std::uint8_t* b,
              std::span<std::uint32_t> cells) const override;
  GridPoint point(std::size_t cell) const override;
  int plane(const GridPoint&) const override { return 0; }
  DacCode code(const PointSum& mean) const override;

 private:
  int bits_;
};

/// What can be chosen about the HSV grid.
struct HsvGridShape {
  static constexpr int kMaxLevels = 1024;
  static constexpr std::int64_t kMaxCells = std::int64_t{1} << 24;  // as many as there are colours

  int hues = 36;         ///< planes; bin i stands for the hue 360 i / hues degrees
  int saturations = 30;  ///< level i stands for i / (saturations - 1)
  int values = 30;       ///< likewise, and in the grey plane

  /// A colour is grey if its saturation or its value is at most this.
  double grey_s = 0.2;
  double grey_v = 0.2;

  /// At least 1 hue and 2 levels, at most kMaxLevels each and kMaxCells in
  /// all; limits from 0 to 1.
  bool valid() const;
};

/// Reads "HxSxV" into hues, saturations and values. False, and `shape` as it
/// was, where the text is nothing of the kind or the grid is not valid.
bool parse_grid(std::string_view text, HsvGridShape& shape);

/// hues x saturations x values cells numbered (h * saturations + s) * values + v,
/// then the grey plane's `values` cells. Each hue is a plane, the grey one is
/// the last.
class HsvGrid final : public Grid {
 public:
  /// Throws std::invalid_argument where the shape is not valid.
  explicit HsvGrid(const HsvGridShape& shape = {});

  std::size_t size() const override;
  std::size_t cell(Rgb8 colour) const override;
  void locate(const std::uint8_t* r, const std::uint8_t* g, const std::uint8_t* b,
              std::span<std::uint32_t> cells) const override;
  GridPoint point(std::size_t cell) const override;
  int plane(const GridPoint& point) const override { return point[0]; }
  DacCode code(const PointSum& mean) const override;

  int grey_plane() const { return shape_.hues; }

 private:
  HsvGridShape shape_;
  int first_grey_;
  // The limits as integers: grey if chroma * grey_max_ <= grey_chroma_ * max
  // or max <= grey_value_; 1/5 and 51 by default.
  int grey_chroma_ = 0, grey_max_ = 1, grey_value_ = 0;
};

}  // namespace sir::quant
