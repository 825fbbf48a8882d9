// The trees of composition as rows of a list.
#include "viewer/tree_rows.h"

#include <gmock/gmock.h>

#include "modeler/interpreter.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class TreeRowsTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* line :
         {"create a sphere 1", "create b sphere 1", "create Cálice sphere 1", "create d sphere 1",
          "combine ab a union b", "combine abc ab union Cálice", "rename abc Todo"})
      interpreter_.execute(line);
  }
  std::vector<std::string> shown(const std::string& filter = "") {
    std::vector<std::string> text;
    for (const TreeRow& row : rows_.rows(interpreter_.solids(), filter))
      text.push_back(std::string(row.depth, ' ') + row.node->name + " " +
                     std::to_string(row.place) + (row.open ? " open" : ""));
    return text;
  }

  modeler::Interpreter interpreter_;
  TreeRows rows_;
};

TEST_F(TreeRowsTest, OnlyWhatIsOpenHasItsPartsShown) {
  EXPECT_THAT(shown(), ElementsAre("d 0", "Todo 0"));
  rows_.set_open("Todo", 0, true);
  EXPECT_THAT(shown(), ElementsAre("d 0", "Todo 0 open", " ab 1", " Cálice 4"));
  rows_.set_open("Todo", 1, true);
  rows_.set_open("d", 0, true);  // has no parts
  EXPECT_THAT(shown(),
              ElementsAre("d 0", "Todo 0 open", " ab 1 open", "  a 2", "  b 3", " Cálice 4"));
  rows_.set_open("Todo", 0, false);
  EXPECT_THAT(shown(), ElementsAre("d 0", "Todo 0"));
}

TEST_F(TreeRowsTest, RevealOpensWhatANodeIsPartOf) {
  rows_.reveal(interpreter_.solids(), "Todo", 4);
  EXPECT_THAT(shown(), ElementsAre("d 0", "Todo 0 open", " ab 1", " Cálice 4"));
  rows_.reveal(interpreter_.solids(), "Todo", 3);
  EXPECT_THAT(shown(),
              ElementsAre("d 0", "Todo 0 open", " ab 1 open", "  a 2", "  b 3", " Cálice 4"));
  rows_.reveal(interpreter_.solids(), "none", 0);
  rows_.reveal(interpreter_.solids(), "Todo", 99);
}

TEST_F(TreeRowsTest, AFilterFindsNamesAnywhere) {
  EXPECT_THAT(shown("CALI"), ElementsAre("Cálice 4"));
  EXPECT_THAT(shown("b"), ElementsAre("ab 1", "b 3"));
  EXPECT_THAT(shown("d"), ElementsAre("d 0", "Todo 0"));
  EXPECT_THAT(shown("none"), IsEmpty());
  EXPECT_THAT(shown("  "), ElementsAre("d 0", "Todo 0"));
}

TEST_F(TreeRowsTest, AChainOfAnyDepthIsWalked) {
  for (int i = 0; i < 5000; ++i) {
    const std::string n = std::to_string(i);
    interpreter_.execute("create x" + n + " sphere 1");
    interpreter_.execute("combine c" + n + " " + (i == 0 ? "d" : "c" + std::to_string(i - 1)) +
                         " union x" + n);
  }
  rows_.reveal(interpreter_.solids(), "c4999", 5000);
  EXPECT_EQ(shown().size(), 10002u);  // and Todo
}

}  // namespace
}  // namespace sir::viewer
