#include "cli/cost_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "quant/metrics.h"
#include "quant/shown_through.h"
#include "tracer/error.h"

namespace sir::cli {
namespace {

using quant::ChooseOptions;
using quant::Method;
using quant::Space;
using quant::SplitOrder;

struct Choice {
  std::string name;
  ChooseOptions options;
};

using Quality = quant::ImageMetrics;

// A column of the table, and its name in JSON.
struct Measure {
  const char* key;
  const char* title;
  int places;
  std::optional<double> (*of)(const Quality&);  // none: the images are equal
};
constexpr Measure kMeasures[] = {
    {"psnr", "PSNR dB", 2, [](const Quality& q) { return q.psnr; }},
    {"rmse", "rmse", 3, [](const Quality& q) { return std::optional(q.rmse); }},
    {"de_mean", "dE mean", 2, [](const Quality& q) { return std::optional(q.de_mean); }},
    {"de_p95", "dE p95", 2, [](const Quality& q) { return std::optional(q.de_p95); }},
    {"hue_loss", "hues lost", 4, [](const Quality& q) { return std::optional(q.hue_loss); }},
};

struct Row {
  Choice choice;
  std::size_t colours = 0, entries = 0;
  std::vector<double> ms;  // one for each run
  Quality quality;
};

struct ImageRows {
  std::string name;
  std::vector<Row> rows;
};

std::vector<Choice> choices_of(const CostOptions& command) {
  std::vector<Choice> choices;
  const ChooseOptions& own = command.own;
  const auto add = [&choices](const std::string& name, const auto& change) {
    choices.push_back({name, {}});  // median in hsv by pixels, 36x30x30, limits 0.2, all pixels
    change(choices.back().options);
  };
  for (const auto& [name, space] : {std::pair("rgb", Space::rgb), std::pair("hsv", Space::hsv)}) {
    add(fmt::format("frequency {}", name), [&, space = space](ChooseOptions& o) {
      o.method = Method::frequency;
      o.space = space;
    });
    for (const auto& [word, order] :
         {std::pair("pixels", SplitOrder::pixels), std::pair("breadth", SplitOrder::breadth),
          std::pair("longest", SplitOrder::longest)})
      add(fmt::format("median {} --split {}", name, word),
          [&, space = space, order = order](ChooseOptions& o) {
            o.space = space;
            o.split = order;
          });
  }
  for (const auto& [s, v] : {std::pair(0.0, 0.0), std::pair(0.05, 0.05), std::pair(0.1, 0.1),
                             std::pair(0.1, 0.2), std::pair(0.2, 0.1), std::pair(0.4, 0.2)})
    add(fmt::format("median hsv --grey-s {:g} --grey-v {:g}", s, v),
        [s = s, v = v](ChooseOptions& o) {
          o.grid.grey_s = s;
          o.grid.grey_v = v;
        });
  for (const std::string grid : {"18x15x15", "72x60x60"})
    add("median hsv --grid " + grid, [&](ChooseOptions& o) { quant::parse_grid(grid, o.grid); });
  for (const std::size_t sample : {4u, 16u, 64u})
    add(fmt::format("median hsv --sample {}", sample),
        [sample](ChooseOptions& o) { o.sample = sample; });
  if (command.has_own)
    add(fmt::format("your own: {}x{}x{}, limits {:g} {:g}, sample {}", own.grid.hues,
                    own.grid.saturations, own.grid.values, own.grid.grey_s, own.grid.grey_v,
                    own.sample),
        [&own](ChooseOptions& o) { o = own; });
  return choices;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// Each round begins with another row: a round is as long as a scheduler's turn, which would
// otherwise always end in the same row. The first also judges. False where it was interrupted.
bool run_round(const Planes& image, std::size_t round, std::vector<Row>& rows,
               const std::function<void()>& done) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[(round + i) % rows.size()];
    if (interrupted()) return false;
    const auto start = std::chrono::steady_clock::now();
    const auto cells = quant::count_for(image, row.choice.options);
    const auto lut = quant::choose_from(cells, row.choice.options);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    if (row.ms.empty()) {
      row.colours = cells.size();
      row.entries = lut.chosen;
      row.quality = quant::measure(image, quant::shown_through(image, lut));
    }
    row.ms.push_back(took.count());
    done();
  }
  return true;
}

std::string as_text(const std::vector<ImageRows>& images) {
  std::size_t width = 0;
  for (const Row& row : images.front().rows) width = std::max(width, row.choice.name.size());
  std::string text;
  for (const ImageRows& image : images) {
    text += fmt::format("{}{}\n{:<{}}{:>9}{:>9}{:>9}", text.empty() ? "" : "\n", image.name,
                        "choice", width, "colours", "entries", "ms");
    for (const Measure& measure : kMeasures) text += fmt::format("{:>11}", measure.title);
    for (const Row& row : image.rows) {
      text += fmt::format("\n{:<{}}{:>9}{:>9}{:>9.3f}", row.choice.name, width, row.colours,
                          row.entries, median(row.ms));
      for (const Measure& measure : kMeasures) {
        const auto value = measure.of(row.quality);
        text += value ? fmt::format("{:>11.{}f}", *value, measure.places)
                      : fmt::format("{:>11}", "equal");
      }
    }
    text += "\n";
  }
  return text +
         "\ncolours: occupied cells of the grid; ms: counting and choosing, median of the runs.\n";
}

std::string as_json(const std::vector<ImageRows>& images) {
  auto list = nlohmann::ordered_json::array();
  for (const ImageRows& image : images) {
    auto rows = nlohmann::ordered_json::array();
    for (const Row& row : image.rows) {
      nlohmann::ordered_json json{{"choice", row.choice.name},
                                  {"colours", row.colours},
                                  {"entries", row.entries},
                                  {"ms", median(row.ms)}};
      for (const Measure& measure : kMeasures) {
        const auto value = measure.of(row.quality);
        json[measure.key] = value ? nlohmann::ordered_json(*value) : nullptr;
      }
      rows.push_back(json);
    }
    list.push_back({{"image", image.name}, {"rows", rows}});
  }
  return nlohmann::ordered_json{{"images", list}}.dump(2) + "\n";
}

}  // namespace

int run_cost(const CostOptions& options, const Session& session) {
  const auto choices = choices_of(options);
  std::vector<ImageRows> images;
  Progress progress(session, "cost");
  const auto show = progress.callback();
  const double runs = static_cast<double>(options.inputs.size() * choices.size()) * options.repeats;
  double done = 0;
  for (const auto& input : options.inputs) {
    const Planes image = load_image(input, options.size);
    images.push_back({input.string(), {}});
    for (const Choice& choice : choices) images.back().rows.push_back({choice, 0, 0, {}, {}});
    for (std::size_t round = 0; round < static_cast<std::size_t>(options.repeats); ++round)
      if (!run_round(image, round, images.back().rows, [&] {
            ++done;
            if (show) show(done / runs);
          }))
        return kInterrupted;
  }
  progress.finish();
  print(options.json ? as_json(images) : as_text(images));
  return kDone;
}

}  // namespace sir::cli
