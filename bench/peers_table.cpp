#include "bench/peers_table.h"

#include <algorithm>
#include <cstdio>

namespace sir::bench {

Quartiles::Quartiles(std::vector<double> values) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  low = values[values.size() / 4];
  middle = values[values.size() / 2];
  high = values[values.size() * 3 / 4];
}

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> quotients;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) quotients.push_back(a[i] / b[i]);
  return quotients;
}

void SpeedTable::begin(const std::string& title) {
  std::printf("\n%s\n%-23s %-34s %7s  %-16s %5s %5s\n", title.c_str(), "", "", "median",
              "quartiles", "must", "aim");
}

void SpeedTable::line(const std::string& what, const std::string& detail, const Quartiles& figure,
                      Demand demand) {
  char range[32];
  std::snprintf(range, sizeof range, "%.3g..%.3g", figure.low, figure.high);
  std::printf("%-23s %-34s %7.4g  %-16s", what.c_str(), detail.c_str(), figure.middle, range);
  const auto column = [](double bound) {
    if (bound > 0) std::printf(" %5.4g", bound);
    else std::printf(" %5s", "");
  };
  const auto met = [&](double bound) {
    return bound <= 0 || (demand.at_most ? figure.middle <= bound : figure.middle >= bound);
  };
  if (demand.must > 0 || demand.aim > 0) {
    column(demand.must);
    column(demand.aim);
    const bool aimed = demand.aim > 0 && met(demand.aim);
    std::printf("  %s", !met(demand.must)  ? "MISSED"
                        : aimed            ? "aim met"
                        : demand.must <= 0 ? "aim missed"
                                           : "met");
    missed_ += !met(demand.must);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace sir::bench
