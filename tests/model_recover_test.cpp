// sir model at a terminal is killed, and what was done is there again.
#include <gmock/gmock.h>
#include <signal.h>

#include <random>

#include "tests/at_terminal.h"
#include "tests/cli_fixture.h"
#include "tests/modeler_player.h"

namespace sir::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class ModelRecover : public CliTest {
 protected:
  void SetUp() override {
    if (!terminals_exist()) GTEST_SKIP() << "no terminal to type at";
    ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
    ::setenv("TERM", "dumb", 1);  // plain lines
  }

  /// Types a line and waits until it and all before it are done.
  void finish_with(AtTerminal& terminal, const std::string& line) {
    const std::string mark = "mark" + std::to_string(marks_++);
    terminal.type(line + "\n" + mark + "\n");
    ASSERT_TRUE(terminal.wait_for("there is no command \"" + mark + "\"")) << terminal.shown();
  }

  std::vector<std::string> journals() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "state/sir"))
      if (entry.path().extension() == ".journal") names.push_back(entry.path().stem());
    return names;
  }

  static std::string text_of(const modeler::Interpreter& session) {
    std::string text;
    for (const std::string& line : session.script()) text += line + "\n";
    return text;
  }

 private:
  int marks_ = 0;
};

TEST_F(ModelRecover, WhatWasDoneBeforeItWasKilledIsThereAgain) {
  std::filesystem::create_directory(folder / "made");
  for (std::uint64_t seed = 100; seed < 108; ++seed) {
    std::mt19937_64 random(seed);
    modeler::Outlet outlet;
    outlet.write_picture = [](const std::filesystem::path&, const Planes&) {};
    modeler::Interpreter uninterrupted(outlet);
    Player player(seed, (folder / "made").string());
    const std::size_t sure = 1 + random() % 30, commands = sure + random() % 12;
    // The command that made it so is the last: it is one that stays in the journal.
    std::vector<std::string> lines, scripts{text_of(uninterrupted)};
    while (lines.size() < commands) {
      const std::string line = player.draw(uninterrupted);
      try {
        uninterrupted.execute(line);
      } catch (const std::exception&) {
        continue;
      }
      lines.push_back(line);
      scripts.push_back(text_of(uninterrupted));
    }
    {
      AtTerminal terminal({"model"}, folder.path(), 80);
      ASSERT_TRUE(terminal.wait_for("sir> "));
      for (std::size_t i = 0; i < sure; ++i) finish_with(terminal, lines[i]);
      std::string rest;
      for (std::size_t i = sure; i < commands; ++i) rest += lines[i] + "\n";
      terminal.type(rest);  // in the midst of which it dies
      terminal.signal(SIGKILL);
      EXPECT_EQ(terminal.finish(), 128 + SIGKILL);
    }
    if (journals().empty()) {
      EXPECT_EQ(scripts[sure], "") << seed;  // it was but asked
      continue;
    }
    const bool at_once = random() % 2 == 0;
    AtTerminal terminal(at_once ? std::vector<std::string>{"model", "--recover"}
                                : std::vector<std::string>{"model"},
                        folder.path(), 80);
    if (!at_once) {
      ASSERT_TRUE(terminal.wait_for("1 session can be recovered; the last: in "));
      terminal.type("recover\n");
    }
    ASSERT_TRUE(terminal.wait_for("recovered: ")) << terminal.shown();
    finish_with(terminal, "script save " + (folder / "again").string());
    const std::string again = folder.read("again.model");
    const std::vector<std::string> possible(scripts.begin() + static_cast<std::ptrdiff_t>(sure),
                                            scripts.end());
    EXPECT_THAT(possible, Contains(again)) << seed;
    EXPECT_THAT(terminal.shown(), Not(HasSubstr("warning"))) << seed;
    terminal.type("quit\n");
    EXPECT_EQ(terminal.finish(), 0);
    EXPECT_TRUE(journals().empty()) << seed;  // it was saved
  }
}

TEST_F(ModelRecover, WhoeverHangsUpFindsItAgain) {
  for (const int signal : {SIGHUP, SIGTERM}) {
    {
      AtTerminal terminal({"model"}, folder.path(), 80);
      ASSERT_TRUE(terminal.wait_for("sir> "));
      finish_with(terminal, "create bola sphere 1");
      terminal.signal(signal);
      EXPECT_NE(terminal.finish(), 0);
    }
    const std::vector<std::string> names = journals();
    ASSERT_EQ(names.size(), 1u);
    AtTerminal terminal({"model", "--recover", names[0]}, folder.path(), 80);
    ASSERT_TRUE(terminal.wait_for("recovered: 1 command of "));
    finish_with(terminal, "list");
    EXPECT_THAT(terminal.shown(), HasSubstr("\"bola\": sphere"));
    finish_with(terminal, "quit");
    terminal.type("undo\nquit\n");
    EXPECT_EQ(terminal.finish(), 0);
    EXPECT_TRUE(journals().empty());
  }
}

TEST_F(ModelRecover, WhoeverLeavesWithSomethingUnsavedIsToldWhereItIs) {
  {
    AtTerminal terminal({"model"}, folder.path(), 80);
    ASSERT_TRUE(terminal.wait_for("sir> "));
    terminal.type("create bola sphere 1\nquit\nquit\n");
    EXPECT_EQ(terminal.finish(), 0);
    ASSERT_EQ(journals().size(), 1u);
    EXPECT_THAT(terminal.shown(), HasSubstr("not all was saved; " + journals()[0] + " is kept"));
  }
  AtTerminal terminal({"model"}, folder.path(), 80);
  ASSERT_TRUE(terminal.wait_for("sir> "));
  terminal.type("recover --discard\nquit\n");
  EXPECT_EQ(terminal.finish(), 0);
  EXPECT_TRUE(journals().empty());
}

TEST_F(ModelRecover, OnlyAPersonsSessionIsKept) {
  EXPECT_EQ(sir_reading("create a cube 1\n", {"model"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "state"));
  expect_failure(sir_reading("", {"model", "--recover"}), "a session goes on at a terminal");
  expect_failure(sir_reading("recover\n", {"model"}), "-:1: only at the prompt and in the window");
  AtTerminal terminal({"model", "--recover"}, folder.path(), 80);
  EXPECT_EQ(terminal.finish(), 1);
  EXPECT_THAT(terminal.shown(), HasSubstr("sir: --recover: there is no session to recover"));
}

}  // namespace
}  // namespace sir::test
