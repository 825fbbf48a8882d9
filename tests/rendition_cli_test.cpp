// The viewer's methods beside `sir lut` and `sir show`: the same LUTs, the same pixels.
#include <gtest/gtest.h>

#include "tests/cli_fixture.h"
#include "viewer/png_file.h"
#include "viewer/rendition.h"

namespace sir::test {
namespace {

using viewer::Method;
using RenditionCommand = CliTest;

TEST_F(RenditionCommand, MakesWhatTheProgramMakes) {
  struct Case {
    Method method;
    std::vector<std::string> words;
  };
  render();
  viewer::Picture picture;
  picture.input = folder / "s.png";
  picture.base = folder / "s";
  picture.planes = viewer::read_png(folder / "s.png");
  for (const Case& c : {Case{Method::rgb_frequency, {"--method", "frequency", "--space", "rgb"}},
                        Case{Method::rgb_median, {"--method", "median", "--space", "rgb"}},
                        Case{Method::hsv_frequency, {"--method", "frequency", "--space", "hsv"}},
                        Case{Method::hsv_median, {}}, Case{Method::best, {"--method", "best"}}}) {
    std::vector<std::string> words{"lut", "s.png", "-q"};
    words.insert(words.end(), c.words.begin(), c.words.end());
    ASSERT_EQ(sir(words).exit_code, 0) << name(c.method);
    ASSERT_EQ(sir({"show", "s.png", "--crop", "--png", "shown.png"}).exit_code, 0);
    const Planes shown = viewer::read_png(folder / "shown.png");

    const viewer::Rendition chosen = make_rendition(picture, c.method, {});
    EXPECT_EQ(quant::lut_text(chosen.lut), folder.read("s.LUT")) << name(c.method);
    EXPECT_EQ(chosen.seen, shown) << name(c.method);
    const viewer::Rendition read = make_rendition(picture, Method::lut_file, {});
    EXPECT_EQ(read.lut, quant::read_lut(folder / "s.LUT"));
    EXPECT_EQ(read.seen, shown) << name(c.method);
  }
}

TEST_F(RenditionCommand, ShowTakesMedianInHsvWhereThereIsNoLut) {
  render();
  const Ended ended = sir({"show", "s.png", "--crop", "--png", "shown.png"});
  EXPECT_EQ(ended.err, "s.png: there is no s.LUT; shown with a LUT chosen by median in hsv\n");
  viewer::Picture picture;
  picture.planes = viewer::read_png(folder / "s.png");
  EXPECT_EQ(viewer::read_png(folder / "shown.png"),
            make_rendition(picture, Method::hsv_median, {}).seen);
}

}  // namespace
}  // namespace sir::test
