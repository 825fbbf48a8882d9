// sir model from outside: scripts, standard input, --from, the prompt.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include "tests/at_terminal.h"
#include "tests/cli_fixture.h"
#include "tests/eventually.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ModelCli : public CliTest {
 protected:
  void SetUp() override { ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1); }
};

TEST_F(ModelCli, AScriptBuildsAndSaves) {
  folder.write("bola.model",
               "# uma bola\ncria bola esfera 1\r\n\ncreate furo cylinder 2\nscale furo 0.5 4 0.5\n"
               "translate furo 0 -2 0\ncombine \"bola furada\" bola difference furo\n"
               "save \"bola furada\" bola\nshow \"bola furada\" bola.png --size 64x48\nlist\n");
  const Ended ended = sir({"model", "bola.model"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "\"bola furada\": difference of \"bola\" and \"furo\", 3 nodes\n");
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(viewer::read_png(folder / "bola.png").size, (ImageSize{64, 48}));
  for (const char* suffix : {".CAM", ".LUZ", ".SUP"})
    folder.write(std::string("bola") + suffix, folder.read(std::string("s") + suffix));
  EXPECT_EQ(sir({"check", "bola"}).exit_code, 0);
}

TEST_F(ModelCli, AnErrorNamesTheScriptAndTheLineAndExitsWithOne) {
  folder.write("a.model", "create a cube 1\n\ncreate a cube 1\nsave a a\n");
  expect_failure(sir({"model", "a.model"}), "a.model:3: a solid \"a\" exists already");
  EXPECT_FALSE(folder.has("a.CSG"));
  expect_failure(sir({"model", "none.model"}), "none.model: cannot be read");
  expect_failure(sir_reading("create a cube 1\ndelete b\n", {"model"}),
                 "-:2: there is no solid \"b\"");
  expect_failure(sir_reading("load a s\nload b x\n", {"model", "-"}), "-:2: x.CSG: is missing");
  folder.write("self.model", "create a cube 1\nsave a self.model\n");
  expect_failure(sir({"model", "self.model"}), "self.model:2: self.model");
  EXPECT_THAT(folder.read("self.model"), HasSubstr("create a cube 1"));
}

TEST_F(ModelCli, TheScriptThatStandardInputComesFromIsNotOverwritten) {
  folder.write("in.model", "create a cube 1\nsave a in.model\n");
  Start start;
  start.in_file = "in.model";
  expect_failure(sir({"model"}, start), "-:2: in.model: is an input");
  EXPECT_THAT(folder.read("in.model"), HasSubstr("create a cube 1\nsave"));
}

TEST_F(ModelCli, LooksAreSaidInScriptsToo) {
  folder.write("a.model",
               "create a cube 1\ncamera target 0.5 0.5 0.5 distance 4\n"
               "light set ambient 0.25 add 5 5 5 1\nsurface 1 colour 0.75 0.5 0.25\n"
               "camera save a\nlight save a\nsurfaces save a\nsave a a\n"
               "show a shown --shaded --size 32x24\nselect a 0 2\nscript save again\nscript\n");
  const Ended ended = sir({"model", "a.model"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, folder.read("again.model"));
  EXPECT_EQ(sir({"render", "a", "--size", "32x24"}).exit_code, 0);
  EXPECT_EQ(folder.read("a.png"), folder.read("shown.png"));
  const Ended again = sir_reading(folder.read("again.model") + "script\n", {"model"});
  EXPECT_EQ(again.out, folder.read("again.model")) << again.err;
  folder.write("b.model", "create a cube 1\nlight move 2 0 0 0\n");
  expect_failure(sir({"model", "b.model"}), "b.model:2: there is no light 2");
  folder.write("c.model", "create a cube 1\nscript save c\n");
  expect_failure(sir({"model", "c.model"}), "c.model:2: c.model: is an input");
}

TEST_F(ModelCli, AWindowNeedsADisplay) {
  for (const char* name : {"SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(name);
  // A library of the desktop would complain of its own.
  ::setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  folder.write("a.model", "create a cube 1\n");
  expect_failure(sir({"model", "--window", "a.model"}), "window: ");
  expect_failure(sir({"model", "--window"}), "window: ");
#ifdef SIR_WITH_IMGUI
  expect_failure(sir({"model", "--window"}), "without --window");
  expect_failure(sir({"model", "--window", "-"}), "from a file");
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  expect_failure(sir({"model", "--window", "--from", "none"}), "none.CSG: is missing");
  folder.write("b.model", "create a cube 1\ncreate a cube 1\n");
  expect_failure(sir({"model", "--window", "b.model"}), "b.model:2: ");
  folder.write("c.model", "create a cube 1\nsave a a\nquit\n");
  const Ended ended = sir({"model", "--window", "c.model"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(folder.has("a.CSG"));
  ::unsetenv("SDL_VIDEODRIVER");
#endif
}

TEST_F(ModelCli, StandardInputIsAScript) {
  const Ended ended = sir_reading("create a cube 1\nlist\nquit\nnonsense\n", {"model"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "\"a\": cube\n");
  EXPECT_EQ(sir_reading("lista", {"model", "-"}).out, "the list of solids is empty\n");
  const Ended latin = sir_reading("create Ma\xE7\xE3 cube 1\nlist\n", {"model"});
  EXPECT_EQ(latin.out, "\"Maçã\": cube\n");
}

TEST_F(ModelCli, WhoAsksLineByLineIsAnsweredLineByLine) {
  Start start;
  start.in = "create a cube 1\nlist\n";
  start.folder = folder.path();
  start.keep_in_open = true;
  Program program(SIR_PROGRAM, {"model"}, start);
  EXPECT_TRUE(program.wait_for("\"a\": cube\n"));
  EXPECT_EQ(program.finish().exit_code, 0);
}

TEST_F(ModelCli, FromGivesTheScriptThatMakesTheFile) {
  for (const char* name : {"s", "s.CSG", "./s"}) {
    const Ended ended = sir({"model", "--from", name});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_THAT(ended.out, HasSubstr("create caixa cube 1\n"));
    EXPECT_THAT(ended.out, HasSubstr("number tudo 0\n"));  // the file counts from 0
    EXPECT_THAT(ended.out, HasSubstr("\nsave tudo s.CSG\n"));
  }
  folder.write("s.model", sir({"model", "--from", "s"}).out);
  const std::string probe = "0.9 0.9 5 0 0 -1\n0.2 0.2 5 0 0 -1\n";
  const std::string before = sir_reading(probe, {"probe", "s"}).out;
  EXPECT_EQ(sir({"model", "s.model"}).exit_code, 0);
  EXPECT_EQ(sir_reading(probe, {"probe", "s"}).out, before);
  // What has been written by us comes back byte for byte.
  const std::string bytes = folder.read("s.CSG");
  folder.write("again.model", sir({"model", "--from", "s"}).out);
  EXPECT_EQ(sir({"model", "again.model"}).exit_code, 0);
  EXPECT_EQ(folder.read("s.CSG"), bytes);
  expect_failure(sir({"model", "--from", "none"}), "none.CSG: is missing");
  EXPECT_EQ(sir({"model", "--from", "s", "s.model"}).exit_code, 2);
}

TEST_F(ModelCli, AHundredThousandCommands) {
  std::string script = "create p0 cube 1\n";
  for (int i = 1; i < 33'333; ++i) {
    const std::string n = std::to_string(i), last = i == 1 ? "p0" : "c" + std::to_string(i - 1);
    script += "create p" + n + " sphere 1\ntranslate p" + n + " " + n + " 0 0\ncombine c" + n +
              " " + last + " union p" + n + "\n";
  }
  folder.write("long.model", script + "rotate c33332 y 90\nsave c33332 long\n");
  const Ended ended = sir({"model", "long.model"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(folder.read("long.CSG").starts_with("66665\n"));
  EXPECT_LT(ended.peak_kilobytes, 1'000'000);
}

TEST_F(ModelCli, AFullDiskAndAClosedPipeAreFailures) {
  Start start;
  start.in = "list\n";
  ASSERT_TRUE(std::filesystem::is_character_file("/dev/full"));  // else it proves nothing
  start.out_file = "/dev/full";
  expect_failure(sir({"model"}, start), "standard output: cannot be written");
  expect_failure(sir_reading("create a cube 1\nsave a /dev/full\n", {"model"}), "/dev/full");
  expect_failure(sir_reading("create a cube 1\nshow a /dev/full\n", {"model"}), "/dev/full");
}

// No suffix is put behind the name of a device or a pipe, whoever may make files beside it.
TEST_F(ModelCli, ADeviceHasItsNameAlready) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  // Both ends, so that nobody waits for the other.
  const int pipe = ::open((folder / "pipe").c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(pipe, 0);
  const Ended ended =
      sir_reading("create a cube 1\nsave a pipe\nsave a /dev/null\nsave a file\n", {"model"});
  std::string bytes(4096, '\0');
  const ssize_t got = ::read(pipe, bytes.data(), bytes.size());
  ::close(pipe);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  ASSERT_GT(got, 0);
  bytes.resize(static_cast<std::size_t>(got));
  EXPECT_EQ(bytes, folder.read("file.CSG"));
  EXPECT_FALSE(folder.has("pipe.CSG"));
}

class ModelPrompt : public CliTest {
 protected:
  void SetUp() override {
    if (!terminals_exist()) GTEST_SKIP() << "no terminal to type at";
    ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
    ::setenv("TERM", "xterm", 1);
  }

  /// Waits until lines can be edited, which is a moment after the prompt is there.
  static void wait_for_editor(const AtTerminal& terminal) {
#ifdef SIR_WITH_EDIT
    ASSERT_TRUE(eventually([&] { return (terminal.modes().c_lflag & ICANON) == 0; }));
#else
    (void)terminal;
#endif
  }

  /// Types a line and waits for what it says, and for the next prompt.
  static void answer(AtTerminal& terminal, const std::string& keys, const std::string& said) {
    terminal.type(keys);
    ASSERT_TRUE(terminal.wait_for(said + "\r\nsir> ")) << terminal.shown();
    if (std::string(::getenv("TERM")) != "dumb") wait_for_editor(terminal);
  }
};

TEST_F(ModelPrompt, SaysWhatIsWrongAndGoesOn) {
  AtTerminal terminal({"model"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  wait_for_editor(terminal);
  answer(terminal, "create bola sphere 1\r", "bola: sphere");
  answer(terminal, "delete bloa\r", "did you mean \"bola\"?");
  answer(terminal, "load x nada\r", "nada.CSG: is missing (looked for nada.CSG and nada.csg)");
  answer(terminal, "save bola bola\r", "wrote bola.CSG (1 node)");
  terminal.type("quit\r");
  EXPECT_EQ(terminal.finish(), 0);
  EXPECT_TRUE(folder.read("bola.CSG").starts_with("1\n"));
}

TEST_F(ModelPrompt, WarnsOnceOfWhatIsNotSaved) {
  AtTerminal terminal({"model"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  wait_for_editor(terminal);
  answer(terminal, "create bola sphere 1\r", "bola: sphere");
  answer(terminal, "\x04",
         "not saved: \"bola\"; quit again to leave");  // the end of input is a quit
  terminal.type("quit\r");
  EXPECT_EQ(terminal.finish(), 0);
}

#ifdef SIR_WITH_EDIT
// Half a character, as a terminal that is not in UTF-8 sends it.
TEST_F(ModelPrompt, WhatIsNoCharacterTakesNoOtherWithIt) {
  AtTerminal terminal({"model"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  wait_for_editor(terminal);
  answer(terminal, "create C\xE1lice sphere 1\r", "\nClice: sphere");
  answer(terminal, "delete Clice\xE1\r", "\nClice: deleted");  // nor the end of the line
  terminal.type("quit\r");
  EXPECT_EQ(terminal.finish(), 0);
}

TEST_F(ModelPrompt, CompletesAndRemembers) {
  {
    AtTerminal terminal({"model"}, folder.path(), 80);
    ASSERT_TRUE(terminal.wait_for("sir> "));
    wait_for_editor(terminal);
    answer(terminal, "cre\t\"Cálice um\" cu\t1\r", "Cálice um: cube");
    answer(terminal, "inspect ca\tvol\t\r", "volume 1, give or take 1e-06 (12288 rays)");
    answer(terminal, "create x\x03list\r", "\"Cálice um\": cube");  // Ctrl-C empties the line
    answer(terminal, "delete ca\t\r", "Cálice um: deleted");
    terminal.type("quit\r");
    EXPECT_EQ(terminal.finish(), 0);
    EXPECT_THAT(terminal.shown(), Not(HasSubstr("exists already")));
  }
  EXPECT_TRUE(folder.has("state/sir/history"));
  AtTerminal terminal({"model"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  wait_for_editor(terminal);
  for (int i = 0; i < 5; ++i) terminal.type("\x1b[A");  // five lines back
  answer(terminal, "\r", "Cálice um: cube");
  answer(terminal, "quit\r", "not saved: \"Cálice um\"; quit again to leave");
  terminal.type("quit\r");
  EXPECT_EQ(terminal.finish(), 0);
}

TEST_F(ModelPrompt, ItsHistoryIsReplacedAsAWholeAndIsItsOwnersAlone) {
  std::string first;
  for (const char* line : {"list\r", "help\r"}) {
    AtTerminal terminal({"model"}, folder.path(), 80);
    ASSERT_TRUE(terminal.wait_for("sir> "));
    wait_for_editor(terminal);
    terminal.type(line);
    terminal.type("quit\r");
    EXPECT_EQ(terminal.finish(), 0);
    if (!first.empty()) continue;
    first = folder.read("state/sir/history");
    std::filesystem::create_hard_link(folder / "state/sir/history", folder / "before");
  }
  EXPECT_EQ(folder.read("before"), first);
  EXPECT_THAT(folder.read("state/sir/history"), HasSubstr("help"));
  EXPECT_EQ(std::filesystem::status(folder / "state/sir/history").permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}
#endif

TEST_F(ModelPrompt, ADumbTerminalGetsPlainLines) {
  ::setenv("TERM", "dumb", 1);
  AtTerminal terminal({"model", "-q"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  answer(terminal, "list\n", "the list of solids is empty");
  terminal.type("\x04");
  EXPECT_EQ(terminal.finish(), 0);
  EXPECT_EQ(terminal.shown(), "sir> list\nthe list of solids is empty\nsir> \n");
}

TEST_F(ModelPrompt, ASignalEndsIt) {
  AtTerminal terminal({"model"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  terminal.signal(SIGTERM);
  EXPECT_EQ(terminal.finish(), 130);
}

}  // namespace
}  // namespace sir::test
