// The modeler's window without the window.
#include "viewer/model_desk.h"

#include <gmock/gmock.h>

#include "modeler/csg.h"
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
  EXPECT_THAT(desk.script(),
              ElementsAre(HasSubstr("load whitted "), HasSubstr("light load "),
                          HasSubstr("surfaces load "), HasSubstr("camera window "), "view axes off",
                          "view bounds off", "select whitted"));
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
  do_all({"create \"a b\" sphere 1", "create c cube 2", "undo", "create d cube 3"});
  ASSERT_TRUE(desk.save_script(folder / "S")) << desk.message();
  ModelDesk again{DeskOptions{}};
  again.run_script(folder / "S.model");
  EXPECT_EQ(again.script(), desk.script());
  EXPECT_EQ(again.interpreter().solids().size(), 2u);
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
  desk.close();
  EXPECT_TRUE(desk.closed());
  ModelDesk empty{DeskOptions{}};
  empty.execute("quit");
  EXPECT_TRUE(empty.closed());
}

}  // namespace
}  // namespace sir::viewer
