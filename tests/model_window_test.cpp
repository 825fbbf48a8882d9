// The modeler's window: what a hand does in it becomes commands.
#ifdef SIR_WITH_IMGUI
#include <map>

#include "model_window_fixture.h"
#include "modeler/look_text.h"
#include "tracer/scene_file.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST_F(ModelWindowTest, ShowsThePreviewPixelForPixel) {
  begin_with({"create ball sphere 1"});
  const eltek::Screen seen = window().pixels();
  const auto picture = desk().picture();
  ASSERT_TRUE(picture && picture->whole);
  const Spot corner = spot("picture");
  const ImageSize size = picture->planes.size;
  EXPECT_EQ(size, desk().picture_size());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      ASSERT_EQ(seen.at(corner.x + x, corner.y + y),
                picture->planes.at(static_cast<std::size_t>(y * size.width + x)))
          << x << "," << y;
}

TEST_F(ModelWindowTest, AButtonCreatesASolid) {
  const auto nothing = window().desk().picture();
  click("Create##do");
  EXPECT_THAT(desk().script(), ElementsAre("create cube cube 1", "select cube"));
  EXPECT_EQ(desk().selection(), (Selection{"cube", 0}));
  EXPECT_FALSE(desk().picture()->planes == nothing->planes);
  click("Create##do");
  EXPECT_THAT(desk().script(), ElementsAre("create cube cube 1", "create \"cube (2)\" cube 1",
                                           "select \"cube (2)\""));
  click("Delete");
  EXPECT_EQ(desk().interpreter().solids().size(), 1u);
  click("Undo");
  EXPECT_EQ(desk().interpreter().solids().size(), 2u);
  click("Redo");
  EXPECT_EQ(desk().interpreter().solids().size(), 1u);
}

TEST_F(ModelWindowTest, TheCommandLineDoesCommands) {
  click("command");
  type("create ball sphere 1");
  key(SDLK_RETURN, SDL_SCANCODE_RETURN);
  EXPECT_THAT(desk().script(), ElementsAre("create ball sphere 1"));
  EXPECT_FALSE(desk().refused());
  const auto before = desk().picture();
  // The keyboard has stayed where it was.
  type("scale ball 0");
  key(SDLK_RETURN, SDL_SCANCODE_RETURN);
  EXPECT_TRUE(desk().refused());
  EXPECT_THAT(desk().message(), Not(IsEmpty()));
  EXPECT_THAT(desk().script(), ElementsAre("create ball sphere 1"));
  EXPECT_TRUE(desk().picture()->planes == before->planes);
}

TEST_F(ModelWindowTest, AClickSelectsWhatIsThere) {
  begin_with({"create ball sphere 1", "create wall cube 2", "translate wall 3 0 0",
              "combine both ball union wall", "create far sphere 3", "translate far -4 0 0"});
  window();
  key(SDLK_f, SDL_SCANCODE_F);
  const ImageSize size = desk().picture_size();
  // By what the picture says of each solid's place.
  std::map<std::string, Spot> places;
  for (int y = 0; y < size.height; y += 8)
    for (int x = 0; x < size.width; x += 8) {
      desk().select_at(x, y);
      const auto* node = desk().selected_node();
      places[node == nullptr ? "" : node->name] = {x + spot("picture").x, y + spot("picture").y};
    }
  ASSERT_EQ(places.size(), 4u);
  desk().select(std::nullopt);
  click(places["wall"]);
  ASSERT_TRUE(desk().selection() && desk().selection()->face);
  EXPECT_EQ(desk().selection(), (Selection{"both", 2, desk().selection()->face}));
  click(places["far"]);
  EXPECT_EQ(desk().selection(), (Selection{"far", 0, 0}));
  click(places[""]);
  EXPECT_FALSE(desk().selection());
  click("\"both\"");
  EXPECT_EQ(desk().selection(), (Selection{"both", 0}));
}

TEST_F(ModelWindowTest, ADragOfAFieldIsOneCommand) {
  begin_with({"create ball sphere 1"});
  click("\"ball\"");
  // The commands, of which the last is the selection's.
  const auto changes = [this] {
    auto script = desk().script();
    EXPECT_EQ(script.back(), "select ball");
    script.pop_back();
    return script;
  };
  const Spot field = spot("move");
  drag(field, {field.x + 60, field.y});
  ASSERT_EQ(changes().size(), 2u);
  EXPECT_THAT(changes()[1], StartsWith("translate ball 0 "));
  const double moved = desk().selected_node()->bounds.centre().y;
  EXPECT_NEAR(moved, 0.6, 1e-9);  // a pixel is 1/200 of the ball
  // Elsewhere in it: two clicks at one place may be a double click.
  drag({field.x - 20, field.y}, {field.x + 40, field.y});
  EXPECT_EQ(changes().size(), 3u);
  EXPECT_NEAR(desk().selected_node()->bounds.centre().y, 2 * moved, 1e-12);
  const Spot turn = spot("turn z");
  drag(turn, {turn.x + 30, turn.y});
  EXPECT_EQ(changes().back(), "rotate ball z 30");
  const Spot scale = spot("scale all");
  drag({scale.x - 20, scale.y}, {scale.x + 40, scale.y});
  EXPECT_THAT(changes().back(), StartsWith("scale ball 1.6"));
  EXPECT_EQ(changes().size(), 5u);
}

TEST_F(ModelWindowTest, TheMouseLeadsTheCamera) {
  begin_with({"create ball sphere 1"});
  window();
  const auto text = [this] { return camera_text(desk().camera()); };
  const CameraFile first = desk().camera();
  drag(in_picture(0.4, 0.4), in_picture(0.6, 0.5));
  EXPECT_NE(desk().camera().normal, first.normal);
  EXPECT_EQ(desk().camera().target, first.target);
  EXPECT_FALSE(desk().selection());  // a drag is no click
  const CameraFile turned = desk().camera();
  for (const std::uint8_t which :
       {std::uint8_t{SDL_BUTTON_RIGHT}, std::uint8_t{SDL_BUTTON_MIDDLE}}) {
    const glm::dvec3 target = desk().camera().target;
    drag(in_picture(0.4, 0.4), in_picture(0.5, 0.45), which);
    EXPECT_EQ(desk().camera().normal, turned.normal);
    EXPECT_NE(desk().camera().target, target);
  }
  SDL_Event wheel{};
  wheel.type = SDL_MOUSEWHEEL;
  wheel.wheel.y = 1;
  move(in_picture(0.5, 0.5));
  send(wheel);
  window().settle();
  EXPECT_LT(desk().camera().window.x, first.window.x);
  const std::string before = text();
  move(spot("Undo"));
  send(wheel);  // the panel's own
  window().settle();
  EXPECT_EQ(text(), before);
  key(SDLK_f, SDL_SCANCODE_F);
  EXPECT_EQ(text(), camera_text(first));
  EXPECT_THAT(desk().script(),
              ElementsAre("create ball sphere 1", modeler::camera_line(desk().camera())));
  // Each drag was one, the wheel another.
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(desk().execute("undo camera")) << i;
  EXPECT_FALSE(desk().execute("undo camera"));
  EXPECT_EQ(text(), camera_text(first));
}

TEST_F(ModelWindowTest, KeysUndoAndRedo) {
  begin_with({"create ball sphere 1"});
  window();
  key(SDLK_z, SDL_SCANCODE_Z, KMOD_LCTRL);
  EXPECT_THAT(desk().script(), IsEmpty());
  key(SDLK_y, SDL_SCANCODE_Y, KMOD_LCTRL);
  EXPECT_THAT(desk().script(), ElementsAre("create ball sphere 1"));
  key(SDLK_z, SDL_SCANCODE_Z, KMOD_LCTRL);
  key(SDLK_z, SDL_SCANCODE_Z, KMOD_LCTRL | KMOD_LSHIFT);
  EXPECT_THAT(desk().script(), ElementsAre("create ball sphere 1"));
}

TEST_F(ModelWindowTest, OneRowOnAnotherCombines) {
  begin_with({"create ball sphere 1", "create bite cube 2"});
  window();
  EXPECT_FALSE(window().find("Combine##do"));
  drag(spot("\"bite\""), spot("\"ball\""));
  click("operation");
  click("difference");
  click("combined name");
  type("rest");
  click("Combine##do");
  EXPECT_THAT(desk().script(), ElementsAre("create ball sphere 1", "create bite cube 2",
                                           "combine rest ball difference bite", "select rest"));
  EXPECT_EQ(desk().selection(), (Selection{"rest", 0}));
  click("Split");
  EXPECT_EQ(desk().script().back(), "split rest");
}

TEST_F(ModelWindowTest, BoxesChangeTheView) {
  begin_with({"create ball sphere 1", "create bite sphere 2", "translate bite 0 0 1",
              "combine rest ball difference bite"});
  window();
  const auto before = desk().picture();
  click("ghosts");
  EXPECT_TRUE(desk().view().ghosts);
  EXPECT_FALSE(desk().picture()->planes == before->planes);
  click("ghosts");
  EXPECT_TRUE(desk().picture()->planes == before->planes);
  click("axes");
  EXPECT_FALSE(desk().view().axes);
  EXPECT_FALSE(desk().picture()->planes == before->planes);
}

TEST_F(ModelWindowTest, ClosingWarnsOnceOfWhatIsNotSaved) {
  begin_with({"create ball sphere 1"});
  window();
  SDL_Event event{};
  event.type = SDL_QUIT;
  send(event);
  window().settle();
  EXPECT_FALSE(desk().closed());
  EXPECT_THAT(desk().message(), HasSubstr("ball"));
  send(event);
  window().run();
  EXPECT_TRUE(desk().closed());
}

TEST_F(ModelWindowTest, AStopEndsIt) {
  std::stop_source source;
  source.request_stop();
  window().run(source.get_token());
  EXPECT_FALSE(desk().closed());
}

}  // namespace
}  // namespace sir::viewer
#endif
