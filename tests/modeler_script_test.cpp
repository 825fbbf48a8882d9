// From a .CSG to a script and back, to the last bit.
#include <bit>
#include <random>

#include "modeler/script.h"
#include "modeler/script_text.h"
#include "tests/cases.h"
#include "tests/modeler_fixture.h"
#include "tests/scene_builder.h"
#include "tracer/error.h"

namespace sir::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class ScriptTest : public ModelerTest {
 protected:
  CsgTree read(const std::string& text) {
    TextFile file("T.CSG", text);
    return read_csg(file);
  }

  // What a script saves, which goes to a folder of its own.
  std::string built(const std::string& script) {
    modeler::Interpreter fresh;
    TextFile file("T.model", script);
    modeler::run_script(file, fresh, [](const modeler::Reply&) {});
    return folder.read("out.CSG");
  }
  std::string script_of(const CsgTree& tree) {
    return modeler::script_text(*modeler::from_csg(tree), (folder / "out.CSG").string());
  }
};

TEST_F(ScriptTest, TheFiveScenesComeFromTheirScripts) {
  for (const char* name : {"calice", "lcg", "luminar", "piramide", "whitted"}) {
    const std::filesystem::path base = std::filesystem::path(SIR_IMAGES) / name;
    std::ifstream csg(base.string() + ".CSG"), source(base.string() + ".model");
    const std::string text{std::istreambuf_iterator<char>(csg), {}};
    std::string script{std::istreambuf_iterator<char>(source), {}};
    ASSERT_FALSE(text.empty()) << name;
    const std::string save = std::string(name) + ".CSG\n";
    ASSERT_TRUE(script.ends_with(" " + save)) << name;
    script.replace(script.size() - save.size(), save.size(), (folder / "out.CSG").string() + "\n");
    EXPECT_EQ(built(script), text) << name;
    EXPECT_EQ(built(script_of(read(text))), text) << name;
  }
}

TEST_F(ScriptTest, RandomScenesComeBackBitForBit) {
  const char* const names[] = {"a",    "dois nomes", "Pirâmide nº 3", "3",
                               "CUBO", "\"x\"",      "a (2)",         "a\\b #c"};
  for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
    std::mt19937_64 random(seed);
    CsgTree tree = random_scene(seed, 1 + static_cast<int>(seed % 25), seed % 2 == 0).tree;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      CsgNode& node = tree.nodes[i];
      if (seed % 3 == 0) node.number = static_cast<std::int64_t>((random() >> 1) / 32 * 32 + i);
      if (seed % 3 == 1) node.number = static_cast<std::int64_t>(i);
      node.name = names[random() % std::size(names)];
      if (node.composite) continue;
      node.surface_per_face = face_count(node.kind) > 1 && random() % 2 == 0;
      for (int face = 0; face < face_count(node.kind); ++face)
        node.surfaces[static_cast<std::size_t>(face)] =
            node.surface_per_face ? static_cast<std::int64_t>(random() % 4) : 7;
    }
    const std::string text = csg_text(tree);
    EXPECT_EQ(built(script_of(read(text))), text) << seed;
  }
}

TEST_F(ScriptTest, NumbersOfAnySizeComeBack) {
  std::mt19937_64 random(7);
  int matrices = 0;
  for (int i = 0; i < 200; ++i) {
    Placement placement;
    for (int line = 0; line < 3; ++line)
      for (int axis = 0; axis < 3; ++axis) {
        const int exponent = static_cast<int>(random() % 60) - 30;
        placement.linear[line][axis] =
            random() % 3 == 0 ? (random() % 2 == 0 ? 0.0 : -0.0)
                              : std::ldexp(static_cast<double>(random() >> 11), exponent);
      }
    placement.translation = {-0.0, 1e-300, 1e300};
    if (!modeler::is_usable(placement)) continue;
    const std::string text = csg_text(modeler::to_csg(*modeler::make_node(
        "p", modeler::Primitive{PrimitiveKind::cone, {1, 2}, true, placement})));
    const std::string script = script_of(read(text));
    matrices += script.find("\nmatrix ") != script.npos;
    ASSERT_EQ(built(script), text);
  }
  EXPECT_GT(matrices, 20);
}

TEST_F(ScriptTest, PlainPlacementsAreReadable) {
  say_all({"create a cylinder 1", "scale a 0.5 2 3", "rotate a x 90", "translate a 0.1 0.2 0.3"});
  EXPECT_EQ(modeler::script_text(solid("a"), "a.CSG"),
            "# a.CSG, 1 node; sir model makes it from this script.\n"
            "\n"
            "create a cylinder 1\n"
            "scale a 0.5 2 3\n"
            "rotate a x 90\n"
            "translate a 0.1 0.2 0.3\n"
            "\n"
            "save a a.CSG\n");
  say_all({"create b sphere 1", "scale b 0.7", "translate b 1 0 0"});
  EXPECT_THAT(modeler::script_text(solid("b"), "b.CSG"),
              HasSubstr("create b sphere 1\nscale b 0.7\ntranslate b 1 0 0\n\nsave"));
  say_all({"create c cube 1", "scale c -1 1 1"});  // a mirror, and no turn
  EXPECT_THAT(modeler::script_text(solid("c"), "c.CSG"), HasSubstr("\nscale c -1 1 1\n\nsave"));
  say("rotate b z 30");
  EXPECT_THAT(modeler::script_text(solid("b"), "b.CSG"), HasSubstr("\nmatrix b "));
}

TEST_F(ScriptTest, NamesThatRepeatAreToldApartOnlyWhereTheyMeet) {
  say_all({"create a cube 1", "create b cube 1", "combine c a union b", "create a cube 2",
           "create d cube 1", "label d a", "combine e a union d", "combine f c union e",
           "label f c"});
  const std::string script = modeler::script_text(solid("f"), "f.CSG");
  EXPECT_THAT(script, HasSubstr("combine c a union b\n"));
  EXPECT_THAT(script, HasSubstr("create a cube 2\n"));  // the first one is part of c by then
  EXPECT_THAT(script, HasSubstr("create \"a (2)\" cube 1\nlabel \"a (2)\" a\n"));
  EXPECT_THAT(script, HasSubstr("combine \"c (2)\" c union e\nlabel \"c (2)\" c\n"));
  const std::string text = csg_text(modeler::to_csg(solid("f")));
  EXPECT_EQ(built(script_of(read(text))), text);
}

// A .CSG may hold control characters within a name, which no list should.
TEST_F(ScriptTest, NamesWithControlCharactersAreLabels) {
  say_all({"create a cube 1", "create b cube 1", "combine c a union b", "edit c 1 label \"x\ty\"",
           "edit c 2 label \"x\ty\"", "label c \"\x1b[2J\""});
  const std::string text = csg_text(modeler::to_csg(solid("c")));
  EXPECT_THAT(text, HasSubstr("\nx\ty\n"));
  EXPECT_EQ(built(script_of(read(text))), text);
  // A terminal is not told what to do.
  const std::string shown = say("inspect c tree").text;
  EXPECT_THAT(shown, HasSubstr("?[2J: union"));
  EXPECT_EQ(shown.find('\x1b'), shown.npos);
  for (const char* text_at_an_end : {"\"x\t\"", "\"\tx\"", "\" x\""})
    expect_refused(std::string("label c ") + text_at_an_end, "white space");
  expect_refused("rename c \"x\ty\"", "only a label may");
}

TEST_F(ScriptTest, NumbersThatAreNotThoseOfThePlacesAreKept) {
  // Leaves first, from 0, as programs write.
  const std::string text =
      "3\n\n0\nx\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
      "4\nx\nPRIMITIVO\nESFERA\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
      "9\nx\nCOMPOSTO\nUNIÃO\nPRIMITIVO\nPRIMITIVO\n4\n0\n\n";
  EXPECT_EQ(built(script_of(read(text))), text);
}

TEST_F(ScriptTest, PartsThatDoNotMeetAreBuiltAllTheSame) {
  say_all({"create a cube 1", "create b cube 1", "translate b 5 0 0",
           "combine c a difference b apart"});
  const std::string text = csg_text(modeler::to_csg(solid("c")));
  EXPECT_THAT(script_of(read(text)), HasSubstr("difference b apart"));
  EXPECT_EQ(built(script_of(read(text))), text);
}

TEST_F(ScriptTest, SaveWritesAScriptThatSavesTheSolid) {
  say_all({"create a cube 1", "rotate a y 10"});
  say("save a " + (folder / "s.model").string());
  EXPECT_EQ(folder.read("s.model"), modeler::script_text(solid("a"), "s.CSG"));
}

TEST_F(ScriptTest, AnErrorNamesTheLineAndStops) {
  const auto message = [&](const std::string& script) -> std::string {
    interpreter = modeler::Interpreter();
    TextFile file("T.model", script);
    try {
      modeler::run_script(file, interpreter, [](const modeler::Reply&) {});
    } catch (const FileError& error) {
      return error.what();
    }
    return "(none)";
  };
  EXPECT_EQ(message("# one\n\ncreate a cube 1\r\ncreate a cube 1\ncreate b cube 1\n"),
            "T.model:4: a solid \"a\" exists already");
  EXPECT_TRUE(has("a"));
  EXPECT_FALSE(has("b"));
  EXPECT_EQ(message("create a cube 1\nquit\nnonsense\n"), "(none)");
  EXPECT_EQ(message("create \"Ma\xE7\xE3\" cube 1\ndelete Ma\xC3\xA7\xC3\xA3"),
            "T.model:2: there is no solid \"Ma\xC3\x83\xC2\xA7\xC3\x83\xC2\xA3\"");  // one file,
                                                                                     // one encoding
  folder.write("bad.CSG", "0\n");
  EXPECT_THAT(message("\nload x " + (folder / "bad.CSG").string()),
              testing::AllOf(testing::StartsWith("T.model:2: "), HasSubstr("bad.CSG:1: a scene")));
}

}  // namespace
}  // namespace sir::test
