// The eleven functions of the modeler (thesis 3.2.2) as commands, and what each refuses.
#include "tests/modeler_fixture.h"

#include <memory>
#include <random>

#include "modeler/operations.h"

namespace sir::test {
namespace {

using modeler::Box;
using testing::ElementsAre;
using testing::HasSubstr;

class Functions : public ModelerTest {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& [place, entry] : interpreter.solids().entries()) all.push_back(entry->name);
    return all;
  }
};

TEST_F(Functions, CreatePutsAPrimitiveAtItsStandardPlace) {
  say_all({"create a cube 1", "create b sphere 2", "create c cone 3 4", "create d cylinder 5 6 7"});
  EXPECT_THAT(names(), ElementsAre("a", "b", "c", "d"));
  for (const char* name : {"a", "b", "c", "d"}) {
    EXPECT_EQ(placement(name).linear, glm::dmat3(1.0)) << name;
    EXPECT_EQ(placement(name).translation, glm::dvec3(0.0)) << name;
    EXPECT_EQ(solid(name).count, 1u);
  }
  EXPECT_EQ(solid("a").primitive()->kind, PrimitiveKind::cube);
  EXPECT_EQ(solid("a").primitive()->surfaces, (std::array<std::int64_t, 6>{1, 1, 1, 1, 1, 1}));
  EXPECT_FALSE(solid("a").primitive()->surface_per_face);
  EXPECT_EQ(solid("d").primitive()->surfaces, (std::array<std::int64_t, 6>{5, 6, 7, 0, 0, 0}));
  EXPECT_TRUE(solid("d").primitive()->surface_per_face);
  EXPECT_EQ(solid("a").bounds.low, glm::dvec3(0.0));
  EXPECT_EQ(solid("a").bounds.high, glm::dvec3(1.0));
  EXPECT_EQ(solid("b").bounds.low, glm::dvec3(-1.0));
  EXPECT_EQ(solid("c").bounds.low, glm::dvec3(-1, 0, -1));
  EXPECT_EQ(solid("c").bounds.high, glm::dvec3(1, 1, 1));
}

TEST_F(Functions, TheThesissNamesDoTheSame) {
  modeler::Interpreter english;
  const char* const pairs[][2] = {
      {"create bola sphere 1", "CRIA bola ESFERA 1"},
      {"create furo cylinder 2", "cria furo cilindro 2"},
      {"create caixa cube 3", "cria caixa cubo 3"},
      {"create bico cone 4", "cria bico cone 4"},
      {"scale furo 0.5 4 0.5", "transforma furo escala 0.5 4 0.5"},
      {"rotate furo x 90", "transforma furo ROTAÇÃO x 90"},
      {"translate furo 0 0 -2", "transforma furo translacao 0 0 -2"},
      {"combine x bola difference furo", "combina x bola diferença furo"},
      {"combine y x union caixa", "combina y x uniao caixa"},
      {"combine z y intersection bico", "combina z y INTERSECAO bico"},
      {"copy z w", "copia z w"},
      {"split z", "desfaz z"},
      {"delete bico", "deleta bico"},
      {"list", "lista"},
      {"inspect w", "verifica w"},
      {"undo", "anula"},
      {"redo", "refaz"},
      {"help", "ajuda"},
      {"show w", "mostra w"},
  };
  for (const auto& [one, other] : pairs) {
    const modeler::Reply a = english.execute(one), b = interpreter.execute(other);
    EXPECT_EQ(a.text, b.text) << other;
    EXPECT_EQ(state_of(english), state_of(interpreter)) << other;
  }
  EXPECT_TRUE(interpreter.execute("sai").quit);
}

TEST_F(Functions, CreateRefusesWhatIsNoSolid) {
  say("create bola sphere 1");
  expect_refused("create bola cube 1", "a solid \"bola\" exists already");
  expect_refused("create c cub 1", "did you mean cube?");
  expect_refused("create c cube", "create NAME cube|sphere|cone|cylinder SURFACE...");
  expect_refused("create c cube 1 2", "1 surface number for all faces or 6, one per face; 2 given");
  expect_refused("create c sphere 1 1", "a sphere takes 1 surface number; 2 given");
  expect_refused("create c cube -1", "\"-1\" is not a non-negative integer");
  expect_refused("create c cube 1.5", "\"1.5\" is not");
  expect_refused("create uma bola sphere 1", "a name with spaces goes in quotes");
  expect_refused("create \"\" cube 1", "cannot be empty");
  expect_refused("create \" a\" cube 1", "white space");
  expect_refused("create \"a\tb\" cube 1", "control character");
  expect_refused("create \"a cube 1", "a quote is opened and not closed");
  expect_refused("cretae c cube 1", "there is no command \"cretae\"; did you mean create?");
}

TEST_F(Functions, NamesMayHoldSpacesAndAccents) {
  say_all({"create \"bola de gude nº 1\" sphere 1", "create Maçã sphere 1",
           "combine \"a #1 \\\"x\\\"\" \"bola de gude nº 1\" union Maçã"});
  EXPECT_THAT(names(), ElementsAre("a #1 \"x\""));
  expect_refused("delete \"a #1\"", "there is no solid \"a #1\"");
  say("split \"a #1 \\\"x\\\"\"  # taken apart");
  EXPECT_THAT(names(), ElementsAre("bola de gude nº 1", "Maçã"));
  expect_refused("delete maca", "did you mean \"Maçã\"?");
}

TEST_F(Functions, TransformsOfAPrimitiveAccumulateAboutTheOrigin) {
  say_all({"create a cube 1", "translate a 1 2 3", "scale a 2 3 4", "rotate a z 90"});
  // (x, y, z) -> (2(x+1), 3(y+2), 4(z+3)) -> (-3(y+2), 2(x+1), 4(z+3))
  EXPECT_EQ(placement("a").linear, glm::dmat3(0, 2, 0, -3, 0, 0, 0, 0, 4));
  EXPECT_EQ(placement("a").translation, glm::dvec3(-6, 2, 12));
  EXPECT_EQ(solid("a").bounds.low, glm::dvec3(-9, 2, 12));
  EXPECT_EQ(solid("a").bounds.high, glm::dvec3(-6, 4, 16));
  say("scale a 0.5");
  EXPECT_EQ(placement("a").translation, glm::dvec3(-3, 1, 6));
  say("matrix a 1 0 0  0 1 0  1 0 1  5 0 0");  // a shear: x grows by z
  EXPECT_EQ(placement("a").translation, glm::dvec3(-3 + 6 + 5, 1, 6));
  EXPECT_EQ(placement("a").linear[2], glm::dvec3(2, 0, 2));
}

TEST_F(Functions, ACompositeTurnsAboutTheCentreOfItsBounds) {
  say_all({"create a cube 1", "create b cube 1", "translate b 3 0 0", "combine c a union b"});
  say("scale c 2 1 1");  // bounds 0..4 become -2..6
  EXPECT_EQ(solid("c").bounds.low, glm::dvec3(-2, 0, 0));
  EXPECT_EQ(solid("c").bounds.high, glm::dvec3(6, 1, 1));
  say("rotate c y 90");  // about (2, 0.5, 0.5): x goes to -z
  EXPECT_EQ(solid("c").bounds.low, glm::dvec3(1.5, 0, -3.5));
  EXPECT_EQ(solid("c").bounds.high, glm::dvec3(2.5, 1, 4.5));
  const modeler::Node& first = *solid("c").composite()->left;
  EXPECT_EQ(first.bounds.low, glm::dvec3(1.5, 0, 2.5));  // it was at the low end of x
  say("translate c 1 1 1");
  EXPECT_EQ(solid("c").bounds.low, glm::dvec3(2.5, 1, -2.5));
}

TEST_F(Functions, QuarterTurnsAreExactAndThirdsOfThemTooWhereTheyCanBe) {
  for (const int quarters : {1, 2, 3, 4, 5, -1, 400}) {
    const glm::dmat3 turn = modeler::rotation_about(1, 90.0 * quarters).linear;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row)
        EXPECT_EQ(std::abs(turn[column][row]), std::round(std::abs(turn[column][row])));
  }
  EXPECT_EQ(modeler::rotation_about(0, 30).linear[1].z, 0.5);
  EXPECT_EQ(modeler::rotation_about(0, 60).linear[1].y, 0.5);
  EXPECT_EQ(modeler::rotation_about(0, -150).linear[1].z, -0.5);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-1000, 1000);
  for (int i = 0; i < 1000; ++i) {
    const double degrees = angle(random);
    const long double radians = static_cast<long double>(degrees) * 3.14159265358979323846L / 180;
    const glm::dmat3 turn = modeler::rotation_about(2, degrees).linear;
    EXPECT_NEAR(turn[0].x, static_cast<double>(std::cos(radians)), 2e-16) << degrees;
    EXPECT_NEAR(turn[0].y, static_cast<double>(std::sin(radians)), 2e-16) << degrees;
    EXPECT_EQ(turn[1].x, -turn[0].y);
  }
}

TEST_F(Functions, TransformsThatLeaveNothingAreRefused) {
  say_all({"create a cube 1", "create b cube 1", "copy a d", "combine c a union b"});
  for (const std::string name : {"c", "d"}) {
    expect_refused("scale " + name + " 0", "a scale of 0");
    expect_refused("scale " + name + " 1 0 1", "a scale of 0");
    expect_refused("scale " + name + " 1 2", "scale NAME x y z");
    expect_refused("scale " + name + " nan", "\"nan\" is not a finite number");
    expect_refused("scale " + name + " inf", "is not a finite number");
    expect_refused("translate " + name + " 1 2", "translate NAME x y z");
    expect_refused("translate " + name + " 1 2 3 4", "translate NAME x y z");
    expect_refused("rotate " + name + " w 30", "\"w\" is no axis");
    expect_refused("rotate " + name + " x", "rotate NAME x|y|z DEGREES");
    expect_refused("rotate " + name + " x 1,5", "\"1,5\" is not a finite number");
    expect_refused("matrix " + name + " 1 0 0 0 1 0 0 0 1", "12 numbers, or 16");
    expect_refused("matrix " + name + " 1 0 0 2 0 0 0 0 1 0 0 0", "singular");
    expect_refused("matrix " + name + " 1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1", "0 0 0 1");
    expect_refused("transform " + name + " turn x 30", "\"turn\" is no transform");
    say("scale " + name + " 1e200");
    expect_refused("scale " + name + " 1e200", "singular, or its numbers too large");
  }
  expect_refused("scale e 2", "there is no solid \"e\"");
  expect_refused("translate cc 1 1 1", "did you mean \"c\"?");
}

TEST_F(Functions, CombineConsumesBothAndCombinesTheirBounds) {
  const auto combined = [&](const char* operation) {
    interpreter = modeler::Interpreter();
    say_all({"create a cube 1", "create b cube 2", "translate b 0.5 0.25 0"});
    say(std::string("combine c a ") + operation + " b");
    EXPECT_THAT(names(), ElementsAre("c"));
    EXPECT_EQ(solid("c").composite()->left->name, "a");
    EXPECT_EQ(solid("c").composite()->right->name, "b");
    return solid("c").bounds;
  };
  Box box = combined("union");
  EXPECT_EQ(box.low, glm::dvec3(0));
  EXPECT_EQ(box.high, glm::dvec3(1.5, 1.25, 1));
  box = combined("difference");
  EXPECT_EQ(box.high, glm::dvec3(1));
  box = combined("intersection");
  EXPECT_EQ(box.low, glm::dvec3(0.5, 0.25, 0));
  EXPECT_EQ(box.high, glm::dvec3(1));
}

TEST_F(Functions, CombineRefusesSolidsThatDoNotMeet) {
  say_all({"create a cube 1", "create b cube 1", "translate b 1.5 0 0"});
  expect_refused("combine c a difference b", "there is no intersection between \"a\" and \"b\"");
  expect_refused("combine c a intersection b", "their bounds do not meet");
  expect_refused("combine c a union a", "cannot be combined with itself");
  expect_refused("combine a a union b", "a solid \"a\" exists already");
  expect_refused("combine c a union d", "there is no solid \"d\"");
  expect_refused("combine c d union a", "there is no solid \"d\"");
  expect_refused("combine c a unoin b", "did you mean union?");
  expect_refused("combine c a union", "combine NAME LEFT");
  expect_refused("combine c a union b c", "combine NAME LEFT");
  say("combine c a difference b apart");
  EXPECT_THAT(names(), ElementsAre("c"));
  say_all({"undo", "translate b -0.5 0 0", "combine c a difference b"});  // touching boxes meet
  say_all({"undo", "combine c a union b"});
  EXPECT_EQ(solid("c").bounds.high.x, 2);
}

TEST_F(Functions, AnEmptySolidHasNoCentre) {
  say_all({"create a cube 1", "create b cube 1", "translate b 5 0 0",
           "combine c a intersection b apart"});
  expect_refused("scale c 2", "the solid is empty");
  expect_refused("rotate c x 10", "the solid is empty");
  expect_refused("show c", "nothing to look at");
  say("translate c 1 1 1");
  EXPECT_THAT(say("inspect c").text, HasSubstr("bounds in SC_CENA empty"));
}

TEST_F(Functions, CopiesAreOfTheirOwn) {
  say_all({"create a cube 1", "create b sphere 2", "combine c a union b", "copy c d"});
  const std::string before = csg_text(modeler::to_csg(solid("c")));
  say_all({"translate d 1 2 3", "scale d 2", "split d"});
  EXPECT_EQ(csg_text(modeler::to_csg(solid("c"))), before);
  EXPECT_THAT(names(), ElementsAre("c", "a", "b"));
  EXPECT_NE(placement("a").translation, glm::dvec3(0.0));
  say("copy a e");  // a primitive too
  EXPECT_EQ(solid("e").name, "e");
  expect_refused("copy e a", "a solid \"a\" exists already");
  expect_refused("copy x y", "there is no solid \"x\"");
}

TEST_F(Functions, SplitGivesThePartsBack) {
  say_all({"create a cube 1", "create b sphere 2", "combine c a union b"});
  expect_refused("split a", "there is no solid \"a\"");
  say("create d cone 1");
  expect_refused("split d", "\"d\" is not a composite");
  say("split c");
  EXPECT_THAT(names(), ElementsAre("d", "a", "b"));
}

TEST_F(Functions, SplitFindsNamesForPartsWhoseNamesAreTaken) {
  say_all({"create a cube 1", "create b sphere 2", "combine c a union b", "copy c d", "split c"});
  EXPECT_THAT(say("split d").done, HasSubstr("now \"a (2)\" and \"b (2)\""));
  EXPECT_THAT(names(), ElementsAre("a", "b", "a (2)", "b (2)"));
  // A part may have the name of the whole, and both parts the same.
  say_all({"combine a2 \"a (2)\" union \"b (2)\"", "label a2 x", "delete a", "delete b"});
  say_all({"create p cube 1", "label p q", "create r cube 1", "label r q", "combine q p union r",
           "split q"});
  EXPECT_THAT(names(), ElementsAre("a2", "q", "q (2)"));
}

TEST_F(Functions, DeleteTakesASolidAway) {
  expect_refused("delete a", "the list of solids is empty");
  say_all({"create a cube 1", "create b cube 1", "delete a"});
  EXPECT_THAT(names(), ElementsAre("b"));
  expect_refused("delete a", "there is no solid \"a\"");
  expect_refused("delete", "delete NAME");
}

TEST_F(Functions, SaveAndLoadKeepASolid) {
  const std::string file = (folder / "s").string();
  say_all({"create a cube 1 2 3 4 5 6", "create b sphere 2", "rotate a x 33", "scale b 0.1 7 3",
           "combine c a union b"});
  EXPECT_THAT(interpreter.unsaved(), ElementsAre("c"));
  say("save c " + file);
  EXPECT_THAT(interpreter.unsaved(), ElementsAre());
  EXPECT_EQ(folder.read("s.CSG"), csg_text(modeler::to_csg(solid("c"))));
  say("load d " + file);
  say("load e " + file + ".CSG");
  EXPECT_EQ(solid("d").name, "d");
  EXPECT_EQ(csg_text(modeler::to_csg(*modeler::renamed(solid("d"), "c"))), folder.read("s.CSG"));
  EXPECT_THAT(interpreter.unsaved(), ElementsAre());
  say("translate d 1 0 0");
  EXPECT_THAT(interpreter.unsaved(), ElementsAre("d"));
  say("undo");
  EXPECT_THAT(interpreter.unsaved(), ElementsAre());
}

TEST_F(Functions, FilesThatCannotBeReadOrWrittenAreNamed) {
  say("create a cube 1");
  const std::string at = folder.path().string();
  expect_refused("load b " + at + "/none", "/none.CSG: is missing");
  expect_refused("load b " + at, "is missing");
  folder.write("bad.CSG", "1\n\n1\nx\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n0 1 0 0\n0 0 0 0\n0 0 0 1\n");
  expect_refused("load b " + at + "/bad", "bad.CSG:8: node 1 \"x\": LOCAL_CENA is singular");
  folder.write("cut.CSG", "2\n\n1\nx\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n");
  expect_refused("load b " + at + "/cut.CSG", "cut.CSG:8: the file ends");
  expect_refused("load a " + at + "/bad", "bad.CSG:8");
  expect_refused("save a " + at + "/no/s", "/no/s.CSG: cannot be written");
  expect_refused("save a " + at + "/s.LUZ", "another kind of file");
  expect_refused("save a \"\"", "no name of a file");
  expect_refused("save a " + at + "/", "is a folder");
  expect_refused("save b " + at + "/s", "there is no solid \"b\"");
  interpreter.protect(folder.write("mine.model", "#"));
  expect_refused("save a " + at + "/mine.model", "mine.model");
  EXPECT_EQ(folder.read("mine.model"), "#");
  EXPECT_THAT(folder.list(), ElementsAre("bad.CSG", "cut.CSG", "mine.model"));
}

TEST_F(Functions, APointInAFilesNameMakesNoSuffix) {
  const std::string file = (folder / "v1.2").string();
  say_all({"create a cube 1"});
  EXPECT_EQ(say("save a " + file).done, "wrote " + file + ".CSG (1 node)");
  say("load again " + file);
  EXPECT_TRUE(has("again"));
}

TEST_F(Functions, ListTellsWhatThereIs) {
  EXPECT_EQ(say("list").text, "the list of solids is empty\n");
  say_all({"create a cube 1", "create \"b c\" sphere 1", "create d cone 1",
           "combine e a difference d"});
  EXPECT_EQ(say("lista").text, "\"b c\": sphere\n\"e\": difference of \"a\" and \"d\", 3 nodes\n");
}

TEST_F(Functions, RenameLabelAndNumber) {
  say_all({"create a cube 1", "rename a b", "create c cube 1"});
  EXPECT_EQ(solid("b").name, "b");
  expect_refused("rename b c", "exists already");
  say_all({"label b c", "number b 7"});
  EXPECT_EQ(solid("b").name, "c");
  EXPECT_EQ(modeler::to_csg(solid("b")).nodes[0].number, 7);
  expect_refused("number b -1", "is not a non-negative integer");
  expect_refused("label b \"\"", "cannot be empty");
  say("combine d b union c");  // c has no number, so none counts
  EXPECT_EQ(modeler::to_csg(solid("d")).nodes[1].number, 2);
  const auto reply = say("save d " + (folder / "d").string());
  EXPECT_THAT(reply.warnings, ElementsAre(HasSubstr("numbered anew")));
}

TEST_F(Functions, NothingIsBegunAfterAStop) {
  std::stop_source source;
  modeler::Outlet outlet;
  outlet.stop = source.get_token();
  interpreter = modeler::Interpreter(outlet);
  say("create a cube 1");
  source.request_stop();
  expect_refused("create b cube 1", "interrupted");
  expect_refused("show a", "interrupted");
}

TEST_F(Functions, HelpKnowsEveryCommand) {
  const std::string all = say("help").text;
  for (const modeler::CommandInfo& info : modeler::commands()) {
    EXPECT_THAT(all, HasSubstr(std::string(info.name)));
    const std::string one = say("help " + std::string(info.portuguese)).text;
    EXPECT_THAT(one, HasSubstr(std::string(info.name)));
    EXPECT_THAT(one, HasSubstr(std::string(info.help)));
  }
  expect_refused("help nonsense", "there is no command");
  EXPECT_TRUE(say("quit").quit);
}

}  // namespace
}  // namespace sir::test
