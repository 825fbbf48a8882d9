// Coarse to fine: the same image in the end, and what is shown on the way.
#include "tracer/sample_progressive.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/scene_builder.h"
#include "tracer/scene_file.h"

namespace sir {
namespace {

struct Shown {
  Planes picture;
  Stage stage;
};

RenderResult progressive(const Scene& scene, const RenderOptions& options,
                         std::vector<Shown>& shown) {
  shown.clear();
  return render_progressive(scene, options, [&](const Planes& picture, const Stage& stage) {
    shown.push_back({picture, stage});
  });
}

RenderOptions sized(ImageSize size) {
  RenderOptions options;
  options.size = size;
  return options;
}

void expect_the_plain_image(const Scene& scene, const RenderOptions& options) {
  const RenderResult plain = render(scene, options);
  std::vector<Shown> shown;
  const RenderResult result = progressive(scene, options, shown);
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(result.planes == plain.planes);
  EXPECT_EQ(result.counts.primary, plain.counts.primary) << "a pixel was traced twice, or never";
  EXPECT_EQ(result.counts.shadow, plain.counts.shadow);
  EXPECT_EQ(result.counts.reflected, plain.counts.reflected);
  EXPECT_EQ(result.counts.refracted, plain.counts.refracted);
  EXPECT_EQ(result.counts.filtered, plain.counts.filtered);
  EXPECT_EQ(result.counts.spared, plain.counts.spared);
  EXPECT_EQ(result.counts.exact, plain.counts.exact);
  EXPECT_EQ(result.counts.doubtful, plain.counts.doubtful);
  ASSERT_EQ(shown.size(), 6u);
  for (std::size_t s = 0; s < 6; ++s) {
    EXPECT_EQ(shown[s].stage.block, std::max(16 >> s, 1));
    EXPECT_EQ(shown[s].stage.refined_only, s >= 1 && s <= 4);
    EXPECT_FALSE(shown[s].stage.antialiased);
    EXPECT_EQ(shown[s].picture.size, plain.planes.size);
  }
  const std::size_t first = static_cast<std::size_t>((plain.planes.size.width + 15) / 16) *
                            static_cast<std::size_t>((plain.planes.size.height + 15) / 16);
  EXPECT_DOUBLE_EQ(shown[0].stage.share, double(first) / double(plain.planes.size.pixels()));
  EXPECT_EQ(shown[5].stage.share, 1);
  EXPECT_TRUE(shown[5].picture == plain.planes);
}

TEST(Progressive, FiveImages) {
  for (const char* name : {"whitted", "calice", "luminar", "piramide", "lcg"}) {
    SCOPED_TRACE(name);
    expect_the_plain_image(read_scene(std::filesystem::path(SIR_IMAGES) / name), sized({100, 75}));
  }
}

TEST(Progressive, RandomScenesSizesRegionsThreadsAndPrecisions) {
  const ImageSize sizes[] = {{1, 1}, {1, 40}, {40, 1}, {17, 31}, {16, 16}, {33, 48}};
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    RenderOptions options = sized(sizes[seed % 6]);
    options.threads = 1 + static_cast<int>(seed % 3) * 3;
    options.precision = seed % 2 ? Precision::float_ : Precision::double_;
    const Scene scene = test::random_scene(seed, 9, seed % 4 == 0);
    expect_the_plain_image(scene, options);
    options.size = {64, 48};
    options.region = {13, 7, 40, 33};
    expect_the_plain_image(scene, options);
  }
}

// The definition of the stages, told from the finished image.
TEST(Progressive, EachStageTracesWhereBlocksDiffer) {
  for (const std::uint64_t seed : {3u, 7u, 15u}) {
    const Scene scene = test::random_scene(seed, 9, false);
    const RenderOptions options = sized({75, 53});
    std::vector<Shown> shown;
    const Planes plain = progressive(scene, options, shown).planes;
    const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 75 + x); };
    std::vector<bool> traced(75 * 53, false);
    std::size_t count = 0;
    for (int y = 0; y < 53; ++y)
      for (int x = 0; x < 75; ++x)
        if (x % 16 == 0 && y % 16 == 0) traced[at(x, y)] = true, ++count;
    for (std::size_t s = 0; s < 5; ++s) {
      const int block = 16 >> s;
      const Planes& picture = shown[s].picture;
      EXPECT_DOUBLE_EQ(shown[s].stage.share, double(count) / (75 * 53));
      EXPECT_TRUE(s == 0 ? count == 20u : count > 20u) << count;
      for (int y = 0; y < 53; ++y)
        for (int x = 0; x < 75; ++x) {
          ASSERT_EQ(picture.at(at(x, y)), picture.at(at(x - x % block, y - y % block)));
          if (traced[at(x, y)]) {
            ASSERT_EQ(picture.at(at(x, y)), plain.at(at(x, y)));
          }
        }
      for (int y = 0; y < 53; ++y)
        for (int x = 0; x < 75; ++x) {
          if (block == 1 || x % (block / 2) || y % (block / 2) || traced[at(x, y)]) continue;
          const int own_x = x - x % block, own_y = y - y % block;
          bool differs = false;
          for (int v = own_y - block; v <= own_y + block; v += block)
            for (int u = own_x - block; u <= own_x + block; u += block)
              if (u >= 0 && v >= 0 && u < 75 && v < 53)
                differs = differs || picture.at(at(u, v)) != picture.at(at(own_x, own_y));
          if (differs) traced[at(x, y)] = true, ++count;
        }
    }
  }
}

TEST(Progressive, AntialiasedImageIsTheLastStage) {
  const Scene scene = test::random_scene(3, 9, false);
  RenderOptions options = sized({50, 37});
  const Planes plain = render(scene, options).planes;
  for (const auto mode : {Antialias::adaptive, Antialias::random}) {
    options.antialias.mode = mode;
    options.region = {0, 0, 50, 37};
    const RenderResult direct = render(scene, options);
    std::vector<Shown> shown;
    const RenderResult result = progressive(scene, options, shown);
    EXPECT_TRUE(result.planes == direct.planes);
    EXPECT_TRUE(result.effects.antialias);
    EXPECT_EQ(result.antialias.points, direct.antialias.points);
    EXPECT_EQ(result.antialias.divided, direct.antialias.divided);
    EXPECT_EQ(result.counts.primary, direct.counts.primary + 50 * 37);
    ASSERT_EQ(shown.size(), 7u);
    EXPECT_TRUE(shown[5].picture == plain);
    EXPECT_FALSE(shown[5].stage.antialiased);
    EXPECT_TRUE(shown[6].stage.antialiased);
    EXPECT_TRUE(shown[6].picture == direct.planes);
  }
  options.antialias.threshold = 256;
  options.antialias.mode = Antialias::adaptive;
  std::vector<Shown> shown;
  EXPECT_THROW(progressive(scene, options, shown), std::invalid_argument);
  EXPECT_TRUE(shown.empty());
}

TEST(Progressive, AStopLeavesTheLatestPicture) {
  const Scene scene = test::random_scene(3, 9, false);
  for (const std::size_t after : {1u, 2u, 5u}) {
    std::stop_source stop;
    std::vector<Shown> shown;
    const auto show = [&](const Planes& picture, const Stage& stage) {
      shown.push_back({picture, stage});
      if (shown.size() == after) stop.request_stop();
    };
    const RenderResult result = render_progressive(scene, sized({100, 75}), show, stop.get_token());
    EXPECT_FALSE(result.complete);
    ASSERT_EQ(shown.size(), after);
    EXPECT_TRUE(result.planes == shown.back().picture);
    // Not one ray more.
    EXPECT_DOUBLE_EQ(double(result.counts.primary) / 7500, shown.back().stage.share);
  }
}

TEST(Progressive, ProgressRisesToOne) {
  double last = 0;
  bool rising = true;
  RenderOptions options = sized({100, 75});
  render_progressive(
      test::random_scene(3, 9, false), options, [](const Planes&, const Stage&) {}, {},
      [&](double done) {
        rising = rising && done >= last;
        last = done;
      });
  EXPECT_TRUE(rising);
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(Preview, IsAStageOrARegularPattern) {
  const Scene scene = test::random_scene(3, 9, false);
  RenderOptions options = sized({75, 53});
  std::vector<Shown> shown;
  const Planes plain = progressive(scene, options, shown).planes;
  options.antialias.mode = Antialias::adaptive;  // without effect
  for (std::size_t s = 0; s < 5; ++s) {
    const int block = 16 >> s;
    const RenderResult refined = render_preview(scene, options, block, true);
    EXPECT_TRUE(refined.planes == shown[s].picture) << block;
    EXPECT_DOUBLE_EQ(double(refined.counts.primary) / (75 * 53), shown[s].stage.share);
    EXPECT_FALSE(refined.effects.antialias);
    const RenderResult whole = render_preview(scene, options, block, false);
    EXPECT_EQ(whole.counts.primary,
              static_cast<std::uint64_t>(((75 + block - 1) / block) * ((53 + block - 1) / block)));
    for (int y = 0; y < 53; ++y)
      for (int x = 0; x < 75; ++x)
        ASSERT_EQ(whole.planes.at(static_cast<std::size_t>(y * 75 + x)),
                  plain.at(static_cast<std::size_t>((y - y % block) * 75 + x - x % block)));
  }
  for (const int block : {-1, 0, 3, 32})
    EXPECT_THROW(render_preview(scene, options, block, true), std::invalid_argument);
}

}  // namespace
}  // namespace sir
