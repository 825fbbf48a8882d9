#include "cli/clock_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "quant/choose.h"
#include "quant/thesis_work.h"

namespace sir::cli {
namespace {

using quant::ClockFit;
using quant::ClockSample;
using Samples = std::vector<ClockSample>;

struct Fitted {
  const ClockReading* reading;
  ClockFit fit;
};

const char* name_of(quant::Space space) { return space == quant::Space::rgb ? "RGB" : "HSV"; }

std::vector<double> measured(const Samples& samples) {
  std::vector<double> seconds;
  for (const ClockSample& sample : samples) seconds.push_back(sample.measured_seconds);
  return seconds;
}

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, " "));
}

/// R^2 of the HSV times about their own mean: of the differences among them.
double r2_within_hsv(const Samples& samples, const ClockFit& fit) {
  double mean = 0, number = 0, missed = 0, spread = 0;
  const auto each_hsv = [&](auto work) {
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].space == quant::Space::hsv)
        work(samples[i].measured_seconds, fit.predicted[i]);
  };
  each_hsv([&](double time, double) { mean += time, ++number; });
  mean /= number;
  each_hsv([&](double time, double predicted) {
    missed += std::pow(predicted - time, 2);
    spread += std::pow(time - mean, 2);
  });
  return 1 - missed / spread;
}

std::string fit_line(const std::string& name, const ClockFit& fit, const Samples& samples) {
  return fmt::format("{:<22}{:>7.1f}  {:>10.1f}  {:>11.1f}  {:>6.3f}  {:>12.1f}  {}\n", name,
                     1e6 * fit.seconds_per[0], 1e6 * fit.seconds_per[1], 1e6 * fit.seconds_per[2],
                     fit.r2, fit.leave_one_image_out,
                     listed(quant::faster_in_rgb(samples, fit.predicted)));
}

std::string all_fits(std::span<const Fitted> fits, const ClockFit& counts, const Samples& samples) {
  std::string text =
      "                      us per  us per RGB-  us per cell          RMS seconds,  faster\n"
      "                      pixel   HSV convers. visited      R^2     image left out in RGB\n";
  for (const Fitted& one : fits)
    text += fit_line(one.reading->split + (one.reading->shrink ? "" : ", not shrunk"), one.fit,
                     one.reading->samples);
  text += fit_line("counts alone (*)", counts, samples);
  return text +
         fmt::format("{:<22}{:>55}\n", "the thesis's times",
                     listed(quant::faster_in_rgb(samples, measured(samples)))) +
         "(*) a colour, that is an occupied cell, in place of a cell visited\n";
}

std::string comparison(const Fitted& best, std::span<const Fitted> fits, const ClockFit& counts) {
  std::string text =
      fmt::format("\nOf the orders of splitting `{}` fits best. Against it\n", best.reading->split);
  const auto against = [&](const std::string& name, const ClockFit& fit) {
    text +=
        fmt::format("- {}: {:+.3f} of R^2, {:+.1f} s where an image is left out\n", name,
                    fit.r2 - best.fit.r2, fit.leave_one_image_out - best.fit.leave_one_image_out);
  };
  for (const Fitted& one : fits)
    if (&one != &best && one.reading->shrink) against(one.reading->split, one.fit);
  against("counts alone", counts);
  return text;
}

std::string residuals(const Fitted& best, const ClockFit& counts) {
  std::string text =
      "\n                     cells            seconds predicted (residual)\n"
      "                   visited  measured  by cells visited  by counts alone\n";
  const Samples& samples = best.reading->samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time = samples[i].measured_seconds;
    text += fmt::format("{:<10}  {}  {:>9}  {:>8.0f}  {:>8.1f} ({:+6.1f})  {:>7.1f} ({:+6.1f})\n",
                        samples[i].image, name_of(samples[i].space), samples[i].work.cells_visited,
                        time, best.fit.predicted[i], best.fit.predicted[i] - time,
                        counts.predicted[i], counts.predicted[i] - time);
  }
  return text;
}

/// Pairs of images whose times in a space are predicted in the order in which they stand.
std::string pairs_in_order(const Samples& samples, const std::vector<double>& predicted,
                           quant::Space space) {
  int right = 0, all = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = 0; j < samples.size(); ++j) {
      if (samples[i].space != space || samples[j].space != space) continue;
      if (samples[i].measured_seconds >= samples[j].measured_seconds) continue;
      ++all;
      if (predicted[i] < predicted[j]) ++right;
    }
  return fmt::format("{} of {}", right, all);
}

std::string order(const Fitted& best, const ClockFit& counts) {
  std::string text = "\nPairs of images in the right order of their times:\n";
  for (const quant::Space space : {quant::Space::rgb, quant::Space::hsv})
    text += fmt::format("- {}: {} by cells visited, {} by counts alone\n", name_of(space),
                        pairs_in_order(best.reading->samples, best.fit.predicted, space),
                        pairs_in_order(best.reading->samples, counts.predicted, space));
  return text;
}

std::string verdict(const Fitted& best) {
  constexpr double kConvincing = 0.85;  // R^2 from which on an explanation is worth the name
  const Samples& samples = best.reading->samples;
  const auto faster = quant::faster_in_rgb(samples, best.fit.predicted);
  const auto truly = quant::faster_in_rgb(samples, measured(samples));
  const auto miss = [&](std::size_t i) {
    return best.fit.predicted[i] - samples[i].measured_seconds;
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (std::abs(miss(i)) > std::abs(miss(worst))) worst = i;
  std::string text =
      best.fit.r2 >= kConvincing
          ? "\nWhat this proves: that the explanation is possible. The times can be the work of\n"
            "walking the cells of boxes, which are large where colours lie far apart, and flat in\n"
            "HSV. It is no proof that this is what happened: "
          : "\nWhat this proves: nothing in favour. With these images the work of walking the "
            "cells\n"
            "of boxes does not explain the times. Nor is it a proof against: ";
  text += fmt::format(
      "three constants were fitted to\n"
      "{} numbers, and the scenes' palettes are ours, free but for the counts of colours;\n"
      "another palette with the same counts would give other boxes.\n"
      "What stays unexplained:\n",
      samples.size());
  text += fmt::format("- RGB is the faster in: {}; the model says: {}.\n", listed(truly),
                      listed(faster));
  text += fmt::format("- The largest residual is {}'s in {}: {:+.1f} s of {:.0f}.\n",
                      samples[worst].image, name_of(samples[worst].space), miss(worst),
                      samples[worst].measured_seconds);
  text += fmt::format("- The differences among the HSV times: their own R^2 is {:.2f}.\n",
                      r2_within_hsv(samples, best.fit));
  if (best.fit.seconds_per[0] > 0 && best.fit.seconds_per[2] > best.fit.seconds_per[0])
    text += fmt::format(
        "- A visit to a cell would cost {:.1f} times the reading of a pixel from three files, as\n"
        "  if boxes had been walked more often than is counted here (one factor for all of them\n"
        "  leaves the fit as it is).\n",
        best.fit.seconds_per[2] / best.fit.seconds_per[0]);
  return text;
}

}  // namespace

std::vector<ClockReading> clock_readings(std::span<const ClockImage> images) {
  struct Order {
    const char* name;
    quant::SplitOrder split;
  };
  constexpr std::array<Order, 3> kOrders{{{"pixels", quant::SplitOrder::pixels},
                                          {"breadth", quant::SplitOrder::breadth},
                                          {"longest", quant::SplitOrder::longest}}};
  std::vector<quant::CellCounts> colours;
  for (const ClockImage& image : images) colours.push_back(quant::occupied_cells(image.planes));
  std::vector<ClockReading> readings;
  for (const bool shrink : {true, false})
    for (const Order& order : kOrders) {
      readings.push_back({order.name, shrink, {}});
      for (std::size_t i = 0; i < images.size(); ++i)
        for (const quant::Space space : {quant::Space::rgb, quant::Space::hsv}) {
          const bool rgb = space == quant::Space::rgb;
          quant::ChooseOptions options;
          options.space = space;
          options.split = order.split;
          readings.back().samples.push_back(
              {images[i].title, space,
               quant::choose_as_in_1989(images[i].planes, options, shrink).work,
               rgb ? colours[i].rgb : colours[i].hsv,
               rgb ? images[i].rgb_seconds : images[i].hsv_seconds});
        }
    }
  return readings;
}

const ClockReading& best_reading(std::span<const ClockReading> readings) {
  const ClockReading* best = nullptr;
  double most = 0;
  for (const ClockReading& reading : readings) {
    if (!reading.shrink) continue;
    const double r2 = quant::fit_clock(reading.samples).r2;
    if (best != nullptr && r2 <= most) continue;
    best = &reading;
    most = r2;
  }
  if (best == nullptr) throw std::invalid_argument("no reading with boxes that are shrunk");
  return *best;
}

std::string clock_text(std::span<const ClockReading> readings) {
  const ClockReading& reading = best_reading(readings);
  std::vector<Fitted> fits;
  for (const ClockReading& one : readings) fits.push_back({&one, quant::fit_clock(one.samples)});
  const Fitted& best = fits[static_cast<std::size_t>(&reading - readings.data())];
  const ClockFit counts = quant::fit_counts(reading.samples);
  return "The clock of 1989 - can a price for each step of the work explain the ten times?\n\n" +
         all_fits(fits, counts, reading.samples) + comparison(best, fits, counts) +
         residuals(best, counts) + order(best, counts) + verdict(best);
}

}  // namespace sir::cli
