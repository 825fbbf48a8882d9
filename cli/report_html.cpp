#include "cli/report_html.h"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "cli/base64.h"
#include "cli/report_svg.h"
#include "eltek/display_driver.h"
#include "quant/heat_map.h"
#include "viewer/png_file.h"
#include "viewer/station.h"

namespace sir::cli {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1d1f21; --faint: #68707a; --line: #d5d9de;
  --paper: #fcfcfa; --rgb: #b3422e; --hsv: #1f6f8b; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e6e3; --faint: #9aa3ad; --line: #3a3f45; --paper: #16181a; --rgb: #ef8c78;
    --hsv: #6fc0dc; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 76rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { margin-top: 2.5rem; font-size: 1.25rem; }
p { max-width: 46rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .7rem; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 1px solid var(--line); vertical-align: bottom; }
th[colspan] { text-align: center; }
td.thesis, th.thesis { color: var(--faint); }
tbody tr:nth-child(odd) { background: color-mix(in srgb, var(--line) 25%, transparent); }
.four { display: grid; grid-template-columns: repeat(4, minmax(0, 1fr)); gap: .7rem;
  margin: 0 0 1.2rem; }
.five { display: grid; grid-template-columns: repeat(5, minmax(0, 1fr)); gap: 1rem; }
@media (max-width: 48rem) { .four { grid-template-columns: repeat(2, minmax(0, 1fr)); } }
figure { margin: 0; } figcaption { color: var(--faint); font-size: .85rem; }
img { width: 100%; height: auto; display: block; }
svg.lut { width: 100%; display: block; border: 1px solid var(--line); }
svg.plot { width: min(100%, 34rem); display: block; }
svg text { fill: var(--ink); font-size: 11px; } svg .right { text-anchor: end; }
svg .mid { text-anchor: middle; }
svg .grid { stroke: var(--line); } svg .equal { stroke: var(--faint); stroke-dasharray: 4 3; }
svg .rgb { fill: var(--rgb); } svg .hsv { fill: var(--hsv); }
.key-rgb { color: var(--rgb); } .key-hsv { color: var(--hsv); }
pre { overflow-x: auto; font-size: .8rem; }
)";

std::string data_uri(const std::filesystem::path& png) {
  std::ifstream file(png, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return "data:image/png;base64," + base64(bytes);
}

std::string figure(const std::string& uri, ImageSize size, const std::string& alt,
                   const std::string& caption) {
  return fmt::format(
      "<figure><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">"
      "<figcaption>{}</figcaption></figure>\n",
      uri, size.width, size.height, alt, caption);
}

class Page {
 public:
  Page(const TableData& data, const std::filesystem::path& scratch)
      : data_(data), scratch_(scratch / "picture.png") {}

  std::string text() {
    out("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<title>Table 4.1: 256 colours by median cut in RGB and in HSV</title>"
        "<link rel=\"icon\" href=\"data:,\">"
        "<style>");
    out(kStyle);
    out("</style></head><body>\n<h1>Table 4.1: 256 colours by median cut in RGB and in HSV</h1>\n"
        "<p>Five images of 640x480, one ray a pixel, and the lookup tables that the median cut "
        "chooses for them in both colour systems, as the Eltek MA120 shows them: 256 entries of 6 "
        "bits a primary. Figures of the thesis (UNICAMP, 1989) are grey. Beside them, beyond the "
        "thesis, the method best: entries chosen for little difference to the eye, and each pixel "
        "shown as the entry nearest to the eye. The scenes were adjusted "
        "until their numbers of colours came close to the thesis's, so these are no evidence; what "
        "follows from them is.</p>\n");
    table();
    quality();
    pictures();
    heat_maps();
    luts();
    clock();
    out("</body></html>\n");
    return std::move(text_);
  }

 private:
  void out(std::string_view text) { text_ += text; }
  template <typename... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void table() {
    out("<div class=\"scroll\"><table><thead><tr><th></th><th colspan=\"4\">RGB</th>"
        "<th colspan=\"4\">HSV</th><th colspan=\"2\">time RGB / HSV</th>"
        "<th colspan=\"2\">best</th></tr><tr><th>image</th>");
    for (int space = 0; space < 2; ++space)
      out("<th>colours</th><th class=\"thesis\">1989</th><th>ms</th><th "
          "class=\"thesis\">1989</th>");
    out("<th>ours</th><th class=\"thesis\">1989</th><th>colours</th><th>ms</th></tr></thead>"
        "<tbody>\n");
    for (const TableRow& row : data_.rows) {
      const ThesisRow& t = row.thesis;
      put("<tr><td>{}</td><td>{}</td><td class=\"thesis\">{}</td><td>{:.2f}</td>"
          "<td class=\"thesis\">{}</td><td>{}</td><td class=\"thesis\">{}</td><td>{:.2f}</td>"
          "<td class=\"thesis\">{}</td><td>{:.2f}</td><td class=\"thesis\">{:.2f}</td>"
          "<td>{}</td><td>{:.2f}</td></tr>\n",
          t.title, row.rgb.colours, t.rgb_colours, row.rgb.ms, minutes(t.rgb_seconds),
          row.hsv.colours, t.hsv_colours, row.hsv.ms, minutes(t.hsv_seconds),
          row.rgb.ms / row.hsv.ms, double(t.rgb_seconds) / t.hsv_seconds, row.best.colours,
          row.best.ms);
    }
    out("</tbody></table></div>\n<p>Colours are occupied cells of the grid (of best, the "
        "different colours of the image); the time is that of "
        "reading the planes, counting, choosing and writing the LUT, the median of repeated "
        "runs.</p>\n");
  }

  void quality() {
    out("<h2>Quality</h2>\n<div class=\"scroll\"><table><thead><tr><th>image</th><th>LUT</th>"
        "<th>PSNR dB</th><th>ΔE mean</th><th>ΔE p95</th><th>ΔE max</th><th>SSIM</th>"
        "<th>banding</th><th>hues lost</th><th>alarms</th></tr></thead><tbody>\n");
    for (const TableRow& row : data_.rows)
      for (const TableMethod& method : kTableMethods) {
        const TableCell& cell = row.*method.cell;
        const auto& m = cell.metrics;
        std::string alarms;
        for (const int plane : cell.hues.alarms) alarms += fmt::format("{}° ", plane * 10);
        put("<tr><td>{}</td><td>{}</td><td>{}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}</td>"
            "<td>{:.4f}</td><td>{:.3f}</td><td>{:.2f} %</td><td>{}</td></tr>\n",
            row.thesis.title, method.name, m.psnr ? fmt::format("{:.2f}", *m.psnr) : "equal",
            m.de_mean, m.de_p95, m.de_max, m.ssim, m.banding, 100 * m.hue_loss, alarms);
      }
    out("</tbody></table></div>\n<p>ΔE is CIEDE2000. Hues lost: the share of coloured pixels that "
        "land in another hue plane of the HSV grid or in grey; an alarm names hues of which too "
        "little is left.</p>\n");
  }

  std::string seen(const TableRow& row, const TableCell& cell) {
    viewer::Rendition rendition;
    rendition.lut = cell.lut;
    rendition.indices = cell.indices;
    viewer::Station station(true);
    station.show(row.thesis.file, row.image.size, rendition);
    viewer::write_indexed_png(scratch_, station.capture());
    return data_uri(scratch_);
  }

  std::string as_stored(const Planes& planes) {
    viewer::write_rgb_png(scratch_, planes);
    return data_uri(scratch_);
  }

  void pictures() {
    out("<h2>As the monitor shows them</h2>\n");
    for (const TableRow& row : data_.rows) {
      const std::string title = row.thesis.title;
      out("<div class=\"four\">");
      out(figure(as_stored(row.image), row.image.size, title + " in true colour",
                 title + ", true colour"));
      for (const TableMethod& method : kTableMethods)
        out(figure(seen(row, row.*method.cell), row.image.size,
                   fmt::format("{} with the {} LUT", title, method.name),
                   fmt::format("{} LUT", method.name)));
      out("</div>\n");
    }
  }

  // A row for each method, a column for each image.
  template <typename Figure>
  void five_by_methods(Figure figure_of) {
    out("<div class=\"five\">");
    for (const TableMethod& method : kTableMethods)
      for (const TableRow& row : data_.rows)
        out(figure_of(row, row.*method.cell, fmt::format("{}, {}", row.thesis.title, method.name)));
    out("</div>\n");
  }

  void heat_maps() {
    put("<h2>Where the error is</h2>\n<p>CIEDE2000 of each pixel, from black (none) to white "
        "(ΔE {} and more).</p>\n",
        quant::kWhiteHot);
    five_by_methods([&](const TableRow& row, const TableCell& cell, const std::string& label) {
      return figure(as_stored(quant::heat_map(row.image, cell.shown)), row.image.size,
                    "error of " + label, label);
    });
  }

  void luts() {
    out("<h2>The lookup tables</h2>\n");
    five_by_methods([](const TableRow&, const TableCell& cell, const std::string& label) {
      return fmt::format("<figure>{}<figcaption>{}, {} entries</figcaption></figure>\n",
                         swatches_svg(cell.lut, "lookup table of " + label), label,
                         cell.lut.chosen);
    });
  }

  void clock() {
    out("<h2>The clock of 1989</h2>\n<p>Could the work that the algorithms do explain the ten "
        "times? Below, the seconds that three constants (per pixel read, per conversion, per cell "
        "visited) give, against those that were measured: <span class=\"key-rgb\">RGB</span> and "
        "<span class=\"key-hsv\">HSV</span>.</p>\n");
    out(clock_svg(best_reading(data_.clock)));
    put("<pre>{}</pre>\n", clock_text(data_.clock));
  }

  const TableData& data_;
  std::filesystem::path scratch_;
  std::string text_;
};

}  // namespace

std::string report_html(const TableData& data, const std::filesystem::path& scratch) {
  return Page(data, scratch).text();
}

}  // namespace sir::cli
