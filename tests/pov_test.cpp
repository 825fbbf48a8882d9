// The image oracle: POV-Ray 3.7 renders what `sir export` writes, and the pixels
// are compared. Skipped where there is no `povray`.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>

#include "interchange/pov_export.h"
#include "tests/pov_scenes.h"
#include "tests/run_program.h"
#include "tests/temp_folder.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"
#include "tracer/trace.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

constexpr const char* kNoPovray =
    "no `povray` in PATH: images are compared only where POV-Ray 3.7 is installed";
constexpr int kNear = 2;                 // levels
constexpr double kWantedShare = 0.9995;  // of the pixels, within kNear in all channels

std::string find_povray() {
  std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/povray").c_str(), X_OK) == 0) return folder + "/povray";
  return {};
}

Planes render_by_povray(const Scene& scene, const PovOptions& options) {
  const TempFolder folder;
  folder.write("scene.pov", pov_text(scene, options));
  Start start;
  start.folder = folder.path();
  Program povray(find_povray(), pov_arguments("scene.pov", "scene.png", options.size), start);
  const Ended ended = povray.finish();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  if (!folder.has("scene.png")) return Planes(options.size);
  return viewer::read_png(folder / "scene.png");
}

// What may be behind a pixel that is not near.
enum class Class { total_reflection, edge, depth_limit, other };
constexpr const char* kClassNames[] = {"total reflection", "edge", "depth limit", "other"};

class Explorer {
 public:
  Explorer(const Scene& scene, const RenderOptions& options)
      : model_(scene, options.trace.allowed_effects),
        tracer_(model_, options.trace),
        size_(options.size),
        depth_limit_(options.trace.depth_limit) {}

  bool has_total_reflection(int i, int j) {
    for (const TraceNode& node : log_of(i, j))
      if (node.total_reflection) return true;
    return false;
  }

  Class classify(int i, int j) {
    if (has_total_reflection(i, j)) return Class::total_reflection;
    const std::string own = path_of(i, j);
    // Within a tenth of a pixel of another tree of rays.
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
      if (path_of(10 * i + 5 + dx, 10 * j + 5 + dy, 10) != path_of(10 * i + 5, 10 * j + 5, 10))
        return Class::edge;
    if (own.find('!') != std::string::npos) return Class::depth_limit;
    return Class::other;
  }

 private:
  const TraceLog& log_of(int i, int j, int finer = 1) {
    log_.clear();
    tracer_.radiance(model_.camera.primary_ray(i, j, {finer * size_.width, finer * size_.height}),
                     &log_);
    return log_;
  }

  // Which faces the tree's rays meet and which lights reach them; '!' where the
  // depth limit cuts rays of weight off.
  std::string path_of(int i, int j, int finer = 1) {
    std::string path;
    for (const TraceNode& node : log_of(i, j, finer)) {
      path += std::to_string(node.depth) + (node.hit ? ":" : "-");
      if (!node.hit) continue;
      path += std::to_string(node.node) + "." + std::to_string(node.face) + "." +
              (node.coefficients.diffuse == first_diffuse(node) ? "a" : "b");
      for (const glm::dvec3& light : node.lights) path += light == glm::dvec3(0) ? "0" : "1";
      if (node.depth == depth_limit_ &&
          node.coefficients.specular + node.coefficients.transmission > 0)
        path += "!";
    }
    return path;
  }

  glm::dvec3 first_diffuse(const TraceNode& node) const {
    return glm::dvec3(model_.textures[node.surface].at({0, 0}, false).diffuse);
  }

  Model<double> model_;
  Tracer<double> tracer_;
  ImageSize size_;
  int depth_limit_;
  TraceLog log_;
};

struct Comparison {
  std::size_t pixels = 0, far_off = 0, unequal = 0;
  std::map<Class, std::size_t> classes;  // of those far off
  double share() const { return 1 - static_cast<double>(far_off) / static_cast<double>(pixels); }
};

Comparison compare(const PovCase& given, ImageSize size, const std::string& mark = "") {
  const std::string name = given.name + mark;
  RenderOptions options;
  options.size = size;
  options.trace.depth_limit = given.depth_limit;
  PovOptions pov;
  pov.size = size;
  pov.depth_limit = given.depth_limit;
  const Planes ours = render(given.scene, options).planes;
  const Planes theirs = render_by_povray(given.scene, pov);
  if (const char* folder = std::getenv("SIR_POV_PICTURES")) {
    viewer::write_rgb_png(std::string(folder) + "/" + name + "-sir.png", ours);
    viewer::write_rgb_png(std::string(folder) + "/" + name + "-pov.png", theirs);
  }
  Comparison result;
  result.pixels = size.pixels();
  if (theirs.size != ours.size) {
    ADD_FAILURE() << name << ": POV-Ray's image has another size";
    result.far_off = result.pixels;
    return result;
  }
  Explorer explorer(given.scene, options);
  const Rgb8 background = to_rgb8(given.scene.lighting.background);
  std::size_t seen = 0;
  int worst = 0;
  for (std::size_t p = 0; p < result.pixels; ++p) {
    const Rgb8 a = ours.at(p), b = theirs.at(p);
    const int d = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    worst = std::max(worst, d);
    seen += a != background;
    result.unequal += d > 0;
    if (d <= kNear) continue;
    ++result.far_off;
    const auto width = static_cast<std::size_t>(size.width);
    ++result.classes[explorer.classify(static_cast<int>(p % width), static_cast<int>(p / width))];
  }
  EXPECT_GT(20 * seen, result.pixels) << name << " shows next to nothing";
  std::cout << name << ": " << 100 * result.share() << " % within " << kNear << " levels, "
            << result.unequal << " of " << result.pixels << " pixels differ, by at most " << worst;
  for (const auto& [kind, count] : result.classes)
    std::cout << "; " << kClassNames[static_cast<int>(kind)] << " " << count;
  std::cout << std::endl;
  return result;
}

class Pov : public testing::TestWithParam<PovCase> {
 protected:
  void SetUp() override {
    if (find_povray().empty())
      GTEST_SKIP()
          << "no `povray` in PATH: images are compared only where POV-Ray 3.7 is installed";
  }
};

TEST_P(Pov, RendersTheSameImage) {
  EXPECT_GE(compare(GetParam(), {320, 240}).share(), kWantedShare);
}

INSTANTIATE_TEST_SUITE_P(Made, Pov, testing::ValuesIn(pov_cases()),
                         [](const auto& given) { return given.param.name; });

class PovImages : public testing::TestWithParam<std::string> {};

TEST_P(PovImages, RendersTheSameImage) {
  if (find_povray().empty()) GTEST_SKIP() << kNoPovray;
  const PovCase given{GetParam(), read_scene(SIR_IMAGES "/" + GetParam())};
  EXPECT_GE(compare(given, {640, 480}).share(), kWantedShare);
}

INSTANTIATE_TEST_SUITE_P(Five, PovImages,
                         testing::Values("whitted", "calice", "luminar", "piramide", "lcg"),
                         [](const auto& given) { return given.param; });

// Where ks + kt is not 1, POV-Ray's weight of the totally reflected ray is another.
class PovUnequal : public Pov {};

TEST_P(PovUnequal, DiffersByTotalReflectionAlone) {
  const Comparison result = compare(GetParam(), {320, 240}, "-as_generated");
  const auto total = result.classes.find(Class::total_reflection);
  const std::size_t others = result.far_off - (total == result.classes.end() ? 0 : total->second);
  EXPECT_LE(static_cast<double>(others), (1 - kWantedShare) * static_cast<double>(result.pixels));
}

INSTANTIATE_TEST_SUITE_P(Random, PovUnequal, testing::ValuesIn(pov_random_cases()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace sir::test
