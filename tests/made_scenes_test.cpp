// The generator of the scenes that speed is measured on: what the benchmarks take for
// granted of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "bench/scenes.h"
#include "tests/temp_folder.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir {
namespace {

using bench::made_scene;
using bench::MadeScene;
using Cut = bench::MadeScene::Cut;

std::ptrdiff_t primitives_of(const Scene& scene) {
  return std::ranges::count(scene.tree.nodes, false, &CsgNode::composite);
}

Planes small_image(const MadeScene& made) {
  RenderOptions options;
  options.size = {40, 30};
  options.trace.depth_limit = 1;
  return render(made_scene(made), options).planes;
}

TEST(MadeScenes, TheSameNumbersGiveTheSameFiles) {
  const test::TempFolder folder;
  for (const MadeScene& made : bench::made_suite(std::vector{40})) {
    SCOPED_TRACE(made.name());
    write_scene(folder / "first", made_scene(made));
    write_scene(folder / "second", made_scene(made));
    for (const char* end : {".CSG", ".CAM", ".LUZ", ".SUP"}) {
      const std::string first = folder.read(std::string("first") + end);
      EXPECT_FALSE(first.empty());
      EXPECT_EQ(first, folder.read(std::string("second") + end));
    }
  }
}

TEST(MadeScenes, HoldAsManyPrimitivesAsTheirNamesSay) {
  for (const int n : {1, 2, 3, 7, 300, 3'000}) {
    SCOPED_TRACE(n);
    EXPECT_EQ(primitives_of(made_scene({.primitives = n})), n);
    EXPECT_EQ(primitives_of(made_scene({.primitives = n, .chain = true})), n);
    EXPECT_EQ(primitives_of(made_scene({.primitives = n, .cut = Cut::root})), n + 1);
    const Scene spheres = made_scene({.primitives = n, .spheres = true});
    EXPECT_EQ(primitives_of(spheres), n);
    for (const CsgNode& node : spheres.tree.nodes)
      EXPECT_TRUE(node.composite ? node.operation == Operation::union_of
                                 : node.kind == PrimitiveKind::sphere);
  }
}

TEST(MadeScenes, AMixedOneHasEveryKindAndOperation) {
  std::set<PrimitiveKind> kinds;
  std::set<Operation> operations;
  for (const CsgNode& node : made_scene({.primitives = 300}).tree.nodes)
    if (node.composite) operations.insert(node.operation);
    else kinds.insert(node.kind);
  EXPECT_EQ(kinds.size(), 4u);
  EXPECT_EQ(operations.size(), 3u);
}

TEST(MadeScenes, AChainIsDeepAndABalancedTreeFlat) {
  // 300 primitives are 189 solids, of three primitives at the most: 2^8 leave room for them.
  EXPECT_GE(depth_of(made_scene({.primitives = 300, .chain = true}).tree), 189u);
  EXPECT_LE(depth_of(made_scene({.primitives = 300}).tree), 11u);
}

TEST(MadeScenes, AChainIsTheSamePictureAsABalancedTree) {
  const Planes balanced = small_image({.primitives = 300});
  EXPECT_EQ(balanced, small_image({.primitives = 300, .chain = true}));
  EXPECT_NE(balanced, small_image({.primitives = 300, .cut = Cut::root}));
}

TEST(MadeScenes, ACutIsADifferenceAtTheRoot) {
  const Scene cut = made_scene({.primitives = 300, .cut = Cut::root});
  const CsgNode& root = cut.tree.nodes[cut.tree.root];
  ASSERT_TRUE(root.composite);
  EXPECT_EQ(root.operation, Operation::difference);
  const CsgNode& cube = cut.tree.nodes[root.right];
  EXPECT_FALSE(cube.composite);
  EXPECT_EQ(cube.kind, PrimitiveKind::cube);
}

TEST(MadeScenes, ACutDistributedByHandIsTheSamePicture) {
  EXPECT_EQ(small_image({.primitives = 300, .cut = Cut::root}),
            small_image({.primitives = 300, .cut = Cut::distributed}));
}

}  // namespace
}  // namespace sir
