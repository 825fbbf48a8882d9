#include "cli/cost/cost_plots.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "cli/cost/effort_plot.h"
#include "cli/cost/plot_script.h"

namespace sir::cli {
namespace {

// Of a name in a plot, in the plot's height; of a letter, in its width.
constexpr double kNameHeight = 0.03, kLetterWidth = 0.0105;

// Where a logarithmic axis up to `end` must begin so that there is room for the names to the
// left of their points.
double start_of_axis(const std::vector<const CostRow*>& named, double end) {
  double start = INFINITY;
  for (const CostRow* row : named) {
    const double width = std::min(0.6, kLetterWidth * static_cast<double>(row->name.size()) + 0.03);
    start = std::min(start, (std::log(row->time.median) - width * std::log(end)) / (1 - width));
  }
  return std::exp(start);
}

using RowsOfSeries = std::vector<std::pair<std::string, std::vector<const CostRow*>>>;

RowsOfSeries by_knob(const CostPart& part) {
  RowsOfSeries series;
  for (const CostRow& row : part.rows) {
    if (!row.picture.psnr || row.time.median <= 0) continue;
    const std::string name = row.knob                     ? name_of(*row.knob)
                             : &row == &part.rows.front() ? "default"
                                                          : "your own";
    auto found = std::find_if(series.begin(), series.end(),
                              [&](const auto& each) { return each.first == name; });
    if (found == series.end()) found = series.insert(series.end(), {name, {}});
    found->second.push_back(&row);
  }
  return series;
}

// All rows, and the front as a stair: what is under it is worse than one of its points.
CostPlot price_plot(const CostPart& part, const std::string& of) {
  CostPlot plot{
      "Time and accuracy of " + of,
      "Each point is a row, its bar the middle half of the runs; the stair is the Pareto "
      "front, whose rows are named where there is room. Rows without any error are not drawn.",
      plot_head(900, 560)};
  const RowsOfSeries series = by_knob(part);
  std::vector<const CostRow*> front;
  double most = 0, worst = INFINITY, best = -INFINITY;
  std::string curves;
  for (std::size_t i = 0; i < series.size(); ++i) {
    std::string lines;
    for (const CostRow* row : series[i].second) {
      lines += fmt::format("{} {} {} {}\n", row->time.median, *row->picture.psnr, row->time.low,
                           row->time.high);
      most = std::max(most, row->time.median);
      worst = std::min(worst, *row->picture.psnr);
      best = std::max(best, *row->picture.psnr);
      if (row->front) front.push_back(row);
    }
    plot.script += plot_block(fmt::format("series{}", i), lines);
    curves += fmt::format(
        "{}$series{} using 1:2:3:4 with xerrorbars pt 7 ps {} lw 1 lc rgb \"{}\" title {}",
        i == 0 ? "" : ", ", i, series[i].first == "default" ? 1.1 : 0.6, plot_colour(i),
        plot_string(series[i].first));
  }
  if (series.empty()) return {};
  std::sort(front.begin(), front.end(),
            [](const CostRow* a, const CostRow* b) { return a->time.median < b->time.median; });
  std::string stair;
  double last_named = -INFINITY;
  for (const CostRow* row : front) {
    const bool room = *row->picture.psnr - last_named > kNameHeight * (best - worst);
    if (room) last_named = *row->picture.psnr;
    stair += fmt::format("{} {} {}\n", row->time.median, *row->picture.psnr,
                         plot_string(room ? row->name : ""));
  }
  // Above and left of the front nothing is: its names stand there.
  plot.script += plot_block("front", stair) +
                 fmt::format(
                     "set logscale x\nset xrange [{}:{}]\nset offsets 0,0,1,0.5\n"
                     "set xlabel \"time, ms\"\nset ylabel \"PSNR, dB\"\nplot ",
                     start_of_axis(front, most * 1.5), most * 1.5) +
                 "$front using 1:2 with steps lw 1.5 lc rgb \"black\" title \"front\", " + curves +
                 ", $front using 1:2:3 with labels right offset -0.7,0.45 font \",11\" notitle\n";
  return plot;
}

CostPlot depth_plot(const CostPart& part) {
  std::map<double, const CostRow*> rows;
  for (const CostRow& row : part.rows)
    if (row.knob == Knob::depth) rows[row.at] = &row;
  if (rows.empty()) return {};
  rows[part.rows.front().at] = &part.rows.front();
  CostPlot plot{"The depth of the tree of rays",
                "Left: the time, in the default's. Right: pixels that differ from the truth with "
                "one ray through each pixel's centre.",
                plot_head(900, 330)};
  std::string lines;
  for (const auto& [depth, row] : rows)
    lines += fmt::format("{} {} {}\n", depth, row->ratio.median, row->points->pixels);
  plot.script += plot_block("depth", lines) +
                 fmt::format("set xrange [0.5:{}]\n", rows.rbegin()->first + 0.5) +
                 "set nokey\nset xtics 1\nset xlabel \"depth\"\n"
                 "set multiplot layout 1,2\nset yrange [0:*]\nset ylabel \"time, default's = 1\"\n"
                 "plot $depth using 1:2 with linespoints pt 7 ps 0.7 lw 2 lc rgb \"#2f86a6\"\n"
                 "set ylabel \"wrong pixels\"\nset format y \"%.0f\"\n"
                 "plot $depth using 1:3 with linespoints pt 7 ps 0.7 lw 2 lc rgb \"#c2543c\"\n"
                 "unset multiplot\n";
  return plot;
}

CostPlot antialias_plot(const CostPart& part) {
  RowsOfSeries series;
  for (const CostRow& row : part.rows) {
    if (row.knob != Knob::antialias || !row.picture.psnr) continue;
    if (series.empty() || series.back().first != row.family) series.push_back({row.family, {}});
    series.back().second.push_back(&row);
  }
  if (series.empty()) return {};
  CostPlot plot{"Antialiasing",
                "Adaptive by threshold and random by number of rays, each named beside its point; "
                "the time is in the default's, of one ray a pixel.",
                plot_head(900, 420)};
  std::string curves, names;
  for (std::size_t i = 0; i < series.size(); ++i) {
    std::string lines;
    for (const CostRow* row : series[i].second)
      lines += fmt::format("{} {} {}\n", row->ratio.median, *row->picture.psnr,
                           plot_string(fmt::format("{:g}", row->at)));
    plot.script += plot_block(fmt::format("series{}", i), lines);
    curves += fmt::format(
        "{}$series{} using 1:2 with linespoints pt 7 ps 0.7 lw 2 lc rgb \"{}\" title {}",
        i == 0 ? "" : ", ", i, plot_colour(i), plot_string(series[i].first));
    names += fmt::format(", $series{} using 1:2:3 with labels {} notitle", i,
                         i % 2 == 0 ? "right offset -0.6,0.5" : "left offset 0.6,-0.5");
  }
  if (const CostRow& usual = part.rows.front(); usual.picture.psnr) {
    plot.script += plot_block("usual", fmt::format("1 {}\n", *usual.picture.psnr));
    curves += ", $usual using 1:2 with points pt 7 ps 1.1 lc rgb \"#808890\" title \"one ray\"";
  }
  plot.script +=
      "set logscale x\nset offsets graph 0.08,graph 0.05,1,0.5\n"
      "set xlabel \"time, default's = 1\"\nset ylabel \"PSNR, dB\"\nplot " +
      curves + names + "\n";
  return plot;
}

void keep(std::vector<CostPlot>& plots, CostPlot plot) {
  if (!plot.script.empty()) plots.push_back(std::move(plot));
}

}  // namespace

std::vector<CostPlot> tracer_plots(const CostPart& part) {
  std::vector<CostPlot> plots;
  keep(plots, price_plot(part, "the tracer's settings"));
  keep(plots, antialias_plot(part));
  keep(plots, depth_plot(part));
  return plots;
}

std::vector<CostPlot> lut_plots(const CostPart& part) {
  std::vector<CostPlot> plots;
  keep(plots, price_plot(part, "the LUT's settings"));
  keep(plots, effort_plot(part));
  return plots;
}

}  // namespace sir::cli
