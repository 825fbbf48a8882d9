#include "bench/speed_duel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "bench/child.h"
#include "interchange/pov_export.h"
#include "tracer/scene_file.h"
#include "viewer/png_file.h"

namespace sir::bench {
namespace {

// POV-Ray's images differ from ours by a level here and there, by more at single pixels where
// one of both just misses an edge. More than these are another picture.
constexpr int kFar = 16;            // levels
constexpr double kMostFar = 0.001;  // of the pixels

using Words = std::vector<std::string>;

Words sir_words(const Contest& contest, const Arena& arena, const std::string& precision) {
  return {
      arena.sir,     "-q",
      "render",      "ours",
      "--size",      std::to_string(contest.size.width) + "x" + std::to_string(contest.size.height),
      "--depth",     std::to_string(contest.depth),
      "--precision", precision,
      "--threads",   "1",
      "--no-png",    "--out",
      "planes"};
}

// The arguments in the exported file's head, on one thread; for timing without the image.
Words pov_words(const Contest& contest, bool with_image) {
  Words words{"povray"};
  for (const std::string& word : pov_arguments("theirs.pov", "theirs.png", contest.size))
    if (with_image || (!word.starts_with("+O") && !word.starts_with("+F"))) words.push_back(word);
  if (!with_image) words.push_back("-F");
  words.push_back("+WT1");
  return words;
}

double seconds_of(const Words& words) {
  const auto used = child_cpu_seconds(words);
  if (!used) throw std::runtime_error("cannot run " + words[0]);
  return *used;
}

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
  seconds_of(sir_words(contest, arena, "double"));
  seconds_of(pov_words(contest, true));
  const Planes ours = read_planes(arena.folder / "planes" / "ours", contest.size);
  const Difference difference = compare(ours, viewer::read_png(arena.folder / "theirs.png"));
  const std::size_t pixels = contest.size.pixels();
  const bool same = static_cast<double>(difference.far) <= kMostFar * static_cast<double>(pixels);
  std::printf("%-26s %zu of %zu pixels differ, %zu by more than %d levels%s\n",
              contest.name.c_str(), difference.any, pixels, difference.far, kFar,
              same ? "" : "   NOT THE SAME PICTURE, not timed");
  return same;
}

}  // namespace

bool has_povray() { return child_cpu_seconds({"povray", "--help"}).has_value(); }

bool run_contest(const Contest& contest, const Arena& arena, SpeedTable& table) {
  write_scene(arena.folder / "ours", contest.ours);
  if (arena.povray) {
    PovOptions options;
    options.file = "theirs.pov";
    options.depth_limit = contest.depth;
    options.size = contest.size;
    // Scaled up POV-Ray takes every object for infinite (a box of more than 2e10 is) and has no
    // use for its boxes: several times slower.
    options.scale = PovScale::keep;
    std::ofstream(arena.folder / "theirs.pov") << pov_text(contest.theirs, options);
    if (!same_picture(contest, arena)) return false;
  }
  std::vector<double> in_double, in_float, pov;
  for (int round = 0; round < arena.rounds; ++round) {
    in_double.push_back(seconds_of(sir_words(contest, arena, "double")));
    if (arena.povray) pov.push_back(seconds_of(pov_words(contest, false)));
    in_float.push_back(seconds_of(sir_words(contest, arena, "float")));
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

void compare_pixels(const Contest& contest, const Arena& arena, SpeedTable& table) {
  if (!arena.povray) return;
  Contest one = contest, small = contest, large = contest;
  one.size = {1, 1};
  large.size = {500, 500};
  const auto pixels = [](const Contest& of) { return static_cast<double>(of.size.pixels() - 1); };
  std::vector<double> ours, theirs;
  for (int round = 0; round < arena.rounds; ++round) {
    const double start = seconds_of(sir_words(one, arena, "double"));
    const double pov_start = seconds_of(pov_words(one, false));
    ours.push_back((seconds_of(sir_words(large, arena, "double")) - start) / pixels(large));
    theirs.push_back((seconds_of(pov_words(small, false)) - pov_start) / pixels(small));
  }
  char detail[64];
  std::snprintf(detail, sizeof detail, "a pixel: POV %.0f us / double %.2f us",
                1e6 * Quartiles(theirs).middle, 1e6 * Quartiles(ours).middle);
  table.line(contest.name, detail, Quartiles(ratios(theirs, ours)));
}

double peak_megabytes(const Scene& scene, ImageSize size, const Arena& arena) {
  write_scene(arena.folder / "ours", scene);
  Contest contest;
  contest.size = size;
  const auto used = child_use(sir_words(contest, arena, "double"));
  if (!used) throw std::runtime_error("cannot run " + arena.sir);
  return static_cast<double>(used->peak_kilobytes) / 1024;
}

}  // namespace sir::bench
