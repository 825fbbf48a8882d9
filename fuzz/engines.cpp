#include "fuzz/engines.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/target.h"
#include "tests/instruction_sets.h"
#include "tests/plain_image.h"
#include "tracer/recentre.h"
#include "tracer/trace.h"

namespace sir::fuzz {
namespace {

void require_same(const Planes& found, const Planes& plain, const std::string& way) {
  if (found == plain) return;
  std::size_t p = 0;
  while (found.at(p) == plain.at(p)) ++p;
  const auto width = static_cast<std::size_t>(plain.size.width);
  require(false, "an image is the same by " + way + " as by the plain engine: column " +
                     std::to_string(p % width) + ", row " + std::to_string(p / width));
}

template <typename T>
Planes image_in(const Scene& original, RenderOptions options) {
  const Recentred moved(original, offset_for(original, options.precision));
  const Scene& scene = moved;
  const Model<T> model(scene, options.trace.possible_effects());
  const Planes plain = test::plain_image(model, options);
  options.threads = 1;
  options.trace.packets = false;
  options.trace.engine = Engine::roth;
  require_same(render_model(model, options).planes, plain, "bounded rays");
  options.trace.engine = Engine::gates;
  require_same(render_model(model, options).planes, plain, "gates");
  options.trace.packets = true;
  test::with_each_instruction_set([&](const std::string& set) {
    require_same(render_model(model, options).planes, plain, "packets (" + set + ")");
  });
  return plain;
}

}  // namespace

Planes image_by_all_engines(const Scene& scene, RenderOptions options) {
  switch (options.precision) {
    case Precision::float_: return image_in<float>(scene, options);
    case Precision::double_: return image_in<double>(scene, options);
    case Precision::long_double: return image_in<long double>(scene, options);
  }
  return Planes();
}

}  // namespace sir::fuzz
