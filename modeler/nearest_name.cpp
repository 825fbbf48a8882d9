#include "modeler/nearest_name.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

// Optimal string alignment (Damerau and Levenshtein), by bytes of the folded texts.
std::size_t distance_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

constexpr std::size_t kLongest = 200;  // no one types more by mistake

}  // namespace

NearestName::NearestName(std::string_view wanted)
    : wanted_(fold_keyword(wanted.substr(0, kLongest))),
      distance_(std::numeric_limits<std::size_t>::max()) {}

void NearestName::offer(std::string_view known) {
  const std::string folded = fold_keyword(known.substr(0, kLongest));
  const std::size_t longer = std::max(folded.size(), wanted_.size());
  const std::size_t shorter = std::min(folded.size(), wanted_.size());
  const bool begins = !wanted_.empty() && folded.starts_with(wanted_);
  const std::size_t allowed = std::max<std::size_t>(longer / 3, longer > 1 ? 1 : 0);
  if (!begins && longer - shorter > allowed) return;
  const std::size_t distance = begins ? 0 : distance_between(wanted_, folded);
  if (distance > allowed || distance >= distance_) return;
  distance_ = distance;
  name_ = known;
  found_ = true;
}

}  // namespace sir::modeler
