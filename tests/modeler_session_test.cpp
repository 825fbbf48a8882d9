// The script of a session makes all of it again.
#include <map>
#include <sstream>

#include "tests/cases.h"
#include "tests/modeler_fixture.h"
#include "tests/modeler_player.h"
#include "tracer/error.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using Lines = std::vector<std::string>;

class Session : public ModelerTest {
 protected:
  std::string file(const std::string& name) { return (folder / name).string(); }

  // A fresh interpreter that has done the script; pictures go to `pictures`.
  modeler::Interpreter replayed(const Lines& script) {
    modeler::Interpreter again(outlet());
    for (const std::string& line : script) again.execute(line);
    return again;
  }
  modeler::Outlet outlet() {
    modeler::Outlet outlet;
    outlet.write_picture = [this](const std::filesystem::path& name, const Planes& picture) {
      pictures.insert_or_assign(name.string(), picture);
    };
    return outlet;
  }

  // Every file of the folder that a line of the script names, and every picture.
  std::map<std::string, std::string> written_by(const Lines& script) {
    std::map<std::string, std::string> found;
    for (const std::string& line : script) {
      const auto at = line.find(folder.path().string());
      if (at == line.npos) continue;
      const std::string name = line.substr(at, line.find(' ', at) - at);
      const auto picture = pictures.find(name);
      if (picture != pictures.end())
        for (const auto& channel : picture->second.channel)
          found[name].append(channel.begin(), channel.end());
      else found[name] = folder.read(std::filesystem::path(name).filename().string());
    }
    return found;
  }

  std::map<std::string, Planes> pictures;
};

TEST_F(Session, TheScriptMakesAllOfItAgain) {
  std::size_t written_files = 0;
  for (std::uint64_t seed = 0; seed < cases(30); ++seed) {
    Player player(seed, folder.path().string());
    interpreter = modeler::Interpreter(outlet());
    pictures.clear();
    int refused = 0, done = 0;
    while (done < 150) {
      const std::string command = player.draw(interpreter);
      const std::string before = state_of(interpreter) + looks_of(interpreter);
      if (done % 7 == 0) interpreter.hold_camera();
      if (done % 7 == 3) interpreter.let_go_of_camera();
      try {
        say(command);
        ++done;
      } catch (const std::exception&) {
        ++refused;
        ASSERT_EQ(state_of(interpreter) + looks_of(interpreter), before) << command;
      }
      if (done % 50 != 49) continue;
      const Lines script = interpreter.script();
      const auto files = written_by(script);
      modeler::Interpreter again = replayed(script);
      ASSERT_EQ(state_of(again), state_of(interpreter)) << seed;
      ASSERT_EQ(looks_of(again), looks_of(interpreter)) << seed;
      ASSERT_EQ(again.script(), script) << seed;
      ASSERT_EQ(written_by(script), files) << seed;  // the files are written anew
      written_files += files.size();
    }
    EXPECT_GT(refused, 0);
    // To the beginning and back.
    while (interpreter.undoable() > 0) say("undo");
    EXPECT_TRUE(interpreter.solids().empty());
    EXPECT_FALSE(interpreter.looks().lighting);
    EXPECT_TRUE(interpreter.looks().surfaces.empty());
  }
  EXPECT_GT(written_files, 100u);
}

TEST_F(Session, UndoAndRedoTakeFilesOutOfTheScriptAndBringThemBack) {
  const std::string a = "save a " + file("a.CSG"), light = "light save " + file("l.LUZ");
  say("light save " + file("first.LUZ"));
  say("create a cube 1");
  say(a);
  say("scale a 2");
  say("light set ambient 1");
  say(light);
  const Lines all = interpreter.script();
  // The first light is that of the camera that there was.
  ASSERT_THAT(
      all, ElementsAre(StartsWith("camera window "), StartsWith("light save "), "create a cube 1",
                       a, "scale a 2", "light set ambient 1", light, "camera auto"));
  say_all({"undo", "undo"});
  EXPECT_EQ(interpreter.script()[3], a);
  EXPECT_EQ(interpreter.script().size(), 5u);
  say("undo");
  EXPECT_EQ(interpreter.script().size(), 3u);
  std::filesystem::remove(folder / "a.CSG");
  say_all({"redo", "redo", "redo"});
  EXPECT_EQ(interpreter.script(), all);
  EXPECT_FALSE(folder.has("a.CSG"));  // it is not done again
  say_all({"undo", "undo", "undo", "create b cube 1"});
  EXPECT_THAT(interpreter.script(),
              ElementsAre(StartsWith("camera window "), StartsWith("light save "),
                          "create b cube 1", "camera auto"));
}

TEST_F(Session, WhatHangsOnTheCameraHasItsLineBeforeIt) {
  say_all({"create a cube 1", "camera target 1 0 0"});
  const std::string first = modeler::camera_line(interpreter.camera());
  say("camera save " + file("1"));
  say("show a 1.png");
  for (int i = 0; i < 100; ++i) say("camera turn 0.01 0");
  const std::string second = modeler::camera_line(interpreter.camera());
  say("show a 2.png");
  say("show a 3.png --scene " SIR_IMAGES "/lcg");
  say("camera zoom 2");
  const std::string last = modeler::camera_line(interpreter.camera());
  EXPECT_THAT(interpreter.script(),
              ElementsAre("create a cube 1", first, "camera save " + file("1"), "show a 1.png",
                          second, "show a 2.png", "show a 3.png --scene " SIR_IMAGES "/lcg", last));
  say("list");
  say("show a");
  EXPECT_EQ(interpreter.script().size(), 8u);
}

TEST_F(Session, TheScriptIsToldAndSaved) {
  say_all({"create a cube 1  # one", "view grid on", "select a"});
  EXPECT_EQ(say("script").text, "create a cube 1\nview grid on\nselect a\n");
  EXPECT_THAT(interpreter.unsaved(), ElementsAre("a"));
  EXPECT_EQ(say("roteiro salva " + file("s")).done, "wrote " + file("s.model"));
  EXPECT_EQ(folder.read("s.model"), "create a cube 1\nview grid on\nselect a\n");
  EXPECT_TRUE(interpreter.unsaved().empty());
  EXPECT_EQ(interpreter.script().size(), 3u);
  expect_refused("script sav x", "did you mean save?");
  expect_refused("script save", "it is script save FILE");
  expect_refused("script save glass.CSG", "the name of another kind of file; this is a .model");
  expect_refused("script save " + file(""), "is a folder");
  expect_refused("script save " + file("none/x"), "none");
  // What is being read is not overwritten, and what has been read by this command alone.
  interpreter.protect(folder / "s.model");
  expect_refused("script save " + file("s"), "is not overwritten");
  interpreter.release(folder / "s.model");
  EXPECT_THAT(say("script save " + file("s")).done, StartsWith("wrote "));
  expect_refused("save a " + file("s.model"), "is not overwritten");
  say("save a " + file("a.model"));
  expect_refused("script save " + file("a"), "is what a command of the script writes: save a");
}

TEST_F(Session, APointInAScriptsNameMakesNoSuffix) {
  say("create a cube 1");
  EXPECT_EQ(say("script save " + file("v1.2")).done, "wrote " + file("v1.2.model"));
  say("delete a");
  say("script load " + file("v1.2"));
  EXPECT_TRUE(has("a"));
}

// Every command that names a file asks where it is.
TEST_F(Session, FilesAreWhereTheOutletSaysTheyAre) {
  modeler::Outlet outlet;
  std::vector<std::string> asked;
  outlet.locate = [&](const std::string& named) {
    if (named.starts_with("/")) throw modeler::CommandError("out of reach");
    asked.push_back(named);
    return folder / named;
  };
  outlet.write_picture = [this](const std::filesystem::path& path, const Planes&) {
    written_to = path;
  };
  interpreter = modeler::Interpreter(outlet);
  say_all({"create a cube 1", "surface 1 ambient 0.5", "save a S.CSG", "camera save S.CAM",
           "light save S.LUZ", "surfaces save S.SUP", "script save S.model",
           "show a P.png --shaded --size 2x2 --scene S", "load b S.CSG", "camera load S.CAM",
           "light load S.LUZ", "surfaces load S.SUP", "delete a", "delete b"});
  say("script load S.model");
  EXPECT_EQ(written_to, folder / "P.png");
  EXPECT_THAT(folder.list(), testing::ElementsAre("S.CAM", "S.CSG", "S.LUZ", "S.SUP", "S.model"));
  EXPECT_GE(asked.size(), 12u);
  for (const char* line :
       {"save a /x", "load c /x", "camera save /x", "camera load /x", "light save /x",
        "light load /x", "surfaces save /x", "surfaces load /x", "script save /x", "script load /x",
        "show a /x.png", "show a P.png --scene /x"})
    expect_refused(line, "out of reach");
}

TEST_F(Session, AScriptIsDoneWhollyOrNotAtAll) {
  folder.write("part.model",
               "create part cube 1\nlist\ncamera turn 0.1 0\ncamera zoom 1\nquit\nnonsense\n");
  say_all({"create a sphere 1", "create gone sphere 1", "undo"});
  const modeler::Reply reply = say("script load " + file("part"));
  EXPECT_EQ(reply.text, "\"a\": sphere\n\"part\": cube\n");
  EXPECT_FALSE(reply.quit);
  EXPECT_THAT(interpreter.script(),
              ElementsAre("create a sphere 1", "create part cube 1", StartsWith("camera window ")));
  say("undo camera");  // one, as from a hand
  EXPECT_FALSE(interpreter.looks().camera);
  say("undo");
  EXPECT_FALSE(has("part"));
  folder.write("bad.model",
               "create b cube 1\nlight set\nselect b\nview grid on\ncamera zoom 1\ndelete c\n");
  expect_refused("script load " + file("bad.model"), "bad.model:6: there is no solid \"c\"");
  say("redo");  // what could be redone still can
  EXPECT_TRUE(has("part"));
  expect_refused("script load " + file("none"), "none.model: cannot be read");
  folder.write("self.model", "script load " + file("self") + "\n");
  expect_refused("script load " + file("self"), "self.model:1: \"");
  folder.write("over.model", "script save " + file("over") + "\n");
  expect_refused("script load " + file("over"), "is not overwritten");
  say("script save " + file("part"));  // which has been read
}

TEST_F(Session, TheListOfCommandsIsNoWiderThanAPage) {
  std::istringstream lines(say("help").text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 102u) << line;
}

TEST_F(Session, ACommandIsOneLine) { expect_refused("create a\ncube 1", "a command is one line"); }

}  // namespace
}  // namespace sir::test
