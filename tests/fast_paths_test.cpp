// Every optimisation keeps the plain path: each fast way to an image gives, byte for
// byte, what the plain algorithm of Roth gives ray by ray; on every instruction set
// that packets are compiled for.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "bench/scenes.h"
#include "tests/cases.h"
#include "tests/instruction_sets.h"
#include "tests/packet_scenes.h"
#include "tests/plain_image.h"
#include "tracer/recentre.h"
#include "tracer/render.h"
#include "tracer/sample_adaptive.h"
#include "tracer/sample_progressive.h"
#include "tracer/sample_random.h"
#include "tracer/scene_file.h"
#include "tracer/trace.h"

namespace sir {
namespace {

constexpr const char* kImages[] = {"whitted", "calice", "luminar", "piramide", "lcg"};

Scene image(const char* name) { return read_scene(std::filesystem::path(SIR_IMAGES) / name); }

template <typename T>
constexpr Precision kPrecision = std::is_same_v<T, float> ? Precision::float_ : Precision::double_;

void expect_same(const Planes& found, const Planes& expected, const std::string& way) {
  ASSERT_EQ(found.size, expected.size);
  for (std::size_t p = 0; p < found.size.pixels(); ++p) {
    const auto width = static_cast<std::size_t>(found.size.width);
    ASSERT_EQ(found.at(p), expected.at(p))
        << way << ", column " << p % width << ", row " << p / width;
  }
}

// Every way there is to the image of a model. `packets` counts those sent.
template <typename T>
void expect_the_plain_image(const Scene& original, RenderOptions options, std::uint64_t& packets) {
  const Recentred moved(original, offset_for(original, kPrecision<T>));
  const Scene& scene = moved;
  const Model<T> model(scene, options.trace.possible_effects());
  const Planes plain = test::plain_image(model, options);
  options.threads = 1;
  for (const auto& [engine, way] : {std::pair{Engine::roth, "tiles"},
                                    {Engine::envelopes, "envelopes"},
                                    {Engine::gates, "products"}}) {
    options.trace.engine = engine;
    options.trace.packets = engine != Engine::gates;
    const RenderResult found = render_model(model, options);
    ASSERT_EQ(found.counts.packets, 0u) << way;
    ASSERT_NO_FATAL_FAILURE(expect_same(found.planes, plain, way));
  }
  Model<T> gates(scene, options.trace.possible_effects());
  gates.solid.products.complete = false;
  gates.laid_out = nullptr;
  options.trace.packets = true;
  ASSERT_NO_FATAL_FAILURE(expect_same(render_model(gates, options).planes, plain, "gates"));
  std::optional<RayCounts> counts;
  test::with_each_instruction_set([&](const char* set) {
    for (const int threads : {1, 2, 7}) {
      options.threads = threads;
      const RenderResult found = render_model(model, options);
      packets += found.counts.packets;
      if (!counts) counts = found.counts;
      EXPECT_EQ(found.counts.spans, counts->spans) << set;
      EXPECT_EQ(found.counts.exact, counts->exact) << set;
      EXPECT_EQ(found.counts.doubtful, counts->doubtful) << set;
      EXPECT_EQ(found.counts.costs, counts->costs) << set;
      expect_same(found.planes, plain, std::string("packets, ") + set);
    }
  });
}

void expect_plain_images(const Scene& scene, ImageSize size, std::uint64_t& packets) {
  RenderOptions options;
  options.size = size;
  {
    SCOPED_TRACE("double");
    ASSERT_NO_FATAL_FAILURE(expect_the_plain_image<double>(scene, options, packets));
  }
  SCOPED_TRACE("float");
  ASSERT_NO_FATAL_FAILURE(expect_the_plain_image<float>(scene, options, packets));
}

TEST(FastPaths, FiveImages) {
  for (const char* name : kImages) {
    SCOPED_TRACE(name);
    std::uint64_t packets = 0;
    expect_plain_images(image(name), {52, 39}, packets);
    EXPECT_GT(packets, 1000u);
  }
}

TEST(FastPaths, MadeScenes) {
  using Cut = bench::MadeScene::Cut;
  for (const int primitives : {60, 300})
    for (const auto& [chain, cut] : {std::pair{false, Cut::none},
                                     {true, Cut::none},
                                     {false, Cut::root},
                                     {true, Cut::distributed}}) {
      const bench::MadeScene made{.primitives = primitives, .chain = chain, .cut = cut};
      SCOPED_TRACE(made.name() + (chain ? ", a chain" : ""));
      std::uint64_t packets = 0;
      expect_plain_images(bench::made_scene(made), {37, 35}, packets);
      EXPECT_GT(packets, 1000u);
    }
}

// Glass cubes with gaps about as wide as a start far from the camera is known: some
// starts lie, by that, on the neighbour too, which envelopes must not hide.
TEST(FastPaths, StartsNearNeighboursSeenFromAfar) {
  for (const auto& [distance, gap] :
       {std::pair{1e3, 4e-4}, {1e4, 4e-3}, {3e4, 0.013}, {1e5, 0.045}}) {
    SCOPED_TRACE("from " + std::to_string(distance));
    test::SceneBuilder build;
    std::size_t root = 0;
    for (int k = 0; k < 12; ++k) {
      const double x = k / 3 * (1 + gap) - 2, y = k % 3 * (1 + gap) - 1.5;
      const auto cube = build.cube({x, y, 0}, {x + 1, y + 1, 1});
      root = k == 0 ? cube : build.combine(Operation::union_of, root, cube);
    }
    build.surface(1).first = {{0.3, 0.2, 0.1}, {0.3, 0.2, 0.3}, 0.2, 10, 0.7, 1.3};
    Scene scene = build.finish(root);
    scene.camera = {{5, 4}, {0, 0, 0}, {0.6, 0.35, -1}, distance, {0, 1, 0}, true, 1, false};
    scene.lighting = {{0.3, 0.5, 0.8}, glm::dvec3(0.2), {{{3, 5, 9}, glm::dvec3(1)}}};
    std::uint64_t packets = 0;
    expect_plain_images(scene, {64, 48}, packets);
    EXPECT_GT(packets, 1000u);
  }
}

// The envelope of a room's walls holds the light: that something blocks it cannot be
// told by the parts alone.
TEST(FastPaths, ALightInARoom) {
  test::SceneBuilder build;
  const auto walls = build.combine(Operation::difference, build.cube(glm::dvec3(-5), glm::dvec3(5)),
                                   build.cube(glm::dvec3(-4.5), glm::dvec3(4.5)));
  auto root = walls;
  for (int k = 0; k < 10; ++k)
    root = build.combine(Operation::union_of, root,
                         build.sphere({0.8 * k - 3.6, 0.3 * (k % 3) - 1, 0.4 * (k % 4) - 1}, 0.7));
  Scene scene = build.finish(root);
  scene.camera = {{4, 3}, {0, 0, 0}, {0, 0, -1}, 4, {0, 1, 0}, false, 3, true};
  scene.lighting.lights = {{{1, 3, 1}, glm::dvec3(0.6)}, {{-3, -2, 3}, glm::dvec3(0.5)}};
  std::uint64_t packets = 0;
  expect_plain_images(scene, {53, 40}, packets);
  EXPECT_GT(packets, 1000u);
}

TEST(FastPaths, RandomScenes) {
  std::uint64_t packets = 0;
  for (std::uint64_t seed = 0; seed < test::cases(48); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool aligned = seed % 2;
    expect_plain_images(
        test::random_scene(1000 + seed, 2 + static_cast<int>(seed * 5) % 23, aligned), {22, 17},
        packets);
  }
  EXPECT_GT(packets, 10'000u);
}

// Surfaces of colours of their own, some with mirrors and glass; two lights; seen in
// perspective, or along the lattice that aligned primitives lie on, so that rays run in
// faces and along edges, from outside (`distance` 4) or from within (0).
void dress(Scene& scene, std::uint64_t seed, bool parallel, double distance) {
  std::mt19937_64 random(seed);
  const auto pick = [&](int below) { return double(random() % static_cast<unsigned>(below)); };
  scene.surfaces.clear();
  for (std::int64_t number = 1; number <= 5; ++number) {
    Surface& surface = scene.surfaces.emplace_back();
    surface.number = number;
    surface.first.ambient = surface.first.diffuse =
        0.1 + 0.2 * glm::dvec3(pick(4), pick(4), pick(4));
    if (seed % 4 < 2) continue;
    surface.first.specular = 0.3 * pick(2);
    surface.first.exponent = 20;
    surface.first.transmission = 0.4 * pick(2);
    surface.first.index = 1 + 0.3 * pick(2);
  }
  for (CsgNode& node : scene.tree.nodes)
    node.surfaces.fill(1 + static_cast<std::int64_t>(random() % 5));
  scene.lighting.background = {0.1, 0.2, 0.4};
  scene.lighting.ambient = glm::dvec3(0.2);
  scene.lighting.lights = {{{3, 5, 4}, glm::dvec3(0.7)}, {{-4, 2, 3}, {0.3, 0.2, 0.1}}};
  scene.camera = {};
  scene.camera.window = {4.25, 3.25};
  scene.camera.normal = parallel ? glm::dvec3(0, 0, -1) : glm::dvec3(-0.3, -0.4, -1);
  scene.camera.distance = distance;
  scene.camera.focal = 6;
  scene.camera.focal_given = true;
  scene.camera.parallel = parallel;
}

// Unions of parts, half of them with faces, edges and corners in common.
TEST(FastPaths, UnionsAndLattices) {
  std::uint64_t packets = 0;
  int plain_faced = 0;
  for (std::uint64_t seed = 0; seed < test::cases(48); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool aligned = seed % 2;
    Scene scene = test::union_of_parts(500 + seed, 1 + static_cast<int>(seed * 7) % 40,
                                       seed % 3 ? 0.4 : 1.2, aligned);
    dress(scene, seed / 2, seed % 4 == 3, seed % 8 == 7 ? 0 : 4);
    // Pixels' centres have coordinates in quarters.
    const ImageSize size{17, 13};
    ASSERT_NO_FATAL_FAILURE(expect_plain_images(scene, size, packets));
    RenderOptions options;
    options.size = size;
    const Planes planes = render(scene, options).planes;
    std::size_t background = 0;
    for (std::size_t p = 0; p < size.pixels(); ++p) background += planes.at(p) == planes.at(0);
    plain_faced += background == size.pixels();
  }
  EXPECT_GT(packets, 10'000u);
  EXPECT_LT(plain_faced, 8);
}

// Samples by the plain path.
template <typename T>
SampleSource plain_samples(const Model<T>& model, Tracer<T>& tracer, ImageSize size) {
  return [&model, &tracer, size](std::span<const ScreenPoint> points, std::span<Rgb8> colours,
                                 const Share&) {
    for (std::size_t p = 0; p < points.size(); ++p)
      colours[p] = tracer.pixel(model.camera.ray_through(points[p].x, points[p].y, size));
    return true;
  };
}

template <typename T>
void expect_plain_samples(const Scene& scene, RenderOptions options) {
  options.precision = kPrecision<T>;
  const Model<T> model(Recentred(scene, offset_for(scene, kPrecision<T>)),
                       options.trace.possible_effects());
  TraceOptions plain = options.trace;
  plain.engine = Engine::roth;
  Tracer<T> tracer(model, plain);
  const SampleSource source = plain_samples(model, tracer, options.size);
  const Region all{0, 0, options.size.width, options.size.height};
  for (const auto mode : {Antialias::none, Antialias::adaptive, Antialias::random}) {
    options.antialias.mode = mode;
    options.antialias.samples = 5;
    Planes expected;
    AntialiasCounts counts;
    if (mode == Antialias::none) expected = test::plain_image(model, options);
    else if (mode == Antialias::adaptive)
      ASSERT_TRUE(sample_adaptive(all, options.antialias, source, expected, counts));
    else ASSERT_TRUE(sample_random(all, options.antialias, source, expected, counts));
    test::with_each_instruction_set([&](const char* set) {
      for (const int threads : {1, 2, 7}) {
        options.threads = threads;
        const RenderResult found =
            mode == Antialias::none
                ? render_progressive(scene, options, [](const Planes&, const Stage&) {})
                : render(scene, options);
        EXPECT_GT(found.counts.packets, 0u);
        expect_same(found.planes, expected, std::string("samples, ") + set);
      }
    });
  }
}

TEST(FastPaths, ProgressiveAndAntialiasedImages) {
  RenderOptions options;
  options.size = {20, 15};
  for (const char* name : kImages) {
    SCOPED_TRACE(name);
    ASSERT_NO_FATAL_FAILURE(expect_plain_samples<double>(image(name), options));
    ASSERT_NO_FATAL_FAILURE(expect_plain_samples<float>(image(name), options));
  }
}

}  // namespace
}  // namespace sir
