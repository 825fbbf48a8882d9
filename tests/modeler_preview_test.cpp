// The preview: what it shows in the end, on the way, and when it is told otherwise; what is at a
// pixel.
#include <set>

#include "modeler/ghosts.h"
#include "modeler/pick.h"
#include "modeler/preview.h"
#include "modeler/silhouette.h"
#include "modeler/view.h"
#include "tests/cases.h"
#include "tests/eventually.h"
#include "tests/modeler_fixture.h"
#include "tests/scene_builder.h"
#include "tracer/camera.h"
#include "tracer/probe.h"
#include "tracer/render.h"

namespace sir::test {
namespace {

using modeler::PreviewPicture;
using modeler::PreviewRequest;

class PreviewTest : public ModelerTest {
 protected:
  // Hears of every picture, as a window would.
  struct Heard {
    std::mutex mutex;
    std::vector<std::shared_ptr<const PreviewPicture>> pictures;
  };

  // The preview's thread calls this: the picture of the moment is taken within the call.
  std::unique_ptr<modeler::Preview> listening() {
    auto preview = std::make_unique<modeler::Preview>([this] {
      const std::scoped_lock lock(heard_.mutex);
      if (!preview_) return;
      const auto picture = preview_->take();
      if (picture && (heard_.pictures.empty() || heard_.pictures.back() != picture))
        heard_.pictures.push_back(picture);
    });
    const std::scoped_lock lock(heard_.mutex);
    preview_ = preview.get();
    return preview;
  }

  static std::shared_ptr<const PreviewPicture> whole(modeler::Preview& preview,
                                                     std::uint64_t number) {
    EXPECT_TRUE(eventually([&] {
      const auto picture = preview.take();
      return picture && picture->request == number && picture->whole;
    })) << preview.error();
    return preview.take();
  }

  static PreviewRequest request_of(const char* name, ImageSize size = {96, 72}) {
    const Scene scene = read_scene(std::string(SIR_IMAGES "/") + name);
    PreviewRequest request;
    request.solid = modeler::from_csg(scene.tree);
    request.camera = scene.camera;
    request.lighting = scene.lighting;
    request.surfaces = scene.surfaces;
    request.size = size;
    return request;
  }

  // A ball of which a smaller one in front is taken away, and a wall behind them.
  PreviewRequest bitten() {
    say_all({"create ball sphere 1", "create bite sphere 2", "scale bite 0.5",
             "translate bite 0 0 1", "combine rest ball difference bite", "create wall cube 3",
             "translate wall -0.5 -0.5 -3", "combine all rest union wall"});
    PreviewRequest request;
    request.solid = interpreter.solids().find("all")->solid.tree();
    request.camera.window = {4, 3};
    request.camera.target = {0, 0, 0};
    request.camera.distance = 3;
    request.camera.focal = 3;
    request.size = {64, 48};
    return request;
  }

  Heard heard_;
  modeler::Preview* preview_ = nullptr;
};

TEST_F(PreviewTest, TheWholePictureIsTheTracersOfTheSameScene) {
  modeler::Preview preview([] {});
  for (const char* name : {"calice", "piramide", "whitted"}) {
    const PreviewRequest request = request_of(name);
    RenderOptions options;
    options.size = request.size;
    const auto picture = whole(preview, preview.request(request));
    EXPECT_TRUE(picture->planes ==
                render(read_scene(std::string(SIR_IMAGES "/") + name), options).planes)
        << name;
    EXPECT_EQ(picture->block, 1);
    EXPECT_TRUE(eventually([&] { return !preview.busy(); }));
    EXPECT_EQ(preview.error(), "");
  }
}

TEST_F(PreviewTest, NumbersThatAreNotDescribedHaveTheLooksOfShow) {
  PreviewRequest request = request_of("whitted", {32, 24});
  request.surfaces.clear();
  request.lighting.reset();
  modeler::Preview preview([] {});
  RenderOptions options;
  options.size = request.size;
  EXPECT_TRUE(whole(preview, preview.request(request))->planes ==
              render(modeler::scene_of(*request.solid, request.camera), options).planes);
}

TEST_F(PreviewTest, PicturesComeFromCoarseToFine) {
  const auto preview = listening();
  const std::uint64_t number = preview->request(request_of("calice"));
  whole(*preview, number);
  ASSERT_TRUE(eventually([&] { return !preview->busy(); }));
  const std::scoped_lock lock(heard_.mutex);
  ASSERT_GE(heard_.pictures.size(), 2u);
  EXPECT_EQ(heard_.pictures.front()->block, 16);
  for (std::size_t i = 0; i < heard_.pictures.size(); ++i) {
    EXPECT_EQ(heard_.pictures[i]->request, number);
    EXPECT_EQ(heard_.pictures[i]->whole, i + 1 == heard_.pictures.size());
    EXPECT_LE(heard_.pictures[i]->block, heard_.pictures[i > 0 ? i - 1 : 0]->block);
  }
}

TEST_F(PreviewTest, ARequestReplacesTheOneUnderWay) {
  // Far more pixels than are traced before the next call.
  const PreviewRequest endless = request_of("whitted", {8000, 6000});
  const PreviewRequest small = request_of("piramide", {40, 30});
  modeler::Preview preview([] {});
  const std::uint64_t first = preview.request(endless);
  ASSERT_TRUE(eventually([&] { return preview.take() != nullptr; }));
  EXPECT_EQ(preview.take()->request, first);
  EXPECT_FALSE(preview.take()->whole);
  std::uint64_t number = 0;
  for (int i = 0; i < 20; ++i) number = preview.request(i % 2 == 0 ? endless : small);
  EXPECT_EQ(number, 21u);
  EXPECT_EQ(whole(preview, number)->planes.size, small.size);
  EXPECT_TRUE(eventually([&] { return !preview.busy(); }));
  EXPECT_EQ(preview.take()->request, number);
}

TEST_F(PreviewTest, WhatIsCancelledStaysAsItWas) {
  modeler::Preview preview([] {});
  preview.request(request_of("whitted", {8000, 6000}));
  ASSERT_TRUE(eventually([&] { return preview.take() != nullptr; }));
  preview.cancel();
  EXPECT_TRUE(eventually([&] { return !preview.busy(); }));
  EXPECT_FALSE(preview.take()->whole);
  EXPECT_EQ(preview.error(), "");
}

TEST_F(PreviewTest, NothingIsTheBackground) {
  PreviewRequest request;
  request.size = {8, 6};
  request.lighting.emplace().background = {1, 0.5, 0};
  modeler::Preview preview([] {});
  EXPECT_EQ(whole(preview, preview.request(request))->planes.at(20), (Rgb8{255, 128, 0}));
}

TEST_F(PreviewTest, GhostsAreSeenOnlyWhereTheyAreInFront) {
  PreviewRequest request = bitten();
  modeler::Preview preview([] {});
  const Planes plain = whole(preview, preview.request(request))->planes;
  request.ghosts = true;
  const Planes haunted = whole(preview, preview.request(request))->planes;
  // The ghost's outline from the eye at z = 6: a ball of 0.5 that is 5 away.
  int inside = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const double across = std::hypot((x + 0.5 - 32) / 16, (y + 0.5 - 24) / 16);
      const bool seen = across / 3 < std::tan(std::asin(0.5 / 5));
      const auto pixel = static_cast<std::size_t>(y * 64 + x);
      EXPECT_EQ(haunted.at(pixel) != plain.at(pixel), seen) << x << "," << y;
      inside += seen ? 1 : 0;
    }
  EXPECT_GT(inside, 50);
  // From behind, the ball hides all of it.
  request.camera.normal = {0, 0, 1};
  request.ghosts = false;
  const Planes behind = whole(preview, preview.request(request))->planes;
  request.ghosts = true;
  EXPECT_TRUE(whole(preview, preview.request(request))->planes == behind);
}

TEST_F(PreviewTest, WithoutDifferencesThereAreNoGhosts) {
  say("create a sphere 1");
  const Scene scene = modeler::scene_of(solid("a"), CameraFile{});
  Scene ghosts;
  EXPECT_FALSE(modeler::make_ghost_scene(scene, ghosts));
}

TEST_F(PreviewTest, TheSilhouetteLiesOverThePicture) {
  PreviewRequest request = bitten();
  modeler::Preview preview([] {});
  const Planes plain = whole(preview, preview.request(request))->planes;
  request.silhouette = true;
  const Planes lined = whole(preview, preview.request(request))->planes;
  const Planes lines =
      modeler::silhouette(*request.solid, modeler::preview_scene(request), request.size);
  for (std::size_t pixel = 0; pixel < plain.size.pixels(); ++pixel)
    EXPECT_EQ(lined.at(pixel), lines.at(pixel) == Rgb8{} ? plain.at(pixel) : lines.at(pixel));
}

TEST_F(PreviewTest, LinesAreFaintBehindTheSolid) {
  PreviewRequest request = bitten();
  modeler::Preview preview([] {});
  const Planes plain = whole(preview, preview.request(request))->planes;
  // Along X, in front of the ball and the same behind it (farther away, hence higher up).
  const Rgb8 red{255, 0, 0};
  for (const bool parallel : {false, true})
    for (const double z : {2.0, -2.0}) {
      request.camera.parallel = parallel;
      request.guides = {{{-3, 0.3, z}, {3, 0.3, z}, red}};
      modeler::Picker picker(request.solid, request.camera, request.size);
      const auto pixels = modeler::pixels_of(request.guides, request.camera, request.size, &picker);
      std::set<double> over_ball, beside;
      for (const auto& at : pixels) {
        const int x = static_cast<int>(at.pixel % 64), y = static_cast<int>(at.pixel / 64);
        (picker.at(x, y) ? over_ball : beside).insert(at.share);
      }
      ASSERT_EQ(over_ball.size(), 1u);
      ASSERT_EQ(beside.size(), 1u);
      if (z > 0) EXPECT_EQ(*over_ball.begin(), *beside.begin());
      else EXPECT_LT(*over_ball.begin(), *beside.begin());
    }
  // What is before the screen is not seen.
  EXPECT_TRUE(
      modeler::pixels_of({{{0, 0, 4}, {1, 1, 5}, red}}, request.camera, request.size, nullptr)
          .empty());
  request.camera.parallel = false;
  request.guides = {{{-3, 1.2, 0}, {3, 1.2, 0}, red}};
  const auto picture = whole(preview, preview.request(request));
  for (const auto& at : modeler::pixels_of(request.guides, request.camera, request.size, nullptr))
    EXPECT_EQ(picture->planes.at(at.pixel),
              modeler::mixed(plain.at(at.pixel), at.colour, at.share));
}

TEST_F(PreviewTest, GuidesEncloseTheBox) {
  const modeler::Box box{{-1, 2, 3}, {4, 5, 9}};
  std::set<std::pair<double, double>> ends;
  for (const auto& line : modeler::edges(box)) {
    const glm::dvec3 way = line.to - line.from;
    EXPECT_EQ((way.x != 0) + (way.y != 0) + (way.z != 0), 1);
    for (const glm::dvec3& end : {line.from, line.to})
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_TRUE(end[axis] == box.low[axis] || end[axis] == box.high[axis]);
  }
  EXPECT_EQ(modeler::edges(box).size(), 12u);
  EXPECT_TRUE(modeler::edges(modeler::Box{}).empty());
  for (const auto& line : modeler::grid(box)) {
    EXPECT_EQ(line.from.y, 0);
    EXPECT_LE(line.from.x, 4 + 1);
    EXPECT_GE(line.to.x, -1 - 1);
  }
  EXPECT_EQ(modeler::axes(modeler::Box{}).size(), 3u);
}

TEST_F(PreviewTest, APickIsWhatTheProberFindsFirst) {
  const ImageSize size{40, 30};
  for (std::uint64_t seed = 0; seed < cases(20); ++seed) {
    const modeler::NodePtr tree =
        modeler::from_csg(random_scene(seed, 1 + static_cast<int>(seed % 7), false).tree);
    if (modeler::is_empty(tree->bounds)) continue;
    CameraFile file = modeler::framing(tree->bounds, 4.0 / 3);
    file.parallel = seed % 3 == 0;
    const Scene scene = modeler::scene_of(*tree, file);
    const auto prober = make_prober(scene, Precision::double_);
    const Camera<double> camera(file);
    modeler::Picker picker(tree, file, size);
    const auto nodes = modeler::preorder(*tree);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const auto ray = camera.primary_ray(x, y, size);
        const auto& hits = prober->hits(ray.origin.v, ray.direction.v);
        const auto pick = picker.at(x, y);
        ASSERT_EQ(pick.has_value(), !hits.empty()) << seed;
        if (!pick) continue;
        EXPECT_EQ(pick->node, nodes[pick->place]);
        EXPECT_EQ(pick->face, hits.front().face);
        EXPECT_EQ(pick->surface, hits.front().surface);
        EXPECT_DOUBLE_EQ(pick->t, hits.front().t);
        const auto same = [&](const CsgNode& node) { return node.number == hits.front().node; };
        EXPECT_EQ(std::ranges::find_if(scene.tree.nodes, same)->name, pick->node->name);
      }
  }
}

TEST_F(PreviewTest, ANodeThatIsInATreeTwiceIsFoundInItsPlace) {
  say_all({"create a sphere 1", "copy a b", "translate b 4 0 0"});
  const modeler::NodePtr shared = modeler::make_node(
      "pair", modeler::Composite{Operation::union_of, interpreter.solids().find("a")->solid.tree(),
                                 interpreter.solids().find("b")->solid.tree()});
  CameraFile camera;
  camera.window = {8, 2};
  camera.target = {2, 0, 0};
  camera.distance = 5;
  camera.parallel = true;
  modeler::Picker picker(shared, camera, {80, 20});
  ASSERT_TRUE(picker.at(20, 10) && picker.at(60, 10));
  EXPECT_EQ(picker.at(20, 10)->place, 1u);
  EXPECT_EQ(picker.at(60, 10)->place, 2u);
  EXPECT_FALSE(picker.at(40, 10));
}

}  // namespace
}  // namespace sir::test
