// The modeler's window: what is typed into fields, and names that are hard to show.
#ifdef SIR_WITH_IMGUI
#include "model_window_fixture.h"

namespace sir::viewer {
namespace {

using testing::Contains;
using testing::ElementsAre;

class ModelWindowFieldsTest : public ModelWindowTest {
 protected:
  void press_tab() { key(SDLK_TAB, SDL_SCANCODE_TAB); }
  void press_escape() { key(SDLK_ESCAPE, SDL_SCANCODE_ESCAPE); }

  // Opens a field of numbers for typing.
  void click_with_ctrl(Spot at) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym = {SDL_SCANCODE_LCTRL, SDLK_LCTRL, KMOD_LCTRL, 0};
    send(event);
    click(at);
    event.type = SDL_KEYUP;
    event.key.keysym.mod = KMOD_NONE;
    send(event);
    window().settle();
  }

  // What is to be seen around the middle of a field.
  std::vector<Rgb8> seen_at(const std::string& label) {
    const Spot at = spot(label);
    const eltek::Screen seen = window().pixels();
    std::vector<Rgb8> pixels;
    for (int y = at.y - 7; y < at.y + 7; ++y)
      for (int x = at.x - 50; x < at.x + 30; ++x) pixels.push_back(seen.at(x, y));
    return pixels;
  }
};

TEST_F(ModelWindowFieldsTest, TabLeadsOnAndWhatWasTypedStays) {
  begin_with({"create ball sphere 1", "select ball"});
  click_with_ctrl(spot("scale"));  // the middle of the three
  type("3");
  press_tab();
  type("2");
  press_enter();
  EXPECT_EQ(desk().selected_node()->bounds.high, glm::dvec3(1, 3, 2));
  click_with_ctrl(spot("turn x"));
  type("30");
  press_tab();
  type("40");
  press_enter();
  EXPECT_THAT(desk().script(), Contains("rotate ball x 30"));
  EXPECT_THAT(desk().script(), Contains("rotate ball y 40"));
}

TEST_F(ModelWindowFieldsTest, AFieldThatGoesWhileItIsDraggedBeginsAnew) {
  begin_with({"create ball sphere 1", "select ball"});
  const Spot field = spot("move");
  move(field);
  button(SDL_MOUSEBUTTONDOWN, field, SDL_BUTTON_LEFT);
  window().settle();
  move({field.x + 60, field.y});
  window().settle();
  const double moved = desk().selected_node()->bounds.centre().y;
  EXPECT_GT(moved, 0);
  press_escape();  // nothing is selected any more
  EXPECT_FALSE(desk().selection());
  button(SDL_MOUSEBUTTONUP, {field.x + 60, field.y}, SDL_BUTTON_LEFT);
  window().settle();
  click("\"ball\"");
  drag({field.x - 20, field.y}, {field.x + 40, field.y});
  EXPECT_NEAR(desk().selected_node()->bounds.centre().y, 2 * moved, 1e-9);
}

TEST_F(ModelWindowFieldsTest, EnterInANameCreatesAndCombines) {
  window();
  click("new name");
  type("ball");
  press_enter();
  EXPECT_THAT(desk().script(), ElementsAre("create ball cube 1", "select ball"));
  desk().execute("create bite sphere 2");
  window().settle();
  drag(spot("\"bite\""), spot("\"ball\""));
  click("combined name");
  type("rest");
  press_enter();
  EXPECT_EQ(desk().selection(), (Selection{"rest", 0, {}}));
}

TEST_F(ModelWindowFieldsTest, TextIsTakenOverAndPutElsewhere) {
  begin_with({"create ball sphere 1", "select ball"});
  click("name");
  key(SDLK_a, SDL_SCANCODE_A, KMOD_LCTRL);
  key(SDLK_c, SDL_SCANCODE_C, KMOD_LCTRL);
  type("globe");
  press_enter();
  EXPECT_EQ(desk().selection(), (Selection{"globe", 0, {}}));
  // The letters of a keyboard that has its A where others have their Q.
  click("name");
  key(SDLK_a, SDL_SCANCODE_Q, KMOD_LCTRL);
  key(SDLK_v, SDL_SCANCODE_V, KMOD_LCTRL);
  key(SDLK_KP_ENTER, SDL_SCANCODE_KP_ENTER);
  EXPECT_EQ(desk().selection(), (Selection{"ball", 0, {}}));
}

TEST_F(ModelWindowFieldsTest, EscClosesAList) {
  begin_with({"create ball sphere 1", "select ball"});
  window();
  click("kind");
  EXPECT_TRUE(window().find("cone"));
  press_escape();
  EXPECT_FALSE(window().find("cone"));
  EXPECT_TRUE(desk().selection());
  click("File");
  EXPECT_TRUE(window().find("Quit"));
  press_escape();
  EXPECT_FALSE(window().find("Quit"));
}

TEST_F(ModelWindowFieldsTest, NamesAreShownToTheirEnd) {
  begin_with({R"(create "o##a" sphere 1)", R"(create "o##m" cube 2)"});
  window();
  drag(spot("\"o##a\""), spot("\"o##m\""));
  move(in_picture(0.5, 0.5));
  window().settle();
  const auto left = seen_at("left"), right = seen_at("right");
  drag(spot("\"o##m\""), spot("\"o##a\""));
  move(in_picture(0.5, 0.5));
  window().settle();
  EXPECT_NE(seen_at("left"), left);
  EXPECT_NE(seen_at("right"), right);
}

TEST_F(ModelWindowFieldsTest, ANameLongerThanItsFieldStaysAsItIs) {
  const std::string name(600, 'x');
  lines_ = {"create " + name + " sphere 1", "select " + name};
  window();
  click("name");
  press_enter();
  EXPECT_EQ(desk().selection(), (Selection{name, 0, {}}));
}

TEST_F(ModelWindowFieldsTest, ASolidMayBeCalledAsAButtonIs) {
  begin_with({"create a sphere 1", "create b sphere 2", "combine both a difference b apart",
              "create c sphere 3", "combine union both union c", "select union 1"});
  window();
  click("be union");
  EXPECT_EQ(desk().selected_node()->composite()->operation, Operation::union_of);
  click("whole");
  EXPECT_EQ(desk().selection(), (Selection{"union", 0, {}}));
}

TEST_F(ModelWindowFieldsTest, SurfacesWithLargeNumbersAreOfTheirOwn) {
  begin_with({"create a sphere 1", "surface 1 colour 0.5", "surface 4294967297 colour 0.7"});
  window();
  for (const char* part : {"Solids", "Selected", "Create", "Surfaces"}) click(part);
  click("surface row 4294967297");
  EXPECT_TRUE(window().find("surface 4294967297 specular"));
  EXPECT_FALSE(window().find("surface 1 specular"));
}

}  // namespace
}  // namespace sir::viewer
#endif
