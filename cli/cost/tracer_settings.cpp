#include "cli/cost/tracer_settings.h"

#include <functional>

#include <fmt/format.h>

namespace sir::cli {
namespace {

constexpr Precision kMostPrecise = Precision::double_;

class List {
 public:
  explicit List(const KnobSet& only) : only_(only) {
    rows_.push_back({});
    rows_.back().name = "default";
    rows_.back().subject = "the default";
    rows_.back().at = rows_.back().options.trace.depth_limit;
  }

  TracerSetting* add(Knob knob, const std::string& name, const std::string& subject,
                     const std::function<void(RenderOptions&)>& change) {
    if (!wants(only_, knob)) return nullptr;
    TracerSetting& row = rows_.emplace_back();
    row.knob = knob;
    row.name = name;
    row.subject = subject;
    change(row.options);
    return &row;
  }

  std::vector<TracerSetting> take() { return std::move(rows_); }

 private:
  const KnobSet& only_;
  std::vector<TracerSetting> rows_;
};

void add_depths(List& list) {
  for (int depth = 1; depth <= kGreatestDepth; ++depth)
    if (depth != TraceOptions{}.depth_limit)
      if (TracerSetting* row =
              list.add(Knob::depth, fmt::format("depth {}", depth), fmt::format("depth {}", depth),
                       [depth](RenderOptions& o) { o.trace.depth_limit = depth; })) {
        row->family = "depth";
        row->at = depth;
      }
}

void add_cutoffs(List& list) {
  for (const double cutoff : {0.002, 0.01, 0.05, 0.2})
    if (TracerSetting* row = list.add(Knob::cutoff, fmt::format("cutoff {:g}", cutoff),
                                      fmt::format("a cutoff of {:g}", cutoff),
                                      [cutoff](RenderOptions& o) { o.trace.cutoff = cutoff; })) {
      row->family = "cutoff";
      row->at = cutoff;
    }
}

}  // namespace

bool TracerSetting::one_ray() const { return preview_block == 0; }

bool TracerSetting::only_calculates_otherwise() const {
  const TraceOptions usual;
  return one_ray() && options.trace.depth_limit == usual.depth_limit &&
         options.trace.cutoff == usual.cutoff;
}

std::vector<TracerSetting> tracer_settings(const KnobSet& only) {
  List list(only);
  list.add(Knob::precision, "float", "float",
           [](RenderOptions& o) { o.precision = Precision::float_; });
  add_depths(list);
  add_cutoffs(list);
  list.add(Knob::combined, "float, depth 3, cutoff 0.05", "float at depth 3 with a cutoff of 0.05",
           [](RenderOptions& o) {
             o.precision = Precision::float_;
             o.trace.depth_limit = 3;
             o.trace.cutoff = 0.05;
           });
  return list.take();
}

TracerSetting true_points() {
  TracerSetting truth = true_default();
  truth.options.trace.depth_limit = kGreatestDepth;
  return truth;
}

TracerSetting true_picture(int) { return true_points(); }

TracerSetting true_default() {
  TracerSetting truth;
  truth.name = truth.subject = "truth";
  truth.options.precision = kMostPrecise;
  return truth;
}

std::string truth_in_words(int) { return fmt::format("double, depth {}", kGreatestDepth); }

RenderResult render_setting(const Scene& scene, const TracerSetting& setting, ImageSize size,
                            int threads, std::stop_token stop) {
  RenderOptions options = setting.options;
  options.size = size;
  options.threads = threads;
  return render(scene, options, {}, std::move(stop));
}

}  // namespace sir::cli
