// A window that is gone without its end, and the one that opens after it.
#include "modeler/look_text.h"
#include "tests/model_window_fixture.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RecoveringWindow : public ModelWindowTest {
 protected:
  void SetUp() override {
    ModelWindowTest::SetUp();
    open();
  }

  /// After the one before was dropped, as by a crash. `lines` are done before a person comes.
  void open(std::vector<std::string> lines = {}) {
    window_.reset();
    DeskOptions options;
    options.journals = folder_ / "state";
    window_ = std::make_unique<ModelWindow>(std::move(options), [&](ModelDesk& at) {
      for (const std::string& line : lines) ASSERT_TRUE(at.execute(line)) << at.message();
    });
    window_->settle();
  }

  std::string all() {
    std::string text = modeler::camera_line(desk().camera()) + "\n";
    for (const std::string& line : desk().script()) text += line + "\n";
    return text + std::to_string(desk().interpreter().undoable());
  }

  std::size_t journals() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_ / "state"), {}));
  }
};

TEST_F(RecoveringWindow, OffersBackWhatWasDoneByHand) {
  EXPECT_FALSE(window().find("Recover"));
  ASSERT_TRUE(desk().execute("create ball sphere 1"));
  window().settle();
  drag(in_picture(0.2, 0.2), in_picture(0.3, 0.25));
  drag(in_picture(0.2, 0.2), in_picture(0.25, 0.3), SDL_BUTTON_RIGHT);
  click(in_picture(0.5, 0.5));
  ASSERT_TRUE(desk().execute("create cube cube 2"));
  ASSERT_TRUE(desk().drag("translate cube 1 0 0"));
  ASSERT_TRUE(desk().drag("translate cube 2 0 0"));
  desk().end_drag();
  const std::string before = all();
  open();
  EXPECT_FALSE(desk().refused());
  EXPECT_EQ(desk().interpreter().undoable(), 0u);
  click("Recover");
  EXPECT_FALSE(window().find("Recover"));
  EXPECT_THAT(desk().message(), HasSubstr("recovered: "));
  EXPECT_EQ(all(), before);
  ASSERT_TRUE(desk().execute("undo camera"));  // the drags are one each
  ASSERT_TRUE(desk().execute("undo camera"));
  EXPECT_FALSE(desk().interpreter().looks().camera);
  // It goes on.
  ASSERT_TRUE(desk().execute("delete ball"));
  const std::string later = all();
  open();
  click("Recover");
  EXPECT_EQ(all(), later);
}

TEST_F(RecoveringWindow, KeepsItForLaterOrForgetsIt) {
  ASSERT_TRUE(desk().execute("create first cube 1"));
  open();
  click("Keep for later");
  EXPECT_FALSE(window().find("Recover"));
  ASSERT_TRUE(desk().execute("create second cube 1"));
  open();
  EXPECT_EQ(journals(), 2u);
  click("Discard");  // the last one; then it asks of the other
  EXPECT_EQ(journals(), 1u);
  EXPECT_TRUE(window().find("Recover"));
  click("Recover");
  EXPECT_THAT(desk().script(), ElementsAre("create first cube 1"));
  open();
  key(SDLK_ESCAPE, SDL_SCANCODE_ESCAPE);
  EXPECT_FALSE(window().find("Recover"));
  EXPECT_EQ(journals(), 1u);
}

TEST_F(RecoveringWindow, IsClosedWithoutATraceWhereNothingWasDone) {
  open({"create a cube 1", "camera zoom 1"});
  drag(in_picture(0.2, 0.2), in_picture(0.3, 0.25));
  EXPECT_EQ(desk().end(), "");
  EXPECT_EQ(journals(), 0u);
  open({"create a cube 1"});
  ASSERT_TRUE(desk().execute("scale a 2"));
  EXPECT_THAT(desk().end(), HasSubstr("is kept"));
  EXPECT_EQ(journals(), 1u);
}

}  // namespace
}  // namespace sir::viewer
