// Words, nearest names and completion.
#include "modeler/command_line.h"
#include "modeler/completion.h"
#include "modeler/nearest_name.h"
#include "tests/modeler_fixture.h"

namespace sir::test {
namespace {

using testing::ElementsAre;
using Words = std::vector<std::string>;

TEST(CommandLine, SplitsAtWhiteSpaceOutsideOfQuotes) {
  using modeler::split_words;
  EXPECT_EQ(split_words("  create\ta  cube 1 \r"), (Words{"create", "a", "cube", "1"}));
  EXPECT_EQ(split_words("a \"b c\" d"), (Words{"a", "b c", "d"}));
  EXPECT_EQ(split_words("a \"\" b#c d"), (Words{"a", "", "b"}));
  EXPECT_EQ(split_words("\"a#b\" # c \"d"), (Words{"a#b"}));
  EXPECT_EQ(split_words(R"("a\"b\\c\d")"), (Words{R"(a"b\c\d)"}));
  EXPECT_EQ(split_words(R"(a\b)"), (Words{R"(a\b)"}));
  EXPECT_EQ(split_words(" # nothing"), Words{});
  EXPECT_THROW(split_words("a \"b"), modeler::CommandError);
  EXPECT_EQ(modeler::without_comment("  create \"a # b\" x # c"), "create \"a # b\" x");
}

TEST(CommandLine, AnyTextIsAWord) {
  for (const std::string text : {"a", "a b", "", "#", "a#", "\"", "\\", "a\\\"b", "ã", " \\"})
    EXPECT_EQ(modeler::split_words("x " + modeler::as_word(text) + " y"), (Words{"x", text, "y"}));
  EXPECT_EQ(modeler::as_word("plain"), "plain");
}

TEST(NearestName, IsTheOneThatWasMeant) {
  const auto nearest = [](const char* wanted, Words known) -> std::string {
    modeler::NearestName name(wanted);
    for (const std::string& one : known) name.offer(one);
    return name.found() ? name.name() : "-";
  };
  EXPECT_EQ(nearest("bloa", {"base", "bola", "furo"}), "bola");
  EXPECT_EQ(nearest("MACA", {"Maçã", "mala"}), "Maçã");
  EXPECT_EQ(nearest("Cálic", {"Cálice à mesa", "Cal"}), "Cálice à mesa");
  EXPECT_EQ(nearest("furadeira", {"bola", "furo"}), "-");
  EXPECT_EQ(nearest("x", {"y", "z"}), "-");
  EXPECT_EQ(nearest("bola", {}), "-");
}

class Completion : public ModelerTest {
 protected:
  Completion() {
    say_all({"create bola sphere 1", "create \"bola furada\" sphere 1", "create Cálice cone 1"});
  }
  Words words(const std::string& line) { return modeler::complete(interpreter, line).words; }
};

TEST_F(Completion, OffersWhatFits) {
  EXPECT_THAT(words("cr"), ElementsAre("create"));
  EXPECT_THAT(words("CRI"), ElementsAre("cria"));
  EXPECT_THAT(words("co"), ElementsAre("combine", "copy"));
  EXPECT_EQ(words("").size(), modeler::commands().size());
  EXPECT_THAT(words("delete "), ElementsAre("Cálice", "bola", "\"bola furada\""));
  EXPECT_THAT(words("deleta bo"), ElementsAre("bola", "\"bola furada\""));
  EXPECT_THAT(words("delete cal"), ElementsAre("Cálice"));
  EXPECT_THAT(words("delete \"bola "), ElementsAre("\"bola furada\""));
  EXPECT_THAT(words("delete bola "), ElementsAre());
  EXPECT_THAT(words("create x c"), ElementsAre("cone", "cube", "cylinder"));
  EXPECT_THAT(words("create x esf"), ElementsAre("esfera"));
  EXPECT_THAT(words("combine x bola d"), ElementsAre("difference"));
  EXPECT_THAT(words("combine x bola union C"), ElementsAre("Cálice"));
  EXPECT_THAT(words("combine x bola union Cálice "), ElementsAre("apart"));
  EXPECT_THAT(words("rotate bola "), ElementsAre("x", "y", "z"));
  EXPECT_THAT(words("rotate bola x "), ElementsAre());
  EXPECT_THAT(words("transform bola t"), ElementsAre("translation"));
  EXPECT_THAT(words("inspect bola w"), ElementsAre("warnings"));
  EXPECT_THAT(words("help und"), ElementsAre("undo"));
  EXPECT_THAT(words("show bola x.png --s"), ElementsAre("--scene", "--shaded", "--size"));
  EXPECT_THAT(words("delete bola # "), ElementsAre());
  EXPECT_THAT(words("nonsense b"), ElementsAre());
}

TEST_F(Completion, OffersLooks) {
  EXPECT_THAT(words("cam"), ElementsAre("camera"));
  EXPECT_THAT(words("surf"), ElementsAre("surface", "surfaces"));
  EXPECT_THAT(words("camera p"), ElementsAre("pan", "parallel", "perspective"));
  EXPECT_THAT(words("camera target "), ElementsAre());
  EXPECT_THAT(words("câmera alvo 1 2 3 f"), ElementsAre("focal"));
  EXPECT_THAT(words("camera target 1 2 3 focal "), ElementsAre("auto"));
  EXPECT_THAT(words("camera target 1 2 3 focal auto p"), ElementsAre("parallel", "perspective"));
  EXPECT_THAT(words("camera turn 1 "), ElementsAre());
  EXPECT_THAT(words("camera frame b"), ElementsAre("bola", "\"bola furada\""));
  EXPECT_THAT(words("light a"), ElementsAre("add", "ambient", "auto"));
  EXPECT_THAT(words("luz fu"), ElementsAre("fundo"));
  EXPECT_THAT(words("light set a"), ElementsAre("add", "ambient"));
  EXPECT_THAT(words("light set ambient 1 b"), ElementsAre("background"));
  EXPECT_THAT(words("light move "), ElementsAre());
  EXPECT_THAT(words("surfaces "), ElementsAre("delete", "load", "save"));
  EXPECT_THAT(words("surface 1 in"), ElementsAre("index"));
  EXPECT_THAT(words("surface 1 name x sp"), ElementsAre("specular"));
  EXPECT_THAT(words("surface 1 colour "), ElementsAre());
  EXPECT_THAT(words("surface "), ElementsAre());
  EXPECT_THAT(words("view g"), ElementsAre("ghosts", "grid"));
  EXPECT_THAT(words("view grid "), ElementsAre("off", "on"));
  EXPECT_THAT(words("view grid on "), ElementsAre());
  EXPECT_THAT(words("select C"), ElementsAre("Cálice"));
  EXPECT_THAT(words("script "), ElementsAre("load", "save"));
  EXPECT_THAT(words("undo "), ElementsAre("camera"));
  folder.write("x.CAM", "");
  const std::string at = folder.path().string() + "/";
  for (const char* line :
       {"camera load ", "camera save ", "light load ", "surfaces save ", "script save "})
    EXPECT_THAT(words(line + at), ElementsAre(at + "x.CAM")) << line;
  EXPECT_THAT(words("surfaces delete " + at), ElementsAre());
}

TEST_F(Completion, OffersFiles) {
  folder.write("um.CSG", "");
  folder.write("um dois.CSG", "");
  std::filesystem::create_directory(folder / "pasta");
  const std::string at = folder.path().string() + "/";
  EXPECT_THAT(words("load x " + at),
              ElementsAre(at + "pasta/", "\"" + at + "um dois.CSG\"", at + "um.CSG"));
  EXPECT_THAT(words("save bola " + at + "p"), ElementsAre(at + "pasta/"));
  EXPECT_THAT(words("load x " + at + "none/"), ElementsAre());
}

TEST_F(Completion, SaysWhereTheWordBegins) {
  EXPECT_EQ(modeler::complete(interpreter, "delete bo").begin, 7u);
  EXPECT_EQ(modeler::complete(interpreter, "delete \"bo").begin, 7u);
  EXPECT_EQ(modeler::complete(interpreter, "delete ").begin, 7u);
  EXPECT_EQ(modeler::common_start({"cone", "cosa"}), "co");
  EXPECT_EQ(modeler::common_start({"a\xC3\xA1", "a\xC3\xA3"}), "a");
  EXPECT_EQ(modeler::common_start({}), "");
}

}  // namespace
}  // namespace sir::test
