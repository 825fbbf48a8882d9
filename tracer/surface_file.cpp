// .SUP (BASICO, thesis 3.3; textures 2.4.4).
#include <algorithm>
#include <set>

#include "tracer/scene_file.h"

namespace sir {
namespace {

Coefficients read_coefficients(TextFile& file, const std::string& where) {
  std::array<double, 10> k{};
  file.read_numbers(where + "coefficients kar kag kab kdr kdg kdb ks n kt ir", k);
  for (std::size_t i = 0; i < 9; ++i)
    if (k[i] < 0) file.fail(where + "coefficients must not be negative");
  if (k[8] > 0 && !(k[9] > 0))
    file.fail(where + "a surface that transmits light (kt > 0) needs a refraction index > 0");
  if (k[9] < 0) file.fail(where + "the refraction index must not be negative");
  return {{k[0], k[1], k[2]}, {k[3], k[4], k[5]}, k[6], k[7], k[8], k[9]};
}

void read_chequer(TextFile& file, const std::string& where, Surface& surface) {
  file.expect(where + "numbers of cells nu nv of XADREZ");
  const auto tokens = split_tokens(file.line());
  if (tokens.size() != 2 || !parse_count(tokens[0], surface.cells_u) ||
      !parse_count(tokens[1], surface.cells_v) || surface.cells_u < 1 || surface.cells_v < 1)
    file.fail(where + "XADREZ goes on with two positive integers nu nv");
  surface.second = read_coefficients(file, where);
}

}  // namespace

std::vector<Surface> read_surfaces(TextFile& file) {
  std::vector<Surface> surfaces;
  std::set<std::int64_t> numbers;
  const auto announced = file.read_count("the number of surfaces");
  require_at_most(file, announced, "surfaces");
  constexpr std::size_t kLeastBytes = 28;  // a surface has more
  surfaces.reserve(std::min(static_cast<std::size_t>(announced), file.size() / kLeastBytes));
  for (std::int64_t i = 0; i < announced; ++i) {
    if (file.at_end())
      file.fail("the file announces " + counted(announced, "surface") + " and ends after " +
                std::to_string(i));
    Surface surface;
    surface.number = file.read_count("a surface's number");
    if (!numbers.insert(surface.number).second)
      file.fail("surface " + std::to_string(surface.number) + " stands twice in the file");
    file.expect("the name of surface " + std::to_string(surface.number));
    surface.name = file.line();
    const std::string where =
        "surface " + std::to_string(surface.number) + " " + in_quotes(surface.name) + ": ";
    file.expect(where + "the texture");
    const auto word = fold_keyword(file.line());
    if (word != "lisa" && word != "xadrez")
      file.fail(where + "unknown texture " + in_quotes(file.line()) + " (LISA or XADREZ)");
    surface.first = read_coefficients(file, where);
    if (word == "xadrez") {
      surface.texture = TextureKind::chequer;
      read_chequer(file, where, surface);
    }
    surfaces.push_back(std::move(surface));
  }
  if (file.next())
    file.fail("the file announces " + counted(announced, "surface") + " and goes on");
  return surfaces;
}

}  // namespace sir
