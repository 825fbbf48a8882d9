// Journals that are torn, foreign, full, or cannot be written at all.
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "modeler/playback.h"
#include "tests/keeper_fixture.h"
#include "tracer/error.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using TornSessions = KeeperTest;

// Wherever the last write stopped, all that was whole before it is there.
TEST_F(TornSessions, AtAnyByteNothingIsLostThatWasWhole) {
  folder.write("s.LUZ", "0 0 .2\n.1\n1\n5 6 7 1\n");
  std::vector<std::string> states{all_of(interpreter)};
  std::vector<std::uintmax_t> sizes;
  std::filesystem::path path;
  (void)interpreter.camera();
  for (const std::string& line :
       {std::string("create a cube 1"), std::string("create \"do 1 - b\" sphere 2"),
        std::string("camera turn 0.1 0"), "light load " + file("s"), std::string("undo"),
        std::string("redo"), "script save " + file("out"), std::string("view grid on")}) {
    say(line);
    states.push_back(all_of(interpreter));
    path = std::filesystem::directory_iterator(journals())->path();
    sizes.push_back(std::filesystem::file_size(path));
  }
  begin();
  const std::string whole = journal();
  ASSERT_EQ(whole.size(), sizes.back());
  const std::size_t head = modeler::read_journal("j", whole.substr(0, sizes.front() - 1)).whole;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const std::string text = whole.substr(0, size);
    if (size < head) {
      EXPECT_THROW(modeler::read_journal("j", text), FileError) << size;
      continue;
    }
    const modeler::Journal journal = modeler::read_journal("j", text);
    std::size_t commands = 0;
    while (commands < sizes.size() && sizes[commands] <= size) ++commands;
    ASSERT_EQ(journal.entries.size(), commands) << size;
    ASSERT_EQ(journal.whole, commands == 0 ? head : sizes[commands - 1]) << size;
    modeler::Interpreter again(outlet());
    EXPECT_THAT(modeler::play_back("j", journal, again).failed, IsEmpty());
    ASSERT_EQ(all_of(again), states[commands]) << size;
  }
  // The whole way, from a torn file on.
  std::filesystem::resize_file(path, sizes[2] + 7);
  const modeler::Reply reply = say("recover");
  EXPECT_THAT(reply.warnings,
              ElementsAre(HasSubstr("its last 7 bytes are no whole command and are left out")));
  EXPECT_EQ(all_of(interpreter), states[3]);
  say("delete a");
  const std::string all = all_of(interpreter);
  begin();
  EXPECT_THAT(say("recover").warnings, IsEmpty());
  EXPECT_EQ(all_of(interpreter), all);
}

TEST_F(TornSessions, WhatIsRefusedIsToldAndTheRestIsThere) {
  std::filesystem::create_directory(journals());
  const auto head = modeler::journal_text({"2026-11-22 21:50:07", "/nowhere", "images/calice"});
  folder.write("state/session-1.journal", head +
                                              "do 1 - create a cube 1\n"
                                              "do 2 - frobnicate a\n"
                                              "do 3 - create b cube 1\n"
                                              "do 4 - delete c\n"
                                              "do 3 - undo\n"  // of what was refused: nothing
                                              "do 2 - undo\n"  // of b
                                              "do 3 - redo\n"  // of b
                                              "do 4 - redo\n"  // of what was refused
                                              "do 5 - load d nothing\n"
                                              "do 6 - create e cube 1\n");
  EXPECT_THAT(keeper->offer(), HasSubstr("the last: images/calice in /nowhere, "));
  const modeler::Reply reply = say("recover");
  EXPECT_THAT(reply.warnings,
              ElementsAre(HasSubstr("session-1.journal:8: there is no command \"frobnicate\""),
                          HasSubstr("session-1.journal:10: there is no solid \"c\""),
                          HasSubstr("session-1.journal:15: what it read has not been kept")));
  EXPECT_THAT(reply.text, HasSubstr("the session worked in /nowhere"));
  EXPECT_THAT(interpreter.script(),
              ElementsAre("create a cube 1", "create b cube 1", "create e cube 1"));
  // Once more, when it has gone on.
  for (const char* line : {"create f cube 1", "create g cube 1", "create h cube 1", "undo"})
    say(line);
  const std::string all = all_of(interpreter);
  begin();
  EXPECT_THAT(say("recover").warnings, SizeIs(3));
  EXPECT_EQ(all_of(interpreter), all);
  say("redo");
  EXPECT_TRUE(has("h"));
}

// Nor does its undo, when the session goes on, take back another's.
TEST_F(TornSessions, AnUndoOfWhatWasRefusedTakesBackNothing) {
  std::filesystem::create_directory(journals());
  const auto head = modeler::journal_text({"2026-11-22 21:50:07", folder.path().string(), ""});
  folder.write("state/session-1.journal", head +
                                              "do 1 - create a cube 1\n"
                                              "do 2 - delete c\n"
                                              "do 1 - undo\n"
                                              "do 2 - delete d\n");
  EXPECT_THAT(say("recover").warnings, SizeIs(2));
  EXPECT_THAT(interpreter.script(), ElementsAre("create a cube 1"));
  for (const char* line : {"create f cube 1", "undo"}) say(line);
  begin();
  say("recover");
  EXPECT_THAT(interpreter.script(), ElementsAre("create a cube 1"));
  EXPECT_EQ(interpreter.undoable(), 1u);
}

TEST_F(TornSessions, WhatIsNoJournalIsLeftAlone) {
  std::filesystem::create_directory(journals());
  folder.write("state/other.journal", "something else\n");
  folder.write("state/later.journal", "sir journal 2\n");
  folder.write("notes", "mine");
  expect_refused("recover other", "other.journal:1: this is no journal");
  expect_refused("recover later", "a journal of version \"2\"; this program reads version 1");
  expect_refused("recover --discard " + file("notes"), "no journal");
  expect_refused("recover none", "\"none\" is not there, or still goes on");
  expect_refused("recover --lsit", "is no option of recover");
  expect_refused("recover a b", "it is recover");
  EXPECT_TRUE(folder.has("notes"));
  EXPECT_THAT(say("recover --list").text, HasSubstr("other: other.journal:1: this is no journal"));
}

// As where there is no home: said once, and all goes on.
TEST_F(TornSessions, AFolderThatCannotBeMadeIsNoReasonToStop) {
  folder.write("state", "a file");
  EXPECT_THAT(say("create a cube 1").warnings, ElementsAre(HasSubstr("could be recovered")));
  EXPECT_THAT(say("create b cube 1").warnings, IsEmpty());
  EXPECT_EQ(interpreter.undoable(), 2u);
  EXPECT_EQ(keeper->end(), "");
  keeper.reset();
  keeper = std::make_unique<modeler::Keeper>(interpreter, "");
  EXPECT_THAT(say("create c cube 1").warnings, ElementsAre(HasSubstr("XDG_STATE_HOME")));
}

TEST_F(TornSessions, AFullDiskLeavesWhatWasWhole) {
  say("create a cube 1");
  const auto path = std::filesystem::directory_iterator(journals())->path();
  std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const struct rlimit little { std::filesystem::file_size(path) + 5, before.rlim_max };
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
  const auto first = say("create b cube 1").warnings, second = say("create c cube 1").warnings;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_THAT(first, ElementsAre(HasSubstr("cannot be written: File too large; from here on")));
  EXPECT_THAT(second, IsEmpty());
  EXPECT_TRUE(has("c"));
  begin();
  EXPECT_THAT(say("recover").warnings, IsEmpty());
  EXPECT_THAT(interpreter.script(), ElementsAre("create a cube 1"));
}

TEST_F(TornSessions, OnlyWhereAPersonWorksIsThereSomethingToRecover) {
  keeper.reset();
  expect_refused("recover", "only at the prompt and in the window");
}

}  // namespace
}  // namespace sir::test
