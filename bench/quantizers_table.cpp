#include "bench/quantizers_table.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/quantizers_peers.h"
#include "bench/timing.h"
#include "tracer/atomic_file.h"

namespace sir::bench {
namespace {

using Json = nlohmann::json;

void cell(const char* format, const std::optional<double>& figure) {
  char text[32] = "";
  if (figure) std::snprintf(text, sizeof text, format, *figure);
  std::printf(" %9s", text);
}

void heading(bool dithered) {
  std::printf("  %-24s %9s %9s %9s %9s", "", "PSNR dB", "CIEDE2000", "95 %", "in areas");
  if (dithered) std::printf(" %9s %9s", "blurred", "contours");
  std::printf(" %9s %9s\n", "CPU ms", "/pngquant");
}

void line(const std::string& name, const Score& score, std::optional<double> milliseconds,
          std::optional<double> ratio, bool dithered) {
  std::printf("  %-24s", name.c_str());
  if (score.psnr) cell("%.2f", score.psnr);
  else std::printf(" %9s", "no error");
  cell("%.3f", score.mean);
  cell("%.3f", score.p95);
  cell("%.3f", score.area);
  if (dithered) {
    cell("%.3f", score.blurred);
    cell("%.4f", score.contours);
  }
  cell("%.1f", milliseconds);
  cell("%.2f", ratio);
  std::printf("\n");
}

/// The means of some scores; what one of them lacks the mean lacks.
Score mean_of(const std::vector<Score>& scores) {
  const auto mean = [&](auto figure) {
    std::optional<double> sum = 0;
    for (const Score& one : scores) {
      const std::optional<double> here = figure(one);
      sum = sum && here ? std::optional(*sum + *here) : std::nullopt;
    }
    if (sum) *sum /= static_cast<double>(scores.size());
    return sum;
  };
  Score all;
  all.psnr = mean([](const Score& one) { return one.psnr; });
  all.mean = *mean([](const Score& one) { return std::optional(one.mean); });
  all.p95 = *mean([](const Score& one) { return std::optional(one.p95); });
  all.blurred = mean([](const Score& one) { return one.blurred; });
  all.contours = mean([](const Score& one) { return one.contours; });
  return all;
}

Json optional(const std::optional<double>& figure) { return figure ? Json(*figure) : Json(); }

Json json_of(const Score& score) {
  Json json{{"psnr", optional(score.psnr)}, {"de_mean", score.mean}, {"de_p95", score.p95}};
  if (score.area) json["de_area"] = *score.area;
  if (score.blurred) json["de_blurred"] = *score.blurred;
  if (score.contours) json["banding"] = *score.contours;
  return json;
}

}  // namespace

void print_picture(const Picture& picture, bool dithered) {
  std::printf("\n%s, %dx%d: %zu colours, %zu of them left by the DAC%s\n", picture.name.c_str(),
              picture.size.width, picture.size.height, picture.colours, picture.lattice,
              picture.trivial() ? "; TRIVIAL" : "");
  heading(dithered);
  line("floor: the DAC", picture.floor, {}, {}, dithered);
  if (picture.trivial()) line("floor: the same, as seen", picture.floor_as_seen, {}, {}, dithered);
  for (const Row& row : picture.rows)
    line(row.contender, row.score, 1e3 * median(row.cpu_seconds),
         picture.find(kReference) ? std::optional(cpu_ratio(picture, row.contender)) : std::nullopt,
         dithered);
  std::fflush(stdout);
}

void print_means(const Pictures& pictures, const std::vector<std::string>& contenders,
                 bool dithered) {
  std::vector<Score> floors;
  for (const Picture& one : pictures)
    if (!one.trivial()) floors.push_back(one.floor);
  if (floors.empty()) return;
  std::printf("\nmeans of %zu pictures, those left out that are trivial; CPU summed\n",
              floors.size());
  heading(dithered);
  line("floor: the DAC", mean_of(floors), {}, {}, dithered);
  for (const std::string& name : contenders) {
    const auto with = contested(pictures, name, name);
    if (with.empty()) continue;
    std::vector<Score> scores;
    double milliseconds = 0;
    for (const Picture* one : with) {
      scores.push_back(one->find(name)->score);
      milliseconds += 1e3 * median(one->find(name)->cpu_seconds);
    }
    const auto paired = contested(pictures, kReference, name);
    line(with.size() == floors.size() ? name : name + " *", mean_of(scores), milliseconds,
         paired.empty() ? std::nullopt : std::optional(summed_cpu_ratio(paired, name)), dithered);
    if (with.size() != floors.size())
      std::printf("  * of %zu pictures only: it failed on the others\n", with.size());
  }
}

int print_targets(const std::vector<Target>& targets) {
  int missed = 0;
  if (targets.empty()) return missed;
  std::printf("\n%-70s %9s %9s %9s\n", "", "measured", "must", "aim");
  for (const Target& one : targets) {
    std::printf("%-70s", one.what.c_str());
    cell("%.4g", one.measured);
    cell("%.4g", one.must);
    cell("%.4g", one.aim);
    missed += !one.met(one.must);
    const char* const verdict = !one.met(one.must)            ? "MISSED"
                                : one.aim && one.met(one.aim) ? "aim met"
                                : one.must                    ? "met"
                                                              : "";
    std::printf("  %s%s%s\n", verdict, one.note.empty() ? "" : ": ", one.note.c_str());
  }
  std::printf("%d missed\n", missed);
  return missed;
}

void write_json(const std::string& path, const Pictures& pictures,
                const std::vector<Target>& targets) {
  Json json{{"pictures", Json::array()}, {"targets", Json::array()}};
  for (const Picture& one : pictures) {
    Json picture{{"name", one.name},
                 {"width", one.size.width},
                 {"height", one.size.height},
                 {"colours", one.colours},
                 {"lattice_colours", one.lattice},
                 {"trivial", one.trivial()},
                 {"floor", json_of(one.floor)},
                 {"contenders", Json::object()}};
    if (one.trivial()) picture["floor_as_seen"] = json_of(one.floor_as_seen);
    for (const Row& row : one.rows) {
      Json& contender = picture["contenders"][row.contender] = json_of(row.score);
      contender["cpu_seconds"] = median(row.cpu_seconds);
      if (one.find(kReference)) contender["cpu_ratio"] = cpu_ratio(one, row.contender);
    }
    json["pictures"].push_back(std::move(picture));
  }
  for (const Target& one : targets)
    json["targets"].push_back({{"what", one.what},
                               {"measured", one.measured},
                               {"must", optional(one.must)},
                               {"must", optional(one.must)},
                               {"aim", optional(one.aim)},
                               {"met", one.met(one.must)},
                               {"picture", one.note}});
  AtomicFile file(path);
  file.write(json.dump(2) + "\n");
  file.commit();
}

}  // namespace sir::bench
