#include "cli/cost_command.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "cli/cost/answer.h"
#include "cli/cost/cost_fields.h"
#include "cli/cost/cost_html.h"
#include "cli/cost/cost_text.h"
#include "cli/cost/measure.h"
#include "cli/cost/sentences.h"
#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "tracer/atomic_files.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"

namespace sir::cli {
namespace {

namespace fs = std::filesystem;

bool has_scene(const fs::path& input) {
  std::error_code ignored;
  return !is_png(input) && (fs::exists(with_suffix(input, "CSG"), ignored) ||
                            fs::exists(with_suffix(input, "csg"), ignored));
}

// None where it was interrupted.
class Pricing {
 public:
  Pricing(const CostOptions& options, const Session& session, int threads)
      : options_(options), session_(session), threads_(threads) {}

  std::optional<CostImage> operator()(const fs::path& input) const {
    CostImage image;
    image.name = input.string();
    const auto picture = has_scene(input) ? price_scene(input, image)
                                          : std::optional(load_image(input, options_.size));
    if (!picture) return std::nullopt;
    image.size = picture->size;
    if (wants_lut(options_.only) && !price_lut(*picture, image)) return std::nullopt;
    if (!image.tracer && !image.lut)
      throw FileError(input.string(), 0, "has no scene, and --only names the tracer's knobs alone");
    answer(image);
    return image;
  }

 private:
  MeasureOptions measuring(Progress& progress) const {
    return {options_.repeats, threads_, options_.truth_samples, progress.callback(),
            interruption()};
  }

  // The default's picture.
  std::optional<Planes> price_scene(const fs::path& input, CostImage& image) const {
    const Scene scene = read_scene(input);
    const auto settings = tracer_settings(options_.only);
    Progress progress(session_, "cost of tracing " + input.filename().string());
    if (!wants_tracer(options_.only)) {
      auto result =
          render_setting(scene, settings.front(), options_.size, threads_, interruption());
      if (!result.complete) return std::nullopt;
      return std::move(result.planes);
    }
    auto measured = measure_tracer(scene, options_.size, settings, measuring(progress));
    if (!measured) return std::nullopt;
    image.tracer = std::move(measured->part);
    image.tracer->sentences = tracer_sentences(*image.tracer);
    image.tracer->sentences.push_back(noise_in_words(measured->noise));
    image.truth_noise = measured->noise;
    image.truth = truth_in_words(options_.truth_samples);
    return std::move(measured->picture);
  }

  bool price_lut(const Planes& picture, CostImage& image) const {
    const auto settings =
        lut_settings(options_.only, options_.has_own ? std::optional(options_.own) : std::nullopt);
    Progress progress(session_, "cost of a LUT");
    image.lut = measure_lut(picture, settings, measuring(progress));
    if (image.lut) image.lut->sentences = lut_sentences(*image.lut);
    return image.lut.has_value();
  }

  void answer(CostImage& image) const {
    const CostPart& part = image.tracer ? *image.tracer : *image.lut;
    const CostQuestion& question = options_.question;
    if (question.budget_ms) image.answers.push_back(within_budget(part, *question.budget_ms));
    if (question.target_db) image.answers.push_back(at_target(part, *question.target_db));
    for (CostAnswer& each : image.answers) each.of_tracer = image.tracer.has_value();
  }

  const CostOptions& options_;
  const Session& session_;
  int threads_;
};

// Says which questions have no answer. Returns whether all have.
bool all_answered(const CostReport& report) {
  bool all = true;
  for (const CostImage& image : report.images)
    for (const CostAnswer& answer : image.answers) {
      if (answer.row) continue;
      all = false;
      std::fputs(fmt::format("sir: {}: {}\n", image.name, answer.text).c_str(), stderr);
    }
  return all;
}

}  // namespace

int run_cost(const CostOptions& options, const Session& session) {
  for (const auto& output : {options.csv, options.html})
    if (output)
      for (const auto& input : options.inputs) refuse_input_file(*output, input);
  for (const auto& output : {options.csv, options.html})
    if (output) require_writable(*output);
  CostReport report;
  report.threads = options.threads > 0
                       ? options.threads
                       : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  report.repeats = options.repeats;
  report.truth_samples = options.truth_samples;
  const Pricing price(options, session, report.threads);
  for (const auto& input : options.inputs) {
    auto image = price(input);
    if (!image) return kInterrupted;
    report.images.push_back(std::move(*image));
  }
  AtomicFiles together;
  if (options.csv) together.add(*options.csv).write(cost_csv(report));
  if (options.html) {
    const auto page = cost_html(report);
    if (!page.missing.empty()) note(session, page.missing);
    together.add(*options.html).write(page.text);
  }
  together.commit();
  for (const auto& output : {options.csv, options.html})
    if (output) note(session, "wrote " + output->string());
  print(options.json ? cost_json(report) : cost_text(report));
  return all_answered(report) ? kDone : kThreshold;
}

}  // namespace sir::cli
