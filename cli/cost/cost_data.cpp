#include "cli/cost/cost_data.h"

#include "cli/cost/pareto.h"

namespace sir::cli {

void settle(CostPart& part) {
  std::vector<Offer> offers;
  for (CostRow& row : part.rows) {
    row.time = spread_of(row.ms);
    row.ratio = ratio_of(row.ms, part.rows.front().ms);
    offers.push_back({row.time.median, comparable(row.picture.psnr)});
  }
  const auto front = pareto_front(offers);
  for (std::size_t i = 0; i < front.size(); ++i) part.rows[i].front = front[i];
}

}  // namespace sir::cli
