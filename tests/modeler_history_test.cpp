// Undo, redo, memory, and trees of any depth.
#include <random>

#include "modeler/operations.h"
#include "tests/cases.h"
#include "tests/modeler_fixture.h"

namespace sir::test {
namespace {

using testing::ElementsAre;

class HistoryTest : public ModelerTest {
 protected:
  // A command out of all that change the list, with names that are mostly there.
  std::string draw(std::mt19937_64& random) {
    const auto& entries = interpreter.solids().entries();
    const auto any = [&] {
      if (entries.empty() || random() % 16 == 0) return std::string("nothing");
      auto at = entries.begin();
      std::advance(at, static_cast<std::ptrdiff_t>(random() % entries.size()));
      return "\"" + at->second->name + "\"";
    };
    const auto number = [&] { return std::to_string(static_cast<int>(random() % 9) - 4); };
    const std::string fresh = "s" + std::to_string(random() % 30);
    const char* const kinds[] = {"cube 1", "sphere 2", "cone 1 3", "cylinder 4"};
    const char* const operations[] = {" union ", " difference ", " intersection "};
    switch (random() % 12) {
      case 0:
      case 1:
      case 2: return "create " + fresh + " " + kinds[random() % 4];
      case 3: return "translate " + any() + " " + number() + " 0.3 " + number();
      case 4: return "scale " + any() + " " + number() + " 1.5 " + number();
      case 5: return "rotate " + any() + " y " + number() + "5";
      case 6:
      case 7: return "combine " + fresh + " " + any() + operations[random() % 3] + any();
      case 8: return "copy " + any() + " " + fresh;
      case 9: return "split " + any();
      case 10: return random() % 2 == 0 ? "delete " + any() : "rename " + any() + " " + fresh;
      default: return random() % 2 == 0 ? "label " + any() + " x" : "number " + any() + " 5";
    }
  }
};

TEST_F(HistoryTest, UndoAndRedoGoThroughEveryStateBitForBit) {
  for (std::uint64_t seed = 0; seed < cases(20); ++seed) {
    std::mt19937_64 random(seed);
    interpreter = modeler::Interpreter();
    std::vector<std::string> states{state_of(interpreter)};
    int refused = 0;
    while (states.size() < 200) {
      const std::string command = draw(random);
      try {
        say(command);
        states.push_back(state_of(interpreter));
      } catch (const modeler::CommandError&) {
        ++refused;
        ASSERT_EQ(state_of(interpreter), states.back()) << command;
      }
    }
    EXPECT_GT(refused, 0);
    for (std::size_t i = states.size() - 1; i-- > 0;) {
      say("undo");
      ASSERT_EQ(state_of(interpreter), states[i]) << seed << " " << i;
    }
    expect_refused("undo", "there is nothing to undo");
    for (std::size_t i = 1; i < states.size(); ++i) {
      say("redo");
      ASSERT_EQ(state_of(interpreter), states[i]) << seed << " " << i;
    }
    expect_refused("redo", "there is nothing to redo");
    // The commands in force, done anew, make the same.
    modeler::Interpreter again;
    for (const std::string& command : interpreter.script()) again.execute(command);
    EXPECT_EQ(state_of(again), states.back());
  }
}

TEST_F(HistoryTest, ACommandAfterUndoEndsWhatCouldBeRedone) {
  say_all({"create a cube 1", "create b cube 1", "undo", "undo", "create c cube 1  # instead"});
  expect_refused("redo", "there is nothing to redo");
  EXPECT_THAT(interpreter.script(), ElementsAre("create c cube 1"));
}

TEST_F(HistoryTest, OnlyWhatChangesTheListIsUndone) {
  say_all({"create a cube 1", "list", "inspect a bounds", "help", "undo"});
  EXPECT_FALSE(has("a"));
}

TEST_F(HistoryTest, ManyTransformsOfACompositeAreUndoneExactly) {
  say_all({"create a cube 1", "create b sphere 1", "combine c a union b"});
  std::vector<std::string> states;
  for (int i = 0; i < 3 * modeler::Solid::kMostSteps; ++i) {
    states.push_back(state_of(interpreter));
    say(i % 3 == 0 ? "rotate c y 7" : i % 3 == 1 ? "scale c 1.01 1 0.99" : "translate c 0.1 0 0");
  }
  const std::string last = state_of(interpreter);
  // Without a look in between, too.
  for (int i = 0; i < 100; ++i) say("undo");
  EXPECT_EQ(state_of(interpreter), states[states.size() - 100]);
  for (int i = 0; i < 100; ++i) say("redo");
  EXPECT_EQ(state_of(interpreter), last);
  while (!states.empty()) {
    say("undo");
    ASSERT_EQ(state_of(interpreter), states.back()) << states.size();
    states.pop_back();
  }
}

// A hundred transforms of a thousand nodes do not keep a hundred trees.
TEST_F(HistoryTest, TreesThatCanBeWorkedOutAgainAreNotKept) {
  say_all({"create a cube 1", "create b cube 1", "combine c a union b"});
  std::vector<std::weak_ptr<const modeler::Node>> trees;
  for (int i = 0; i < 100; ++i) {
    say("translate c 1 0 0");
    trees.push_back(interpreter.solids().find("c")->solid.tree());
  }
  const auto alive =
      std::count_if(trees.begin(), trees.end(), [](const auto& tree) { return !tree.expired(); });
  EXPECT_LE(alive, 3);
}

TEST_F(HistoryTest, DeletedSolidsAreFreedWithTheirLastUse) {
  say_all({"create a cube 1", "create b cube 1", "combine c a union b", "copy c d"});
  std::vector<std::weak_ptr<const modeler::Node>> nodes;
  const auto& composite = *solid("c").composite();
  nodes.emplace_back(interpreter.solids().find("c")->solid.tree());
  nodes.emplace_back(composite.left);
  nodes.emplace_back(composite.right);
  say("delete c");
  EXPECT_FALSE(nodes[0].expired());  // it can come back
  interpreter = modeler::Interpreter();
  for (const auto& node : nodes) EXPECT_TRUE(node.expired());

  // What can no longer be redone is freed at once.
  say("create a cube 1");
  const std::weak_ptr<const modeler::Node> a = interpreter.solids().find("a")->solid.tree();
  say("undo");
  EXPECT_FALSE(a.expired());
  say("create b cube 1");
  EXPECT_TRUE(a.expired());
}

TEST_F(HistoryTest, ForgettingFreesWhatUndoCouldBringBackAndKeepsTheScript) {
  say_all({"create a cube 1", "create b cube 1", "light add 1 2 3 1", "delete a"});
  say_all({"create c cube 1", "undo"});
  const std::weak_ptr<const modeler::Node> b = interpreter.solids().find("b")->solid.tree();
  say("delete b");
  say_all({"undo", "redo"});
  EXPECT_FALSE(b.expired());
  const std::string before = state_of(interpreter);
  const auto script = interpreter.script();
  say("forget");
  EXPECT_TRUE(b.expired());
  EXPECT_EQ(state_of(interpreter), before);
  EXPECT_EQ(interpreter.script(), script);
  expect_refused("undo", "nothing to undo");
  expect_refused("redo", "nothing to redo");
  say_all({"create d cube 1", "forget", "create e cube 1", "undo"});
  EXPECT_TRUE(has("d"));
  expect_refused("undo", "nothing to undo");
}

TEST_F(HistoryTest, ChainsOfAnyDepth) {
  constexpr int kDepth = 100'000;
  say("create s cube 1");
  for (int i = 0; i < kDepth; ++i) {
    const std::string n = std::to_string(i);
    say("create p" + n + " sphere 1");
    if (i % 2 == 0)
      say("combine c" + n + " " + (i == 0 ? "s" : "c" + std::to_string(i - 1)) + " union p" + n);
    else say("combine c" + n + " p" + n + " union c" + std::to_string(i - 1));
  }
  const std::string last = "c" + std::to_string(kDepth - 1);
  EXPECT_EQ(solid(last).count, 2u * kDepth + 1);
  const std::string file = (folder / "deep").string();
  say("save " + last + " " + file);
  say("rotate " + last + " y 90");
  say("copy " + last + " copy");
  say("delete " + last);
  EXPECT_THAT(say("inspect copy tree").text, testing::HasSubstr("nodes below"));
  say("load again " + file);
  EXPECT_EQ(solid("again").count, 2u * kDepth + 1);
  interpreter = modeler::Interpreter();
}

}  // namespace
}  // namespace sir::test
