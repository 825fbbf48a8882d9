#include "bench/quantizers_results.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "bench/quantizers_peers.h"
#include "bench/timing.h"

namespace sir::bench {
namespace {

using Figure = std::function<std::optional<double>(const Row&)>;
using Contested = std::vector<const Picture*>;

double total(const Contested& pictures, const std::string& contender, const Figure& figure) {
  double sum = 0;
  for (const Picture* one : pictures) sum += figure(*one->find(contender)).value_or(0);
  return sum;
}

/// The sums' quotient.
double quotient(const Contested& pictures, const std::string& ours, const Figure& figure,
                const std::string& theirs = kReference) {
  return total(pictures, ours, figure) / total(pictures, theirs, figure);
}

struct Worst {
  double figure;
  std::string picture;
};

/// The picture where a figure is greatest, or least.
Worst worst(const Contested& pictures, bool greatest,
            const std::function<double(const Picture&)>& figure) {
  Worst found{figure(*pictures.front()), pictures.front()->name};
  for (const Picture* one : pictures) {
    const double here = figure(*one);
    if (greatest ? here > found.figure : here < found.figure) found = {here, one->name};
  }
  return found;
}

double mean_of(const Row& row) { return row.score.mean; }
double p95_of(const Row& row) { return row.score.p95; }
double psnr_of(const Row& row) { return row.score.psnr.value_or(0); }

void add_cpu(const Contested& pictures, const std::string& ours, std::vector<Target>& targets) {
  targets.push_back({ours + ": CPU, all pictures / pngquant's", summed_cpu_ratio(pictures, ours),
                     1.2, 0.8, true, ""});
  const Worst slow =
      worst(pictures, true, [&](const Picture& one) { return cpu_ratio(one, ours); });
  targets.push_back({ours + ": CPU, the worst picture", slow.figure, 3, 1.5, true, slow.picture});
}

/// In the small areas of each picture that has some, trivial or not.
void add_areas(const Pictures& pictures, std::vector<Target>& targets) {
  for (const Picture& one : pictures) {
    const Row *ours = one.find(kPerceptual), *theirs = one.find(kReference);
    if (!ours || !theirs || !ours->score.area || !theirs->score.area) continue;
    targets.push_back({"perceptual: CIEDE2000 in the small areas / pngquant's",
                       *ours->score.area / *theirs->score.area,
                       1,
                       {},
                       true,
                       one.name});
  }
}

/// Where nothing has to be chosen nothing may be lost. The lattice in bytes is what must be
/// reached; the one as seen is what a mapping by CIEDE2000 can.
void add_trivial(const Pictures& pictures, std::vector<Target>& targets) {
  for (const Picture& one : pictures) {
    if (!one.trivial()) continue;
    if (const Row* row = one.find(kPerceptual))
      targets.push_back({"perceptual: CIEDE2000 of a trivial picture (must: its floor)",
                         row->score.mean, one.floor.mean + 1e-9, one.floor_as_seen.mean + 1e-9,
                         true, one.name});
    if (const Row* row = one.find(kPsnr)) {
      constexpr double kEqual = std::numeric_limits<double>::infinity();
      targets.push_back({"psnr: PSNR of a trivial picture (must: its floor)",
                         row->score.psnr.value_or(kEqual),
                         one.floor.psnr.value_or(kEqual) - 1e-9,
                         {},
                         false,
                         one.name});
    }
  }
}

}  // namespace

const Row* Picture::find(const std::string& contender) const {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& row) { return row.contender == contender; });
  return found == rows.end() ? nullptr : &*found;
}

std::vector<const Picture*> contested(const Pictures& pictures, const std::string& a,
                                      const std::string& b) {
  Contested found;
  for (const Picture& one : pictures)
    if (!one.trivial() && one.find(a) && one.find(b)) found.push_back(&one);
  return found;
}

double summed_cpu_ratio(const std::vector<const Picture*>& pictures, const std::string& contender) {
  std::size_t rounds = pictures.front()->find(contender)->cpu_seconds.size();
  std::vector<double> ratios;
  for (std::size_t round = 0; round < rounds; ++round) {
    const Figure seconds = [&](const Row& row) { return row.cpu_seconds.at(round); };
    ratios.push_back(quotient(pictures, contender, seconds));
  }
  return median(ratios);
}

double cpu_ratio(const Picture& picture, const std::string& contender) {
  return summed_cpu_ratio({&picture}, contender);
}

std::vector<Target> plain_targets(const Pictures& pictures) {
  std::vector<Target> targets;
  if (const auto both = contested(pictures, kReference, kPerceptual); !both.empty()) {
    targets.push_back({"perceptual: mean CIEDE2000, all pictures / pngquant's",
                       quotient(both, kPerceptual, mean_of), 0.80, 0.77, true, ""});
    const Worst most = worst(both, true, [](const Picture& one) {
      return one.find(kPerceptual)->score.mean / one.find(kReference)->score.mean;
    });
    targets.push_back({"perceptual: mean CIEDE2000, the worst picture", most.figure, 0.92, 0.89,
                       true, most.picture});
    targets.push_back({"perceptual: 95 % of CIEDE2000, mean of the pictures / pngquant's",
                       quotient(both, kPerceptual, p95_of), 0.70, 0.65, true, ""});
    add_areas(pictures, targets);
    add_cpu(both, kPerceptual, targets);
  }
  if (const auto both = contested(pictures, kReference, kPsnr); !both.empty()) {
    const double gain = total(both, kPsnr, psnr_of) - total(both, kReference, psnr_of);
    targets.push_back({"psnr: dB above pngquant, mean of the pictures",
                       gain / static_cast<double>(both.size()), 0.2, 0.3, false, ""});
    const Worst least = worst(both, false, [](const Picture& one) {
      return psnr_of(*one.find(kPsnr)) - psnr_of(*one.find(kReference));
    });
    targets.push_back(
        {"psnr: dB above pngquant, the worst picture", least.figure, 0, {}, false, least.picture});
    add_cpu(both, kPsnr, targets);
  }
  add_trivial(pictures, targets);
  return targets;
}

std::vector<Target> dither_targets(const Pictures& pictures) {
  std::vector<Target> targets;
  const Figure blurred = [](const Row& row) { return row.score.blurred; };
  const Figure contours = [](const Row& row) { return row.score.contours; };
  for (const std::string ours : {kFloyd, kBlueNoise}) {
    if (const auto both = contested(pictures, kReference, ours); !both.empty()) {
      targets.push_back({ours + ": blurred CIEDE2000, mean of the pictures / pngquant's",
                         quotient(both, ours, blurred), 0.70, 0.62, true, ""});
      targets.push_back({ours + ": false contours, summed / pngquant's",
                         quotient(both, ours, contours), 0.5, 0.33, true, ""});
    }
    if (const auto both = contested(pictures, kPosterized, ours); !both.empty()) {
      targets.push_back({ours + ": blurred CIEDE2000 / that of pngquant, posterize 2",
                         quotient(both, ours, blurred, kPosterized),
                         {},
                         {},
                         true,
                         ""});
      targets.push_back({ours + ": false contours / those of pngquant, posterize 2",
                         quotient(both, ours, contours, kPosterized),
                         {},
                         {},
                         true,
                         ""});
    }
  }
  return targets;
}

}  // namespace sir::bench
