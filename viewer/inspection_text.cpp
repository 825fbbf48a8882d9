#include <array>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "tracer/intersect.h"
#include "tracer/names.h"
#include "viewer/font.h"
#include "viewer/inspection.h"

namespace sir::viewer {
namespace {

constexpr std::size_t kNameWidth = 24;  // of names that come from files

/// A name of at most kNameWidth letters; what is not of Latin-1 as question marks.
std::string shortened(std::string_view name) {
  std::string text;
  std::size_t letters = 0;
  while (!name.empty()) {
    if (letters++ == kNameWidth) return text + "...";
    std::string_view rest = name;
    const char32_t letter = take_character(rest);
    const bool known = letter < 0x100 && has_glyph(letter);
    if (known) text += name.substr(0, name.size() - rest.size());
    else text += '?';
    name = rest;
  }
  return text;
}

std::string bytes(Rgb8 colour) {
  return fmt::format("{:3} {:3} {:3}", colour.r, colour.g, colour.b);
}

std::string counted(std::uint64_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::array<char, 3> axes(quant::Space space) {
  return space == quant::Space::rgb ? std::array{'r', 'g', 'b'} : std::array{'h', 's', 'v'};
}

/// Writes the lines of one inspection.
class Description {
 public:
  explicit Description(const Inspection& found) : found_(found) {
    place();
    if (found.shown) {
      result(*found.shown);
      nearest(*found.shown);
      why(*found.shown);
      group(*found.shown);
    }
    if (found.ray) ray(*found.ray);
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  template <typename... Values>
  void say(fmt::format_string<Values...> text, Values&&... values) {
    lines_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }
  void gap() { lines_.emplace_back(); }

  void place() {
    std::string text = fmt::format("pixel {},{}", found_.column, found_.row);
    if (!found_.screen) text += " · beyond the screen";
    else text += fmt::format(" · screen {},{}", found_.screen->column, found_.screen->row);
    lines_.push_back(text);
    if (!found_.complete) say("the picture is still being rendered");
    const Rgb8 c = found_.true_colour;
    say("true {}  #{:02X}{:02X}{:02X}", bytes(c), c.r, c.g, c.b);
  }

  void result(const PixelShown& shown) {
    const Rgb8 c = shown.entry.seen;
    say("seen {}  #{:02X}{:02X}{:02X}", bytes(c), c.r, c.g, c.b);
    say("index {} · code {} {} {}", shown.entry.index, shown.code[0], shown.code[1], shown.code[2]);
    say("CIEDE2000 {:.2f} · D² {}", shown.entry.difference, shown.entry.squared);
  }

  void nearest(const PixelShown& shown) {
    gap();
    if (shown.dithered) say("dithered: the entry is not the nearest one");
    two("nearest by the bytes", shown.by_bytes);
    if (shown.by_eye) two("nearest by the eye, as pixels are mapped", *shown.by_eye);
  }

  void two(std::string_view title, const NearestTwo& nearest) {
    say("{}", title);
    const auto entry = [&](const EntryDistance& one) {
      say("  {:3}: {} · D² {} · CIEDE2000 {:.2f}", one.index, bytes(one.seen), one.squared,
          one.difference);
    };
    entry(nearest.winner);
    if (nearest.runner_up) entry(*nearest.runner_up);
  }

  void why(const PixelShown& shown) {
    gap();
    say("why: {}", name(shown.method));
    if (shown.origin) {
      cell(*shown.origin, shown.choice);
      std::visit([&](const auto& how) { made(how, *shown.origin, shown); }, shown.origin->how);
      if (shown.made)
        say("made entry {}: {} · D² {} · CIEDE2000 {:.2f}", shown.made->index,
            bytes(shown.made->seen), shown.made->squared, shown.made->difference);
      if (shown.made && shown.made->index != shown.entry.index)
        say("but {} shows it: {}", shown.entry.index,
            shown.dithered ? "by dithering" : "it came nearer");
    } else if (shown.method == Method::best) {
      const auto& bits = shown.dac.bits;
      say("a code of the DAC's own lattice, {} {} {} bits", bits[0], bits[1], bits[2]);
      say("swaps and nudges moved it there and leave no lineage");
    } else if (shown.method == Method::lut_file) {
      say("out of {}, which does not say why", shortened(shown.lut_name));
    } else {
      say("chosen for an earlier picture, or with other options");
    }
  }

  void cell(const quant::CellOrigin& origin, const quant::ChooseOptions& choice) {
    const auto& at = origin.cell;
    const auto& grid = choice.grid;
    const std::string pixels = counted(origin.pixels, "pixel");
    const std::string entries =
        origin.plane_entries == 1 ? "1 entry" : fmt::format("{} entries", origin.plane_entries);
    const std::string plane = fmt::format("{}, {}, {}", counted(origin.plane_cells, "cell"),
                                          counted(origin.plane_pixels, "pixel"), entries);
    if (choice.space == quant::Space::rgb) {
      say("cell r {} g {} b {} of 0-{}: {}", at[0], at[1], at[2], (1 << choice.rgb_bits) - 1,
          pixels);
      say("grid: {}", plane);
    } else if (origin.grey) {
      say("cell grey {} of 0-{}: {}", at[2], grid.values - 1, pixels);
      say("grey plane: {}", plane);
    } else {
      const double hue = 360.0 * at[0] / grid.hues;
      say("cell h {} ({:g}°) s {} of 0-{} v {} of 0-{}: {}", at[0], hue, at[1],
          grid.saturations - 1, at[2], grid.values - 1, pixels);
      say("plane {} ({:g}°): {}", at[0], hue, plane);
    }
  }

  /// "s 7-29 v 6-29"; within a plane the hue is one, in the grey plane the saturation, too.
  std::string box(const quant::CellBox& box, const quant::ChooseOptions& choice, bool grey) {
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (choice.space == quant::Space::hsv && (axis == 0 || (axis == 1 && grey))) continue;
      text +=
          fmt::format("{}{} {}", text.empty() ? "" : " ", axes(choice.space)[axis], box.low[axis]);
      if (box.high[axis] > box.low[axis]) text += fmt::format("-{}", box.high[axis]);
    }
    return text;
  }

  void made(const quant::NotCounted&, const quant::CellOrigin&, const PixelShown&) {
    say("no counted pixel lies in the cell");
  }

  void made(const quant::OwnEntry&, const quant::CellOrigin&, const PixelShown&) {
    say("no more cells than entries: each has its own");
  }

  void made(const quant::FrequencyRank& rank, const quant::CellOrigin& origin, const PixelShown&) {
    say("rank {} among them: {}", rank.rank, origin.entry ? "chosen" : "not chosen");
    if (origin.plane_entries == 0) say("the plane has no entry at all");
    else say("the last one chosen has {}", counted(rank.last_chosen, "pixel"));
  }

  void made(const quant::CutPath& path, const quant::CellOrigin& origin, const PixelShown& shown) {
    if (!origin.entry) return say("the plane has no entry at all");
    for (const quant::Descent& step : path.splits) {
      const quant::BoxSplit& split = step.split;
      say("  {} · {}{}{}: {} of {}", box(split.box, shown.choice, origin.grey),
          axes(shown.choice.space)[split.axis], step.upper ? ">" : "<=", split.last,
          step.upper ? split.box.pixels - split.lower_pixels : split.lower_pixels,
          split.box.pixels);
    }
    say("  {}: the mean of {} in {}", box(path.box, shown.choice, origin.grey),
        counted(path.box.pixels, "pixel"), counted(path.box.cells, "cell"));
  }

  void group(const PixelShown& shown) {
    const quant::EntryGroup& group = shown.group;
    gap();
    say("entry {} shows {}, {:.2f} %, {}", shown.entry.index, counted(group.pixels, "pixel"),
        100 * static_cast<double>(group.pixels) / static_cast<double>(shown.image_pixels),
        counted(group.colours, "colour"));
    const Rgb8 seen = shown.entry.seen;
    say("  mean {:.1f} {:.1f} {:.1f}, {:.1f} from the entry", group.mean.x, group.mean.y,
        group.mean.z, glm::distance(group.mean, glm::dvec3(seen.r, seen.g, seen.b)));
    say("  spread {:.1f} (root mean square)", group.spread);
    if (shown.nearest_other)
      say("  next entry {}: D² {} · CIEDE2000 {:.2f}", shown.nearest_other->index,
          shown.nearest_other->squared, shown.nearest_other->difference);
  }

  void ray(const RayFind& ray) {
    gap();
    if (!ray.hit) return say("ray: the background");
    say("ray: node {} \"{}\", t {:.6g}", ray.node, shortened(ray.node_name), ray.t);
    say("  {} face {}{}", name_of(ray.kind), ray.face,
        face_count(ray.kind) == 1 ? "" : fmt::format(" ({})", face_name(ray.kind, ray.face)));
    say("  surface {} \"{}\"", ray.surface, shortened(ray.surface_name));
  }

  const Inspection& found_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> describe(const Inspection& inspection) {
  return Description(inspection).take();
}

}  // namespace sir::viewer
