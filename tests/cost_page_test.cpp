// Parts of the page: drawings made safe, plots, the page without a drawer.
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/cost/cost_html.h"
#include "cli/cost/cost_plots.h"
#include "cli/cost/svg_inline.h"

namespace sir::cli {
namespace {

constexpr const char* kDrawing = R"svg(<?xml version="1.0"?>
<!DOCTYPE svg>
<svg viewBox="0 0 9 9" xmlns="http://www.w3.org/2000/svg" onload='alert(1)' width="5">
<title>hidden</title><!-- <g> --><script>bad()</script>
<style>* { fill: url(http://x) }</style>
<defs><circle id='dot' r='1'/><filter id="f"><feFlood/></filter></defs>
<g id="empty" stroke="black">
</g>
<g stroke='black' style="x" fill="url(#f)"><use xlink:href='#dot' x="3"/><use href="http://x"/>
<image href="http://x"/><foreignObject><p>in</p></foreignObject>
<text font-family="Arial" onclick='x'>a &lt;b> <tspan>c</tspan></text></g>
</svg>
)svg";

TEST(InlineSvg, KeepsShapesAndTextsAlone) {
  EXPECT_EQ(
      inline_svg(kDrawing, "p-", "A \"plot\""),
      "<svg class=\"plot\" role=\"img\" aria-label=\"A &quot;plot&quot;\" viewBox=\"0 0 9 9\">"
      "<defs><circle id=\"p-dot\" r=\"1\"/></defs>"
      "<g stroke=\"currentColor\"><use href=\"#p-dot\" x=\"3\"/><use/>"
      "<text>a &lt;b> <tspan>c</tspan></text></g></svg>");
}

TEST(InlineSvg, IsEmptyForWhatIsNoDrawing) {
  for (const char* text : {"", "hello", "<html><svg></svg></html>", "<svg>", "<svg><g></svg>",
                           "<svg></svg><svg></svg>", "<svg x></svg>", "<svg a=b></svg>", "</svg>",
                           "<svg viewBox=\"0 0", "<svg><g></text></g></svg>"})
    EXPECT_EQ(inline_svg(text, "p", "l"), "") << text;
}

CostReport a_report() {
  CostReport report;
  CostImage& image = report.images.emplace_back();
  image.name = "<b>&\"x\"";
  CostPart& part = image.tracer.emplace();
  for (int i = 0; i < 4; ++i) {
    CostRow& row = part.rows.emplace_back();
    if (i > 0) row.knob = i < 3 ? Knob::depth : Knob::antialias;
    row.name = row.subject = "row <" + std::to_string(i) + ">";
    row.family = "adaptive";
    row.at = i;
    row.ms = {10.0 + i, 11.0 + i};
    row.picture.psnr = 30.0 + i;
    row.points.emplace();
  }
  settle(part);
  return report;
}

Drawing no_drawer(const std::string&) { return {"", "no <drawer>"}; }
Drawing bad_drawer(const std::string&) { return {"<html></html>", ""}; }

TEST(CostPageText, WithoutADrawerSaysSoAndKeepsTheTables) {
  const CostPage page = cost_html(a_report(), no_drawer);
  EXPECT_EQ(page.missing, "no <drawer>; the page has no plots");
  EXPECT_NE(page.text.find("No plots: no &lt;drawer&gt;."), std::string::npos);
  EXPECT_EQ(page.text.find("<svg"), std::string::npos);
  for (const char* text :
       {"row &lt;0&gt;", "row &lt;3&gt;", "&lt;b&gt;&amp;&quot;x&quot;", "33.00"})
    EXPECT_NE(page.text.find(text), std::string::npos) << text;
  EXPECT_EQ(page.text.find("row <"), std::string::npos);
  EXPECT_EQ(cost_html(a_report(), bad_drawer).missing,
            "gnuplot wrote no SVG; the page has no plots");
}

TEST(CostPlots, AreDrawnByGnuplot) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "gnuplot is not installed (Debian: gnuplot-nox)";
  const auto plots = tracer_plots(*a_report().images[0].tracer);
  ASSERT_EQ(plots.size(), 3u);  // prices, antialiasing, depth
  for (const CostPlot& plot : plots) {
    const Drawing drawing = draw(plot.script);
    EXPECT_EQ(drawing.failure, "") << plot.script;
    const std::string svg = inline_svg(drawing.svg, "p", plot.title);
    EXPECT_NE(svg.find("<path"), std::string::npos) << plot.script;
    EXPECT_EQ(svg.find("http"), std::string::npos);
  }
  const std::string prices = inline_svg(draw(plots[0].script).svg, "p", "");
  EXPECT_NE(prices.find("row &lt;3>"), std::string::npos) << "the front's rows are named";
  const CostPage page = cost_html(a_report());
  EXPECT_EQ(page.missing, "");
  EXPECT_EQ(draw("no such command").failure.find("gnuplot failed: "), 0u);
}

TEST(CostPlots, WithoutRowsOfAKnobItsPlotIsNotThere) {
  CostPart part;
  part.rows.push_back(a_report().images[0].tracer->rows.front());
  settle(part);
  EXPECT_EQ(tracer_plots(part).size(), 1u);
  part.rows.front().picture.psnr.reset();  // nothing is left to draw
  EXPECT_TRUE(tracer_plots(part).empty());
  EXPECT_TRUE(lut_plots(part).empty());
}

}  // namespace
}  // namespace sir::cli
