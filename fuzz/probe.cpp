// What `sir probe` is asked on standard input, of one small solid.
#include <algorithm>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "fuzz/targets.h"
#include "tracer/probe_text.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {
namespace {

// All four primitives and operations of all kinds: a cube with a bore, a ball that shares some of
// it, and a cone whose base lies in a face of the cube.
constexpr std::string_view kSolid = R"(7
0
all
COMPOSTO
UNIAO
COMPOSTO
PRIMITIVO
1
6
1
bored
COMPOSTO
DIFERENCA
COMPOSTO
PRIMITIVO
2
5
2
round
COMPOSTO
INTERSECAO
PRIMITIVO
PRIMITIVO
3
4
3
cube
PRIMITIVO
CUBO
1 2 3 4 5 6
1 0 0 0
0 1 0 0
0 0 1 0
-0.5 -0.5 -0.5 1
4
ball
PRIMITIVO
ESFERA
7
0.7 0 0 0
0 0.7 0 0
0.1 0 0.7 0
0 0 0 1
5
bore
PRIMITIVO
CILINDRO
8
0.2 0 0 0
0 2 0 0
0 0 0.2 0
0 -1 0 1
6
hat
PRIMITIVO
CONE
9
0.5 0 0 0
0 0.5 0 0
0 0 0.5 0
0 0.5 0 1
)";

Scene solid() {
  Scene scene;
  TextFile file("solid.CSG", std::string(kSolid));
  scene.tree = read_csg(file);
  for (std::int64_t number = 1; number <= 9; ++number) {
    Surface surface;
    surface.number = number;
    scene.surfaces.push_back(surface);
  }
  return scene;
}

struct Pair {
  std::unique_ptr<Prober> fast, plain;
  Pair(const Scene& scene, Precision precision)
      : fast(make_prober(scene, precision, Engine::gates)),
        plain(make_prober(scene, precision, Engine::roth)) {}
};

void check_answer(const std::string& text, bool good) {
  require(std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n',
          "a line is answered by a line");
  const auto answer = nlohmann::json::parse(text);
  require(answer.is_object() && answer.size() == 1 && answer.contains(good ? "hits" : "error"),
          "an answer has hits, or an error");
  if (!good) return;
  const nlohmann::json* before = nullptr;
  for (const auto& hit : answer["hits"]) {
    const double t = hit["t"];
    require(t >= 0, "no boundary lies behind the ray's origin");
    require(before == nullptr || (*before)["t"] <= t, "boundaries come in the order of t");
    require(before == nullptr || (*before)["side"] != hit["side"], "in and out take turns");
    before = &hit;
  }
  require(before == nullptr || (*before)["side"] == "out", "a bounded solid is left in the end");
}

void play_line(std::string_view line, Pair& probers) {
  std::string fast, plain;
  const bool good = answer_ray(*probers.fast, line, fast);
  require(answer_ray(*probers.plain, line, plain) == good && plain == fast,
          "every engine finds the same boundaries");
  if (!fast.empty()) check_answer(fast, good);
  else require(good && split_tokens(line).empty(), "only a blank line goes without an answer");
}

}  // namespace

void play_probe(Bytes bytes) {
  static Pair in_double(solid(), Precision::double_), in_float(solid(), Precision::float_);
  std::string_view rest = text_of(bytes);
  while (!rest.empty()) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const auto line = rest.substr(0, end);
    play_line(line, in_double);
    play_line(line, in_float);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

}  // namespace sir::fuzz
