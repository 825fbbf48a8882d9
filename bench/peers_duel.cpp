#include "bench/peers_duel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "bench/child.h"
#include "bench/peers_programs.h"
#include "tracer/scene_file.h"
#include "viewer/png_file.h"

namespace sir::bench {
namespace {

// POV-Ray's images differ from ours by a level here and there, by more at single pixels where
// one of both just misses an edge. More than these are another picture.
constexpr int kFar = 16;            // levels
constexpr double kMostFar = 0.001;  // of the pixels

constexpr ImageSize kWhole{500, 500};

double our_seconds(const Contest& contest, const Arena& arena, const char* precision) {
  return seconds_of(sir_words(arena.sir, contest.size, contest.depth, precision));
}

// On one thread and without an image.
double pov_seconds(const Contest& contest) { return seconds_of(pov_words(contest.size, 1, false)); }

struct Difference {
  std::size_t any = 0, far = 0;
};

Difference compare(const Planes& a, const Planes& b) {
  if (a.size != b.size) throw std::runtime_error("POV-Ray's image has another size");
  Difference difference;
  for (std::size_t p = 0; p < a.size.pixels(); ++p) {
    const Rgb8 x = a.at(p), y = b.at(p);
    const int most = std::max({std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b)});
    difference.any += most > 0;
    difference.far += most > kFar;
  }
  return difference;
}

// `sir` with the planes, POV-Ray with its PNG.
bool same_picture(const Contest& contest, const Arena& arena) {
  our_seconds(contest, arena, "double");
  seconds_of(pov_words(contest.size, 1, true));
  const Planes ours = read_planes(arena.folder / "planes" / "ours", contest.size);
  const Difference difference = compare(ours, viewer::read_png(arena.folder / "theirs.png"));
  const std::size_t pixels = contest.size.pixels();
  const bool same = static_cast<double>(difference.far) <= kMostFar * static_cast<double>(pixels);
  std::printf("%-23s %zu of %zu pixels differ, %zu by more than %d levels%s\n",
              contest.name.c_str(), difference.any, pixels, difference.far, kFar,
              same ? "" : "   NOT THE SAME PICTURE, not timed");
  return same;
}

}  // namespace

bool run_contest(const Contest& contest, const Arena& arena, SpeedTable& table) {
  write_scene(arena.folder / "ours", contest.ours);
  if (arena.povray) {
    write_pov(arena.folder, contest.theirs, contest.size, contest.depth);
    if (!same_picture(contest, arena)) return false;
  }
  std::vector<double> in_double, in_float, pov;
  for (int round = 0; round < arena.rounds; ++round) {
    in_double.push_back(our_seconds(contest, arena, "double"));
    if (arena.povray) pov.push_back(pov_seconds(contest));
    in_float.push_back(our_seconds(contest, arena, "float"));
  }
  const auto tell = [&](const char* precision, const std::vector<double>& ours, Demand demand) {
    const Quartiles seconds(ours);
    char detail[64];
    if (!arena.povray) {
      table.line(contest.name, std::string(precision) + ", s", seconds);
      return;
    }
    std::snprintf(detail, sizeof detail, "POV %.3f s / %s %.3f s", Quartiles(pov).middle, precision,
                  seconds.middle);
    table.line(contest.name, detail, Quartiles(ratios(pov, ours)), demand);
  };
  tell("double", in_double, contest.in_double);
  tell("float", in_float, contest.in_float);
  return true;
}

void run_extrapolated(const Contest& contest, const Arena& arena, SpeedTable& table) {
  if (!arena.povray) return;
  Contest one = contest, small = contest, large = contest;
  one.size = {1, 1};
  large.size = kWhole;
  std::vector<double> ours, theirs;
  for (int round = 0; round < arena.rounds; ++round) {
    ours.push_back(our_seconds(large, arena, "double"));
    const double start = pov_seconds(one);
    const double pixel = (pov_seconds(small) - start) / double(small.size.pixels() - 1);
    theirs.push_back(start + pixel * double(large.size.pixels() - 1));
  }
  char detail[64];
  std::snprintf(detail, sizeof detail, "POV about %.0f s / double %.3f s", Quartiles(theirs).middle,
                Quartiles(ours).middle);
  table.line(contest.name.substr(0, contest.name.find(' ')) + " 500x500", detail,
             Quartiles(ratios(theirs, ours)), contest.in_double);
}

double peak_megabytes(const Scene& scene, ImageSize size, const Arena& arena) {
  write_scene(arena.folder / "ours", scene);
  const auto used = child_use(sir_words(arena.sir, size, 1, "double"));
  if (!used) throw std::runtime_error("cannot run " + arena.sir);
  return static_cast<double>(used->peak_kilobytes) / 1024;
}

}  // namespace sir::bench
