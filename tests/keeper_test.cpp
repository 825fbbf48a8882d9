// Sessions that are brought back.
#include <sys/stat.h>

#include <random>

#include "tests/keeper_fixture.h"
#include "tests/modeler_player.h"
#include "tracer/error.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using Sessions = KeeperTest;

// Back to the beginning and on again, the camera for itself: the same at every step.
void expect_same_history(modeler::Interpreter& a, modeler::Interpreter& b) {
  for (const char* command : {"undo camera", "redo camera", "undo", "redo"}) {
    for (bool goes_on = true; goes_on;) {
      std::string said, said_again;
      try {
        said = a.execute(command).done;
      } catch (const modeler::CommandError& error) {
        said = error.what();
        goes_on = false;
      }
      try {
        said_again = b.execute(command).done;
      } catch (const modeler::CommandError& error) {
        said_again = error.what();
      }
      ASSERT_EQ(said_again, said) << command;
      ASSERT_EQ(state_of(b) + looks_of(b), state_of(a) + looks_of(a)) << command;
    }
  }
}

TEST_F(Sessions, AnyOfThemComesBackAsItWas) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    begin();
    std::mt19937_64 random(seed);
    Player player(seed, folder.path().string());
    const std::size_t commands = 1 + random() % 120;
    for (std::size_t done = 0; done < commands;) {
      // A window draws when it likes, and a hand takes the camera and lets go of it.
      if (random() % 5 == 0) (void)interpreter.camera();
      if (random() % 4 == 0) interpreter.hold_camera();
      if (random() % 6 == 0) interpreter.let_go_of_camera();
      try {
        say(player.draw(interpreter));
        ++done;
      } catch (const std::exception&) {
        continue;
      }
    }
    modeler::Interpreter uninterrupted = interpreter;
    uninterrupted.keep({});
    // What was written is there, or not, as its owner has it.
    for (const std::string& name : folder.list())
      if (name != "state") std::filesystem::remove(folder / name);
    begin();
    if (keeper->sessions().empty()) {
      // Nothing was done but to look around.
      EXPECT_TRUE(uninterrupted.undoable() == 0) << seed;
      continue;
    }
    const modeler::Reply reply = say("recover");
    EXPECT_THAT(reply.warnings, IsEmpty());
    ASSERT_EQ(all_of(interpreter), all_of(uninterrupted)) << seed;
    EXPECT_THAT(folder.list(), ElementsAre("state")) << seed;  // nothing is written again
    modeler::Interpreter copy = interpreter;
    copy.keep({});
    expect_same_history(uninterrupted, copy);
    // It goes on, and comes back once more.
    say("create last cube 1");
    const std::string all = all_of(interpreter);
    begin();
    say("recover");
    ASSERT_EQ(all_of(interpreter), all) << seed;
    say("script save " + file("end"));
    EXPECT_EQ(keeper->end(), "");
    EXPECT_THAT(keeper->sessions(), IsEmpty());
  }
}

TEST_F(Sessions, WhatHasBeenReadIsAsItWasThen) {
  say("create a cube 1");
  say("save a " + file("a"));
  say("delete a");
  folder.write("looks.model", "load b " + file("a") + "\nlight load " SIR_IMAGES "/lcg\n");
  say("script load " + file("looks"));
  say("load c " + file("a"));
  const std::string all = all_of(interpreter);
  folder.write("a.CSG", "1\n\nnonsense\n");
  folder.write("looks.model", "nonsense\n");
  begin("images/a");
  const auto kept = keeper->sessions();
  ASSERT_THAT(kept, SizeIs(1));
  EXPECT_THAT(kept[0].changed, ElementsAre(file("a.CSG"), file("looks.model")));
  EXPECT_EQ(kept[0].commands, 5u);
  EXPECT_THAT(say("recover --list").text, HasSubstr("\n  changed since: " + file("a.CSG") + "\n"));
  const modeler::Reply reply = say("recupera");
  EXPECT_THAT(reply.text, HasSubstr(file("a.CSG") + ": has changed since; taken as it was"));
  EXPECT_THAT(reply.done, HasSubstr("recovered: 5 commands of 20"));
  EXPECT_EQ(all_of(interpreter), all);
  EXPECT_EQ(folder.read("a.CSG"), "1\n\nnonsense\n");
}

TEST_F(Sessions, OneThatGoesOnIsNobodyElses) {
  say("create a cube 1");
  EXPECT_THAT(keeper->sessions(), IsEmpty());
  const std::string name = std::filesystem::directory_iterator(journals())->path().stem();
  modeler::Interpreter other;
  {
    modeler::Keeper beside(other, journals());
    EXPECT_EQ(beside.offer(), "");
    EXPECT_THROW(other.execute("recover"), modeler::CommandError);
    EXPECT_THROW(other.execute("recover " + name), modeler::CommandError);
    EXPECT_THROW(other.execute("recover --discard " + name), modeler::CommandError);
    other.execute("create b sphere 1");
  }
  // Both are dropped: the last one first.
  begin();
  ASSERT_THAT(keeper->sessions(), SizeIs(2));
  EXPECT_THAT(keeper->offer(), HasSubstr("2 sessions can be recovered; the last: in "));
  say("recover " + name);
  EXPECT_TRUE(has("a"));
  EXPECT_THAT(keeper->sessions(), SizeIs(1));
  // What there was is put aside, and can be had again.
  const modeler::Reply reply = say("recover");
  EXPECT_TRUE(has("b"));
  EXPECT_THAT(reply.warnings, ElementsAre("not all was saved; " + name +
                                          " is kept: sir model, "
                                          "then recover"));
  say("recover --discard all");
  EXPECT_THAT(keeper->sessions(), IsEmpty());
  EXPECT_TRUE(has("b"));
}

TEST_F(Sessions, AHandThatHeldTheCameraIsGone) {
  interpreter.hold_camera();
  say_all({"create a cube 1", "camera zoom 1", "camera zoom 1"});
  const std::string looks = looks_of(interpreter);
  begin();
  say_all({"recover", "camera zoom 1", "undo camera"});
  EXPECT_EQ(looks_of(interpreter), looks);
  say("undo camera");
  EXPECT_FALSE(interpreter.looks().camera);
}

TEST_F(Sessions, WhatIsSavedNeedsNoJournal) {
  EXPECT_EQ(keeper->end(), "");
  EXPECT_FALSE(std::filesystem::exists(journals()));
  say_all({"view grid on", "camera zoom 1"});
  EXPECT_EQ(keeper->end(), "");
  begin();
  say("create a cube 1");
  say("save a " + file("a"));
  EXPECT_EQ(keeper->end(), "");
  begin();
  say("load a " + file("a"));
  say("light ambient 0.5");
  EXPECT_THAT(keeper->end(), HasSubstr("is kept"));
  begin();
  say("recover");
  say("light save " + file("a"));
  EXPECT_EQ(keeper->end(), "");
  EXPECT_THAT(folder.list(), ElementsAre("a.CSG", "a.LUZ", "state"));
  EXPECT_TRUE(std::filesystem::is_empty(journals()));
  // What was there at the beginning is made again by whoever begins so.
  begin();
  say("create a cube 1");
  keeper->begin();
  say("camera zoom 1");
  EXPECT_EQ(keeper->end(), "");
  EXPECT_TRUE(std::filesystem::is_empty(journals()));
  // Be it that it ends where it was to begin.
  begin("a.model");
  say("create a cube 1");
  begin();
  EXPECT_TRUE(std::filesystem::is_empty(journals()));
}

TEST_F(Sessions, TheyAreForTheirOwnersEyes) {
  const mode_t before = ::umask(0);
  say("create a cube 1");
  ::umask(before);
  struct stat about {};
  ASSERT_EQ(::stat(journals().c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0700u);
  for (const auto& entry : std::filesystem::directory_iterator(journals())) {
    ASSERT_EQ(::stat(entry.path().c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 0777, 0600u);
  }
}

TEST_F(Sessions, TheOldestGoWhereThereAreTooMany) {
  for (std::size_t i = 0; i < modeler::kMostKept + 3; ++i) {
    begin();
    say("create s" + std::to_string(i) + " cube 1");
  }
  begin();
  const auto kept = keeper->sessions();
  ASSERT_THAT(kept, SizeIs(modeler::kMostKept + 1));  // with the one made after the last look
  say("recover " + kept.back().name);
  EXPECT_TRUE(has("s2"));
}

}  // namespace
}  // namespace sir::test
