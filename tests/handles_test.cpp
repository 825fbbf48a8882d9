// Handles in the picture: where they are, and what dragging them means.
#include "viewer/handles.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "modeler/step.h"

namespace sir::viewer {
namespace {

using modeler::ScreenFrame;

constexpr ImageSize kSize{640, 480};
constexpr double kLength = 90, kReach = 8;

CameraFile from_aside(bool parallel) {
  CameraFile camera;
  camera.window = {8, 6};
  camera.normal = {-0.5, -0.4, -1};
  camera.target = {1, 2, 3};
  camera.distance = 9;
  camera.focal = 7;
  camera.focal_given = true;
  camera.parallel = parallel;
  return camera;
}

// Where a point is seen, worked out afresh.
glm::dvec2 seen(const CameraFile& camera, const glm::dvec3& point) {
  const glm::dvec3 at = ScreenFrame(camera).observe(point);
  const double shrink = camera.parallel ? 1 : camera.focal / (camera.focal + at.z);
  return {(at.x * shrink / camera.window.x + 0.5) * kSize.width,
          (0.5 - at.y * shrink / camera.window.y) * kSize.height};
}

class HandlesTest : public testing::TestWithParam<bool> {
 protected:
  CameraFile camera = from_aside(GetParam());
  glm::dvec3 centre{1.5, 1.5, 2.5};
  Handles handles(HandleKind kind) const { return {kind, centre, camera, kSize, kLength}; }
};

INSTANTIATE_TEST_SUITE_P(Cameras, HandlesTest, testing::Bool(), [](const auto& camera) {
  return camera.param ? "parallel" : "perspective";
});

TEST_P(HandlesTest, LinesAreAsLongWhateverTheDistance) {
  const Handles at_hand = handles(HandleKind::move);
  ASSERT_EQ(at_hand.all().size(), 4u);
  EXPECT_NEAR(glm::length(at_hand.middle() - seen(camera, centre)), 0, 1e-9);
  for (const Handle& handle : at_hand.all()) {
    if (handle.axis == Handle::kAll) continue;
    const double length = glm::length(handle.line.back() - handle.line.front());
    EXPECT_GT(length, 0.1 * kLength);
    EXPECT_LT(length, 1.2 * kLength);
    EXPECT_EQ(at_hand.at(handle.line.back(), kReach), handle.axis);
  }
  EXPECT_EQ(at_hand.at(at_hand.middle() + glm::dvec2(2, 1), kReach), Handle::kAll);
  EXPECT_FALSE(at_hand.at(at_hand.middle() + glm::dvec2(300, 0), kReach));
  // Twice as far away with twice the focal length: what stands there is as large, and so are they.
  camera.distance *= 10;
  if (!camera.parallel) camera.window *= 0.2;
  const Handles far = handles(HandleKind::move);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(glm::length(far.all()[i].line.back() - far.middle()), 1.2 * kLength);
}

TEST_P(HandlesTest, ASolidFollowsTheMouse) {
  const Handles at_hand = handles(HandleKind::move);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 way(0);
    way[axis] = 1.25;
    const glm::dvec2 from = at_hand.middle(), to = seen(camera, centre + way);
    const glm::dvec3 moved = at_hand.moved(axis, from, to);
    EXPECT_NEAR(glm::length(moved - way), 0, 0.01) << axis;  // a pixel is about 0.02
    // Beside the axis counts for nothing, and what is not dragged is not moved.
    EXPECT_EQ(at_hand.moved(axis, from, from), glm::dvec3(0));
    EXPECT_EQ(moved[(axis + 1) % 3], 0);
  }
  const glm::dvec2 to = at_hand.middle() + glm::dvec2(40, -25);
  const glm::dvec3 all = at_hand.moved(Handle::kAll, at_hand.middle(), to);
  EXPECT_NEAR(glm::length(seen(camera, centre + all) - to), 0, 1);
  EXPECT_NEAR(glm::dot(all, ScreenFrame(camera).normal), 0, 0.02);
}

TEST_P(HandlesTest, AmountsAreShortNumbers) {
  const Handles at_hand = handles(HandleKind::move);
  const double moved = at_hand.moved(0, {0, 0}, {37, 11}).x;
  EXPECT_EQ(moved, std::round(moved * 100) / 100);
  const glm::dvec3 scaled = handles(HandleKind::scale).scaled(Handle::kAll, {0, 0}, {13, 4});
  EXPECT_EQ(scaled.x, std::round(scaled.x * 100) / 100);
  EXPECT_EQ(scaled.x, scaled.y);
}

TEST_P(HandlesTest, AnArcIsTurnedAsTheMouseGoes) {
  const Handles at_hand = handles(HandleKind::turn);
  ASSERT_EQ(at_hand.all().size(), 3u);
  for (const Handle& handle : at_hand.all()) {
    EXPECT_EQ(at_hand.at(handle.line[handle.line.size() / 3], kReach), handle.axis);
    // A point that is turned as rotation_about() turns it.
    const double unit =
        camera.window.y / kSize.height *
        (camera.parallel ? 1
                         : (camera.focal + ScreenFrame(camera).observe(centre).z) / camera.focal);
    glm::dvec3 arm(0);
    arm[(handle.axis + 1) % 3] = kLength * unit;
    for (const double degrees : {-120.0, -30.0, 45.0, 90.0}) {
      const glm::dvec3 after = modeler::rotation_about(handle.axis, degrees).linear * arm;
      EXPECT_NEAR(
          at_hand.turned(handle.axis, seen(camera, centre + arm), seen(camera, centre + after)),
          degrees, 1e-9)
          << handle.axis;
    }
    EXPECT_EQ(at_hand.turned(handle.axis, handle.line.front(), handle.line.front()), 0);
  }
}

TEST_P(HandlesTest, ArcsAreTheHalfInFront) {
  const ScreenFrame frame(camera);
  const Handles at_hand = handles(HandleKind::turn);
  for (const Handle& handle : at_hand.all()) {
    // The ends of the arc are about as far as its centre, and opposite of each other.
    const glm::dvec2 middle = seen(camera, centre);
    const glm::dvec2 ends = handle.line.front() + handle.line.back() - 2.0 * middle;
    EXPECT_LT(glm::length(ends), 0.15 * kLength);
  }
}

TEST_P(HandlesTest, ARingSeenFromItsEdgeIsPulled) {
  camera.normal = {0, 0, -1};
  camera.target = centre;
  const Handles at_hand = handles(HandleKind::turn);
  // About Y, the near side goes to the right where the angle grows; in perspective it is nearer
  // than the middle, and goes faster.
  const double depth = ScreenFrame(camera).observe(centre).z;
  const double radius =
      kLength * camera.window.y / kSize.height * (camera.focal + depth) / camera.focal;
  const double faster =
      camera.parallel ? 1 : (camera.focal + depth) / (camera.focal + depth - radius);
  const double degrees = at_hand.turned(1, at_hand.middle(), at_hand.middle() + glm::dvec2(45, 0));
  EXPECT_NEAR(degrees, 0.5 * 180 / std::numbers::pi / faster, 0.6);
  EXPECT_EQ(at_hand.turned(1, at_hand.middle(), at_hand.middle() + glm::dvec2(0, 30)), 0);
}

TEST_P(HandlesTest, AGripIsScaledByWhatItIsPulled) {
  const Handles at_hand = handles(HandleKind::scale);
  for (const Handle& handle : at_hand.all()) {
    if (handle.axis == Handle::kAll) continue;
    const glm::dvec2 grip = handle.line.back();
    const glm::dvec3 twice =
        at_hand.scaled(handle.axis, grip, at_hand.middle() + 2.0 * (grip - at_hand.middle()));
    EXPECT_NEAR(twice[handle.axis], 2, camera.parallel ? 0.01 : 0.4);
    EXPECT_EQ(twice[(handle.axis + 1) % 3], 1);
    // Through the middle and beyond it is no mirror, and never 0.
    const glm::dvec3 least =
        at_hand.scaled(handle.axis, grip, at_hand.middle() - 2.0 * (grip - at_hand.middle()));
    EXPECT_EQ(least[handle.axis], 0.01);
  }
  EXPECT_EQ(at_hand.scaled(Handle::kAll, {100, 100}, {100 + kLength, 100}), glm::dvec3(2));
  EXPECT_EQ(at_hand.scaled(Handle::kAll, {100, 100}, {100, 100 + kLength}), glm::dvec3(0.5));
}

TEST_P(HandlesTest, AnAxisThatPointsAtTheObserverHasNone) {
  camera.normal = {0, 0, -1};
  camera.target = centre;
  std::vector<int> axes;
  const Handles at_hand = handles(HandleKind::move);
  for (const Handle& handle : at_hand.all()) axes.push_back(handle.axis);
  EXPECT_THAT(axes, testing::ElementsAre(0, 1, Handle::kAll));
}

TEST(Handles, AreNoneBehindTheEye) {
  const CameraFile camera = from_aside(false);
  const glm::dvec3 behind = camera.target - 30.0 * ScreenFrame(camera).normal;
  for (const auto kind : {HandleKind::move, HandleKind::turn, HandleKind::scale}) {
    const Handles none(kind, behind, camera, kSize, kLength);
    EXPECT_TRUE(none.all().empty());
    EXPECT_FALSE(none.at({0, 0}, 1000));
  }
}

}  // namespace
}  // namespace sir::viewer
