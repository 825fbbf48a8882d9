// sir cost of a scene, from outside.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "tests/cli_fixture.h"
#include "tracer/planes.h"

namespace sir::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

// A scene of 16x12 pixels, priced quickly.
class CostCommand : public CliTest {
 protected:
  Ended cost(const Words& more) const {
    Words words{"cost", "s", "--size", "16x12", "--repeats", "2", "--truth-samples", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return sir(words);
  }
};

using Table = std::vector<std::vector<std::string>>;

// RFC 4180.
Table parse_csv(const std::string& text) {
  Table table(1, {""});
  bool within = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (within) {
      if (c != '"') table.back().back() += c;
      else if (i + 1 < text.size() && text[i + 1] == '"') table.back().back() += text[i++];
      else within = false;
    } else if (c == '"') {
      within = true;
    } else if (c == ',') {
      table.back().emplace_back();
    } else if (c == '\n') {
      table.push_back({""});
    } else if (c != '\r') {
      table.back().back() += c;
    }
  }
  EXPECT_FALSE(within);
  EXPECT_EQ(table.back(), std::vector<std::string>{""}) << "no end of line at the end";
  table.pop_back();
  return table;
}

// As the CSV has a value of the JSON.
void expect_same(const std::string& cell, const json& row, const std::string& key) {
  if (!row.contains(key)) EXPECT_EQ(cell, "") << key;
  else if (row[key].is_null()) EXPECT_EQ(cell, "inf") << key;
  else if (row[key].is_boolean()) EXPECT_EQ(cell, row[key].get<bool>() ? "true" : "false") << key;
  else if (row[key].is_string()) EXPECT_EQ(cell, row[key].get<std::string>()) << key;
  else EXPECT_EQ(std::strtod(cell.c_str(), nullptr), row[key].get<double>()) << key << " " << cell;
}

TEST_F(CostCommand, JsonAndCsvHoldTheSame) {
  const Ended ended = cost({"--json", "--csv", "a.csv"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const json report = json::parse(ended.out);
  const json& image = report["images"][0];
  EXPECT_EQ(image["image"], "s");
  EXPECT_EQ(image["size"], json({16, 12}));
  EXPECT_EQ(report["repeats"], 2);
  EXPECT_EQ(report["truth_samples"], 4);
  json rows = image["tracer"]["rows"];
  const std::size_t of_tracer = rows.size();
  for (const json& row : image["rows"]) rows.push_back(row);

  const Table table = parse_csv(folder.read("a.csv"));
  ASSERT_EQ(table.size(), rows.size() + 1);
  const auto& keys = table[0];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(table[i + 1].size(), keys.size());
    EXPECT_EQ(table[i + 1][0], "s");
    EXPECT_EQ(table[i + 1][1], i < of_tracer ? "tracer" : "lut");
    for (std::size_t k = 2; k < keys.size(); ++k) expect_same(table[i + 1][k], rows[i], keys[k]);
    for (const auto& [key, value] : rows[i].items())
      EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << key;
    EXPECT_GT(rows[i]["ms"], 0);
    EXPECT_LE(rows[i]["ms_low"], rows[i]["ms"]);
    EXPECT_LE(rows[i]["ms"], rows[i]["ms_high"]);
    EXPECT_GE(rows[i]["runs"], 1);
    EXPECT_LE(rows[i]["runs"], 2);
  }
  EXPECT_FALSE(image["tracer"]["sentences"].empty());
  EXPECT_FALSE(image["sentences"].empty());
}

const json& row_of(const json& rows, const std::string& choice) {
  for (const json& row : rows)
    if (row["choice"] == choice) return row;
  throw std::runtime_error("no row " + choice);
}

TEST_F(CostCommand, EveryKnobHasItsRows) {
  const json image = json::parse(cost({"--json"}).out)["images"][0];
  std::map<std::string, int> rows;
  for (const json& row : image["tracer"]["rows"]) ++rows[row.value("knob", "default")];
  EXPECT_EQ(rows["default"], 1);
  EXPECT_EQ(rows["depth"], 9);  // and the default's
  for (const char* knob : {"precision", "formulas", "cutoff", "antialias", "preview", "combined"})
    EXPECT_GE(rows[knob], 1) << knob;
  rows.clear();
  for (const json& row : image["rows"]) ++rows[row.value("knob", "default")];
  for (const char* knob : {"method", "grid", "sample", "nearest", "combined"})
    EXPECT_GE(rows[knob], 1) << knob;
  EXPECT_EQ(rows["effort"], 10);  // five for each goal
  EXPECT_EQ(rows["map"], 2);
  EXPECT_EQ(rows["dither"], 4);
  // The default is what `sir render` renders, so its picture differs from itself nowhere.
  EXPECT_EQ(image["tracer"]["rows"][0]["changed"], 0);
  EXPECT_EQ(image["tracer"]["rows"][0]["ratio"], 1);
  EXPECT_EQ(image["rows"][0]["choice"], "median hsv --split pixels");
}

TEST_F(CostCommand, WhatIsTheTruthItselfHasNoError) {
  const json image = json::parse(cost({"--json"}).out)["images"][0];
  const json& rows = image["tracer"]["rows"];
  EXPECT_EQ(row_of(rows, "long double")["rounded"], 0);
  const json& best = row_of(rows, "long double, depth 10");
  EXPECT_EQ(best["points_pixels"], 0);
  EXPECT_EQ(best["points_largest"], 0);
  EXPECT_EQ(best["points_de_mean"], 0);
  EXPECT_TRUE(best["points_psnr"].is_null());
  // The true picture is of no row's rays: edges are not met by the same.
  for (const json& row : rows) EXPECT_FALSE(row["psnr"].is_null()) << row["choice"];
  EXPECT_TRUE(image["tracer"]["truth_noise"].is_number());
  for (const char* choice : {"antialias adaptive:16", "antialias random:4", "preview, blocks of 8"})
    EXPECT_FALSE(row_of(rows, choice).contains("points_psnr")) << choice;
}

TEST_F(CostCommand, RowsAreWhatTheOtherCommandsMake) {
  const json image = json::parse(cost({"--json"}).out)["images"][0];
  const auto render = [&](const std::string& folder_name, const Words& more) {
    Words words{"render", "s", "--size", "16x12", "-q", "--out", folder_name};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(sir(words).exit_code, 0);
    return read_planes(folder / (folder_name + "/s"), ImageSize{16, 12});
  };
  const Planes usual = render("usual", {});
  for (const auto& [choice, more] : std::vector<std::pair<std::string, Words>>{
           {"default", {}},
           {"float", {"--precision", "float"}},
           {"textbook", {"--formulas", "textbook"}},
           {"depth 1", {"--depth", "1"}},
           {"cutoff 0.2", {"--cutoff", "0.2"}},
           {"antialias adaptive:16", {"--antialias", "adaptive:16"}},
           {"antialias random:8", {"--antialias", "random:8"}}}) {
    const Planes picture = render("other", more);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < usual.size.pixels(); ++i)
      changed += !(usual.at(i) == picture.at(i));
    EXPECT_EQ(row_of(image["tracer"]["rows"], choice)["changed"], changed) << choice;
  }

  ASSERT_EQ(sir({"lut", "usual/s.png", "--space", "rgb", "--rgb-bits", "4"}).exit_code, 0);
  ASSERT_EQ(sir({"show", "usual/s.png", "--crop", "--png", "shown.png", "-q"}).exit_code, 0);
  const Ended metrics = sir({"metrics", "usual/s.png", "shown.png", "--json"});
  const json& row = row_of(image["rows"], "median rgb --rgb-bits 4");
  EXPECT_EQ(row["psnr"], json::parse(metrics.out)["psnr"]) << metrics.err;
  EXPECT_EQ(row["de_p95"], json::parse(metrics.out)["de_p95"]);
  EXPECT_EQ(sir({"lut", "usual/s.png", "--rgb-bits", "9"}).exit_code, 2);
}

TEST_F(CostCommand, MoreRandomRaysAreNearerToTheTruth) {
  const Ended ended = sir({"cost", "s", "--size", "64x48", "--repeats", "1", "--truth-samples",
                           "256", "--only", "antialias", "--json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const json image = json::parse(ended.out)["images"][0];
  const json& rows = image["tracer"]["rows"];
  const auto psnr = [&](const std::string& choice) {
    return row_of(rows, choice)["psnr"].get<double>();
  };
  EXPECT_LT(psnr("default"), psnr("antialias random:4"));
  EXPECT_LT(psnr("antialias random:4"), psnr("antialias random:16"));
  EXPECT_LT(psnr("antialias random:16"), psnr("antialias random:64"));
  EXPECT_LT(psnr("default"), psnr("antialias adaptive:16"));
  EXPECT_GT(image["tracer"]["truth_noise"], psnr("antialias random:64"));
}

TEST_F(CostCommand, OnlyTheKnobsAskedFor) {
  const json depth = json::parse(cost({"--json", "--only", "depth"}).out)["images"][0];
  EXPECT_EQ(depth["tracer"]["rows"].size(), 10u);
  EXPECT_FALSE(depth.contains("rows"));
  const json lut = json::parse(cost({"--json", "--only", "sample,nearest"}).out)["images"][0];
  EXPECT_FALSE(lut.contains("tracer"));
  EXPECT_EQ(row_of(lut["rows"], "median hsv --sample 16")["knob"], "sample");
  const Ended unknown = cost({"--only", "depth,width"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("\"depth,width\""), std::string::npos);
  for (const char* knob :
       {"precision", "formulas", "depth", "cutoff", "antialias", "preview", "grid", "sample",
        "method", "nearest", "combined", "effort", "map", "dither"})
    EXPECT_NE(unknown.err.find(knob), std::string::npos) << knob;
}

TEST_F(CostCommand, PlanesWithoutASceneHaveTheLutAlone) {
  ASSERT_EQ(sir({"render", "s", "--size", "16x12", "--out", "o", "-q"}).exit_code, 0);
  const Words words{"cost", "o/s", "--size", "16x12", "--repeats", "1", "--json"};
  const json image = json::parse(sir(words).out)["images"][0];
  EXPECT_FALSE(image.contains("tracer"));
  Words again = words;
  again[1] = "o/s.png";
  const json png = json::parse(sir(again).out)["images"][0];
  const json scene = json::parse(cost({"--json"}).out)["images"][0];
  ASSERT_EQ(image["rows"].size(), scene["rows"].size());
  for (std::size_t i = 0; i < image["rows"].size(); ++i)
    for (const char* key : {"choice", "psnr", "largest", "de_mean", "colours", "changed"}) {
      EXPECT_EQ(image["rows"][i][key], png["rows"][i][key]) << key;
      EXPECT_EQ(image["rows"][i][key], scene["rows"][i][key]) << key;
    }
  Words tracer = words;
  tracer.insert(tracer.end(), {"--only", "depth"});
  expect_failure(sir(tracer), "has no scene");
}

TEST_F(CostCommand, BudgetAndTargetAreAnsweredOrEndInThree) {
  const Ended met = cost({"--budget", "1000s", "--target", "1dB", "--only", "depth"});
  EXPECT_EQ(met.exit_code, 0) << met.err;
  EXPECT_NE(met.out.find("Within 1000 s, the most accurate is \""), std::string::npos) << met.out;
  EXPECT_NE(met.out.find("The cheapest that reaches 1 dB is \""), std::string::npos) << met.out;

  const Ended broke = cost({"--budget", "0.000001ms", "--only", "depth", "--json"});
  EXPECT_EQ(broke.exit_code, 3);
  EXPECT_NE(broke.err.find("the cheapest, \""), std::string::npos) << broke.err;
  EXPECT_NE(broke.err.find("costs"), std::string::npos) << broke.err;
  const json answer = json::parse(broke.out)["images"][0]["answers"][0];
  EXPECT_EQ(answer["met"], false);
  EXPECT_EQ(answer["part"], "tracer");

  const Ended far = cost({"--target", "4000dB", "--only", "sample"});
  EXPECT_EQ(far.exit_code, 3);
  EXPECT_NE(far.err.find("the best, \""), std::string::npos) << far.err;
  EXPECT_NE(far.err.find(" dB in "), std::string::npos) << far.err;
}

TEST_F(CostCommand, WrongUsageIsNamed) {
  for (const Words& words :
       {Words{"--budget", "2"}, Words{"--budget", "0s"}, Words{"--budget", "infs"},
        Words{"--budget", "nans"}, Words{"--budget", "-1s"}, Words{"--target", "0"},
        Words{"--target", "nan"}, Words{"--target", "inf"}, Words{"--target", "45db"},
        Words{"--threads", "0"}, Words{"--truth-samples", "0"}, Words{"--repeats", "0"}}) {
    const Ended ended = cost(words);
    EXPECT_EQ(ended.exit_code, 2) << words[0] << " " << words[1];
    EXPECT_NE(ended.err.find(words[0]), std::string::npos) << ended.err;
  }
  EXPECT_EQ(cost({"--csv", "a", "--html", "./a"}).exit_code, 2);
}

TEST_F(CostCommand, InputsAreNotOverwritten) {
  const std::string scene = folder.read("s.CSG");
  expect_failure(cost({"--csv", "s.CSG"}), "s.CSG");
  expect_failure(cost({"--html", "s.CAM"}), "s.CAM");
  EXPECT_EQ(folder.read("s.CSG"), scene);
  folder.write("s.CSG", "broken");
  expect_failure(cost({}), "s.CSG");
}

TEST_F(CostCommand, CanBeInterrupted) {
  Start start;
  start.err_is_terminal = true;
  start.folder = folder.path();
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show progress on";
  Program program(SIR_PROGRAM, {"cost", "s", "--repeats", "1000", "--csv", "a.csv"}, start);
  ASSERT_TRUE(program.wait_for(" %,"));
  program.signal(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_EQ(ended.out, "");
  EXPECT_FALSE(folder.has("a.csv"));
}

// The environment of a program that is run, for the life of this.
class PathIs {
 public:
  explicit PathIs(const std::string& path) : before_(std::getenv("PATH")) {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~PathIs() { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST_F(CostCommand, WithoutGnuplotThePageSaysSo) {
  std::filesystem::create_directory(folder / "empty");
  const PathIs empty((folder / "empty").string());
  const Ended ended = cost({"--html", "p.html"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.err, "gnuplot is not installed; the page has no plots\nwrote p.html\n");
  const std::string page = folder.read("p.html");
  EXPECT_EQ(count(page, "No plots: gnuplot is not installed."), 2u);
  EXPECT_EQ(count(page, "<table>"), 2u);
}

TEST_F(CostCommand, APoorGnuplotIsNoMisfortune) {
  const auto script = folder.write("gnuplot", "#!/bin/sh\necho oh no >&2\nexit 4\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const PathIs here(folder.path().string() + ":/bin");
  const Ended ended = cost({"--html", "p.html", "--only", "depth"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_NE(ended.err.find("gnuplot failed: oh no; the page has no plots"), std::string::npos)
      << ended.err;
  EXPECT_EQ(count(folder.read("p.html"), "<table>"), 1u);
}

TEST_F(CostCommand, ThePageNeedsNothingButItselfAndABrowserShowsItWithoutAWord) {
  const Ended ended = cost({"--html", "p.html"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const std::string page = folder.read("p.html");
  EXPECT_EQ(count(page, "<script") + count(page, "http:") + count(page, "https:"), 0u);
  EXPECT_EQ(count(page, "url(") + count(page, "src=") + count(page, "@import"), 0u);
  EXPECT_EQ(count(page, "href=\""), count(page, "href=\"#") + count(page, "href=\"data:,\""));
  EXPECT_EQ(count(page, "<table>"), 2u);
  if (std::system("command -v gnuplot >/dev/null 2>&1") == 0) {
    EXPECT_GE(count(page, "<svg "), 3u);
    std::set<std::string> ids;
    for (auto at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1))
      EXPECT_TRUE(ids.insert(page.substr(at, page.find('"', at + 5) - at)).second);
    EXPECT_GT(ids.size(), 3u);
  }
  if (std::system("command -v chromium >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "chromium is not installed";
  const std::string here = folder.path().string();
  const std::string command =
      "cd '" + here +
      "' && timeout 120 chromium --headless --no-sandbox --disable-gpu --no-first-run "
      "--disable-background-networking --disable-component-update --user-data-dir='" +
      here +
      "/profile' --enable-logging=stderr --screenshot=p.png --window-size=1200,2400 'file://" +
      here + "/p.html' 2>said";
  EXPECT_EQ(std::system(command.c_str()), 0) << folder.read("said");
  EXPECT_EQ(count(folder.read("said"), "CONSOLE"), 0u) << folder.read("said");
  EXPECT_TRUE(folder.has("p.png"));
}

}  // namespace
}  // namespace sir::test
