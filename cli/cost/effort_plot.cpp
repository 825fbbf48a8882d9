#include "cli/cost/effort_plot.h"

#include <map>

#include <fmt/format.h>

#include "cli/cost/plot_script.h"

namespace sir::cli {

CostPlot effort_plot(const CostPart& part) {
  std::map<std::string, std::string> lines;  // of each family
  for (const CostRow& row : part.rows)
    if (row.knob == Knob::effort && row.picture.psnr)
      lines[row.family] += fmt::format("{} {} {} {:g}\n", row.time.median, row.picture.de_mean,
                                       *row.picture.psnr, row.at);
  if (lines.empty()) return {};
  CostPlot plot{"The effort of the method best",
                "Points are efforts, named beside them, for a LUT that is good to the eye "
                "(perceptual) or by the bytes (psnr). Left: less is better. Right: more is better.",
                plot_head(900, 360)};
  std::size_t series = 0;
  std::string to_the_eye, by_bytes;
  for (const auto& [family, points] : lines) {
    const std::string name = fmt::format("series{}", series);
    plot.script += plot_block(name, points);
    const auto curve = [&](int column, const std::string& title) {
      return fmt::format(
          "{}${} using 1:{} with linespoints pt 7 ps 0.7 lw 2 lc rgb \"{}\" title {}, "
          "${} using 1:{}:4 with labels offset 0,0.8 notitle",
          series == 0 ? "" : ", ", name, column, plot_colour(series), plot_string(title), name,
          column);
    };
    to_the_eye += curve(2, family);
    by_bytes += curve(3, family);
    ++series;
  }
  plot.script +=
      "set logscale x\nset key bottom left inside\nset key samplen 1\n"
      "set offsets graph 0.05,graph 0.05,graph 0.15,graph 0.2\n"
      "set xlabel \"time, ms\"\nset multiplot layout 1,2\n"
      "set ylabel \"mean CIEDE2000\"\nplot " +
      to_the_eye + "\nset nokey\nset ylabel \"PSNR, dB\"\nplot " + by_bytes + "\nunset multiplot\n";
  return plot;
}

}  // namespace sir::cli
