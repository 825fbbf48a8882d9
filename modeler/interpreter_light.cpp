// Light and surfaces by commands (thesis 3.3, 3.6.3).
#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/look_text.h"
#include "modeler/look_words.h"
#include "modeler/view.h"
#include "tracer/scene_file.h"

namespace sir::modeler {
namespace {

constexpr const char* kIntensity = "a light's intensity";

std::string text_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string text_of(const Lighting& lighting) {
  std::string text = fmt::format("background {}\nambient {}\n", text_of(lighting.background),
                                 text_of(lighting.ambient));
  for (std::size_t i = 0; i < lighting.lights.size(); ++i)
    text +=
        fmt::format("light {}: at {}, intensity {}\n", i + 1, text_of(lighting.lights[i].position),
                    text_of(lighting.lights[i].intensity));
  return text;
}

}  // namespace

Lighting Interpreter::lighting() const {
  return looks_.lighting ? *looks_.lighting : made_up_lighting(camera());
}

Reply Interpreter::light_command(Arguments& words) {
  if (words.left() == 0)
    return {(looks_.lighting ? "" : "# made up\n") + text_of(lighting()), {}, {}, false};
  const LightWord word = value_of(light_words(), words.next(), "word of light");
  const bool made_up = !looks_.lighting;
  const Lighting made = made_up ? lighting() : Lighting{};
  const Lighting& now = made_up ? made : *looks_.lighting;
  // A light by its number, and its index.
  const auto one = [&] {
    const std::int64_t number = words.count("light");
    const auto lights = static_cast<std::int64_t>(now.lights.size());
    if (number < 1 || number > lights)
      throw CommandError(fmt::format(
          "there is no light {}: {}", number,
          lights == 0 ? "there are none" : fmt::format("they count from 1 to {}", lights)));
    return static_cast<std::size_t>(number - 1);
  };
  const auto replace = [&](glm::dvec3 Lighting::*shade, const char* what, std::string done) {
    const glm::dvec3 colour = words.colour(what);
    words.end();
    return change_light(words, ShadeChange{shade, now.*shade, colour}, std::move(done));
  };
  const auto all = [&](std::optional<Lighting> lighting, std::string done) {
    words.end();
    return record({words.text(), {}, {LightingChange{looks_.lighting, std::move(lighting)}}, {}},
                  std::move(done));
  };
  switch (word) {
    case LightWord::background:
      return replace(&Lighting::background, "the background", "light: background set");
    case LightWord::ambient:
      return replace(&Lighting::ambient, "the ambient light", "light: ambient set");
    case LightWord::add: {
      const glm::dvec3 position = words.vector();
      const Light light{position, words.colour(kIntensity)};
      words.end();
      const std::size_t index = now.lights.size();
      return change_light(words, LightChange{index, std::nullopt, light},
                          fmt::format("light {}: added", index + 1));
    }
    case LightWord::move:
    case LightWord::colour:
    case LightWord::erase: {
      const std::size_t index = one();
      const Light before = now.lights[index];
      std::optional<Light> after = before;
      if (word == LightWord::move) after->position = words.vector();
      else if (word == LightWord::colour) after->intensity = words.colour(kIntensity);
      else after.reset();
      words.end();
      return change_light(words, LightChange{index, before, after},
                          fmt::format("light {}: {}", index + 1, after ? "set" : "deleted"));
    }
    case LightWord::set: {
      Lighting lighting;
      while (words.left() > 0) {
        switch (value_of(light_words(), words.next(), "word of light set")) {
          case LightWord::background: lighting.background = words.colour("the background"); break;
          case LightWord::ambient: lighting.ambient = words.colour("the ambient light"); break;
          case LightWord::add: {
            const glm::dvec3 position = words.vector();
            lighting.lights.push_back({position, words.colour(kIntensity)});
            break;
          }
          default: words.fail();
        }
      }
      return all(std::move(lighting), "light: set");
    }
    case LightWord::load: {
      TextFile file = read(file_word(words), "LUZ");
      const Lighting lighting = read_lighting(file);
      Reply reply = all(lighting, "light: that of " + file.name());
      saved_light_ = light_line(lighting);
      return reply;
    }
    case LightWord::made_up: return all(std::nullopt, "light: made up");
    case LightWord::save: {
      const std::filesystem::path file = file_to_write(file_word(words), "LUZ");
      words.end();
      require_writable(file);
      write(file, lighting_text(now));
      saved_light_ = light_line(now);
      const Reply reply{{}, "wrote " + file.string(), {}, false};
      // What is made up hangs on the camera.
      return made_up ? noted(words, file, reply, camera()) : noted(words, file, reply);
    }
  }
  return {};
}

// A made-up light, once it is changed, is the session's own: the script has all of it.
Reply Interpreter::change_light(const Arguments& words, LookChange change, std::string done) {
  if (looks_.lighting) return record({words.text(), {}, {std::move(change)}, {}}, std::move(done));
  Looks changed;
  changed.lighting = lighting();
  apply({change}, changed);
  return record(
      {light_line(*changed.lighting), {}, {LightingChange{std::nullopt, changed.lighting}}, {}},
      std::move(done));
}

}  // namespace sir::modeler
