// A palette that is made better step by step (Lloyd 1957; Linde, Buzo and Gray 1980): free of the
// DAC's lattice at first, then on it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quant/colour_points.h"
#include "quant/dac_code.h"
#include "quant/form_sum.h"
#include "quant/principal_split.h"

namespace sir::quant {

/// Which codes an entry may take: all, those for which `allowed` is true, or only its own.
struct EntryRule {
  bool fixed = false;
  std::function<bool(const DacCode&)> allowed;
  bool free() const { return !fixed && !allowed; }
};

/// Entries for points, every point with one of them. The cost is the sum over points of the weight
/// times the difference from the point's entry.
///
/// A point looks for its entry among the kAround entries that are nearest to the group it is in,
/// which are all that matter as entries move little. (The last word, the mapping of pixels, is
/// exact: quant/sweep_search.h.) Groups around which nothing has changed are not looked at.
class Palette {
 public:
  /// An entry for each group, at its centre; entries are free of the lattice. At most 256 groups;
  /// those without points need an entry from set(). `points` and `measure` must outlive it.
  Palette(std::span<const ColourPoint> points, ColourMeasure& measure, const DacBits& dac,
          const Groups& groups);

  std::size_t size() const { return entries_.size(); }
  double cost() const;

  /// The points of an entry, summed.
  const FormSum& sum(std::size_t entry) const { return sums_[entry]; }

  /// Puts an entry at a code, under a rule that admits it.
  void set(std::size_t entry, const DacCode& code, EntryRule rule = {});
  const EntryRule& rule(std::size_t entry) const { return rules_[entry]; }

  /// Every point goes to the nearest entry. The steps below do so by themselves.
  void assign();

  /// Lloyd's step: every entry moves to where it serves its points best, then every point to the
  /// nearest entry. Returns the share of the cost that is saved.
  double step();

  /// Moves the entries to codes of the DAC, where they stay from now on. The cost rises. Those
  /// without points go to the code that was set, or else to black.
  void hold();
  const std::vector<DacCode>& codes() const { return codes_; }  ///< once it is held

  /// Takes up to `most` entries that are missed least and puts them where a group of points would
  /// gain most by being divided; follows by two steps, and goes back where the cost is not less.
  /// Returns how many entries were moved. A division is tried where it gains `worth` of what the
  /// entry is missed by: both figures change as the neighbours fall into place.
  std::size_t swap(std::size_t most, double worth);

  /// Of an entry held on the lattice, Lloyd's step sees only what its own points gain by a move.
  /// This sees those that would come or go as well: for each entry it weighs the `tries` most
  /// promising codes around, and makes the moves that gain most and do not touch each other.
  /// Returns their number; 0 means that no more can be gained.
  std::size_t nudge(std::size_t tries);

  /// On a coarse lattice entries fall together. This puts those without points at the codes that
  /// are no entry's and gain most. The palette must be held. Returns how many were moved.
  std::size_t fill();

  /// What the points of each entry would cost more without it.
  std::vector<double> missed() const;

 private:
  static constexpr std::size_t kAround = 24;

  /// The entries around a group, the group's own included, by index. Where there are fewer, the
  /// own one once more, infinitely far.
  struct Around {
    std::array<float, kAround> x, y, z;
    std::array<std::uint16_t, kAround> index;
    std::size_t own;  ///< the place of the group's own entry here
    glm::vec3 centre{};
    Form form;
    float reach = -1;  ///< the greatest difference of these from the centre; below 0: not made yet
  };
  using Differences = std::array<std::int32_t, kAround>;  // bits of floats: they order alike
  static Differences differences(const ColourPoint& point, const Around& around);

  /// The points in the order of their entries.
  struct Order {
    std::vector<std::uint32_t> start, points;
    Group of(std::size_t entry) {
      return Group(points).subspan(start[entry], start[entry + 1] - start[entry]);
    }
  };
  Order order() const;

  void move(std::size_t entry, const glm::vec3& to);
  void move(std::size_t entry, const DacCode& to);
  void place(std::size_t entry);
  void list(std::size_t group);
  bool refresh(std::size_t group, std::span<const std::uint16_t> moved);
  float second(const ColourPoint& point, std::size_t entry) const;

  std::span<const ColourPoint> points_;
  ColourMeasure* measure_;
  DacBits dac_;
  bool held_ = false;
  std::vector<DacCode> codes_;
  std::vector<EntryRule> rules_;
  std::vector<glm::vec3> entries_;
  std::vector<std::uint16_t> nearest_;  // by point
  // By entry:
  std::vector<FormSum> sums_;
  std::vector<Around> around_;
  std::vector<std::uint8_t> moved_;      // since the last assign()
  std::vector<std::uint8_t> stirred_;    // points have come or gone by the last assign()
  std::vector<std::uint8_t> unsettled_;  // it or its points have changed since the last nudge()
};

}  // namespace sir::quant
