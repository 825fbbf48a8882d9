// Parts changed where they are, against taking the solid apart and putting it together again.
#include <algorithm>
#include <random>

#include "modeler/completion.h"
#include "tests/cases.h"
#include "tests/modeler_parts_fixture.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(PartsTest, AnEditIsSplittingTheCommandAndCombiningAgain) {
  int done = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
    std::mt19937_64 random(seed);
    interpreter = modeler::Interpreter();
    const std::string name = grow(random, 2 + int(seed % 12));
    for (int i = 0; i < 30; ++i) {
      const NodePtr tree = interpreter.solids().find(name)->solid.tree();
      const std::size_t place = random() % tree->count;
      const auto [command, rest] = draw(random, *modeler::node_at(*tree, place));
      const std::string wanted = by_hand(tree, place, command, rest);
      const std::string line = "edit " + name + " " + std::to_string(place) + " " + command + rest;
      const std::string before = text_of(solid(name));
      std::string reason;
      try {
        say(line);
        ++done;
      } catch (const modeler::CommandError& error) {
        reason = error.what();
        ++refused;
      }
      ASSERT_EQ(reason.empty(), !wanted.empty()) << seed << ": " << line << ": " << reason;
      ASSERT_EQ(text_of(solid(name)), wanted.empty() ? before : wanted) << seed << ": " << line;
    }
  }
  EXPECT_GT(done, 1000);
  EXPECT_GT(refused, 100);
}

TEST_F(PartsTest, EveryStateComesBackBitForBit) {
  for (std::uint64_t seed = 100; seed < 110; ++seed) {
    std::mt19937_64 random(seed);
    interpreter = modeler::Interpreter();
    const std::string name = grow(random, 10);
    std::vector<std::string> states{state_of(interpreter)};
    const std::size_t first = interpreter.script().size();
    // Beyond the edits that are kept as edits, among transforms of the whole.
    while (states.size() < 4 * modeler::Solid::kMostSteps) {
      const NodePtr tree = interpreter.solids().find(name)->solid.tree();
      const std::size_t place = random() % 3 == 0 ? 0 : random() % tree->count;
      const auto [command, rest] = draw(random, *modeler::node_at(*tree, place));
      // A matrix at random is ever again near a singular one.
      if (command == "matrix" || command == "scale") continue;
      try {
        if (place == 0) say(command + " " + name + rest);
        else say("edit " + name + " " + std::to_string(place) + " " + command + rest);
        states.push_back(state_of(interpreter));
      } catch (const modeler::CommandError&) {
        ASSERT_EQ(state_of(interpreter), states.back());
      }
    }
    ASSERT_EQ(interpreter.script().size(), first + states.size() - 1);
    for (int i = 0; i < 150; ++i) say("undo");  // without a look in between
    EXPECT_EQ(state_of(interpreter), states[states.size() - 151]);
    for (int i = 0; i < 150; ++i) say("redo");
    for (std::size_t i = states.size() - 1; i-- > 0;) {
      say("undo");
      ASSERT_EQ(state_of(interpreter), states[i]) << seed << " " << i;
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
      say("redo");
      ASSERT_EQ(state_of(interpreter), states[i]) << seed << " " << i;
    }
    modeler::Interpreter again;
    for (const std::string& command : interpreter.script()) again.execute(command);
    EXPECT_EQ(state_of(again), states.back());
  }
}

TEST_F(PartsTest, TranslationsThatWaitAreDoneBeforeAnEdit) {
  // The same with a look at the tree after every command, and with none until the end.
  for (const bool looking : {false, true}) {
    modeler::Interpreter session;
    const auto tell = [&](const std::string& line) {
      session.execute(line);
      if (looking) session.solids().find("c")->solid.tree();
    };
    for (const char* line : {"create a cube 1", "create b sphere 2"}) session.execute(line);
    tell("combine c a union b");
    for (int i = 0; i < 500; ++i) {
      tell("translate c 0.1 0.2 0.3");
      if (i % 7 == 0) tell("edit c 2 scale 1.1");
      if (i % 11 == 0) tell("rotate c z 11");
      if (i % 13 == 0) tell("undo");
    }
    if (looking) EXPECT_EQ(state_of(session), state_of(interpreter));
    else interpreter = std::move(session);
  }
}

TEST_F(PartsTest, ATranslationTooFarIsRefusedThoughItWaits) {
  say_all({"create a cube 1", "create b cube 1", "combine c a union b", "translate c 1e308 0 0",
           "translate c 0 1 0", "translate c 7e307 0 0"});
  expect_refused("translate c 1e307 0 0", "singular, or its numbers too large");
  say("translate c -1e308 0 0");
}

// Trees that are much work are kept in other numbers, and a while longer.
TEST_F(PartsTest, StatesOfALargeSolidComeBack) {
  constexpr int kPrimitives = 256, kCommands = 1200;
  std::string last = "p0";
  for (int i = 0; i < kPrimitives; ++i) {
    const std::string n = std::to_string(i);
    say("create p" + n + " sphere 1");
    say("translate p" + n + " " + n + " 0 0");
    if (i == 0) continue;
    say("combine c" + n + " " + last + " union p" + n);
    last = "c" + n;
  }
  say("rename " + last + " c");
  ASSERT_GT(modeler::Solid::most_steps(solid("c").count), std::size_t{modeler::Solid::kMostSteps});
  const auto state = [&] { return std::hash<std::string>()(text_of(solid("c"))); };
  std::mt19937_64 random(1);
  std::vector<std::size_t> states{state()};
  for (std::size_t at = 0; states.size() < kCommands;) {
    const std::string place = std::to_string(random() % solid("c").count);
    const char* const kWays[] = {"c 0.1 0.2 0.3", "c 1 0 0", "c -1 0 1"};
    switch (random() % 8) {
      case 0: say("edit c " + place + " translate 0.5 0 0"); break;
      case 1: say("edit c " + place + " paint 3"); break;
      case 2: say("rotate c y 30"); break;
      case 3:
      case 4:
        if (at == 0) continue;
        say("undo");
        ASSERT_EQ(state(), states[--at]);
        if (random() % 2 == 0) continue;
        say("redo");
        ASSERT_EQ(state(), states[++at]);
        continue;
      default: say(std::string("translate ") + kWays[random() % 3]); break;
    }
    states.resize(++at);
    states.push_back(state());
  }
  // There and back in strides of which some are long.
  std::size_t at = states.size() - 1;
  for (const bool forward : {false, true, false}) {
    while (forward ? at + 1 < states.size() : at > 0) {
      for (std::size_t stride = 1 + random() % 40; stride > 0; --stride) {
        if (forward ? at + 1 == states.size() : at == 0) break;
        say(forward ? "redo" : "undo");
        forward ? ++at : --at;
      }
      ASSERT_EQ(state(), states[at]) << at;
    }
  }
}

TEST_F(PartsTest, WhatIsNotChangedIsShared) {
  say("create c cube 1");
  for (int i = 0; i < 20; ++i) {
    say("create p sphere 1");
    say("combine w c union p");
    say("rename w c");
  }
  const NodePtr before = interpreter.solids().find("c")->solid.tree();
  say("edit c 4 translate 1 0 0");
  const NodePtr after = interpreter.solids().find("c")->solid.tree();
  const auto old_nodes = modeler::preorder(*before), new_nodes = modeler::preorder(*after);
  ASSERT_EQ(old_nodes.size(), new_nodes.size());
  for (std::size_t i = 0; i < old_nodes.size(); ++i) {
    const bool on_the_way = i <= 4;
    const bool below = i >= 4 && i < 4 + new_nodes[4]->count;
    EXPECT_EQ(old_nodes[i] == new_nodes[i], !on_the_way && !below) << i;
  }
}

TEST_F(PartsTest, TreesOfEditsAreNotKeptEither) {
  say_all({"create a cube 1", "create b cube 1", "combine c a union b"});
  std::vector<std::weak_ptr<const Node>> trees;
  for (int i = 0; i < 100; ++i) {
    say("edit c 1 translate 0.01 0 0");
    trees.push_back(interpreter.solids().find("c")->solid.tree());
  }
  const auto alive =
      std::count_if(trees.begin(), trees.end(), [](const auto& tree) { return !tree.expired(); });
  EXPECT_LE(alive, 3);
}

TEST_F(PartsTest, PaintAndOperationOfASolid) {
  say_all({"create a cube 1", "create b sphere 2", "combine c a union b"});
  say("create d cylinder 1");
  EXPECT_EQ(say("pinta d 4 5 6").done, "d: painted");
  EXPECT_TRUE(solid("d").primitive()->surface_per_face);
  EXPECT_THAT(solid("d").primitive()->surfaces, ElementsAre(4, 5, 6, 0, 0, 0));
  say("paint d 3");
  EXPECT_FALSE(solid("d").primitive()->surface_per_face);
  EXPECT_EQ(say("paint c 9").done, "c: painted");
  for (const Node* node : modeler::preorder(solid("c"))) {
    if (const auto* primitive = node->primitive()) {
      EXPECT_EQ(primitive->surfaces[0], 9);
    }
  }
  EXPECT_EQ(say("operacao c DIFERENCA").done, "c: difference");
  EXPECT_EQ(solid("c").composite()->operation, Operation::difference);
  EXPECT_FALSE(interpreter.solids().find("c")->saved);
  say("undo");
  EXPECT_EQ(solid("c").composite()->operation, Operation::union_of);

  expect_refused("paint d 1 2", "a cylinder takes 1 surface number for all faces or 3");
  expect_refused("paint c 1 2", "\"c\" is a composite: it takes 1 surface number");
  expect_refused("paint d -1", "not a non-negative integer");
  expect_refused("paint d", "wrong number of words; it is paint NAME SURFACE...");
  expect_refused("operation d union", "\"d\" is not a composite");
  expect_refused("operation c onion", "did you mean union?");
  expect_refused("operation c", "wrong number of words");
  expect_refused("operation x union", "there is no solid \"x\"");
  say_all({"translate d 9 0 0", "combine e c union d"});
  expect_refused("operation e intersection", "there is no intersection between \"c\" and \"d\"");
  say("operation e intersection apart");
  EXPECT_EQ(solid("e").composite()->operation, Operation::intersection);
}

TEST_F(PartsTest, APrimitiveIsTurnedAboutItsCentreWhereThatIsSaid) {
  for (const char* name : {"a", "b"}) {
    say(std::string("create ") + name + " cube 1");
    say(std::string("translate ") + name + " 3 4 5");
  }
  const modeler::Box before = solid("a").bounds;
  say("scale a 2 1 1 centre");
  EXPECT_EQ(solid("a").bounds.centre(), before.centre());
  EXPECT_EQ(solid("a").bounds.high.x - solid("a").bounds.low.x, 2 * (before.high.x - before.low.x));
  say("gira a z 90 centro");
  EXPECT_EQ(solid("a").bounds.centre(), before.centre());
  EXPECT_EQ(solid("a").bounds.high.y - solid("a").bounds.low.y, 2 * (before.high.y - before.low.y));
  say("transform a scale 0.5 centre");
  EXPECT_EQ(solid("a").bounds.centre(), before.centre());
  // In place the same, and with apart behind it.
  say("combine both a union b");
  say("edit both 2 scale 2 1 1 centre");
  say("edit both 2 rotate z 90 centre apart");
  say("edit both 2 scale 0.5 centre");
  const Node& both = solid("both");
  EXPECT_EQ(both.composite()->right->bounds.low, both.composite()->left->bounds.low);
  EXPECT_EQ(both.composite()->right->bounds.high, both.composite()->left->bounds.high);
  expect_refused("translate both 1 2 3 centre", "centre");
  expect_refused("scale both centre", "centre");
}

TEST_F(PartsTest, ACompositeWithoutAnIntersectionIsRefused) {
  say_all({"create a cube 1", "create b sphere 1", "combine c a difference b", "create d cube 1",
           "combine e c union d"});
  expect_refused("edit e 3 translate 5 0 0",
                 "there is no intersection between \"a\" and \"b\": their bounds do not meet, so "
                 "the difference would take nothing away");
  // Nor may the whole leave an intersection further up.
  say("operation e intersection");
  expect_refused("edit e 1 translate 5 0 0", "so the intersection would be empty");
  say("edit e 3 translate 5 0 0 apart");
  say("edit e 3 translate 1 0 0");  // they are apart already
  say("edit e 3 scale 2 separados");
  EXPECT_EQ(modeler::node_at(solid("e"), 3)->name, "b");
}

TEST_F(PartsTest, NamesAndNumbersStay) {
  folder.write("t.CSG",
               "3\n\n0\nx\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
               "4\nx\nPRIMITIVO\nESFERA\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
               "9\nwhole\nCOMPOSTO\nUNIÃO\nPRIMITIVO\nPRIMITIVO\n4\n0\n\n");
  say("load s " + (folder / "t").string());
  say_all({"label s whole", "edit s 1 translate 2 0 0", "edit s 1 label \"a ball\"",
           "edit s 2 paint 5", "edit s 0 label all", "edit s 0 operation difference apart"});
  say("save s " + (folder / "u").string());
  EXPECT_EQ(folder.read("u.CSG"),
            "3\n\n0\nx\nPRIMITIVO\nCUBO\n5\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
            "4\na ball\nPRIMITIVO\nESFERA\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n2 0 0 1\n\n"
            "9\nall\nCOMPOSTO\nDIFERENÇA\nPRIMITIVO\nPRIMITIVO\n4\n0\n\n");
  EXPECT_TRUE(has("s"));
}

TEST_F(PartsTest, WrongWordsAreRefusedWithWhatWasMeant) {
  say_all({"create ball sphere 1", "create foot cube 1", "combine glass ball union foot"});
  expect_refused("edit glas 1 paint 2", "did you mean \"glass\"?");
  expect_refused("edit glass", "it is edit NAME PLACE COMMAND...");
  expect_refused("edit glass 1", "it is edit NAME PLACE COMMAND...");
  expect_refused("edit glass 3 paint 2", "there is no place 3 in \"glass\": its places are 0 to 2");
  expect_refused("edit glass foto paint 2", "\"foot\" is at place 2");
  expect_refused("edit glass -1 paint 2", "inspect glass tree shows them");
  expect_refused("edit glass 99999999999999999999 paint 2", "is no place");
  expect_refused("edit glass 1 rotat y 2", "did you mean rotate?");
  expect_refused("edit glass 1 girar y 2", "did you mean gira?");
  expect_refused("edit glass 1 delete",
                 "\"delete\" is nothing that can be done to a part: "
                 "transform, translate, scale, rotate, matrix, paint, ");
  expect_refused("edit glass 1 edit 2", "is nothing that can be done to a part");
  expect_refused(
      "edit glass 1 scale 1 2",
      "wrong number of words; it is edit NAME PLACE scale x y z [centre] | factor [centre]");
  expect_refused("edit glass 1 scale 0", "a scale of 0");
  expect_refused("edit glass 1 translate 1 2 x", "\"x\" is not a finite number");
  expect_refused("edit glass 1 translate", "it is edit NAME PLACE translate x y z");
  expect_refused("edit glass 1 rotate w 2", "is no axis");
  expect_refused("edit glass 1 matrix 1 0 0 2 0 0 3 0 0 0 0 0", "the matrix of \"ball\" singular");
  expect_refused("edit glass 1 paint 1 2", "a sphere takes 1 surface number");
  expect_refused("edit glass 1 operation union", "\"ball\" is not a composite");
  expect_refused("edit glass 1 label \" x\"", "white space");
  expect_refused("edit glass 1 label a b", "it is edit NAME PLACE label TEXT");
  EXPECT_EQ(say("edita glass 1 rotula apart").done, "glass: \"ball\" at 1: \"apart\" in the .CSG");
  say("create ball sphere 1");
  EXPECT_EQ(say("edita ball 0 pinta 2").done, "ball: \"ball\" at 0: painted");
  expect_refused("edit ball 1 paint 2", "there is no place 1 in \"ball\": it is a primitive");
}

TEST_F(PartsTest, ThePlacesAreShown) {
  say_all({"create a cube 1", "create b sphere 2", "combine c a difference b", "create d cone 3",
           "combine e c union d"});
  const std::string text = say("inspect e tree").text;
  EXPECT_THAT(text, HasSubstr("  0 e: union\n"
                              "  1 ├ c: difference\n"
                              "  2 │ ├ a: cube, surface 1\n"
                              "  3 │ └ b: sphere, surface 2\n"
                              "  4 └ d: cone, surface 3\n"));
  say("create f cube 1");
  EXPECT_THAT(say("inspect f tree").text, HasSubstr("  0 f: cube, surface 1\n"));
}

TEST_F(PartsTest, Completion) {
  say_all({"create ball sphere 1", "create foot cube 2", "combine glass ball difference foot"});
  const auto completed = [&](const std::string& line) {
    return modeler::complete(interpreter, line);
  };
  EXPECT_THAT(completed("edit g").words, ElementsAre("glass"));
  EXPECT_THAT(completed("edit glass ").words, ElementsAre("0", "1", "2"));
  EXPECT_THAT(completed("edit glass ").notes,
              ElementsAre("glass: difference", "ball: sphere", "foot: cube"));
  EXPECT_THAT(completed("edit glass fo").words, ElementsAre("2"));
  EXPECT_THAT(completed("edit glass 1").notes, ElementsAre("ball: sphere"));
  EXPECT_THAT(completed("edit none ").words, IsEmpty());
  EXPECT_THAT(completed("edit glass 1 ").words,
              ElementsAre("label", "matrix", "operation", "paint", "rotate", "scale", "transform",
                          "translate"));
  EXPECT_THAT(completed("edit glass 1 t").words, ElementsAre("transform", "translate"));
  EXPECT_THAT(completed("edita glass 1 gi").words, ElementsAre("gira"));
  EXPECT_THAT(completed("edit glass 1 rotate ").words, ElementsAre("x", "y", "z"));
  EXPECT_THAT(completed("edit glass 1 operation d").words, ElementsAre("difference"));
  EXPECT_THAT(completed("edit glass 1 transform s").words, ElementsAre("scale"));
  EXPECT_THAT(completed("edit glass 1 delete ").words, IsEmpty());
  EXPECT_THAT(completed("operation glass union ").words, ElementsAre("apart"));
  EXPECT_THAT(completed("paint fo").words, IsEmpty());  // it is part of glass
}

}  // namespace
}  // namespace sir::test
