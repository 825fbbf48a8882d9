// show and inspect: what is seen of a solid and what is known of it.
#include <numbers>
#include <random>

#include "modeler/coincidence.h"
#include "modeler/inspect.h"
#include "modeler/sampling.h"
#include "modeler/silhouette.h"
#include "modeler/view.h"
#include "tests/cases.h"
#include "tests/modeler_fixture.h"
#include "tests/scene_builder.h"
#include "tracer/camera.h"
#include "tracer/probe.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Look : public ModelerTest {};

// The thesis's loop as it stands, with every ray sent and all its boundaries asked for.
Planes plain_silhouette(const Scene& scene, ImageSize size) {
  const auto prober = make_prober(scene, Precision::double_);
  const Camera<double> camera(scene.camera);
  const auto surface = [&](int x, int y) -> std::int64_t {
    const RayCena<double> ray = camera.primary_ray(x, y, size);
    const auto& hits = prober->hits(ray.origin.v, ray.direction.v);
    return hits.empty() ? -1 : hits.front().surface;
  };
  Planes picture(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (surface(x, y) != surface(x, y - 1) || surface(x, y) != surface(x - 1, y))
        picture.set(static_cast<std::size_t>(y * size.width + x), {255, 255, 255});
  return picture;
}

TEST_F(Look, SilhouettesAreThoseOfThePlainLoop) {
  const ImageSize size{64, 48};
  for (std::uint64_t seed = 0; seed < cases(25); ++seed) {
    std::mt19937_64 random(seed);
    CsgTree nodes = random_scene(seed, 1 + static_cast<int>(seed % 8), false).tree;
    for (CsgNode& node : nodes.nodes)
      for (std::int64_t& surface : node.surfaces) surface = static_cast<std::int64_t>(random() % 4);
    const modeler::NodePtr tree = modeler::from_csg(nodes);
    if (modeler::is_empty(tree->bounds)) continue;
    CameraFile camera = modeler::framing(tree->bounds, 4.0 / 3);
    if (seed % 3 == 1) camera.window *= 0.3;  // part of it is outside
    if (seed % 3 == 2) camera.parallel = true;
    if (seed % 5 == 4) camera.target += 0.8 * (tree->bounds.high - tree->bounds.low);
    const Scene scene = modeler::scene_of(*tree, camera);
    EXPECT_TRUE(modeler::silhouette(*tree, scene, size) == plain_silhouette(scene, size)) << seed;
  }
}

TEST_F(Look, ASquareSeenStraightIsItsOutline) {
  say_all({"create a cube 1", "translate a -0.5 -0.5 -0.5"});
  CameraFile camera;
  camera.window = {4, 4};
  camera.distance = 3;
  camera.parallel = true;
  const Scene scene = modeler::scene_of(solid("a"), camera);
  const Planes picture = modeler::silhouette(solid("a"), scene, {8, 8});
  // The square covers columns and rows 3 and 4. Lit: where it begins, and the first pixels behind.
  const std::string expected =
      "........"
      "........"
      "........"
      "...###.."
      "...#.#.."
      "...##..."
      "........"
      "........";
  std::string found;
  for (const std::uint8_t lit : picture.channel[0]) found += lit != 0 ? '#' : '.';
  EXPECT_EQ(found, expected);
}

TEST_F(Look, SurfacesOfOneNumberAreOne) {
  const auto inner_lines = [&](const char* numbers) {
    interpreter = modeler::Interpreter();
    say(std::string("create a cube ") + numbers);
    const Scene scene = modeler::scene_of(solid("a"), modeler::framing(solid("a").bounds, 1));
    const Planes picture = modeler::silhouette(solid("a"), scene, {100, 100});
    return std::count(picture.channel[0].begin(), picture.channel[0].end(), 255);
  };
  EXPECT_GT(inner_lines("1 2 3 4 5 6"), inner_lines("1") + 100);
  EXPECT_EQ(inner_lines("7 7 7 7 7 7"), inner_lines("0"));
}

TEST_F(Look, BoundsInScObsHoldEveryHit) {
  for (std::uint64_t seed = 0; seed < cases(20); ++seed) {
    const modeler::NodePtr tree = modeler::from_csg(random_scene(seed, 6, false).tree);
    if (modeler::is_empty(tree->bounds)) continue;
    const CameraFile camera = modeler::framing(tree->bounds, 4.0 / 3);
    const auto boxes = modeler::bounds_in_obs(*tree, camera);
    ASSERT_EQ(boxes.size(), tree->count);
    const Scene scene = modeler::scene_of(*tree, camera);
    const auto prober = make_prober(scene, Precision::double_);
    const Camera<double> eye(camera);
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) {
        const RayCena<double> ray = eye.primary_ray(x, y, {40, 30});
        const RayObs<double> obs = eye.primary_ray_obs(x, y, {40, 30});
        for (const ProbeHit& hit : prober->hits(ray.origin.v, ray.direction.v)) {
          const glm::dvec3 point = obs.at(hit.t).v;
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(point[axis], boxes[0].low[axis] - 1e-9);
            EXPECT_LE(point[axis], boxes[0].high[axis] + 1e-9);
          }
        }
      }
  }
}

TEST_F(Look, TheFrameHoldsTheWholeBox) {
  for (const char* scale : {"1 1 1", "100 0.01 1", "1e-5 1e-5 1e-5", "1 50 1"}) {
    interpreter = modeler::Interpreter();
    say_all({"create a cube 1"});
    say(std::string("scale a ") + scale);
    const CameraFile camera = modeler::framing(solid("a").bounds, 4.0 / 3);
    const modeler::Box box = modeler::bounds_in_obs(solid("a"), camera).front();
    EXPECT_GE(box.low.z, 0) << scale;
    const Planes picture =
        modeler::silhouette(solid("a"), modeler::scene_of(solid("a"), camera), {80, 60});
    for (int x = 0; x < 80; ++x)
      for (const int y : {0, 59}) EXPECT_EQ(picture.at(static_cast<std::size_t>(y * 80 + x)).r, 0);
    EXPECT_NE(std::count(picture.channel[0].begin(), picture.channel[0].end(), 255), 0) << scale;
  }
}

TEST_F(Look, WhatADifferenceHasTakenAwayIsNotLookedAt) {
  // Bounds are the left part's: 100 long. What is left of it is 1 long, and 4 rays apart.
  say_all({"create a cylinder 1", "scale a 1 100 1", "create b cube 1", "scale b 4 200 4",
           "translate b -2 1 -2", "combine c a difference b"});
  EXPECT_EQ(solid("c").bounds.high.y, 100);
  const modeler::Box box = modeler::filled_box(solid("c"));
  EXPECT_GE(box.high.y, 1);
  EXPECT_LT(box.high.y, 1 + 100 * 0.05);
  EXPECT_EQ(box.low, solid("c").bounds.low);
  say("show c x.png --size 80x60");
  const auto lit = [](const Planes& picture) {
    return std::count(picture.channel[0].begin(), picture.channel[0].end(), 255);
  };
  const CameraFile wide = modeler::framing(solid("c").bounds, 4.0 / 3);
  EXPECT_GT(lit(written), 3 * lit(modeler::silhouette(
                                  solid("c"), modeler::scene_of(solid("c"), wide), {80, 60})));
  // All that there is stays in it, whatever the solid.
  for (std::uint64_t seed = 0; seed < cases(20); ++seed) {
    const modeler::NodePtr tree = modeler::from_csg(random_scene(seed, 5, false).tree);
    const modeler::Box filled = modeler::filled_box(*tree);
    const modeler::Box met = modeler::sample(*tree, 100'000).met;
    if (modeler::is_empty(met)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(filled.low[axis], met.low[axis] + 1e-12) << seed;
      EXPECT_GE(filled.high[axis], met.high[axis] - 1e-12) << seed;
    }
  }
}

TEST_F(Look, ShowWritesPicturesAndDrawsInCharacters) {
  say_all({"create a cube 1", "create b sphere 2"});
  EXPECT_THAT(say("show a x.png").done, HasSubstr("wrote x.png"));
  EXPECT_EQ(written_to, "x.png");
  EXPECT_EQ(written.size, (ImageSize{640, 480}));
  EXPECT_EQ(written.channel[0], written.channel[2]);
  say("show b y --shaded --size 40x30");
  EXPECT_EQ(written_to, "y.png");
  EXPECT_EQ(written.size, (ImageSize{40, 30}));
  EXPECT_NE(written.channel[0], written.channel[2]);
  const std::string dots = say("mostra b").text;
  EXPECT_EQ(std::count(dots.begin(), dots.end(), '\n'), 30);
  EXPECT_THAT(dots, HasSubstr("\u28C0"));
  EXPECT_EQ(say("show b --sombreado").text, "160 in 80\n");
  expect_refused("show c", "there is no solid \"c\"");
  expect_refused("show a x.jpg", "no name of a picture");
  expect_refused("show a x.png y.png", "show NAME [FILE.png]");
  expect_refused("show a --nonsense", "show NAME [FILE.png]");
  expect_refused("show a --size 0x3", "is not a size");
  expect_refused("show a --scene none", "none.CAM: is missing");
}

TEST_F(Look, ShowSeesThroughAScenesCamera) {
  const std::string base = std::string(SIR_IMAGES) + "/whitted";
  say("load w " + base);
  say("show w x.png --size 80x60 --scene " + base);
  TextFile cam(base + ".CAM");
  EXPECT_TRUE(written == modeler::silhouette(solid("w"),
                                             modeler::scene_of(solid("w"), read_camera(cam)),
                                             {80, 60}));
  say("show w x.png --size 80x60 --shaded --scene " + base + ".CAM");
  RenderOptions options;
  options.size = {80, 60};
  EXPECT_TRUE(written == render(read_scene(base), options).planes);
}

TEST_F(Look, DotsAreTheLitPixels) {
  Planes picture({4, 5});
  picture.set(0, {255, 255, 255});          // first dot of the first character
  picture.set(3 + 3 * 4, {255, 255, 255});  // last dot of the second
  EXPECT_EQ(modeler::in_dots(picture), "\u2801\u2880\n\n");
}

TEST_F(Look, VolumesAgreeWithFormulas) {
  constexpr double kPi = std::numbers::pi;
  const auto check = [&](const char* name, double volume) {
    const modeler::Sampling sampling = modeler::sample(solid(name), 12 * 1024);
    EXPECT_NEAR(sampling.volume, volume, 3 * sampling.error + 1e-9 * volume) << name;
    EXPECT_LT(sampling.error, 0.01 * volume) << name;
    EXPECT_TRUE(sampling.inside) << name;
  };
  say_all({"create cube cube 1", "create sphere sphere 1", "create cone cone 1",
           "create cylinder cylinder 1"});
  check("cube", 1);
  check("sphere", 4 * kPi / 3);
  check("cone", kPi / 3);
  check("cylinder", kPi);
  say_all({"rotate cone x 33", "scale cone 3 1 2", "translate cone 100 0 0"});
  check("cone", 6 * kPi / 3);
  say_all({"create hole sphere 1", "scale hole 0.9", "combine shell sphere difference hole"});
  check("shell", 4 * kPi / 3 * (1 - 0.729));
}

TEST_F(Look, ACombinationThatLeavesNothingIsToldToHandsAtOnce) {
  say_all({"create small sphere 1", "create large cube 1", "scale large 4",
           "translate large -2 -2 -2", "copy small small2", "copy large large2"});
  EXPECT_THAT(say("combine a small difference large").warnings, IsEmpty());  // a script
  interpreter.watch(true);
  say("undo");
  EXPECT_THAT(say("combine a small difference large").warnings,
              ElementsAre("\"a\" is empty: \"large\" takes away all of \"small\""));
  // Nothing less something is nothing, which was told before.
  EXPECT_THAT(say("combine b a difference small2").warnings, IsEmpty());
  EXPECT_THAT(say("combine c large2 intersection b").warnings, IsEmpty());
}

TEST_F(Look, AVolumeThatIsNoDoubleIsSaid) {
  say_all(
      {"create large cube 1", "scale large 1e200", "create small cube 1", "scale small 1e-200"});
  EXPECT_THAT(say("inspect large volume").text, HasSubstr("volume too large for a number"));
  EXPECT_THAT(say("inspect small volume").text, HasSubstr("volume too small for a number"));
}

TEST_F(Look, EmptySolidsAreFound) {
  const auto warned = [&](const char* name) { return modeler::warnings(solid(name)); };
  say_all({"create small sphere 1", "create large cube 1", "scale large 4",
           "translate large -2 -2 -2", "combine nothing small difference large"});
  EXPECT_THAT(
      warned("nothing"),
      ElementsAre(HasSubstr("\"nothing\" is empty: \"large\" takes away all of \"small\"")));
  say_all({"create a sphere 1", "create b sphere 1", "translate b 1.3 1.3 1.3",
           "combine lens a intersection b"});
  EXPECT_THAT(warned("lens"), ElementsAre(HasSubstr("though their bounds meet")));
  // Deep in a solid that is not empty: named once, where it is.
  say_all({"create c cube 1", "combine d c union lens", "create e cube 1", "translate e 3 0 0",
           "combine f d union e"});
  EXPECT_THAT(warned("f"), ElementsAre(HasSubstr("\"lens\" is empty")));
  EXPECT_THAT(say("inspect nothing").text, HasSubstr("volume 0: none of "));
  EXPECT_THAT(say("show nothing").warnings, ElementsAre("nothing of \"nothing\" is seen"));
  say_all({"create g sphere 1", "create h sphere 1", "translate h 1.1 1.1 1.1", "scale g 1.001",
           "combine sliver g intersection h"});
  EXPECT_THAT(warned("sliver"), IsEmpty());
}

// What is known of the whole spares most of the work for its parts, or it would not be done.
TEST_F(Look, AnEmptyPartIsFoundUnderAThousandOthers) {
  say_all({"create a sphere 1", "create b sphere 1", "translate b 1.3 1.3 1.3",
           "combine lens a intersection b", "create block cube 1", "scale block 50",
           "combine c0 block difference lens"});
  for (int i = 1; i <= 1000; ++i) {
    const std::string n = std::to_string(i);
    say("create h" + n + " sphere 1");
    say("scale h" + n + " 0.01");
    say("translate h" + n + " " + std::to_string(i * 0.04) + " 30 30");
    say("combine c" + n + " c" + std::to_string(i - 1) + " difference h" + n);
  }
  EXPECT_THAT(modeler::warnings(solid("c1000")), ElementsAre(HasSubstr("\"lens\" is empty")));
}

TEST_F(Look, ThinThingsAreNotTakenForEmpty) {
  say_all({"create a sphere 1", "create b sphere 1", "scale b 0.999",
           "combine shell a difference b", "create c cube 1", "scale c 1 1 1e-6", "create d cube 1",
           "combine sheet c intersection d"});
  EXPECT_THAT(modeler::warnings(solid("shell")), IsEmpty());
  EXPECT_THAT(modeler::warnings(solid("sheet")), Not(testing::Contains(HasSubstr("empty"))));
}

TEST_F(Look, FacesThatCoincideAreFound) {
  const auto pairs = [&](const char* name) {
    std::vector<std::string> found;
    for (const auto& [first, second] : modeler::coincident_faces(solid(name), 100))
      found.push_back(first.node->name + std::to_string(first.face) + second.node->name +
                      std::to_string(second.face));
    return found;
  };
  say_all(
      {"create a cube 1", "create b cube 1", "translate b 1 0.25 0.25", "combine side a union b"});
  EXPECT_THAT(pairs("side"), ElementsAre("a1b0"));
  say_all(
      {"split side", "translate b 0 1 0", "combine apart a union b"});  // x = 1, but not together
  EXPECT_THAT(pairs("apart"), IsEmpty());
  say_all({"create c cylinder 1", "create d cylinder 1", "scale d 1 0.5 1",
           "combine coaxial c union d"});
  EXPECT_THAT(pairs("coaxial"), ElementsAre("c0d0", "c2d2"));
  say_all({"create e cone 1", "create f cone 1", "scale f 2 1 2", "combine cones e union f"});
  EXPECT_THAT(pairs("cones"), ElementsAre("e1f1"));
  say_all({"create g sphere 1", "create h sphere 1", "rotate h y 45", "combine balls g union h",
           "rotate balls x 20", "scale balls 3 1 2", "translate balls 7 8 9"});
  EXPECT_THAT(pairs("balls"), ElementsAre("g0h0"));
  // Turned together, to the last digits but one.
  say_all({"undo", "undo", "undo", "create i cube 1", "create j cube 1", "translate j 0.5 0.5 1",
           "combine k i union j", "rotate k x 33", "rotate k y 12"});
  EXPECT_THAT(pairs("k"), ElementsAre("i5j4"));
  say_all({"create l sphere 1", "create m sphere 1", "scale m 1.000001", "combine near l union m"});
  EXPECT_THAT(pairs("near"), IsEmpty());
}

// Ctrl-C need not wait for the rays.
TEST_F(Look, AStopEndsSampling) {
  say_all({"create a cube 1", "create b sphere 1", "combine c a difference b"});
  std::stop_source source;
  source.request_stop();
  const std::stop_token stop = source.get_token();
  constexpr std::size_t kForever = std::size_t{1} << 50;
  EXPECT_FALSE(modeler::sample(solid("c"), kForever, stop).inside);
  EXPECT_TRUE(modeler::empty_composites(solid("c"), stop).empty());
  EXPECT_EQ(modeler::filled_box(solid("c"), stop).high, solid("c").bounds.high);
  EXPECT_THAT(modeler::inspect("c", solid("c"), modeler::Aspect::volume, stop),
              Not(HasSubstr("give or take")));
}

// However large or small the solid, made-up cameras and lights are numbers that a file can hold.
TEST_F(Look, WhatIsMadeUpIsFinite) {
  const auto read_back = [&] {
    TextFile camera("camera", camera_text(interpreter.camera()));
    EXPECT_NO_THROW(read_camera(camera));
    TextFile light("light", lighting_text(interpreter.lighting()));
    EXPECT_NO_THROW(read_lighting(light));
  };
  say("create a sphere 1");
  const std::string usual = say("show a").text;
  for (const char* factor : {"1e-200", "1e200", "1e299"}) {
    say(std::string("scale a ") + factor);
    say("camera auto");
    read_back();
    EXPECT_EQ(say("show a").text, usual) << factor;
    say("undo");
  }
  for (const char* line : {"scale a 1e300", "translate a 1e305 0 0"}) say(line);
  say("camera auto");
  read_back();
  expect_refused("show a", "too large");
  say("camera distance 1e308");
  read_back();
  say("light add 1 2 3 4");
  modeler::Interpreter again;
  for (const std::string& line : interpreter.script()) again.execute(line);
  EXPECT_EQ(looks_of(again), looks_of(interpreter));
}

TEST_F(Look, NearlySingularMatricesAreFound) {
  say_all({"create a cube 1", "matrix a 1 1 0 1 1.0000000001 0 0 0 1 0 0 0"});
  EXPECT_THAT(modeler::warnings(solid("a")), ElementsAre(HasSubstr("nearly singular")));
  say_all({"create b cube 1", "scale b 1000 0.01 1"});
  EXPECT_THAT(modeler::warnings(solid("b")), IsEmpty());
}

TEST_F(Look, InspectTellsWhatIsAskedFor) {
  say_all({"create bola sphere 1", "create furo cylinder 2 2 3", "scale furo 0.5 4 0.5",
           "rotate furo x 90", "translate furo 0 0 -2",
           "combine \"bola furada\" bola difference furo"});
  const std::string all = say("inspect \"bola furada\"").text;
  for (const char* part :
       {"\"bola furada\": difference of \"bola\" and \"furo\", 3 nodes\n",
        "bounds in SC_CENA -1 -1 -1 to 1 1 1\n", "bounds in SC_OBS ",
        "LOCAL_CENA of \"furo\"\n    0.5     0   0  0\n      0     0   4  0\n",
        "CENA_LOCAL of \"furo\"\n    2     0   0  0\n    0     0  -2  0\n    0  0.25   0  0\n"
        "    0   0.5   0  1\n",
        "surfaces 1, 2, 3\n",
        "  0 bola furada: difference\n  1 ├ bola: sphere, surface 1\n"
        "  2 └ furo: cylinder, surfaces Y=0 2, Y=1 2, side 3\n",
        "volume 2.72", "no warnings\n"})
    EXPECT_THAT(all, HasSubstr(part));
  const std::string volume = say("verifica \"bola furada\" volume").text;
  EXPECT_THAT(volume, HasSubstr("volume 2.72"));
  EXPECT_THAT(volume, Not(HasSubstr("LOCAL_CENA")));
  expect_refused("inspect bola", "there is no solid \"bola\"");
  expect_refused("inspect \"bola furada\" volum", "did you mean volume?");
}

}  // namespace
}  // namespace sir::test
