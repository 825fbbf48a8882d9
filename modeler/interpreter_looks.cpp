// The commands that change nothing here: show, inspect, list, help (thesis 3.2.2.9 to 3.2.2.11).
#include <algorithm>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/operations.h"
#include "modeler/sampling.h"
#include "modeler/silhouette.h"
#include "modeler/view.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

using Path = std::filesystem::path;

constexpr int kMostPixels = 1 << 26;

struct ShowWords {
  std::string name;
  std::string file;  // empty: in characters
  std::string base;  // of a scene; empty: a camera of our own
  bool shaded = false;
  ImageSize size{0, 0};  // 0: to be chosen
};

ImageSize size_of(const std::string& word) {
  const auto cross = word.find_first_of("xX");
  std::int64_t width = 0, height = 0;
  if (cross == word.npos || !parse_count(std::string_view(word).substr(0, cross), width) ||
      !parse_count(std::string_view(word).substr(cross + 1), height) || width < 1 || height < 1 ||
      width > kMostPixels || height > kMostPixels / width)
    throw CommandError(in_quotes(word) + " is not a size WxH of at most 2^26 pixels");
  return {static_cast<int>(width), static_cast<int>(height)};
}

// BASE.CAM, or the file itself where its suffix is given.
TextFile scene_file(const std::string& base, std::string_view suffix) {
  return TextFile(find_by_suffix(base, suffix));
}

// BASE of BASE.CAM and the like.
std::string base_of(std::string name) {
  const std::string suffix = suffix_of(name);
  for (const char* known : {".cam", ".csg", ".luz", ".sup"})
    if (suffix == known) return Path(name).replace_extension().string();
  return name;
}

CameraFile camera_for(const Node& tree, const std::string& base,
                      const std::optional<CameraFile>& given, double aspect,
                      const std::stop_token& stop) {
  if (!base.empty()) {
    TextFile file = scene_file(base, "CAM");
    return read_camera(file);
  }
  if (given) return *given;
  if (is_empty(tree.bounds))
    throw CommandError("the solid's bounds are empty: there is nothing to look at");
  if (!can_be_framed(tree.bounds))
    throw CommandError("the solid's bounds are too large for a camera to be made up");
  return framing(filled_box(tree, stop), aspect);
}

// The light and the surfaces of BASE, where it has them; numbers that it does not describe keep
// the made-up ones.
void take_looks(const std::string& base, Scene& scene) {
  if (existing_by_suffix(base, "LUZ")) {
    TextFile file = scene_file(base, "LUZ");
    scene.lighting = read_lighting(file);
  }
  if (!existing_by_suffix(base, "SUP")) return;
  TextFile file = scene_file(base, "SUP");
  dress(scene, std::nullopt, read_surfaces(file));
}

bool is_blank(const Planes& lines) {
  return std::all_of(lines.channel[0].begin(), lines.channel[0].end(),
                     [](std::uint8_t value) { return value == 0; });
}

}  // namespace

Reply Interpreter::show(Arguments& words) {
  ShowWords wanted;
  wanted.name = words.next();
  while (words.left() > 0) {
    const std::string word = words.next();
    if (is_word(word, "--shaded", "--sombreado")) wanted.shaded = true;
    else if (is_word(word, "--scene", "--cena")) wanted.base = base_of(file_word(words).string());
    else if (is_word(word, "--size", "--tamanho")) wanted.size = size_of(words.next());
    else if (word.starts_with("--") || !wanted.file.empty()) words.fail();
    else wanted.file = outlet_.locate(word).string();
  }
  const EntryPtr solid = require(solids_, wanted.name);
  const Node& tree = *solid->solid.tree();
  const bool to_file = !wanted.file.empty();
  if (to_file) {
    require_file_name(wanted.file);
    const bool device = is_device(wanted.file);
    if (!device && suffix_of(wanted.file).empty()) wanted.file += ".png";
    if (!device && suffix_of(wanted.file) != ".png")
      throw CommandError(in_quotes(wanted.file) + " is no name of a picture: FILE.png");
    require_writable(wanted.file);
  }
  // It is there, or was when it was shown.
  const auto wrote = [&](Reply reply) {
    reply.done = "wrote " + wanted.file;
    return wanted.base.empty() ? noted(words, wanted.file, reply, looks_.camera)
                               : noted(words, wanted.file, reply);
  };
  if (to_file && repeated_ != nullptr) return wrote({});
  const int columns = std::clamp(outlet_.columns(), 20, 400);
  // A character has 2 by 4 dots; its colours stand for pixels 1 by 2, of which two are joined.
  if (wanted.size.width == 0)
    wanted.size = to_file ? ImageSize{} : ImageSize{2 * columns, 2 * columns * 3 / 4};
  const double aspect = double(wanted.size.width) / wanted.size.height;
  Scene scene = scene_of(tree, camera_for(tree, wanted.base, looks_.camera, aspect, outlet_.stop));
  Planes picture;
  if (wanted.shaded) {
    if (!wanted.base.empty()) take_looks(wanted.base, scene);
    else dress(scene, looks_.lighting, looks_.surface_list());
    RenderOptions options;
    options.size = wanted.size;
    picture = render(scene, options, {}, outlet_.stop).planes;
  } else {
    picture = silhouette(tree, scene, wanted.size, outlet_.stop);
  }
  if (outlet_.stop.stop_requested()) throw CommandError("interrupted");
  Reply reply;
  if (!wanted.shaded && is_blank(picture))
    reply.warnings.push_back("nothing of " + in_quotes(wanted.name) + " is seen");
  if (to_file) {
    outlet_.write_picture(wanted.file, picture);
    return wrote(std::move(reply));
  }
  reply.text = wanted.shaded ? outlet_.draw(picture, columns) : in_dots(picture);
  return reply;
}

Reply Interpreter::inspect(Arguments& words) const {
  const std::string name = words.next();
  Aspect aspect = Aspect::all;
  if (words.left() > 0) aspect = value_of(aspects(), words.next(), "part of what is known");
  words.end();
  Reply reply;
  reply.text = modeler::inspect(name, *require(solids_, name)->solid.tree(), aspect, outlet_.stop);
  if (outlet_.stop.stop_requested()) throw CommandError("interrupted");
  return reply;
}

Reply Interpreter::list() const {
  Reply reply;
  for (const auto& [place, entry] : solids_.entries())
    reply.text += fmt::format("{}: {}\n", in_quotes(entry->name), type_text(*entry->solid.tree()));
  if (solids_.empty()) reply.text = "the list of solids is empty\n";
  return reply;
}

Reply Interpreter::help(Arguments& words) const {
  Reply reply;
  if (words.left() == 0) {
    reply.text = help_text();
    return reply;
  }
  const std::string word = words.next();
  words.end();
  const CommandInfo* info = find_command(word);
  if (info == nullptr) throw CommandError("there is no command " + in_quotes(word));
  reply.text = help_text(*info);
  return reply;
}

}  // namespace sir::modeler
