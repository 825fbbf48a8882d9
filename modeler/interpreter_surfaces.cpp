// Surfaces by commands (thesis 3.3).
#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/look_text.h"
#include "modeler/look_words.h"
#include "modeler/operations.h"
#include "modeler/refusal.h"
#include "modeler/view.h"
#include "tracer/scene_file.h"

namespace sir::modeler {
namespace {

constexpr double kGlass = 1.5;     // index of refraction where light passes and none is given
constexpr double kOddShade = 0.5;  // of the odd cells, until something else is said

std::optional<Surface> find(const Looks& looks, std::int64_t number) {
  const auto found = looks.surfaces.find(number);
  return found == looks.surfaces.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

Reply Interpreter::surfaces_command(Arguments& words) {
  if (words.left() == 0) {
    Reply reply;
    for (const auto& [number, surface] : looks_.surfaces)
      reply.text += surface_line(surface) + "\n";
    if (looks_.surfaces.empty()) reply.text = "no surfaces are described: all are made up\n";
    return reply;
  }
  switch (value_of(surfaces_words(), words.next(), "word of surfaces")) {
    case SurfacesWord::load: {
      TextFile file = read(file_word(words), "SUP");
      words.end();
      const std::vector<Surface> described = read_surfaces(file);
      LookChanges changes;
      for (const auto& [number, surface] : looks_.surfaces)
        changes.push_back(SurfaceChange{number, surface, std::nullopt});
      for (const Surface& surface : described)
        changes.push_back(SurfaceChange{surface.number, std::nullopt, surface});
      Reply reply =
          record({words.text(), {}, std::move(changes), {}},
                 fmt::format("{} of {}", counted(described.size(), "surface"), file.name()));
      saved_surfaces_ = surfaces_text(looks_.surface_list());
      return reply;
    }
    case SurfacesWord::save: {
      const std::filesystem::path file = file_to_write(file_word(words), "SUP");
      words.end();
      require_writable(file);
      std::string text = surfaces_text(looks_.surface_list());
      write(file, text);
      saved_surfaces_ = std::move(text);
      return noted(
          words, file,
          {{},
           fmt::format("wrote {} ({})", file.string(), counted(looks_.surfaces.size(), "surface")),
           {},
           false});
    }
    case SurfacesWord::erase: {
      const std::int64_t number = words.count("surface number");
      words.end();
      const std::optional<Surface> surface = find(looks_, number);
      if (!surface) throw CommandError(fmt::format("surface {} is not described", number));
      return record({words.text(), {}, {SurfaceChange{number, surface, std::nullopt}}, {}},
                    fmt::format("surface {}: made up", number));
    }
  }
  return {};
}

Reply Interpreter::surface_command(Arguments& words) {
  const std::int64_t number = words.count("surface number");
  const std::optional<Surface> before = find(looks_, number);
  Surface surface = before ? *before : made_up_surface(number);
  if (words.left() == 0)
    return {surface_line(surface) + (before ? "\n" : "  # made up\n"), {}, {}, false};
  Coefficients* cells = &surface.first;
  while (words.left() > 0) {
    switch (value_of(surface_words(), words.next(), "word of surface")) {
      case SurfaceWord::name:
        surface.name = words.next();
        require_name(surface.name);
        break;
      case SurfaceWord::colour:
        cells->ambient = cells->diffuse = words.colour("a surface's colour");
        break;
      case SurfaceWord::ambient: cells->ambient = words.colour("a surface's colour"); break;
      case SurfaceWord::diffuse: cells->diffuse = words.colour("a surface's colour"); break;
      case SurfaceWord::specular: cells->specular = words.number(); break;
      case SurfaceWord::exponent: cells->exponent = words.number(); break;
      case SurfaceWord::transmission:
        cells->transmission = words.number();
        if (cells->transmission > 0 && cells->index == 0) cells->index = kGlass;
        break;
      case SurfaceWord::index: cells->index = words.number(); break;
      case SurfaceWord::plain: surface.texture = TextureKind::plain; break;
      case SurfaceWord::chequer:
        if (std::exchange(surface.texture, TextureKind::chequer) == TextureKind::plain) {
          surface.second = surface.first;
          surface.second.ambient *= kOddShade;
          surface.second.diffuse *= kOddShade;
        }
        surface.cells_u = words.count("number of cells");
        surface.cells_v = words.count("number of cells");
        break;
      case SurfaceWord::odd:
        if (surface.texture == TextureKind::plain)
          throw CommandError("only a chequer has odd cells: chequer NU NV goes before odd");
        cells = &surface.second;
        break;
      case SurfaceWord::even: cells = &surface.first; break;
    }
  }
  refusing([&] {
    TextFile file("surface", surfaces_text({surface}));
    read_surfaces(file);
  });
  return record({words.text(), {}, {SurfaceChange{number, before, surface}}, {}},
                fmt::format("surface {}: {}", number, in_quotes(surface.name)));
}

}  // namespace sir::modeler
