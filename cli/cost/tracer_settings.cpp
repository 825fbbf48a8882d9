#include "cli/cost/tracer_settings.h"

#include <functional>

#include <fmt/format.h>

#include "tracer/sample_progressive.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

// No row has these, so that no row is compared with itself.
constexpr std::uint64_t kTruthSeed = 1989, kOtherSeed = 1990;

constexpr double kLongDouble = 7;  // about so much slower than double

AntialiasOptions adaptive(int threshold) {
  AntialiasOptions options;
  options.mode = Antialias::adaptive;
  options.threshold = threshold;
  return options;
}

AntialiasOptions random(int samples) {
  AntialiasOptions options;
  options.mode = Antialias::random;
  options.samples = samples;
  return options;
}

// Where a row stands on which curve, and a guess of its time.
struct Place {
  std::string family;
  double at = 0, weight = 1;
};

class List {
 public:
  explicit List(const KnobSet& only) : only_(only) {
    rows_.push_back({});
    rows_.back().name = "default";
    rows_.back().subject = "the default";
    rows_.back().at = rows_.back().options.trace.depth_limit;
  }

  TracerSetting* add(Knob knob, const std::string& name, const std::string& subject,
                     const std::function<void(RenderOptions&)>& change, const Place& place = {}) {
    if (!wants(only_, knob)) return nullptr;
    TracerSetting& row = rows_.emplace_back();
    row.knob = knob;
    row.name = name;
    row.subject = subject;
    row.family = place.family;
    row.at = place.at;
    row.weight = place.weight;
    change(row.options);
    return &row;
  }

  std::vector<TracerSetting> take() { return std::move(rows_); }

 private:
  const KnobSet& only_;
  std::vector<TracerSetting> rows_;
};

void add_antialiasing(List& list) {
  for (const int threshold : {4, 8, 16, 32, 64})
    list.add(Knob::antialias, fmt::format("antialias adaptive:{}", threshold),
             fmt::format("antialiasing at threshold {}", threshold),
             [threshold](RenderOptions& o) { o.antialias = adaptive(threshold); },
             {"adaptive", double(threshold), 3});
  for (const int samples : {2, 4, 8, 16, 64})
    list.add(Knob::antialias, fmt::format("antialias random:{}", samples),
             fmt::format("antialiasing by {} random rays a pixel", samples),
             [samples](RenderOptions& o) { o.antialias = random(samples); },
             {"random", double(samples), double(samples)});
}

void add_previews(List& list) {
  for (const int block : {16, 8, 4, 2})
    if (TracerSetting* row =
            list.add(Knob::preview, fmt::format("preview, blocks of {}", block),
                     fmt::format("a preview in blocks of {}", block), [](RenderOptions&) {},
                     {"preview", double(block), 1.0 / block / block}))
      row->preview_block = block;
}

void add_combinations(List& list) {
  static_assert(kGreatestDepth == 10, "rows are named by it");
  list.add(Knob::combined, "float, textbook", "float with textbook formulas", [](RenderOptions& o) {
    o.precision = Precision::float_;
    o.trace.formulas = Formulas::textbook;
  });
  list.add(Knob::combined, "float, depth 3, cutoff 0.05", "float at depth 3 with a cutoff of 0.05",
           [](RenderOptions& o) {
             o.precision = Precision::float_;
             o.trace.depth_limit = 3;
             o.trace.cutoff = 0.05;
           });
  list.add(Knob::combined, "cutoff 0.01, antialias adaptive:32",
           "antialiasing at threshold 32 with a cutoff of 0.01",
           [](RenderOptions& o) {
             o.trace.cutoff = 0.01;
             o.antialias = adaptive(32);
           },
           {"", 0, 2});
  list.add(Knob::combined, "float, depth 3, antialias adaptive:32",
           "antialiasing at threshold 32 in float at depth 3",
           [](RenderOptions& o) {
             o.precision = Precision::float_;
             o.trace.depth_limit = 3;
             o.antialias = adaptive(32);
           },
           {"", 0, 2});
  list.add(Knob::combined, "depth 7, antialias adaptive:32",
           "antialiasing at threshold 32 at depth 7",
           [](RenderOptions& o) {
             o.trace.depth_limit = 7;
             o.antialias = adaptive(32);
           },
           {"", 0, 3});
  list.add(Knob::combined, "depth 10, antialias adaptive:8",
           "antialiasing at threshold 8 at depth 10",
           [](RenderOptions& o) {
             o.trace.depth_limit = kGreatestDepth;
             o.antialias = adaptive(8);
           },
           {"", 0, 4});
  list.add(Knob::combined, "depth 10, antialias random:16",
           "antialiasing by 16 random rays a pixel at depth 10",
           [](RenderOptions& o) {
             o.trace.depth_limit = kGreatestDepth;
             o.antialias = random(16);
           },
           {"", 0, 18});
  list.add(Knob::combined, "long double, depth 10", "long double at depth 10",
           [](RenderOptions& o) {
             o.precision = Precision::long_double;
             o.trace.depth_limit = kGreatestDepth;
           },
           {"", 0, kLongDouble});
}

}  // namespace

bool TracerSetting::one_ray() const {
  return preview_block == 0 && options.antialias.mode == Antialias::none;
}

bool TracerSetting::only_calculates_otherwise() const {
  const TraceOptions usual;
  return one_ray() && options.trace.depth_limit == usual.depth_limit &&
         options.trace.cutoff == usual.cutoff;
}

std::vector<TracerSetting> tracer_settings(const KnobSet& only) {
  List list(only);
  list.add(Knob::precision, "float", "float",
           [](RenderOptions& o) { o.precision = Precision::float_; });
  list.add(Knob::precision, "long double", "long double",
           [](RenderOptions& o) { o.precision = Precision::long_double; }, {"", 0, kLongDouble});
  list.add(Knob::formulas, "textbook", "the textbook's",
           [](RenderOptions& o) { o.trace.formulas = Formulas::textbook; });
  for (int depth = 1; depth <= kGreatestDepth; ++depth)
    if (depth != TraceOptions{}.depth_limit)
      list.add(Knob::depth, fmt::format("depth {}", depth), fmt::format("depth {}", depth),
               [depth](RenderOptions& o) { o.trace.depth_limit = depth; },
               {"depth", double(depth), 1});
  for (const double cutoff : {0.002, 0.01, 0.05, 0.2})
    list.add(Knob::cutoff, fmt::format("cutoff {:g}", cutoff),
             fmt::format("a cutoff of {:g}", cutoff),
             [cutoff](RenderOptions& o) { o.trace.cutoff = cutoff; }, {"cutoff", cutoff, 1});
  add_antialiasing(list);
  add_previews(list);
  add_combinations(list);
  return list.take();
}

TracerSetting true_points() {
  TracerSetting truth = true_default();
  truth.options.trace.depth_limit = kGreatestDepth;
  return truth;
}

TracerSetting true_picture(int samples) {
  TracerSetting truth = true_points();
  truth.options.antialias = random(samples);
  truth.options.antialias.seed = kTruthSeed;
  truth.weight *= samples;
  return truth;
}

TracerSetting another_picture(int samples) {
  TracerSetting other = true_picture(samples);
  other.options.precision = Precision::double_;
  other.options.antialias.seed = kOtherSeed;
  other.weight /= kLongDouble;
  return other;
}

TracerSetting true_default() {
  TracerSetting truth;
  truth.name = truth.subject = "truth";
  truth.options.precision = Precision::long_double;
  truth.options.trace.formulas = Formulas::robust;
  truth.weight = kLongDouble;
  return truth;
}

std::string truth_in_words(int samples) {
  return fmt::format("long double, robust formulas, depth {}, cutoff 0, {} a pixel", kGreatestDepth,
                     counted(samples, "random ray"));
}

RenderResult render_setting(const Scene& scene, const TracerSetting& setting, ImageSize size,
                            int threads, std::stop_token stop,
                            const std::function<void(double)>& progress) {
  RenderOptions options = setting.options;
  options.size = size;
  options.threads = threads;
  return setting.preview_block == 0
             ? render(scene, options, progress, std::move(stop))
             : render_preview(scene, options, setting.preview_block, false, std::move(stop));
}

}  // namespace sir::cli
