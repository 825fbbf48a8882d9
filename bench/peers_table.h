// The lines of the tables that `peers` prints: a median with its quartiles beside what is demanded.
#pragma once

#include <string>
#include <vector>

namespace sir::bench {

/// Quartiles of some rounds' figures.
struct Quartiles {
  double low = 0, middle = 0, high = 0;
  explicit Quartiles(std::vector<double> values);
  Quartiles() = default;
};

/// a[i] / b[i] of each round, never the ratio of sums: rounds are alike within, not among
/// themselves.
std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b);

/// What a figure should come to. 0: nothing is demanded, or aimed at.
struct Demand {
  double must = 0, aim = 0;
  bool at_most = false;  ///< else at least
};

class SpeedTable {
 public:
  /// Prints a heading.
  void begin(const std::string& title);

  /// Prints a line and remembers whether what must be is met.
  void line(const std::string& what, const std::string& detail, const Quartiles& figure,
            Demand demand = {});

  int missed() const { return missed_; }

 private:
  int missed_ = 0;
};

}  // namespace sir::bench
