#include "tracer/scene_file.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tests/reason_of.h"
#include "tests/temp_folder.h"

namespace sir {
namespace {

using test::reason_of;
using test::TempFolder;

// The tree of figure 2.5 in small: a cube less a sphere.
const std::string kCsg =
    "3\n\n"                                                         // 1
    "0\ntudo\nCOMPOSTO\nDIFERENÇA\nPRIMITIVO\nPRIMITIVO\n7\n9\n\n"  // 3
    "7\ncaixa azul\nPRIMITIVO\nCUBO\n1 2 1 2 1 2\n"                 // 12
    "2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1\n\n"                        // 17
    "9\nesfera\nPRIMITIVO\nESFERA\n2\n"                             // 22
    "1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1\n\n";                       // 27
const std::string kCam = "4 3\n0 1 2\n0 0 -1\n5\n0 1 0\n";
const std::string kLuz = "0 .1 .2\n0.1 0.2 0.3\n2\n1 2 3 1 .5 .25\n4 5 6 .75\n";
const std::string kSup =
    "2\n\n"
    "1\nazul\nLISA\n.1 .1 .3 0 0 1 .5 20 0 0\n\n"                              // 3
    "2\npiso\nXADREZ\n.1 .1 .1 1 1 1 0 1 .5 1.5\n4 8\n0 0 0 0 0 0 0 0 0 0\n";  // 8

template <typename Result>
Result read_text(Result (*read)(TextFile&), const char* name, const std::string& text) {
  TextFile file(name, text);
  return read(file);
}
CsgTree csg(const std::string& text) { return read_text(read_csg, "B.CSG", text); }
CameraFile cam(const std::string& text) { return read_text(read_camera, "B.CAM", text); }
Lighting luz(const std::string& text) { return read_text(read_lighting, "B.LUZ", text); }
auto sup(const std::string& text) { return read_text(read_surfaces, "B.SUP", text); }

// `text` with line `line` (from 1) replaced; an empty `by` leaves a blank line.
std::string with_line(const std::string& text, std::size_t line, const std::string& by) {
  std::size_t from = 0;
  for (std::size_t i = 1; i < line; ++i) from = text.find('\n', from) + 1;
  return text.substr(0, from) + by + text.substr(text.find('\n', from));
}

// A file that differs from a right one in one line, and what is said of it.
struct Wrong {
  std::size_t line;  ///< replaced
  const char* by;
  std::size_t blamed;  ///< the line named in the error
  const char* reason;  ///< a part of it
};

template <typename Read>
void expect_refusals(const std::string& name, const std::string& good, Read read,
                     const std::vector<Wrong>& wrongs) {
  EXPECT_NO_THROW(read(good));
  for (const Wrong& wrong : wrongs) {
    const std::string said = reason_of([&] { read(with_line(good, wrong.line, wrong.by)); });
    const std::string place = name + ":" + std::to_string(wrong.blamed) + ": ";
    EXPECT_TRUE(said.starts_with(place) && said.find(wrong.reason) != std::string::npos)
        << said << "\n  expected: " << place << wrong.reason;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

// Reading.

TEST(ReadCsg, ReadsTheThesisLayout) {
  const CsgTree tree = csg(kCsg);
  ASSERT_EQ(tree.nodes.size(), 3u);
  const CsgNode& root = tree.nodes[tree.root];
  EXPECT_TRUE(root.composite);
  EXPECT_EQ(root.number, 0);
  EXPECT_EQ(root.operation, Operation::difference);
  const CsgNode& cube = tree.nodes[root.left];
  EXPECT_EQ(cube.number, 7);
  EXPECT_EQ(cube.name, "caixa azul");
  EXPECT_EQ(cube.kind, PrimitiveKind::cube);
  EXPECT_EQ(cube.surfaces, (std::array<std::int64_t, 6>{1, 2, 1, 2, 1, 2}));
  EXPECT_TRUE(cube.surface_per_face);
  EXPECT_EQ(cube.placement.linear, glm::dmat3(2.0));
  const CsgNode& sphere = tree.nodes[root.right];
  EXPECT_EQ(sphere.kind, PrimitiveKind::sphere);
  EXPECT_EQ(sphere.placement.translation, glm::dvec3(1, 2, 3));
  EXPECT_EQ(sphere.line, 22u);
}

TEST(ReadCsg, MatrixLinesAreTheImagesOfTheAxes) {
  const auto tree = csg("1\n5\nn\nprimitivo\ncilindro\n1\n1 2 3 0\n0 4 5 0\n0 0 6 0\n7 8 9 1");
  const Placement& placement = tree.nodes[0].placement;
  EXPECT_EQ(placement.linear[0], glm::dvec3(1, 2, 3));  // row vectors: p' = p M
  EXPECT_EQ(placement.linear[1], glm::dvec3(0, 4, 5));
  EXPECT_EQ(placement.translation, glm::dvec3(7, 8, 9));
  EXPECT_EQ(tree.nodes[0].surfaces[2], 1);
}

TEST(ReadCsg, NodesMayStandInAnyOrder) {
  const std::string leaf = "\nn\nPRIMITIVO\nCONE\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  const std::string middle = "5\nn\nCOMPOSTO\nUNIAO\nPRIMITIVO\nPRIMITIVO\n70\n3\n";
  const std::string root =
      "9223372036854775807\nn\nCOMPOSTO\nintersecao\nCOMPOSTO\nPRIMITIVO\n5\n0\n";
  const auto tree = csg("5\n3" + leaf + middle + "0" + leaf + root + "70" + leaf);
  EXPECT_EQ(tree.root, 3u);
  EXPECT_EQ(tree.nodes[tree.root].left, 1u);
  EXPECT_EQ(tree.nodes[tree.root].right, 2u);
  EXPECT_EQ(tree.nodes[1].left, 4u);
  EXPECT_EQ(tree.nodes[1].right, 0u);
}

TEST(ReadCsg, EncodingsLineEndsAndBlankLinesDoNotMatter) {
  const std::string plain = csg_text(csg(kCsg));
  std::string crlf, airy, latin1 = kCsg;
  for (const char letter : kCsg) {
    crlf += letter == '\n' ? "\r\n" : std::string(1, letter);
    airy += letter == '\n' ? " \n\t\n\n" : std::string(1, letter);
  }
  latin1.replace(latin1.find("Ç"), 2, "\xC7");
  EXPECT_EQ(csg_text(csg(crlf)), plain);
  EXPECT_EQ(csg_text(csg(airy)), plain);
  EXPECT_EQ(csg_text(csg(latin1)), plain);
  EXPECT_EQ(csg_text(csg("\xEF\xBB\xBF" + kCsg)), plain);
}

TEST(ReadCamera, ReadsFiveLinesOrSix) {
  const CameraFile camera = cam(kCam);
  EXPECT_EQ(camera.window, glm::dvec2(4, 3));
  EXPECT_EQ(camera.target, glm::dvec3(0, 1, 2));
  EXPECT_EQ(camera.distance, 5);
  EXPECT_EQ(camera.focal, 5);
  EXPECT_FALSE(camera.focal_given || camera.parallel);
  EXPECT_EQ(cam(kCam + "2.5\n").focal, 2.5);
  for (const char* word : {"PARALELA", "paralela", " Paralela "})
    EXPECT_TRUE(cam(kCam + word + "\n").parallel);
  EXPECT_EQ(cam(with_line(kCam, 4, "0") + "1\n").distance, 0);
  EXPECT_TRUE(cam(with_line(kCam, 4, "0") + "PARALELA").parallel);
}

TEST(ReadLighting, ReadsColoursOrSingleIntensities) {
  const Lighting lighting = luz(kLuz);
  EXPECT_EQ(lighting.background, glm::dvec3(0, .1, .2));
  EXPECT_EQ(lighting.ambient, glm::dvec3(.1, .2, .3));
  ASSERT_EQ(lighting.lights.size(), 2u);
  EXPECT_EQ(lighting.lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(lighting.lights[0].intensity, glm::dvec3(1, .5, .25));
  EXPECT_EQ(lighting.lights[1].intensity, glm::dvec3(.75));
  EXPECT_EQ(luz("0 0 0\n0.5\n0\n").ambient, glm::dvec3(.5));
}

TEST(ReadSurfaces, ReadsPlainAndChequered) {
  const auto surfaces = sup(kSup);
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].texture, TextureKind::plain);
  EXPECT_EQ(surfaces[0].first.ambient, glm::dvec3(.1, .1, .3));
  EXPECT_EQ(surfaces[0].first.diffuse, glm::dvec3(0, 0, 1));
  EXPECT_EQ(surfaces[0].first.specular, .5);
  EXPECT_EQ(surfaces[0].first.exponent, 20);
  EXPECT_EQ(surfaces[1].texture, TextureKind::chequer);
  EXPECT_EQ(surfaces[1].first.transmission, .5);
  EXPECT_EQ(surfaces[1].first.index, 1.5);
  EXPECT_EQ(surfaces[1].cells_u, 4);
  EXPECT_EQ(surfaces[1].cells_v, 8);
  EXPECT_EQ(surfaces[1].second.exponent, 0);
}

// Malformed files.

TEST(ReadCsg, RefusesEveryWrongLine) {
  expect_refusals(
      "B.CSG", kCsg, csg,
      {{1, "0", 1, "at least one node"},
       {1, "-1", 1, "\"-1\" is not a non-negative integer"},
       {1, "3 3", 1, "\"3 3\" is not"},
       {1, "4", 31, "announces 4 nodes and ends after 3"},
       {1, "4611686018427387904", 1,
        "announces 4611686018427387904 nodes; at most 250000 nodes are taken"},
       {1, "2", 22, "announces 2 nodes and goes on"},
       {3, "7", 12, "node 7 stands twice"},
       {3, "x", 3, "a node's number: \"x\" is not"},
       {5, "MISTO", 5, "node 0 \"tudo\": type: COMPOSTO or PRIMITIVO expected, found \"MISTO\""},
       {6, "MENOS", 6, "node 0 \"tudo\": unknown operation \"MENOS\""},
       {7, "COMPOSTO", 9, "node 0 \"tudo\": node 7 is not COMPOSTO"},
       {8, "PRIMITVO", 8, "type of the right node: COMPOSTO or PRIMITIVO expected"},
       {9, "8", 9, "node 0 \"tudo\": node 8 is not in the file"},
       {9, "7.0", 9, "number of the left node: \"7.0\" is not"},
       {10, "7", 10, "node 7 already belongs to node 0"},
       {15, "PIRAMIDE", 15, "node 7 \"caixa azul\": unknown primitive \"PIRAMIDE\""},
       {16, "1 2", 16, "1 surface number for all faces or 6, one per face, expected; 2 found"},
       {16, "1 2 1 2 1 a", 16, "surface number \"a\" is not"},
       {17, "2 0 0", 17, "line 1 of LOCAL_CENA: 4 numbers expected, 3 found"},
       {18, "0 nan 0 0", 18, "line 2 of LOCAL_CENA: \"nan\" is not a finite number"},
       {18, "0 -inf 0 0", 18, "\"-inf\" is not a finite number"},
       {18, "0 1e999 0 0", 18, "\"1e999\" is not a finite number"},
       {18, "0 1,5 0 0", 18, "\"1,5\" is not a finite number"},
       {18, "0 2 0 0.5", 18, "the fourth column of LOCAL_CENA must be 0 0 0 1"},
       {20, "0 0 0 2", 20, "the fourth column of LOCAL_CENA must be 0 0 0 1"},
       {19, "0 2 0 0", 17, "node 7 \"caixa azul\": LOCAL_CENA is singular"},
       {19, "0 0 0 0", 17, "LOCAL_CENA is singular"},
       {30, "", 31, "line 4 of LOCAL_CENA should stand"},
       {31, "mais", 31, "announces 3 nodes and goes on"}});
}

TEST(ReadCsg, RefusesWhatIsNoTree) {
  const auto composite = [](int number, int left, int right) {
    return std::to_string(number) + "\nn\nCOMPOSTO\nUNIAO\nCOMPOSTO\nCOMPOSTO\n" +
           std::to_string(left) + "\n" + std::to_string(right) + "\n";
  };
  const auto leaf = [](int number) {
    return std::to_string(number) + "\nn\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  };
  const auto said = [](const std::string& text) { return reason_of([&] { csg(text); }); };
  EXPECT_EQ(said("2\n" + leaf(4) + leaf(6)),
            "B.CSG:11: node 6 \"n\": a second root; node 4 is named by none either");
  EXPECT_EQ(said("1\n" + composite(1, 1, 1)),
            "B.CSG:9: node 1 \"n\": node 1 already belongs to node 1");
  // A circle beside the tree, and nothing but a circle.
  const std::string mixed =
      "1\nn\nCOMPOSTO\nUNIAO\nCOMPOSTO\nPRIMITIVO\n2\n5\n"
      "2\nn\nCOMPOSTO\nUNIAO\nCOMPOSTO\nPRIMITIVO\n1\n6\n" +
      leaf(5) + leaf(6);
  EXPECT_EQ(said("5\n" + leaf(3) + mixed),
            "B.CSG:11: node 1 \"n\": belongs to a circle of nodes, not to the tree");
  EXPECT_EQ(said("4\n" + mixed),
            "B.CSG:2: node 1 \"n\": belongs to a circle of nodes, not to the tree");
}

TEST(ReadCsg, LongNamesAndControlCharactersStayOutOfTheError) {
  const std::string text = "1\n4\n" + std::string(500'000, 'n') + "\nPRIMITIVO\n\x1B[31m" +
                           std::string(500'000, '\0') + "\n";
  const std::string said = reason_of([&] { csg(text); });
  EXPECT_TRUE(said.starts_with("B.CSG:5: node 4 \"nnn")) << said.substr(0, 200);
  EXPECT_LT(said.size(), 300u);
  EXPECT_EQ(said.find('\x1B'), std::string::npos);
}

TEST(ReadCamera, RefusesEveryWrongLine) {
  expect_refusals("B.CAM", kCam, cam,
                  {{1, "4", 1, "window width and height: 2 numbers expected, 1 found"},
                   {1, "0 3", 1, "must be > 0"},
                   {1, "4 -3", 1, "must be > 0"},
                   {2, "0 0 x", 2, "target: \"x\" is not a finite number"},
                   {3, "0 0 0", 3, "the normal direction must not be zero"},
                   {4, "-1", 4, "must not be negative"},
                   {4, "0", 4, "a sixth line must give a focal distance or PARALELA"},
                   {4, "nan", 4, "\"nan\" is not a finite number"},
                   {5, "0 0 0", 5, "the up vector must not be zero or parallel"},
                   {5, "0 0 7", 5, "the up vector must not be zero or parallel"},
                   {5, "", 5, "the file ends where up vector should stand"}});
  expect_refusals(
      "B.CAM", kCam + "1\n", cam,
      {{6, "0", 6, "must be one number > 0, or PARALELA"},
       {6, "1 1", 6, "must be one number > 0, or PARALELA"},
       {6, "PARALELO", 6, "focal distance (or PARALELA): \"PARALELO\" is not a finite number"},
       {6, "1\n\n1", 8, "this is one more"}});
}

TEST(ReadLighting, RefusesEveryWrongLine) {
  expect_refusals("B.LUZ", kLuz, luz,
                  {{1, "0 0", 1, "background colour: 3 numbers expected, 2 found"},
                   {1, "0 0 -1", 1, "background colour must not be negative"},
                   {2, "1 2", 2, "ambient light: one number or three expected, 2 found"},
                   {2, "-1", 2, "ambient light must not be negative"},
                   {3, "2.5", 3, "the number of lights: \"2.5\" is not"},
                   {3, "3", 5, "announces 3 lights and ends after 2"},
                   {3, "1", 5, "announces 1 light and goes on"},
                   {4, "1 2 3 1 1", 4, "light 1: x y z r g b or x y z i expected, 5 numbers found"},
                   {4, "1 2 3 1 1 -1", 4, "light 1's intensity must not be negative"},
                   {5, "1 2 inf 1", 5, "light 2: \"inf\" is not a finite number"}});
}

TEST(ReadSurfaces, RefusesEveryWrongLine) {
  expect_refusals(
      "B.SUP", kSup, sup,
      {{1, "3", 13, "announces 3 surfaces and ends after 2"},
       {1, "1", 8, "announces 1 surface and goes on"},
       {3, "-1", 3, "a surface's number: \"-1\" is not"},
       {8, "1", 8, "surface 1 stands twice"},
       {5, "LISO", 5, "surface 1 \"azul\": unknown texture \"LISO\""},
       {5, "", 6, "unknown texture \".1 .1 .3 0 0 1 .5 20 0 0\""},  // the texture line missing
       {6, "1 2 3", 6, "kar kag kab kdr kdg kdb ks n kt ir: 10 numbers expected, 3 found"},
       {6, ".1 .1 .3 0 0 -1 .5 20 0 0", 6, "coefficients must not be negative"},
       {6, ".1 .1 .3 0 0 1 .5 -2 0 0", 6, "coefficients must not be negative"},
       {6, ".1 .1 .3 0 0 1 .5 20 .1 0", 6, "needs a refraction index > 0"},
       {12, "4", 12, "XADREZ goes on with two positive integers nu nv"},
       {12, "4 0", 12, "two positive integers"},
       {12, "4 2.5", 12, "two positive integers"},
       {13, "", 13, "surface 2 \"piso\": coefficients"},
       {13, "0 0 0 0 0 0 0 0 1 -1", 13, "needs a refraction index > 0"}});
}

TEST(Readers, AnEmptyFileIsSaidToEnd) {
  for (const std::string text : {"", "\n \n"}) {
    EXPECT_NE(reason_of([&] { csg(text); }).find("the file ends where"), std::string::npos);
    EXPECT_NE(reason_of([&] { cam(text); }).find("the file ends where"), std::string::npos);
    EXPECT_NE(reason_of([&] { luz(text); }).find("the file ends where"), std::string::npos);
    EXPECT_NE(reason_of([&] { sup(text); }).find("the file ends where"), std::string::npos);
  }
}

// No prefix of a file, and no random bytes, do anything but read or be refused.
TEST(Readers, SurviveTruncationAndNoise) {
  std::mt19937 random(11);
  int refused = 0;
  for (std::size_t length = 0; length < kCsg.size() - 3; ++length)
    refused += reason_of([&] { csg(kCsg.substr(0, length)); }) != "no error";
  EXPECT_EQ(refused, static_cast<int>(kCsg.size() - 3));
  for (const std::string& good : {kCsg, kCam, kLuz, kSup})
    for (int i = 0; i < 500; ++i) {
      std::string text = good;
      for (int j = 0; j < 3; ++j) text[random() % text.size()] = static_cast<char>(random());
      reason_of([&] { csg(text); });
      reason_of([&] { cam(text); });
      reason_of([&] { luz(text); });
      reason_of([&] { sup(text); });
    }
}

// Whole scenes.

void write_four(const TempFolder& folder) {
  folder.write("B.CSG", kCsg);
  folder.write("B.CAM", kCam);
  folder.write("B.LUZ", kLuz);
  folder.write("B.SUP", kSup);
}

TEST(ReadScene, ReadsAndWritesTheFourFiles) {
  const TempFolder folder;
  write_four(folder);
  const Scene scene = read_scene(folder / "B");
  EXPECT_EQ(scene.tree.nodes.size(), 3u);
  EXPECT_EQ(scene.surfaces.size(), 2u);
  write_scene(folder / "c.1", scene);
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"B.CAM", "B.CSG", "B.LUZ", "B.SUP", "c.1.CAM",
                                                     "c.1.CSG", "c.1.LUZ", "c.1.SUP"}));
  EXPECT_EQ(csg_text(read_scene(folder / "c.1").tree), csg_text(scene.tree));
  EXPECT_EQ(folder.read("c.1.SUP"), surfaces_text(scene.surfaces));
}

TEST(ReadScene, SuffixesMayBeInLowerCase) {
  const TempFolder folder;
  write_four(folder);
  for (const auto& [upper, lower] : {std::pair("B.CSG", "B.csg"), std::pair("B.CAM", "B.cam"),
                                     std::pair("B.LUZ", "B.luz"), std::pair("B.SUP", "B.sup")}) {
    std::filesystem::rename(folder / upper, folder / lower);
    EXPECT_NO_THROW(read_scene(folder / "B"));
  }
  folder.write("B.sup", "1\n\n9\nn\nLISA\n0 0 0 0 0 0 0 0 0 0\n");
  EXPECT_TRUE(reason_of([&] { read_scene(folder / "B"); }).ends_with("B.sup"));
}

TEST(ReadScene, SaysWhichFileIsMissingAndWhereItWasSought) {
  for (const char* suffix : {"CSG", "CAM", "LUZ", "SUP"}) {
    const TempFolder folder;
    write_four(folder);
    std::filesystem::remove(folder / (std::string("B.") + suffix));
    const std::string upper = (folder / "B.").string() + suffix;
    std::string lower = upper;
    for (std::size_t i = lower.size() - 3; i < lower.size(); ++i)
      lower[i] = static_cast<char>(lower[i] - 'A' + 'a');
    EXPECT_EQ(reason_of([&] { read_scene(folder / "B"); }),
              upper + ": is missing (looked for " + upper + " and " + lower + ")");
  }
}

TEST(ReadScene, SurfacesMustBeDescribed) {
  const TempFolder folder;
  write_four(folder);
  folder.write("B.CSG", with_line(kCsg, 16, "1 2 1 2 1 3"));
  EXPECT_EQ(reason_of([&] { read_scene(folder / "B"); }),
            (folder / "B.CSG").string() +
                ":16: node 7 \"caixa azul\": surface 3 is not described in " +
                (folder / "B.SUP").string());
}

TEST(ReadCsg, AChainOfAHundredThousandUnionsIsReadAndFreed) {
  constexpr int kUnions = 100'000;
  const std::string leaf = "\nfolha\nPRIMITIVO\nESFERA\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n";
  std::string text = std::to_string(2 * kUnions + 1) + "\n\n";
  for (int i = 0; i < kUnions; ++i)  // unions are 0, 1, ..; leaves follow
    text += std::to_string(i) + "\nu\nCOMPOSTO\nUNIÃO\n" +
            (i + 1 < kUnions ? "COMPOSTO" : "PRIMITIVO") + "\nPRIMITIVO\n" + std::to_string(i + 1) +
            "\n" + std::to_string(kUnions + 1 + i) + "\n\n";
  for (int i = kUnions; i <= 2 * kUnions; ++i) text += std::to_string(i) + leaf;
  const CsgTree tree = csg(text);
  ASSERT_EQ(tree.nodes.size(), 2u * kUnions + 1);
  std::size_t deepest = tree.root;
  while (tree.nodes[deepest].composite) deepest = tree.nodes[deepest].left;
  EXPECT_EQ(tree.nodes[deepest].number, kUnions);
}

}  // namespace
}  // namespace sir
