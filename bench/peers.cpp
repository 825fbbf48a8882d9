// How fast `sir` is beside its peers, POV-Ray 3.7 and Embree 3, and how its times grow.
// Usage: peers [--parts LIST] [--rounds N] [--frames N] [--images DIR] [--sir PROGRAM]
// All of it takes several minutes. Without a peer the rest is measured. Exit code 1 where images
// are not the same picture, hits not the same hits, or a program fails; a figure that is missed
// is told, no more: it depends on the machine.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/peers_duel.h"
#include "bench/peers_embree.h"
#include "bench/peers_growth.h"
#include "bench/peers_orbit.h"
#include "bench/peers_programs.h"
#include "bench/scenes.h"
#include "tests/temp_folder.h"
#include "tracer/scene_file.h"

namespace {

namespace fs = std::filesystem;
using namespace sir;
using namespace sir::bench;
using Cut = MadeScene::Cut;

const std::vector<std::string> kParts = {"memory", "primitives", "cut",    "whitted", "images",
                                         "growth", "threads",    "embree", "orbit"};

struct Settings {
  std::vector<std::string> parts = kParts;
  int rounds = 5, frames = 36;
  std::string sir, images = "images";

  bool wants(const std::string& part) const {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  }
};

Contest made_contest(const MadeScene& ours, const MadeScene& theirs, ImageSize size) {
  return {.name = ours.name(),
          .ours = made_scene(ours),
          .theirs = made_scene(theirs),
          .size = size,
          .depth = 1,
          .in_double = {},
          .in_float = {}};
}

bool duel_of_primitives(const Arena& arena, SpeedTable& table) {
  table.begin("whole frames: 500x500, one light, shadows, depth 1; POV-Ray's time / ours");
  bool same = true;
  for (const int primitives : kSizes) {
    const MadeScene made{.primitives = primitives};
    Contest contest = made_contest(made, made, {500, 500});
    contest.in_double = {6, 10};
    contest.in_float = {15, 0};
    same = run_contest(contest, arena, table) && same;
  }
  return same;
}

bool duel_of_cuts(Arena arena, SpeedTable& table) {
  arena.rounds = std::min(arena.rounds, 3);
  table.begin("the whole less a cube; POV-Ray's time / ours");
  std::printf(
      "POV-Ray is given the tree as it is (cut-N); at 3,000 and 30,000 it is so slow that it "
      "renders a small\nimage (ours is start, reading and preparing then) and its time for the "
      "whole is extrapolated\nfrom that; and distributed over the solids by hand (cut-N by hand), "
      "at 500x500, while ours stays\nas it is.\n");
  constexpr int kSides[] = {500, 50, 8};
  bool same = true;
  for (std::size_t i = 0; i < std::size(kSizes); ++i) {
    const MadeScene cut{.primitives = kSizes[i], .cut = Cut::root};
    Contest contest = made_contest(cut, cut, {kSides[i], kSides[i]});
    contest.name += " " + std::to_string(kSides[i]) + "x" + std::to_string(kSides[i]);
    const bool whole = kSides[i] == 500;
    if (whole) contest.in_double = contest.in_float = {30, 60};
    same = run_contest(contest, arena, table) && same;
    contest.in_double = {30, 60};
    if (!whole) run_extrapolated(contest, arena, table);
  }
  for (const int primitives : kSizes) {
    const MadeScene cut{.primitives = primitives, .cut = Cut::root};
    const MadeScene by_hand{.primitives = primitives, .cut = Cut::distributed};
    Contest contest = made_contest(cut, by_hand, {500, 500});
    contest.name += " by hand";
    same = run_contest(contest, arena, table) && same;
  }
  return same;
}

bool duel_of_files(const std::vector<std::string>& names, int depth, Demand demand,
                   const Settings& settings, const Arena& arena, SpeedTable& table) {
  bool same = true;
  for (const std::string& name : names) {
    const Scene scene = read_scene(fs::path(settings.images) / name);
    same =
        run_contest({name, scene, scene, {640, 480}, depth, demand, demand}, arena, table) && same;
  }
  return same;
}

int run(Settings settings) {
  const sir::test::TempFolder scratch;
  settings.sir = fs::absolute(settings.sir).string();
  settings.images = fs::absolute(settings.images).string();
  Arena arena{settings.sir, scratch.path(), has_povray(), settings.rounds};
  // POV-Ray may be allowed to read and write in the working folder only.
  fs::current_path(scratch.path());
  if (!arena.povray) std::printf("No POV-Ray: our own figures only. Debian's package is povray.\n");
  SpeedTable table;
  bool same = true;
  // First: what this process has itself is counted for those that it starts.
  if (settings.wants("memory")) {
    table.begin("memory");
    const MadeScene made{.primitives = 30'000};
    table.line(made.name(), "peak of the process, MB",
               Quartiles({peak_megabytes(made_scene(made), {500, 500}, arena)}), {60, 0, true});
  }
  if (settings.wants("primitives")) same = duel_of_primitives(arena, table) && same;
  if (settings.wants("cut")) same = duel_of_cuts(arena, table) && same;
  if (settings.wants("whitted")) {
    table.begin("whitted: 640x480, depth 5; POV-Ray's time / ours");
    same = duel_of_files({"whitted"}, 5, {4, 7}, settings, arena, table) && same;
  }
  if (settings.wants("images")) {
    table.begin("the five images: 640x480, depth 5; POV-Ray's time / ours");
    arena.rounds = std::min(arena.rounds, 3);
    same = duel_of_files({"whitted", "calice", "luminar", "piramide", "lcg"}, 5, {5, 10}, settings,
                         arena, table) &&
           same;
  }
  if (settings.wants("growth")) measure_growth(settings.rounds, table);
  if (settings.wants("threads")) measure_threads(settings.rounds, table);
  if (settings.wants("embree")) same = measure_embree(settings.rounds, table) && same;
  if (settings.wants("orbit"))
    measure_orbit(read_scene(fs::path(settings.images) / "whitted"), settings.rounds,
                  settings.frames, arena.povray, scratch.path(), table);
  std::printf("\n%d missed%s\n", table.missed(), same ? "" : "; NOT THE SAME");
  fs::current_path("/");
  return same ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) try {
  Settings settings;
  settings.sir = (fs::path(arguments[0]).parent_path() / "sir").string();
  CLI::App app(
      "How fast `sir` is, beside POV-Ray 3.7 and Embree 3 and by the number of primitives");
  app.add_option("--parts", settings.parts,
                 "of memory, primitives, cut, whitted, images, growth, threads, embree, orbit, "
                 "separated by commas (all)")
      ->delimiter(',')
      ->check(CLI::IsMember(kParts));
  app.add_option("--rounds", settings.rounds,
                 "rounds (5; of the cuts and the five images 3 at most)")
      ->check(CLI::Range(1, 1000));
  app.add_option("--frames", settings.frames, "frames of an orbit (36)")
      ->check(CLI::Range(1, 10'000));
  app.add_option("--images", settings.images, "folder of the five images (images)");
  app.add_option("--sir", settings.sir, "the program (beside this one)");
  CLI11_PARSE(app, count, arguments);
  return run(settings);
} catch (const std::exception& error) {
  std::fprintf(stderr, "peers: %s\n", error.what());
  return 1;
}
