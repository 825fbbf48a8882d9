// The modeler's window: parts in place, faces, handles, the command line.
#ifdef SIR_WITH_IMGUI
#include <fmt/format.h>

#include "model_window_fixture.h"
#include "viewer/handles.h"
#include "viewer/model_hand.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class ModelWindowEditTest : public ModelWindowTest {
 protected:
  // Where a point of SC_CENA is seen, in the window.
  Spot at(const glm::dvec2& in_picture) {
    const Spot corner = spot("picture");
    return {corner.x + static_cast<int>(std::lround(in_picture.x)),
            corner.y + static_cast<int>(std::lround(in_picture.y))};
  }
  Handles handles(HandleKind kind) {
    ModelHand hand;
    hand.kind = kind;
    return *hand.handles(desk());
  }
  // The handle of an axis, drawn out by a part of its length.
  void pull(HandleKind kind, int axis, double part) {
    const Handles all = handles(kind);
    for (const Handle& handle : all.all()) {
      if (handle.axis != axis) continue;
      const glm::dvec2 grip = handle.line.back();
      drag(at(grip), at(grip + part * (grip - all.middle())));
    }
  }
};

TEST_F(ModelWindowEditTest, APartIsChangedInPlace) {
  begin_with({"create a sphere 1", "create b sphere 2", "translate b 1 0 0",
              "combine both a difference b", "select both 2"});
  const Spot field = spot("move");
  drag(field, {field.x + 20, field.y});
  EXPECT_THAT(desk().script(), testing::Contains(StartsWith("edit both 2 translate 0 0.2")));
  EXPECT_EQ(desk().selection(), (Selection{"both", 2, {}}));
  click("whole");
  EXPECT_EQ(desk().selection(), (Selection{"both", 0, {}}));
  click("be union");
  EXPECT_THAT(desk().script(), testing::Contains("operation both union"));
  EXPECT_EQ(desk().selected_node()->composite()->operation, Operation::union_of);
}

TEST_F(ModelWindowEditTest, ARefusedDragLeavesSolidAndPicture) {
  begin_with({"create a sphere 1", "create b sphere 2", "translate b 1 0 0",
              "combine both a difference b", "select both 2"});
  const auto before = window().desk().script();
  const Spot field = spot("move");
  drag({field.x - 100, field.y}, {field.x + 900, field.y});  // along X, far away
  EXPECT_TRUE(desk().refused());
  EXPECT_THAT(desk().message(), HasSubstr("meet"));
  EXPECT_EQ(desk().interpreter().solids().find("both")->solid.tree()->bounds.high.x, 1);
}

TEST_F(ModelWindowEditTest, AFaceIsPainted) {
  begin_with({"create box cube 1"});
  window();
  click(in_picture(0.5, 0.5));
  ASSERT_TRUE(desk().selection() && desk().selection()->face);
  const auto face = static_cast<std::size_t>(*desk().selection()->face);
  const auto before = desk().picture();
  click("face");
  click("surface 4");
  const auto& box = *desk().selected_node()->primitive();
  EXPECT_TRUE(box.surface_per_face);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(box.surfaces[i], i == face ? 4 : 1) << i;
  EXPECT_FALSE(desk().picture()->planes == before->planes);
  click("all faces");
  click("surface number");
  type("7");
  press_enter();
  EXPECT_THAT(desk().script(), testing::Contains("paint box 7"));
}

TEST_F(ModelWindowEditTest, ASolidIsRenamedAndAPartLabelled) {
  begin_with({"create a sphere 1", "create b sphere 2", "combine both a union b", "select both"});
  const auto enter = [&](const std::string& name) {
    click("name");
    key(SDLK_END, SDL_SCANCODE_END);
    type(name);
    press_enter();
  };
  enter(" two");
  EXPECT_THAT(desk().script(), testing::Contains("rename both \"both two\""));
  EXPECT_EQ(desk().selection(), (Selection{"both two", 0, {}}));
  desk().execute("select \"both two\" 1");
  window().settle();
  click("Undo");  // a drawing, so that the field has the part's name
  click("Redo");
  enter("x");
  EXPECT_THAT(desk().script(), testing::Contains("edit \"both two\" 1 label ax"));
}

TEST_F(ModelWindowEditTest, HandlesMoveTurnAndScale) {
  begin_with({"create ball sphere 1", "select ball", "camera parallel"});
  window();
  pull(HandleKind::move, 0, 0.5);
  ASSERT_THAT(desk().script()[1], StartsWith("translate ball "));
  EXPECT_THAT(desk().script()[1], EndsWith(" 0 0"));
  EXPECT_GT(desk().selected_node()->bounds.centre().x, 0);
  EXPECT_EQ(desk().interpreter().undoable(), 2u);
  key(SDLK_s, SDL_SCANCODE_S);
  pull(HandleKind::scale, 1, 1);
  ASSERT_THAT(desk().script()[2], StartsWith("scale ball 1 "));
  EXPECT_THAT(desk().script()[2], EndsWith(" 1 centre"));
  const modeler::Box box = desk().selected_node()->bounds;
  EXPECT_NEAR(box.high.y - box.low.y, 4, 0.2);
  key(SDLK_r, SDL_SCANCODE_R);
  const Handles rings = handles(HandleKind::turn);
  const auto& arc = rings.all().front().line;
  drag(at(arc[arc.size() / 4]), at(arc[3 * arc.size() / 4]));
  ASSERT_THAT(desk().script()[3], StartsWith("rotate ball x "));
  EXPECT_EQ(desk().interpreter().undoable(), 4u);
  EXPECT_THAT(desk().script()[4], StartsWith("camera "));  // that it was not the camera that moved
  const CameraFile camera = desk().camera();
  key(SDLK_h, SDL_SCANCODE_H);
  drag(at(arc[arc.size() / 4]), at(arc[3 * arc.size() / 4]));
  EXPECT_NE(desk().camera().normal, camera.normal);  // there are none any more
}

TEST_F(ModelWindowEditTest, AHandleThatIsHeldIsLetGoOfByWhatUndoesOrDeletes) {
  begin_with({"create ball sphere 1", "create box cube 2", "select ball", "camera parallel"});
  window();
  const CameraFile camera = desk().camera();
  struct Case {
    SDL_Keycode sym;
    SDL_Scancode scancode;
    Uint16 modifiers;
    std::size_t solids;
  };
  for (const Case& wanted : {Case{SDLK_z, SDL_SCANCODE_Z, KMOD_LCTRL, 2},
                             Case{SDLK_DELETE, SDL_SCANCODE_DELETE, KMOD_NONE, 1}}) {
    const Handles all = handles(HandleKind::move);
    const auto& axis = all.all().front();
    ASSERT_EQ(axis.axis, 0);
    const Spot grip = at(axis.line.back());
    move(grip);
    button(SDL_MOUSEBUTTONDOWN, grip, SDL_BUTTON_LEFT);
    move({grip.x + 40, grip.y});
    window().settle();
    EXPECT_GT(desk().selected_node()->bounds.centre().x, 0);
    key(wanted.sym, wanted.scancode, wanted.modifiers);
    const auto then = desk().script();
    EXPECT_EQ(desk().interpreter().solids().size(), wanted.solids);
    move({grip.x + 80, grip.y + 60});
    window().settle();
    button(SDL_MOUSEBUTTONUP, {grip.x + 80, grip.y + 60}, SDL_BUTTON_LEFT);
    window().settle();
    EXPECT_EQ(desk().script(), then);
    EXPECT_FALSE(desk().refused());
    EXPECT_EQ(desk().camera().normal, camera.normal);
  }
}

TEST_F(ModelWindowEditTest, TabCompletesAndArrowsBringBack) {
  window();
  click("command");
  type("create ball sph");
  key(SDLK_TAB, SDL_SCANCODE_TAB);
  type("3");
  press_enter();
  EXPECT_THAT(desk().script(), ElementsAre("create ball sphere 3"));
  type("trans");
  key(SDLK_TAB, SDL_SCANCODE_TAB);  // transform, translate
  type("late ball 1 0 0");
  press_enter();
  EXPECT_EQ(desk().script().back(), "translate ball 1 0 0");
  type("unfinished");
  key(SDLK_UP, SDL_SCANCODE_UP);
  key(SDLK_UP, SDL_SCANCODE_UP);
  key(SDLK_UP, SDL_SCANCODE_UP);
  key(SDLK_DOWN, SDL_SCANCODE_DOWN);
  press_enter();
  EXPECT_THAT(desk().script(),
              ElementsAre("create ball sphere 3", "translate ball 1 0 0", "translate ball 1 0 0"));
}

TEST_F(ModelWindowEditTest, ALineOfTheScriptComesBack) {
  begin_with({"create ball sphere 1", "translate ball 1 0 0"});
  window();
  click("line 2");
  key(SDLK_BACKSPACE, SDL_SCANCODE_BACKSPACE);
  type("5");
  press_enter();
  EXPECT_THAT(desk().script(),
              ElementsAre("create ball sphere 1", "translate ball 1 0 0", "translate ball 1 0 5"));
}

TEST_F(ModelWindowEditTest, WhatIsUnderTheMouseIsTold) {
  begin_with({"create ball sphere 1"});
  window();
  const auto told = [&] {
    window().settle();
    const eltek::Screen seen = window().pixels();
    std::vector<Rgb8> corner;
    for (int x = 0; x < 300; ++x) corner.push_back(seen.at(10 + x, seen.size.height - 20));
    return corner;
  };
  move(in_picture(0.01, 0.01));
  const auto background = told();
  move(in_picture(0.5, 0.5));
  const auto ball = told();
  EXPECT_NE(ball, background);
  move(spot("Undo"));
  EXPECT_EQ(told(), background);
}

TEST_F(ModelWindowEditTest, OfManySolidsTheOnesWithANameAreFound) {
  std::vector<std::string> lines;
  for (int i = 0; i < 200; ++i) {
    lines.push_back(fmt::format("create s{} sphere 1", i));
    lines.push_back(fmt::format("translate s{} {} 0 0", i, 3 * i));
  }
  lines_ = lines;
  window();
  EXPECT_FALSE(window().find("\"s150\""));  // out of sight
  click("filter");
  type("S15");
  EXPECT_TRUE(window().find("\"s150\""));
  click("\"s157\"");
  EXPECT_EQ(desk().selection(), (Selection{"s157", 0, {}}));
}

TEST_F(ModelWindowEditTest, LooksAreChangedByCommands) {
  begin_with({"create ball sphere 1"});
  window();
  click("Solids");
  click("Selected");
  click("Create");
  click("Camera");
  const Spot distance = spot("camera distance");
  const double before = desk().camera().distance;
  drag({distance.x - 20, distance.y}, {distance.x + 40, distance.y});
  EXPECT_GT(desk().camera().distance, before);
  click("Back");
  EXPECT_EQ(desk().camera().distance, before);
  click("parallel");
  EXPECT_TRUE(desk().camera().parallel);
  click("Camera");
  click("Light");
  click("Add a light");
  EXPECT_EQ(desk().lighting().lights.size(), 2u);
  const Spot second = spot("light move 2");
  drag(second, {second.x + 40, second.y});
  EXPECT_THAT(desk().script()[2], StartsWith("light move 2 "));
  click("light delete 1");
  EXPECT_EQ(desk().lighting().lights.size(), 1u);
  click("Light");
  click("Surfaces");
  click("Describe");
  EXPECT_TRUE(desk().interpreter().looks().surfaces.contains(1));
  click("surface row 1");
  const Spot gloss = spot("surface 1 specular");
  drag(gloss, {gloss.x + 40, gloss.y});
  EXPECT_GT(desk().interpreter().looks().surfaces.at(1).first.specular, 0.1);
}

}  // namespace
}  // namespace sir::viewer
#endif
