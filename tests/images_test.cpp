// The five scenes of images/ and the whole chain on them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "eltek/display_driver.h"
#include "quant/choose.h"
#include "quant/nearest.h"
#include "tests/scene_builder.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir {
namespace {

const std::filesystem::path kImages = SIR_IMAGES;

class Images : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Five, Images,
                         testing::Values("whitted", "calice", "luminar", "piramide", "lcg"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(Images, SameBytesForEveryEngineAndNumberOfThreads) {
  const Scene scene = read_scene(kImages / GetParam());
  RenderOptions options;
  options.size = {160, 120};
  options.threads = 1;
  const Planes one = render(scene, options).planes;
  for (const int threads : {2, 7}) {
    options.threads = threads;
    EXPECT_EQ(render(scene, options).planes, one) << threads;
  }
  options.trace.engine = Engine::roth;
  EXPECT_EQ(render(scene, options).planes, one) << "roth";
  options.trace.engine = Engine::gates;
  options.trace.allowed_effects.exhaustive = true;
  EXPECT_EQ(render(scene, options).planes, one) << "all effects' rays";
}

TEST_P(Images, LongDoubleSeesTheSame) {
  const Scene scene = read_scene(kImages / GetParam());
  RenderOptions options;
  options.size = {160, 120};
  const Planes usual = render(scene, options).planes;
  options.precision = Precision::long_double;
  const Planes wide = render(scene, options).planes;
  std::size_t off = 0;
  for (std::size_t p = 0; p < usual.size.pixels(); ++p) off += usual.at(p) != wide.at(p);
  EXPECT_LE(off * 1000, usual.size.pixels());
}

TEST_P(Images, ScaleAndPlaceDoNotShow) {
  const Scene scene = read_scene(kImages / GetParam());
  RenderOptions options;
  options.size = {320, 240};
  const Planes usual = render(scene, options).planes;
  for (const int exponent : {-20, 20})
    EXPECT_EQ(render(test::moved(scene, std::ldexp(1, exponent), {}), options).planes, usual)
        << "2^" << exponent;
  const Planes moved = render(test::moved(scene, 1, {1000, 1000, -1000}), options).planes;
  std::size_t off = 0;
  for (std::size_t p = 0; p < usual.size.pixels(); ++p)
    for (const auto& plane : {0u, 1u, 2u})
      if (std::abs(usual.channel[plane][p] - moved.channel[plane][p]) > 2) {
        ++off;
        break;
      }
  EXPECT_LE(static_cast<double>(off), 0.0005 * static_cast<double>(usual.size.pixels()));
}

TEST_P(Images, FewPixelsAreClippedAndNoneIsDull) {
  const Planes planes = render(read_scene(kImages / GetParam()), {}).planes;
  std::size_t clipped = 0;
  for (std::size_t p = 0; p < planes.size.pixels(); ++p) {
    const Rgb8 c = planes.at(p);
    clipped += c.r == 255 || c.g == 255 || c.b == 255;
  }
  EXPECT_LE(clipped, planes.size.pixels() / 20);
  const auto cells = quant::occupied_cells(planes);
  EXPECT_GT(cells.rgb, 256u) << "an image that needs no choice of colours";
  EXPECT_GT(cells.hsv, 100u);
}

TEST_P(Images, ScreenShowsTheNearestEntryOfEveryPixel) {
  const Planes planes = render(read_scene(kImages / GetParam()), {}).planes;
  const quant::Lut lut = quant::choose_lut(planes, {});
  const auto indices = quant::map_to_lut(planes, lut);
  eltek::Ma120 device;
  const auto area =
      eltek::show_image(device, {GetParam(), planes.size, indices}, lut, eltek::Oversize::refuse);
  EXPECT_EQ(area.column, 192);
  EXPECT_EQ(area.row, 150);
  const eltek::Screen screen = device.scan_out();
  for (int j = 0; j < 480; j += 13)
    for (int i = 0; i < 640; i += 7) {
      const auto pixel = static_cast<std::size_t>(j * 640 + i);
      const Rgb8 seen = screen.pixels[static_cast<std::size_t>((j + 150) * 1024 + i + 192)];
      ASSERT_EQ(seen, quant::seen(lut.entry[quant::nearest_entry(planes.at(pixel), lut)]));
    }
}

}  // namespace
}  // namespace sir
