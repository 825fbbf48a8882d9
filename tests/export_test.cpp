// `sir export`: the text for POV-Ray. What POV-Ray makes of it is in pov_test.
#include "interchange/pov_export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interchange/pov_solid.h"
#include "interchange/pov_view.h"
#include "tests/cases.h"
#include "tests/cli_fixture.h"
#include "tests/scene_builder.h"

namespace sir::test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

// Spheres beside one another, surface 1, joined from the left.
Scene chain(int members, Operation operation, double kt = 0) {
  SceneBuilder build;
  auto whole = build.sphere({0, 0, -9}, 1);
  for (int i = 1; i < members; ++i)
    whole = build.combine(operation, whole, build.sphere({i * 0.5, 0, -9}, 1));
  build.surface(1).first.transmission = kt;
  build.surface(1).first.index = 1.5;
  return build.finish(whole);
}

PovOptions kept() {
  PovOptions options;
  options.scale = PovScale::keep;
  return options;
}

TEST(PovText, SaysHowToRenderItAndWhatTheSceneIs) {
  Scene scene = chain(2, Operation::union_of);
  scene.lighting.background = {0.125, 0.25, 0.5};
  scene.lighting.lights = {{{1, 2, 3}, {0.5, 0.25, 0.125}}};
  scene.camera.window = {4, 3};
  scene.camera.target = {0, 0, -9};
  scene.camera.distance = scene.camera.focal = 4;
  PovOptions options = kept();
  options.file = "two.pov";
  options.size = {320, 200};
  options.depth_limit = 7;
  const std::string text = pov_text(scene, options);
  for (const std::string part :
       {"//   povray +Itwo.pov +Otwo.png +W320 +H200", "File_Gamma=1.0", "#version 3.7;",
        "assumed_gamma 1", "max_trace_level 7", "adc_bailout 0",
        "background { rgb <0.125,0.25,0.5> }", "light_source { <1,2,3> rgb <0.5,0.25,0.125> }",
        "location <0,0,-1>", "direction <0,0,-4>", "right <4,0,0>", "up <0,3,0>", "union {",
        "matrix <1,0,0,0,1,0,0,0,1,0.5,0,-9>"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(PovText, QuotesNamesForTheShellAndForPovRay) {
  PovOptions options;
  options.file = "two balls.pov";
  const std::string text = pov_text(chain(2, Operation::union_of), options);
  EXPECT_NE(text.find("//   povray '+I\"two balls.pov\"' '+O\"two balls.png\"' +W640"),
            std::string::npos)
      << text;
  options.file = "two\nballs.pov";
  EXPECT_NE(pov_text(chain(2, Operation::union_of), options).find("+Itwo?balls.pov"),
            std::string::npos);
}

TEST(PovText, BracesCloseAndCommentsHideNone) {
  for (std::uint64_t seed = 0; seed < cases(20); ++seed) {
    Scene scene = random_scene(seed, 12, seed % 2 == 0);
    scene.tree.nodes[0].name = "} // {{ \\ */";
    for (Surface& surface : scene.surfaces) surface.name = "a } b";
    const std::string text = pov_text(scene, {});
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text.compare(i, 2, "//") == 0) i = text.find('\n', i);
      depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
      ASSERT_GE(depth, 0) << text;
    }
    EXPECT_EQ(depth, 0) << text;
  }
}

TEST(PovText, ChainsBecomeOneStatement) {
  EXPECT_EQ(count(pov_solid(chain(50, Operation::union_of), {}).text, "union {"), 1u);
  EXPECT_EQ(count(pov_solid(chain(50, Operation::union_of, 0.5), {}).text, "merge {"), 1u);
  EXPECT_EQ(count(pov_solid(chain(50, Operation::intersection), {}).text, "intersection {"), 1u);
  const std::string cut = pov_solid(chain(50, Operation::difference), {}).text;
  EXPECT_EQ(count(cut, "difference {"), 1u);
  EXPECT_LT(cut.find("0,0,-9>"), cut.find("0.5,0,-9>"));  // the minuend first
  EXPECT_EQ(count(cut, "sphere {"), 50u);
}

TEST(PovText, DifferenceKeepsItsMeaning) {
  // a - (b - c) is not a - b - c, and a - (b or c) is.
  for (const auto& [operation, statements] :
       {std::pair{Operation::difference, 2u}, {Operation::union_of, 1u}}) {
    SceneBuilder build;
    const auto a = build.sphere({0, 0, 0}, 1), b = build.sphere({1, 0, 0}, 1),
               c = build.sphere({2, 0, 0}, 1);
    const Scene scene =
        build.finish(build.combine(Operation::difference, a, build.combine(operation, b, c)));
    const std::string text = pov_solid(scene, {}).text;
    EXPECT_EQ(count(text, "difference {"), statements) << text;
    EXPECT_EQ(count(text, "union {"), 0u) << text;
  }
}

TEST(PovText, TakesChainsOfAnyLength) {
  for (const double kt : {0.0, 0.5}) {
    const std::string text = pov_text(chain(100'000, Operation::union_of, kt), {});
    EXPECT_EQ(count(text, "\n  sphere {"), 100'000u);
  }
  // Nor does alternation, which POV-Ray has to nest, take our stack.
  SceneBuilder build;
  auto whole = build.sphere({0, 0, -9}, 1);
  for (int i = 1; i < 100'000; ++i)
    whole = build.combine(i % 2 == 0 ? Operation::union_of : Operation::intersection, whole,
                          build.sphere({0.1, 0, -9}, 1));
  EXPECT_EQ(count(pov_text(build.finish(whole), {}), "sphere {"), 100'000u);
}

TEST(PovText, MediaOfOneIndexShareAnInterior) {
  SceneBuilder build;
  const auto a = build.sphere({0, 0, 0}, 1, 1), b = build.sphere({1, 0, 0}, 1, 2),
             c = build.sphere({2, 0, 0}, 1, 1);
  for (const int number : {1, 2}) {
    build.surface(number).first.transmission = 0.5;
    build.surface(number).first.index = 1.25 + 0.25 * number;
  }
  Scene scene =
      build.finish(build.combine(Operation::union_of, build.combine(Operation::union_of, a, b), c));
  const PovSolid two = pov_solid(scene, {});
  EXPECT_EQ(count(two.text, "merge {"), 2u) << two.text;
  EXPECT_EQ(count(two.text, "interior { ior 1.5 }"), 1u) << two.text;
  EXPECT_EQ(count(two.text, "interior { ior 1.75 }"), 1u) << two.text;
  EXPECT_EQ(two.interior, "");
  scene.surfaces[1].first.index = 1.5;
  const PovSolid one = pov_solid(scene, {});
  EXPECT_EQ(count(one.text, "interior"), 0u) << one.text;
  EXPECT_EQ(one.interior, "interior { ior 1.5 }");
}

TEST(PovText, FitsTheSceneByAPowerOfTwo) {
  const Scene near = random_scene(3, 6, false);
  const PovFrame plain = fitting_frame(near);
  EXPECT_EQ(plain.centre, glm::dvec3(0));
  EXPECT_EQ(std::exp2(std::round(std::log2(plain.factor))), plain.factor);
  // Powers of two of the scene's size change nothing in the file.
  const auto matrices = [](const Scene& scene) {
    const std::string text = pov_text(scene, {});
    return text.substr(text.find("#declare Solid"));
  };
  EXPECT_EQ(matrices(moved(near, std::ldexp(1, -40), {})), matrices(near));
  const PovFrame far = fitting_frame(moved(near, 1, {1e7, 0, -3e6}));
  EXPECT_LT(glm::length(far.centre - glm::dvec3(1e7, 0, -3e6)), 20);
}

TEST(PovText, ClipsOnlyWhereSomethingStandsBeforeTheScreen) {
  SceneBuilder build;
  Scene scene = build.finish(build.cube({-9, -1, -9}, {9, -0.9, 9}));
  scene.camera.window = {1, 1};
  scene.camera.target = {0, 0, -5};
  scene.camera.distance = scene.camera.focal = 5;
  EXPECT_FALSE(reaches_before_screen(scene));  // below the pyramid, though beside it too
  scene.camera.target.y = -1;
  EXPECT_TRUE(reaches_before_screen(scene));
  EXPECT_EQ(count(pov_text(scene, {}), "clipped_by"), 1u);
  scene.camera.parallel = true;
  EXPECT_FALSE(reaches_before_screen(scene));
  scene.camera.parallel = false;
  scene.tree.nodes[0].placement = placed({99, 99, 99}, {-50, -50, -50});
  EXPECT_FALSE(reaches_before_screen(scene));  // all of it inside
}

TEST_F(CliTest, ExportWritesAPovFile) {
  const Ended ended = sir({"export", "s", "--pov", "cena.pov", "--depth", "3", "--size", "80x60"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "wrote cena.pov\n");
  EXPECT_EQ(ended.out, "");
  const std::string text = folder.read("cena.pov");
  EXPECT_NE(text.find("povray +Icena.pov +Ocena.png +W80 +H60"), std::string::npos);
  EXPECT_NE(text.find("max_trace_level 3"), std::string::npos);
  EXPECT_NE(text.find("difference { // 0 \"tudo\""), std::string::npos);
  EXPECT_NE(text.find("S2_ball"), std::string::npos);
  EXPECT_EQ(sir({"export", "s", "--pov", "kept.pov", "--scale", "keep", "-q"}).exit_code, 0);
  EXPECT_NE(folder.read("kept.pov").find("matrix <1,0,0,0,1,0,0,0,1,0,0,0>"), std::string::npos);
}

TEST_F(CliTest, ExportRefusesWhatItCannotDo) {
  EXPECT_EQ(sir({"export", "s"}).exit_code, 2);
  EXPECT_EQ(sir({"export", "--pov", "cena.pov"}).exit_code, 2);
  EXPECT_EQ(sir({"export", "s", "--pov", "cena.pov", "--scale", "big"}).exit_code, 2);
  EXPECT_EQ(sir({"export", "s", "--pov", "cena.pov", "--depth", "0"}).exit_code, 2);
  expect_failure(sir({"export", "none", "--pov", "cena.pov"}), "none.CSG");
  expect_failure(sir({"export", "s", "--pov", "no/such/cena.pov"}), "no/such/cena.pov");
  const std::string before = folder.read("s.LUZ");
  expect_failure(sir({"export", "s", "--pov", "s.LUZ"}), "s.LUZ");
  std::filesystem::create_symlink("s.CSG", folder / "link.pov");
  expect_failure(sir({"export", "s", "--pov", "link.pov"}), "link.pov");
  EXPECT_EQ(folder.read("s.LUZ"), before);
  EXPECT_FALSE(folder.has("cena.pov"));
}

}  // namespace
}  // namespace sir::test
