#include "cli/cost/cost_html.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "cli/cost/cost_columns.h"
#include "cli/cost/cost_plots.h"
#include "cli/cost/svg_inline.h"

namespace sir::cli {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1d1f21; --faint: #68707a; --line: #d5d9de;
  --paper: #fcfcfa; --front: #e4f0e2; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e6e3; --faint: #9aa3ad; --line: #3a3f45; --paper: #16181a; --front: #203324; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 80rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { margin-top: 3rem; font-size: 1.35rem; }
h3 { margin-top: 2rem; font-size: 1.1rem; }
p, li, dd { max-width: 52rem; }
li { margin: .15rem 0; }
.answer { border-left: 4px solid var(--line); padding: .3rem .8rem; font-weight: 600; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .76rem; font-variant-numeric: tabular-nums; }
th, td { padding: .16rem .32rem; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
th { font-weight: 600; } thead tr:first-child th { color: var(--faint); text-align: left; }
thead tr:last-child th { border-bottom: 1px solid var(--line); }
.first { border-left: 1px solid var(--line); }
tr.front td { background: var(--front); }
tr.knob th { padding-top: .7rem; color: var(--faint); text-align: left; }
tbody tr:hover td { outline: 1px solid var(--line); }
figure { margin: 1rem 0; } figcaption { color: var(--faint); font-size: .85rem;
  max-width: 52rem; }
svg.plot { width: min(100%, 56rem); display: block; color: var(--ink); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .3rem 1rem; font-size: .9rem; }
dt { font-weight: 600; } dd { margin: 0; }
.missing { color: var(--faint); font-style: italic; }
@media (max-width: 40rem) { dl { grid-template-columns: 1fr; } }
)";

class Page {
 public:
  Page(const CostReport& report, Drawing (*draw_by)(const std::string&))
      : report_(report), draw_by_(draw_by) {}

  CostPage operator()() {
    out("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<title>The price of accuracy</title><link rel=\"icon\" href=\"data:,\"><style>");
    out(kStyle);
    out("</style></head><body>\n<h1>The price of accuracy</h1>\n");
    put("<p>Each row changes one thing against the default, or a few that belong together. Its "
        "time is the median of up to {} runs that took turns; its error is measured against the "
        "most accurate setting. <a href=\"#legend\">What the columns mean</a> stands at the "
        "end.</p>\n",
        report_.repeats);
    for (const CostImage& image : report_.images) {
      put("<h2>{}</h2>\n", html_text(title_of(image)));
      for (const CostAnswer& answer : image.answers)
        put("<p class=\"answer\">{}</p>\n", html_text(answer.text));
      if (image.tracer) section("The tracer", *image.tracer, tracer_columns(), tracer_plots);
      if (image.lut) section("The LUT", *image.lut, lut_columns(), lut_plots);
    }
    legend();
    out("</body></html>\n");
    return {std::move(text_), missing_.empty() ? "" : missing_ + "; the page has no plots"};
  }

 private:
  void out(std::string_view text) { text_ += text; }
  template <typename... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void section(const char* title, const CostPart& part, const std::vector<CostColumn>& columns,
               std::vector<CostPlot> (*plots_of)(const CostPart&)) {
    put("<h3>{}</h3>\n", title);
    if (!part.sentences.empty()) {
      out("<ul>\n");
      for (const std::string& sentence : part.sentences) put("<li>{}</li>\n", html_text(sentence));
      out("</ul>\n");
    }
    plots(plots_of(part));
    table(part, columns);
  }

  void plots(const std::vector<CostPlot>& all) {
    for (const CostPlot& plot : all) {
      const std::string svg = missing_.empty() ? drawn(plot) : "";
      if (svg.empty()) {
        put("<p class=\"missing\">No plots: {}.</p>\n", html_text(missing_));
        return;
      }
      put("<figure>{}<figcaption>{}. {}</figcaption></figure>\n", svg, html_text(plot.title),
          html_text(plot.caption));
    }
  }

  std::string drawn(const CostPlot& plot) {
    const Drawing drawing = draw_by_(plot.script);
    const std::string svg = inline_svg(drawing.svg, fmt::format("plot{}-", ++plots_), plot.title);
    if (svg.empty()) missing_ = drawing.failure.empty() ? "gnuplot wrote no SVG" : drawing.failure;
    return svg;
  }

  void table(const CostPart& part, const std::vector<CostColumn>& columns) {
    out("<div class=\"scroll\"><table><thead><tr>");
    const auto first = [&](std::size_t i) {
      return i > 0 && columns[i].group != columns[i - 1].group;
    };
    for (std::size_t i = 0; i < columns.size();) {
      std::size_t end = i + 1;
      while (end < columns.size() && !first(end)) ++end;
      put("<th colspan=\"{}\"{}>{}</th>", end - i, first(i) ? " class=\"first\"" : "",
          columns[i].group);
      i = end;
    }
    out("</tr><tr>");
    for (std::size_t i = 0; i < columns.size(); ++i)
      put("<th{}>{}</th>", first(i) ? " class=\"first\"" : "", columns[i].title);
    out("</tr></thead><tbody>\n");
    std::optional<Knob> knob;
    for (const CostRow& row : part.rows) {
      if (row.knob != knob && row.knob)
        put("<tr class=\"knob\"><th colspan=\"{}\">{}</th></tr>\n", columns.size(),
            name_of(*row.knob));
      knob = row.knob;
      put("<tr{}>", row.front ? " class=\"front\"" : "");
      for (std::size_t i = 0; i < columns.size(); ++i)
        put("<td{}>{}</td>", first(i) ? " class=\"first\"" : "", html_text(columns[i].cell(row)));
      out("</tr>\n");
    }
    out("</tbody></table></div>\n");
  }

  void legend() {
    out("<h2 id=\"legend\">What the columns mean</h2>\n<dl>\n");
    for (const auto& [term, meaning] : cost_legend(report_))
      put("<dt>{}</dt><dd>{}.</dd>\n", html_text(term), html_text(meaning));
    out("</dl>\n");
  }

  const CostReport& report_;
  Drawing (*draw_by_)(const std::string&);
  std::string text_, missing_;
  int plots_ = 0;
};

}  // namespace

CostPage cost_html(const CostReport& report, Drawing (*draw_by)(const std::string&)) {
  return Page(report, draw_by)();
}

}  // namespace sir::cli
