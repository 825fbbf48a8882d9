// How well 256 colours of 6 bits a primary are chosen by `sir` and by its peers, and at what cost.
// Usage: quantizers SIR DIR [--rounds N] [--only NAME,...] [--dither] [--json FILE]
//        quantizers SIR DIR --side-by-side NAME,... --out DIR
// SIR is the program, DIR holds NAME.png and, where there are small coloured areas, NAME.area.png
// (tools/quantizer-pictures makes such a folder). Each peer's palette is rounded to the DAC's bits
// and every pixel takes the nearest rounded colour; ours is the PNG that it shows. The programs
// take turns within each round; printed are medians, and the medians of the rounds' ratios. What
// is not installed is left out. Exit code 1 where a program fails or one of ours shows a colour
// that its LUT does not have; a target that is missed is told, no more.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/quantizers_judge.h"
#include "bench/quantizers_peers.h"
#include "bench/quantizers_results.h"
#include "bench/quantizers_side.h"
#include "bench/quantizers_table.h"
#include "tests/temp_folder.h"
#include "viewer/png_file.h"

namespace {

namespace fs = std::filesystem;
using namespace sir;
using namespace sir::bench;

struct Settings {
  std::string sir, folder, json, out;
  std::vector<std::string> only, views;
  int rounds = 5;
  bool dither = false;
};

/// NAME of each NAME.png of a folder but the areas, in order; `only` these, where there are any.
std::vector<std::string> names_in(const fs::path& folder, const std::vector<std::string>& only) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png" && entry.path().stem().extension() != ".area")
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  if (only.empty()) return names;
  for (const std::string& one : only)
    if (!std::binary_search(names.begin(), names.end(), one))
      throw std::runtime_error("no " + (folder / one).string() + ".png");
  return only;
}

/// A flag a pixel, set where NAME.area.png is light; nothing without that file.
std::vector<bool> area_of(const fs::path& folder, const std::string& name, ImageSize size) {
  const fs::path path = folder / (name + ".area.png");
  if (!fs::exists(path)) return {};
  const Planes mask = viewer::read_png(path);
  if (mask.size != size) throw std::runtime_error(path.string() + " has another size");
  std::vector<bool> area;
  for (std::size_t i = 0; i < size.pixels(); ++i) area.push_back(mask.at(i).g >= 128);
  return area;
}

/// A program that failed on a picture: told, and the run goes on.
class Failures {
 public:
  void add(const std::string& picture, const std::string& contender, const std::string& why) {
    std::printf("FAILED on %s: %s: %s\n", picture.c_str(), contender.c_str(), why.c_str());
    ++count_;
  }
  int count() const { return count_; }

 private:
  int count_ = 0;
};

/// All contenders on one picture, in turns.
std::vector<Row> run_rounds(const std::string& picture, const std::vector<Contender>& contenders,
                            int rounds, const fs::path& scratch, Failures& failures) {
  const std::string name = fs::path(picture).stem().string();
  std::vector<Row> rows(contenders.size());
  std::vector<bool> failed(contenders.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i) try {
        const Contender& one = contenders[i];
        rows[i].contender = one.name;
        if (!failed[i])
          rows[i].cpu_seconds.push_back(run_contender(one, picture, (scratch / one.slug).string()));
      } catch (const std::exception& error) {
        failures.add(name, contenders[i].name, error.what());
        failed[i] = true;
      }
  std::vector<Row> done;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!failed[i]) done.push_back(rows[i]);
  return done;
}

Picture measured(const std::string& name, const std::vector<Contender>& contenders,
                 const Settings& settings, const fs::path& scratch, Failures& failures) {
  const fs::path path = fs::path(settings.folder) / (name + ".png");
  const Planes reference = viewer::read_png(path);
  const std::vector<bool> area = area_of(settings.folder, name, reference.size);
  const Planes lattice = on_the_lattice(reference);
  Picture picture{.name = name,
                  .size = reference.size,
                  .colours = colours_of(reference),
                  .lattice = colours_of(lattice),
                  .floor = judge(reference, lattice, area, settings.dither),
                  .floor_as_seen = {},
                  .rows = {}};
  if (picture.trivial())
    picture.floor_as_seen =
        judge(reference, on_the_lattice_as_seen(reference), area, settings.dither);
  for (Row& row : run_rounds(path.string(), contenders, settings.rounds, scratch, failures)) try {
      const auto one = std::find_if(contenders.begin(), contenders.end(),
                                    [&](const Contender& c) { return c.name == row.contender; });
      const Planes shown = shown_by(*one, reference, (scratch / one->slug).string());
      row.score = judge(reference, shown, area, settings.dither);
      picture.rows.push_back(row);
    } catch (const std::exception& error) {
      failures.add(name, row.contender, error.what());
    }
  return picture;
}

/// The original, pngquant's and ours.
void side_by_side(const std::vector<Contender>& contenders, const Settings& settings,
                  const fs::path& scratch) {
  fs::create_directories(settings.out);
  for (const std::string& text : settings.views) {
    const View view = view_of(text);
    const fs::path path = fs::path(settings.folder) / (view.name + ".png");
    std::vector<Planes> images{viewer::read_png(path)};
    std::string what = "original";
    for (const Contender& one : contenders) {
      if (one.name != kReference && one.name != kPerceptual) continue;
      const std::string own = (scratch / one.slug).string();
      run_contender(one, path.string(), own);
      images.push_back(shown_by(one, images.front(), own));
      what += " | " + one.name;
    }
    const fs::path sheet = fs::path(settings.out) / (view.name + ".png");
    write_side_by_side(sheet, images, view);
    std::printf("%s: %s\n", sheet.c_str(), what.c_str());
  }
}

int run(const Settings& settings) {
  const sir::test::TempFolder scratch;
  const std::string folder = scratch.path().string(), program = fs::absolute(settings.sir).string();
  if (!fs::exists(program)) throw std::runtime_error("no program " + program);
  std::vector<Contender> contenders;
  std::vector<std::string> names;
  for (Contender& one : settings.dither ? dithering_contenders(program, folder)
                                        : plain_contenders(program, folder)) {
    if (!one.missing.empty()) {
      std::printf("left out: %s: %s\n", one.name.c_str(), one.missing.c_str());
      continue;
    }
    names.push_back(one.name);
    contenders.push_back(std::move(one));
  }
  if (!settings.views.empty()) {
    side_by_side(contenders, settings, scratch.path());
    return 0;
  }
  Failures failures;
  Pictures pictures;
  for (const std::string& name : names_in(settings.folder, settings.only)) {
    pictures.push_back(measured(name, contenders, settings, scratch.path(), failures));
    print_picture(pictures.back(), settings.dither);
  }
  print_means(pictures, names, settings.dither);
  const auto targets = settings.dither ? dither_targets(pictures) : plain_targets(pictures);
  print_targets(targets);
  if (!settings.json.empty()) write_json(settings.json, pictures, targets);
  if (failures.count() > 0) std::printf("%d FAILED\n", failures.count());
  return failures.count() == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) try {
  // pngquant's OpenMP threads wait busily for one another: where other programs run beside them
  // that triples its CPU time, to our favour. On one thread it does the same work.
  ::setenv("OMP_NUM_THREADS", "1", 1);
  Settings settings;
  CLI::App app("How well 256 colours are chosen for the MA120, by `sir` and by its peers");
  app.add_option("SIR", settings.sir, "the program `sir`")->required();
  app.add_option("DIR", settings.folder, "the pictures: NAME.png, NAME.area.png")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--rounds", settings.rounds, "rounds (5)")->check(CLI::Range(1, 1000));
  app.add_option("--only", settings.only, "these pictures, separated by commas")->delimiter(',');
  app.add_flag("--dither", settings.dither, "the dithered contest, judged after a blur");
  app.add_option("--json", settings.json, "write the figures as JSON");
  auto* const out = app.add_option("--out", settings.out, "folder of --side-by-side");
  app.add_option("--side-by-side", settings.views,
                 "write OUT/NAME.png: original, pngquant's, ours; NAME:WxH+X+Y shows a part, its "
                 "pixels doubled")
      ->delimiter(',')
      ->needs(out);
  CLI11_PARSE(app, count, arguments);
  return run(settings);
} catch (const std::exception& error) {
  std::fprintf(stderr, "quantizers: %s\n", error.what());
  return 1;
}
