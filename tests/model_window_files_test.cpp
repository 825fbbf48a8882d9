// The modeler's window: opening and saving.
#ifdef SIR_WITH_IMGUI
#include <unistd.h>

#include "model_window_fixture.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class ModelWindowFilesTest : public ModelWindowTest {
 protected:
  void choose(const std::string& item) {
    click("File");
    click(item);
    ASSERT_TRUE(window().find("file name")) << item;
  }
  bool has_dialog() { return window().find("file name").has_value(); }
};

TEST_F(ModelWindowFilesTest, EachKindIsSavedByACommand) {
  begin_with({"create ball sphere 1", "select ball"});
  window();
  const std::pair<const char*, const char*> kinds[]{{"Save solid...", "OUT.CSG"},
                                                    {"Save camera...", "OUT.CAM"},
                                                    {"Save light...", "OUT.LUZ"},
                                                    {"Save surfaces...", "OUT.SUP"},
                                                    {"Save script...", "OUT.model"}};
  for (const auto& [item, name] : kinds) {
    choose(item);
    type((folder_ / "OUT").string());
    press_enter();
    EXPECT_FALSE(has_dialog()) << item;
    EXPECT_FALSE(desk().refused()) << desk().message();
    EXPECT_THAT(desk().message(), StartsWith("wrote ")) << item;
    EXPECT_TRUE(folder_.has(name)) << name;
  }
  // What was written is in the script, and what is read there makes the same again.
  EXPECT_THAT(desk().script(), testing::Contains(HasSubstr("save ball ")));
  EXPECT_THAT(folder_.read("OUT.model"), StartsWith("create ball sphere 1\nsave ball "));
}

TEST_F(ModelWindowFilesTest, ASceneIsOpened) {
  window();
  key(SDLK_o, SDL_SCANCODE_O, KMOD_LCTRL);
  ASSERT_TRUE(has_dialog());
  type(SIR_IMAGES "/whitted.CSG");
  press_enter();
  EXPECT_FALSE(desk().refused()) << desk().message();
  EXPECT_THAT(desk().script(),
              ElementsAre(HasSubstr("load whitted "), HasSubstr("light load "),
                          HasSubstr("surfaces load "), StartsWith("camera "), "select whitted"));
  // Once more, beside it, under a name that is free.
  key(SDLK_o, SDL_SCANCODE_O, KMOD_LCTRL);
  click("\"whitted.CSG\"");
  click("Open##file");
  EXPECT_EQ(desk().interpreter().solids().size(), 2u);
  EXPECT_EQ(desk().selection(), (Selection{"whitted (2)", 0, {}}));
}

TEST_F(ModelWindowFilesTest, EachKindIsLoadedByACommand) {
  window();
  const std::pair<const char*, const char*> kinds[]{{"Load solid...", "/calice.CSG"},
                                                    {"Load camera...", "/calice.CAM"},
                                                    {"Load light...", "/calice.LUZ"},
                                                    {"Load surfaces...", "/calice.SUP"}};
  for (const auto& [item, name] : kinds) {
    choose(item);
    type(SIR_IMAGES + std::string(name));
    press_enter();
    EXPECT_FALSE(desk().refused()) << item << ": " << desk().message();
  }
  EXPECT_TRUE(desk().interpreter().looks().camera && desk().interpreter().looks().lighting);
  EXPECT_FALSE(desk().interpreter().looks().surfaces.empty());
}

TEST_F(ModelWindowFilesTest, AScriptIsRunUpToWhatIsWrong) {
  folder_.write("s.model", "create a sphere 1\ncreate b cube 2\nscale b 0\ncreate c cube 1\n");
  window();
  choose("Run script...");
  type((folder_ / "s").string());
  press_enter();
  EXPECT_TRUE(desk().refused());
  EXPECT_THAT(desk().message(), HasSubstr("s.model:3"));
  EXPECT_THAT(desk().script(), ElementsAre("create a sphere 1", "create b cube 2"));
}

TEST_F(ModelWindowFilesTest, NothingIsReplacedUnasked) {
  begin_with({"create ball sphere 1", "select ball"});
  folder_.write("ball.CSG", "old");
  window();
  const auto ask = [&] {
    key(SDLK_s, SDL_SCANCODE_S, KMOD_LCTRL);
    type((folder_ / "ball.CSG").string());
    press_enter();
    ASSERT_TRUE(window().find("Replace"));
  };
  ask();
  click("Keep it");
  EXPECT_EQ(folder_.read("ball.CSG"), "old");
  EXPECT_TRUE(has_dialog());
  key(SDLK_ESCAPE, SDL_SCANCODE_ESCAPE);
  EXPECT_FALSE(has_dialog());
  EXPECT_TRUE(desk().selection());  // the key was the dialog's
  ask();
  click("Replace");
  EXPECT_THAT(folder_.read("ball.CSG"), HasSubstr("ESFERA"));
  EXPECT_THAT(desk().message(), StartsWith("wrote "));
}

TEST_F(ModelWindowFilesTest, FoldersAreWalked) {
  std::filesystem::create_directory(folder_ / "an inner folder");
  folder_.write("an inner folder/a.CAM", "");  // above it: two clicks at one place are one
  folder_.write("an inner folder/c\xE1lice velho.CAM", "4 3\n0 0 0\n0 0 -1\n5\n0 1 0\n");
  folder_.write("x.LUZ", "");
  window();
  choose("Load camera...");
  type(folder_.path().string());
  press_enter();  // a folder is gone into
  EXPECT_FALSE(window().find("\"x.LUZ\""));
  click("\"an inner folder\"");
  ASSERT_TRUE(window().find("\"cálice velho.CAM\""));
  click("Up");
  EXPECT_TRUE(window().find("\"an inner folder\""));
  type("an inner folder");
  press_enter();
  click("\"cálice velho.CAM\"");
  click("Open##file");
  EXPECT_FALSE(desk().refused()) << desk().message();
  EXPECT_FALSE(has_dialog());
  ASSERT_TRUE(desk().interpreter().looks().camera) << desk().message();
  EXPECT_EQ(desk().camera().distance, 5);
}

TEST_F(ModelWindowFilesTest, WhatIsNotThereIsSaidInTheDialog) {
  window();
  choose("Load light...");
  type("none such");
  press_enter();
  EXPECT_TRUE(has_dialog());
  type((folder_ / "none" / "x").string());
  press_enter();
  EXPECT_TRUE(has_dialog());
  click("Cancel");
  EXPECT_FALSE(has_dialog());
  EXPECT_THAT(desk().script(), IsEmpty());
  // Where nothing can be written, the command says so.
  begin_with({});
  choose("Save camera...");
  type((folder_ / "none" / "x").string());
  press_enter();
  EXPECT_TRUE(desk().refused());
  EXPECT_THAT(desk().message(), HasSubstr("none"));
}

}  // namespace
}  // namespace sir::viewer
#endif
