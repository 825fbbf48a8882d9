// The modeler's window without the window.
#include "viewer/model_desk.h"

#include <gmock/gmock.h>

#include "modeler/look_text.h"
#include "modeler/view.h"
#include "tests/eventually.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ModelDeskTest : public testing::Test {
 protected:
  ModelDeskTest() { desk.set_room({80, 60}); }

  void do_all(std::initializer_list<const char*> lines) {
    for (const char* line : lines) ASSERT_TRUE(desk.execute(line)) << desk.message();
  }

  Planes settled() {
    desk.refresh();
    EXPECT_TRUE(test::eventually([&] {
      const auto picture = desk.picture();
      return picture && picture->whole && !desk.busy();
    }));
    return desk.picture()->planes;
  }

  test::TempFolder folder;
  ModelDesk desk{DeskOptions{}};
};

TEST_F(ModelDeskTest, ASceneLooksAsItIsRendered) {
  desk.open(SIR_IMAGES "/whitted");
  ViewSettings view;
  view.axes = view.bounds = false;
  desk.set_view(view);
  EXPECT_EQ(desk.selection(), (Selection{"whitted", 0}));
  RenderOptions options;
  options.size = desk.picture_size();
  const Scene scene = read_scene(SIR_IMAGES "/whitted");
  EXPECT_TRUE(settled() == render(scene, options).planes);
  EXPECT_EQ(camera_text(desk.camera()), camera_text(scene.camera));
  EXPECT_EQ(lighting_text(desk.lighting()), lighting_text(scene.lighting));
  EXPECT_THAT(desk.script(), ElementsAre(HasSubstr("load whitted "), HasSubstr("light load "),
                                         HasSubstr("surfaces load "), HasSubstr("camera window "),
                                         "view axes off", "view bounds off", "select whitted"));
  EXPECT_THROW(desk.open(folder / "NONE"), FileError);
}

TEST_F(ModelDeskTest, ADragIsTheLastOfItsCommands) {
  do_all({"create a sphere 1", "create b cube 2"});
  for (const char* line : {"translate a 1 0 0", "translate a 2 0 0", "translate a 3 0 0"})
    EXPECT_TRUE(desk.drag(line));
  EXPECT_THAT(desk.script(),
              ElementsAre("create a sphere 1", "create b cube 2", "translate a 3 0 0"));
  desk.end_drag();
  EXPECT_TRUE(desk.drag("scale a 2"));
  EXPECT_FALSE(desk.drag("scale a 0"));
  EXPECT_TRUE(desk.refused());
  EXPECT_EQ(desk.script().back(), "scale a 2");
  EXPECT_TRUE(desk.drag("scale a 3"));
  EXPECT_EQ(desk.script().size(), 4u);
  EXPECT_EQ(desk.script().back(), "scale a 3");
  EXPECT_TRUE(desk.drag(""));
  EXPECT_EQ(desk.script().size(), 3u);
  EXPECT_TRUE(desk.drag("scale a 5"));
  EXPECT_EQ(desk.script().size(), 4u);
  desk.end_drag();
  EXPECT_FALSE(desk.drag("scale a 0"));  // the first of a drag
  EXPECT_EQ(desk.script().back(), "scale a 5");
  EXPECT_TRUE(desk.drag("scale a 7"));
  EXPECT_EQ(desk.script().size(), 5u);
}

TEST_F(ModelDeskTest, ACommandInBetweenCutsADragOff) {
  do_all({"create a sphere 1"});
  for (const char* other : {"undo", "redo"}) {
    EXPECT_TRUE(desk.drag("translate a 1 0 0"));
    EXPECT_TRUE(desk.execute("undo"));
    if (std::string(other) == "redo") {
      EXPECT_TRUE(desk.execute("redo"));
    }
    const auto script = desk.script();
    EXPECT_TRUE(desk.drag("translate a 2 0 0"));  // the hand goes on, with all that it did
    EXPECT_EQ(desk.script(), script);
    desk.end_drag();
    EXPECT_TRUE(desk.drag("translate a 3 0 0"));
    EXPECT_EQ(desk.script().size(), script.size() + 1);
    desk.end_drag();
  }
}

TEST_F(ModelDeskTest, ADragOfTheCameraIsOneForItsUndo) {
  do_all({"create a sphere 1", "translate a 1 0 0"});
  const std::string first = camera_text(desk.camera());
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(desk.turn(0.01, 0.01));
  const std::string second = camera_text(desk.camera());
  desk.end_drag();
  EXPECT_TRUE(desk.pan(0.1, 0));
  EXPECT_TRUE(desk.zoom(1));
  EXPECT_TRUE(desk.drag("camera turn 0.1 0"));
  desk.end_drag();
  EXPECT_THAT(desk.script(), ElementsAre("create a sphere 1", "translate a 1 0 0",
                                         modeler::camera_line(desk.camera())));
  do_all({"undo camera"});
  EXPECT_EQ(camera_text(desk.camera()), second);
  do_all({"undo camera"});
  EXPECT_EQ(camera_text(desk.camera()), first);
  EXPECT_FALSE(desk.execute("undo camera"));
  do_all({"redo camera", "undo"});  // the edit, not the camera
  EXPECT_EQ(camera_text(desk.camera()), second);
  EXPECT_THAT(desk.script(), ElementsAre("create a sphere 1", HasSubstr("camera ")));
}

TEST_F(ModelDeskTest, ADragMayBeOfLights) {
  do_all({"create a sphere 1", "light set add 0 0 9 1"});
  for (const char* line : {"light move 1 1 0 9", "light move 1 2 0 9"})
    EXPECT_TRUE(desk.drag(line));
  desk.end_drag();
  EXPECT_THAT(desk.script(),
              ElementsAre("create a sphere 1", "light set add 0 0 9 1", "light move 1 2 0 9"));
  Lighting lighting = desk.lighting();
  for (const double ambient : {0.25, 0.5, 0.75}) {
    lighting.ambient = glm::dvec3(ambient);
    EXPECT_TRUE(desk.set_lighting(lighting));
  }
  desk.end_drag();
  EXPECT_EQ(desk.script().size(), 4u);
  EXPECT_EQ(desk.script().back(), modeler::light_line(lighting));
  do_all({"undo", "undo"});
  EXPECT_EQ(desk.lighting().lights[0].position.x, 0);
}

TEST_F(ModelDeskTest, WhatIsClickedIsANodeAndAFace) {
  do_all({"create a cube 1", "create b sphere 1", "translate b 3 0 0", "combine c a union b",
          "create d sphere 1", "translate d -3 0 0",
          "camera window 16 12 target 0.5 0.5 0 normal 0 0 -1 distance 10 parallel"});
  // Five pixels are one unit; the target is in the middle, at column 40, row 30.
  desk.select_at(40, 30);
  EXPECT_EQ(desk.selection(), (Selection{"c", 1, 5}));  // Z=1
  EXPECT_EQ(desk.script().back(), "select c 1 5");
  desk.select_at(53, 32);
  EXPECT_EQ(desk.selection(), (Selection{"c", 2, 0}));
  desk.select_at(22, 32);
  EXPECT_EQ(desk.selection(), (Selection{"d", 0, 0}));
  do_all({"select c", "view alone on"});
  desk.select_at(53, 32);
  EXPECT_EQ(desk.selection(), (Selection{"c", 2, 0}));
  desk.select_at(0, 0);
  EXPECT_FALSE(desk.selection());
}

TEST_F(ModelDeskTest, WhatIsRefusedLeavesThePicture) {
  do_all({"create a sphere 1"});
  const Planes before = settled();
  EXPECT_FALSE(desk.execute("combine c a union a"));
  EXPECT_TRUE(desk.refused());
  EXPECT_THAT(desk.message(), Not(IsEmpty()));
  CameraFile camera = desk.camera();
  camera.normal = {0, 0, 0};
  EXPECT_FALSE(desk.set_camera(camera));
  Lighting lighting = desk.lighting();
  lighting.ambient.x = -1;
  EXPECT_FALSE(desk.set_lighting(lighting));
  EXPECT_TRUE(settled() == before);
  lighting.ambient.x = 1;
  EXPECT_TRUE(desk.set_lighting(lighting));
  EXPECT_FALSE(settled() == before);
}

TEST_F(ModelDeskTest, WhatIsSelectedMayGo) {
  do_all({"create a sphere 1", "create b cube 2", "combine c a union b"});
  desk.select(Selection{"c", 2});
  ASSERT_NE(desk.selected_node(), nullptr);
  EXPECT_EQ(desk.selected_node()->name, "b");
  EXPECT_TRUE(desk.execute("split c"));
  EXPECT_FALSE(desk.selection());
  desk.select(Selection{"c", 0});
  EXPECT_FALSE(desk.selection());
  desk.select(Selection{"a", 7});
  EXPECT_FALSE(desk.selection());
}

TEST_F(ModelDeskTest, OneSolidCanBeSeenAlone) {
  do_all({"create a sphere 1", "create b cube 2", "translate b 3 0 0"});
  desk.select(Selection{"a", 0});
  ViewSettings view;
  view.axes = view.bounds = false;
  desk.set_view(view);
  const Planes both = settled();
  view.alone = true;
  desk.set_view(view);
  const Planes one = settled();
  EXPECT_FALSE(one == both);
  RenderOptions options;
  options.size = desk.picture_size();
  const auto& tree = *desk.interpreter().solids().find("a")->solid.tree();
  EXPECT_TRUE(one == render(modeler::scene_of(tree, desk.camera()), options).planes);
}

TEST_F(ModelDeskTest, TheScriptMakesTheSameAgain) {
  do_all({"create \"a b\" sphere 1", "create c cube 2", "undo", "create d cube 3",
          "surface 3 colour 0.5 chequer 4 4"});
  desk.turn(0.1, 0.2);
  desk.end_drag();
  Lighting lighting = desk.lighting();
  lighting.lights[0].position.x += 1;
  EXPECT_TRUE(desk.set_lighting(lighting));
  ViewSettings view;
  view.grid = view.silhouette = true;
  desk.set_view(view);
  EXPECT_TRUE(desk.select(Selection{"d", 0, 3}));
  ASSERT_TRUE(desk.save_script(folder / "S")) << desk.message();
  ModelDesk again{DeskOptions{}};
  again.set_room({80, 60});
  again.run_script(folder / "S.model");
  EXPECT_EQ(again.script(), desk.script());
  EXPECT_EQ(again.interpreter().solids().size(), 2u);
  EXPECT_EQ(camera_text(again.camera()), camera_text(desk.camera()));
  EXPECT_EQ(again.view(), view);
  EXPECT_EQ(again.selection(), desk.selection());
  const Planes picture = settled();
  again.refresh();
  ASSERT_TRUE(test::eventually([&] { return !again.busy(); }));
  EXPECT_TRUE(again.picture()->planes == picture);
  // It may go back to where it came from; a solid may not go there.
  EXPECT_TRUE(again.execute("delete d"));
  EXPECT_TRUE(again.save_script(folder / "S.model")) << again.message();
  EXPECT_FALSE(again.execute("save \"a b\" " + (folder / "S.model").string()));
  EXPECT_FALSE(desk.save_script(folder / "no" / "such"));
  EXPECT_TRUE(desk.refused());
}

TEST_F(ModelDeskTest, QuitAsksOnceWhereSolidsAreNotSaved) {
  EXPECT_TRUE(desk.execute("create a sphere 1"));
  desk.close();
  EXPECT_FALSE(desk.closed());
  EXPECT_TRUE(desk.execute("translate a 1 0 0"));  // anything done begins it anew
  desk.close();
  EXPECT_FALSE(desk.closed());
  EXPECT_TRUE(desk.drag("translate a 2 0 0"));
  desk.end_drag();
  desk.close();
  EXPECT_FALSE(desk.closed());
  desk.close();
  EXPECT_TRUE(desk.closed());
  ModelDesk empty{DeskOptions{}};
  empty.execute("quit");
  EXPECT_TRUE(empty.closed());
}

}  // namespace
}  // namespace sir::viewer
