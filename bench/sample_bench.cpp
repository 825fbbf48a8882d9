// What does antialiasing cost, and what does it give? What does it cost to show an image
// coarse to fine? Usage: sample_bench [BASE [WxH]]
// Times are of the processor, all threads together. Runs are interleaved; a ratio is the median of
// each round's ratio to the plain image of that round. PSNR is against 256 scattered samples a
// pixel with another seed. Exit code 1 where the progressive image differs from the plain one.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "tracer/sample_progressive.h"
#include "tracer/scene_file.h"

namespace {

using sir::bench::median;
using namespace sir;

const int kRounds = sir::bench::rounds(7);

struct Choice {
  std::string name;
  AntialiasOptions options;
};

std::vector<Choice> choices() {
  std::vector<Choice> list{{"none", {}}};
  for (const auto& [threshold, levels] :
       {std::pair{255, 0}, {64, 2}, {16, 1}, {16, 2}, {16, 3}, {4, 2}, {4, 3}}) {
    Choice choice{"adaptive:" + std::to_string(threshold) + ":" + std::to_string(levels), {}};
    choice.options.mode = Antialias::adaptive;
    choice.options.threshold = threshold;
    choice.options.levels = levels;
    list.push_back(choice);
  }
  for (const int samples : {1, 4, 7, 16, 64}) {
    Choice choice{"random:" + std::to_string(samples), {}};
    choice.options.mode = Antialias::random;
    choice.options.samples = samples;
    list.push_back(choice);
  }
  return list;
}

double psnr(const Planes& a, const Planes& b) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t p = 0; p < a.size.pixels(); ++p)
      sum += std::pow(double(a.channel[c][p]) - double(b.channel[c][p]), 2);
  return 10 * std::log10(255.0 * 255.0 * 3 * double(a.size.pixels()) / sum);
}

double processor_ms() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

template <typename Work>
double milliseconds(Work work) {
  const double start = processor_ms();
  work();
  return processor_ms() - start;
}

std::uint64_t all_rays(const RayCounts& rays) {
  return rays.primary + rays.reflected + rays.refracted + rays.shadow;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string base = argc > 1 ? argv[1] : "images/whitted";
  RenderOptions options;
  options.size = {320, 240};
  if (argc > 2 && (std::sscanf(argv[2], "%dx%d", &options.size.width, &options.size.height) != 2 ||
                   options.size.width < 1 || options.size.height < 1)) {
    std::fprintf(stderr, "usage: sample_bench [BASE [WxH]]\n");
    return 2;
  }
  const Scene scene = read_scene(base);
  const std::vector<Choice> list = choices();
  RenderOptions fine = options;
  fine.antialias.mode = Antialias::random;
  fine.antialias.samples = 256;
  fine.antialias.seed = 1000;
  const Planes reference = render(scene, fine).planes;

  std::vector<std::vector<double>> times(list.size()), ratios(list.size());
  std::vector<RenderResult> results(list.size());
  std::vector<double> progressive_ratios, first_ratios;
  bool equal = true;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t n = 0; n < list.size(); ++n) {
      options.antialias = list[n].options;
      times[n].push_back(milliseconds([&] { results[n] = render(scene, options); }));
      ratios[n].push_back(times[n].back() / times[0].back());
    }
    options.antialias = {};
    RenderResult finished;
    const double start = processor_ms();
    double first = 0;
    const auto show = [&](const Planes&, const Stage& stage) {
      if (stage.block == 16) first = processor_ms() - start;
    };
    const double total = milliseconds([&] { finished = render_progressive(scene, options, show); });
    progressive_ratios.push_back(total / times[0].back());
    first_ratios.push_back(first / times[0].back());
    equal = equal && finished.planes == results[0].planes;
  }
  const auto plain_rays = static_cast<double>(all_rays(results[0].counts));
  std::printf("%s, %dx%d, %d rounds\n", base.c_str(), options.size.width, options.size.height,
              kRounds);
  std::printf("%-16s %10s %8s %12s %8s %8s\n", "", "CPU ms", "ratio", "rays a pixel", "rays",
              "PSNR");
  for (std::size_t n = 0; n < list.size(); ++n)
    std::printf("%-16s %10.1f %8.2f %12.2f %8.2f %8.2f\n", list[n].name.c_str(), median(times[n]),
                median(ratios[n]),
                double(results[n].counts.primary) / double(options.size.pixels()),
                static_cast<double>(all_rays(results[n].counts)) / plain_rays,
                psnr(reference, results[n].planes));
  std::printf("progressive: total %.3f of plain, first picture after %.4f of it%s\n",
              median(progressive_ratios), median(first_ratios), equal ? "" : ", IMAGES DIFFER");
  return equal ? 0 : 1;
}
