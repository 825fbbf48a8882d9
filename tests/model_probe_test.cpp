// What is under the mouse in the modeler's window.
#include "viewer/model_probe.h"

#include <gmock/gmock.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace sir::viewer {
namespace {

using testing::HasSubstr;

constexpr ImageSize kSize{160, 120};

class ModelProbeTest : public testing::Test {
 protected:
  void say(std::initializer_list<const char*> lines) {
    for (const char* line : lines) interpreter_.execute(line);
  }
  // The first pixel at which this node of this solid is seen.
  std::optional<Probed> find(const std::string& solid, std::size_t place) {
    for (int row = 0; row < kSize.height; ++row)
      for (int column = 0; column < kSize.width; ++column)
        if (auto probed = probe_.at(interpreter_, kSize, column, row);
            probed && probed->what.solid == solid && probed->what.place == place)
          return probed;
    return std::nullopt;
  }

  modeler::Interpreter interpreter_;
  ModelProbe probe_;
};

TEST_F(ModelProbeTest, TellsNodeFaceSurfaceAndPoint) {
  say({"create ball sphere 7", "translate ball 3 0 0", "create box cube 1 2 3 4 5 6",
       "create far sphere 8", "translate far -3 0 0", "combine both box union far",
       "camera frame"});
  const auto ball = find("ball", 0);
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->pick.surface, 7);
  EXPECT_NEAR(glm::length(ball->pick.point - glm::dvec3(3, 0, 0)), 1, 1e-9);
  EXPECT_GT(ball->pick.t, 0);
  EXPECT_THAT(text_of(*ball), HasSubstr("\"ball\": sphere, surface 7"));
  const auto box = find("both", 1);
  ASSERT_TRUE(box && box->what.face);
  EXPECT_EQ(box->pick.surface, *box->what.face + 1);
  EXPECT_THAT(text_of(*box), HasSubstr("\"box\" in \"both\" at 1: cube, face "));
  EXPECT_TRUE(find("both", 2));
  EXPECT_FALSE(probe_.at(interpreter_, kSize, 0, 0));
  EXPECT_FALSE(probe_.at(interpreter_, kSize, -1, 0));
  EXPECT_FALSE(probe_.at(interpreter_, kSize, 0, kSize.height));
}

TEST_F(ModelProbeTest, SeesWhatThereIsNow) {
  EXPECT_EQ(probe_.shown(interpreter_), nullptr);
  EXPECT_FALSE(probe_.at(interpreter_, kSize, 80, 60));
  say({"create a sphere 1", "create b sphere 2", "translate b 4 0 0", "camera frame"});
  EXPECT_TRUE(find("a", 0));
  EXPECT_TRUE(find("b", 0));
  const auto both = probe_.shown(interpreter_);
  EXPECT_EQ(probe_.shown(interpreter_), both);  // the same while nothing changes
  say({"select a", "view alone on"});
  EXPECT_TRUE(find("a", 0));
  EXPECT_FALSE(find("b", 0));
  say({"view alone off", "delete a"});
  EXPECT_FALSE(find("a", 0));
  EXPECT_TRUE(find("b", 0));
  // Where the camera looks elsewhere, so does the probe.
  say({"camera pan 3 0"});
  EXPECT_FALSE(find("b", 0));
}

}  // namespace
}  // namespace sir::viewer
