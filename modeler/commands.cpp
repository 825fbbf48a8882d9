#include "modeler/commands.h"

#include <unordered_map>

#include <fmt/format.h>

#include "modeler/command_error.h"
#include "modeler/look_words.h"
#include "modeler/nearest_name.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

constexpr CommandInfo kCommands[] = {
    {Command::create, "create", "cria", "NAME cube|sphere|cone|cylinder SURFACE...",
     "A primitive at its standard place; one surface number for all faces, or one for each.",
     "nk-"},
    {Command::transform, "transform", "transforma", "NAME translation|scale|rotation|matrix ...",
     "The same as translate, scale, rotate or matrix.", "st-"},
    {Command::translate, "translate", "translada", "NAME x y z", "Moves a solid.", "s-"},
    {Command::scale, "scale", "escala", "NAME x y z [centre] | NAME factor [centre]",
     "Scales a primitive about the origin, a composite, or with the word centre any solid, about "
     "the centre of its bounds. Negative factors mirror; 0 is refused.",
     "s-m"},
    {Command::rotate, "rotate", "gira", "NAME x|y|z DEGREES [centre]",
     "Turns about an axis through the origin or, a composite or with the word centre, through the "
     "centre of its bounds: counter-clockwise, seen from the axis's positive end.",
     "sx-m"},
    {Command::matrix, "matrix", "matriz", "NAME m11 m12 m13 m21 ... m43 (12 numbers, or 16)",
     "Transforms by a matrix for row vectors, p' = p M, about the origin: its four lines of three "
     "numbers, or of four, the fourth column 0 0 0 1.",
     "s-"},
    {Command::paint, "paint", "pinta", "NAME SURFACE...",
     "Other surface numbers for a primitive, one for all faces or one for each; or one for all "
     "that "
     "is in a composite.",
     "s-"},
    {Command::combine, "combine", "combina",
     "NAME LEFT union|difference|intersection RIGHT [apart]",
     "Makes one solid of two, which become its parts. Difference and intersection of solids whose "
     "bounds do not meet are refused, but with the word apart.",
     "nsosp"},
    {Command::operation, "operation", "operação", "NAME union|difference|intersection [apart]",
     "Another operation for a composite; refused as combine would refuse it.", "sop"},
    {Command::edit, "edit", "edita", "NAME PLACE COMMAND... [apart]",
     "Changes a part of a solid in place, as if it were split down to the part and combined again. "
     "PLACE is the part's number in inspect NAME tree, COMMAND one of translate, scale, rotate, "
     "matrix, transform, paint, operation, label without its NAME.",
     "sNE"},
    {Command::erase, "delete", "deleta", "NAME", "Takes a solid off the list.", "s"},
    {Command::copy, "copy", "copia", "SOURCE DESTINATION", "The same solid under a second name.",
     "sn"},
    {Command::split, "split", "desfaz", "NAME",
     "Takes a composite apart; its two parts take its place, under the names of their nodes.", "s"},
    {Command::rename, "rename", "renomeia", "NAME NEW", "Another name for a solid.", "sn"},
    {Command::label, "label", "rotula", "NAME TEXT",
     "Another name for a solid's root in the .CSG alone, where names may repeat.", "s-"},
    {Command::number, "number", "numera", "NAME NUMBER [POSITION]",
     "The number of a solid's root in the .CSG, and its position among the nodes (by their "
     "numbers). "
     "Both are kept where all nodes of what is saved have them, no two the same.",
     "s-"},
    {Command::save, "save", "salva", "NAME FILE",
     "Writes a solid: FILE.CSG, or where FILE ends in .model the commands that make it.", "sf"},
    {Command::load, "load", "carrega", "NAME FILE", "Reads a solid that was saved.", "nf"},
    {Command::show, "show", "mostra", "NAME [FILE.png] [--shaded] [--scene BASE] [--size WxH]",
     "The silhouette, or the solid shaded, as a picture or in characters: as BASE.CAM says (and "
     "BASE.LUZ and BASE.SUP, shaded), else as camera, light and surface have been set, else from "
     "the front, right and above.",
     "sf"},
    {Command::inspect, "inspect", "verifica",
     "NAME [bounds|matrices|surfaces|tree|volume|warnings]",
     "Tells what is known of a solid, or one part of it.", "sa"},
    {Command::camera, "camera", "câmera",
     "[window W H] [target X Y Z] [normal X Y Z] [distance D] [up X Y Z] [focal F|auto] "
     "[parallel|perspective] | load FILE | save FILE | frame [NAME] | turn RIGHT DOWN | "
     "pan RIGHT DOWN | zoom STEPS | auto",
     "The camera, as in a .CAM: what is not named stays. frame has all, or one solid, in its "
     "window; turn goes around the target and pan moves it, by parts of the picture; zoom makes "
     "the window a tenth smaller a step; auto has it made up again. Alone, tells it.",
     "C"},
    {Command::light, "light", "luz",
     "background R G B | ambient R G B | add X Y Z R G B | move N X Y Z | colour N R G B | "
     "delete N | set [background R G B] [ambient R G B] [add X Y Z R G B]... | load FILE | "
     "save FILE | auto",
     "The light, as in a .LUZ; N counts from 1, one number does for three equal ones. set says all "
     "of it: what is not named is black; auto has it made up again. Alone, tells it.",
     "L"},
    {Command::surfaces, "surfaces", "superfícies", "load FILE | save FILE | delete NUMBER",
     "All surfaces that are described, as in a .SUP; load puts those of the file in their place. "
     "Alone, tells them.",
     "U"},
    {Command::surface, "surface", "superfície",
     "NUMBER [name TEXT] [colour R G B] [ambient R G B] [diffuse R G B] [specular KS] "
     "[exponent N] [transmission KT] [index IR] [plain | chequer NU NV] [odd|even ...]",
     "Describes a surface: what is not named stays, or is as it is made up. colour is ambient and "
     "diffuse in one; behind odd, all is of the odd cells of a chequer, behind even of the others. "
     "A number alone tells it.",
     "-F"},
    {Command::view, "view", "vista", "[ghosts|axes|bounds|grid|silhouette|alone on|off]",
     "What the window shows besides the solids: what differences take away, lines, or the selected "
     "solid alone. Alone, tells it.",
     "VO"},
    {Command::select, "select", "seleciona", "[NAME [PLACE [FACE]]]",
     "What the window has selected: a solid, the node at a place of its tree (0 the solid itself, "
     "each node before its parts, the left one first), a face of a primitive. Alone, nothing.",
     "s--"},
    {Command::list, "list", "lista", "", "The solids that there are.", ""},
    {Command::script, "script", "roteiro", "load FILE | save FILE",
     "The commands that make all that is there now, written to FILE.model; load does those of a "
     "file, and where one of them cannot be done, none. Alone, tells them.",
     "T"},
    {Command::undo, "undo", "anula", "[camera]",
     "Takes back the last command that changed solids, light or surfaces; or the camera's last.",
     "h"},
    {Command::redo, "redo", "refaz", "[camera]", "Does again what was taken back.", "h"},
    {Command::forget, "forget", "esquece", "",
     "Ends what undo and redo could bring back, and frees its memory. The session's script stays.",
     ""},
    {Command::recover, "recover", "recupera", "[SESSION] | --list | --discard [SESSION|all]",
     "Brings back the last session that was not ended, or ended with something not saved, or the "
     "one that is named, in the place of what there is. --list tells them, --discard forgets one.",
     "J-"},
    {Command::help, "help", "ajuda", "[COMMAND]", "What there is to be said of a command, or all.",
     "c"},
    {Command::quit, "quit", "sai", "", "Ends the session.", ""},
};

constexpr Word<PrimitiveKind> kKinds[] = {{"cube", "cubo", PrimitiveKind::cube},
                                          {"sphere", "esfera", PrimitiveKind::sphere},
                                          {"cone", "cone", PrimitiveKind::cone},
                                          {"cylinder", "cilindro", PrimitiveKind::cylinder}};
constexpr Word<Operation> kOperations[] = {{"union", "união", Operation::union_of},
                                           {"difference", "diferença", Operation::difference},
                                           {"intersection", "interseção", Operation::intersection}};
constexpr Word<Step::Kind> kTransforms[] = {{"translation", "translação", Step::Kind::translation},
                                            {"scale", "escala", Step::Kind::scale},
                                            {"rotation", "rotação", Step::Kind::rotation},
                                            {"matrix", "matriz", Step::Kind::matrix}};
constexpr Word<Aspect> kAspects[] = {
    {"bounds", "envoltórios", Aspect::bounds},     {"matrices", "matrizes", Aspect::matrices},
    {"surfaces", "superfícies", Aspect::surfaces}, {"tree", "árvore", Aspect::tree},
    {"volume", "volume", Aspect::volume},          {"warnings", "avisos", Aspect::warnings}};

const std::unordered_map<std::string, const CommandInfo*>& by_name() {
  static const auto table = [] {
    std::unordered_map<std::string, const CommandInfo*> known;
    for (const CommandInfo& info : kCommands) {
      known.emplace(info.name, &info);
      known.emplace(fold_keyword(info.portuguese), &info);
    }
    return known;
  }();
  return table;
}

}  // namespace

std::span<const CommandInfo> commands() { return kCommands; }
std::span<const Word<PrimitiveKind>> kinds() { return kKinds; }
std::span<const Word<Operation>> operations() { return kOperations; }
std::span<const Word<Step::Kind>> transforms() { return kTransforms; }
std::span<const Word<Aspect>> aspects() { return kAspects; }

const CommandInfo* find_command(std::string_view word) {
  const auto found = by_name().find(fold_keyword(word));
  return found == by_name().end() ? nullptr : found->second;
}

bool is_for_parts(Command command) {
  switch (command) {
    case Command::transform:
    case Command::translate:
    case Command::scale:
    case Command::rotate:
    case Command::matrix:
    case Command::paint:
    case Command::operation:
    case Command::label: return true;
    default: return false;
  }
}

bool is_word(std::string_view word, std::string_view english, std::string_view portuguese) {
  if (word == english || word == portuguese) return true;  // needs no folding
  const std::string folded = fold_keyword(word);
  return folded == english || folded == fold_keyword(portuguese);
}

template <typename Value>
Value value_of(std::span<const Word<Value>> words, std::string_view word, std::string_view what) {
  std::string names;
  NearestName nearest(word);
  for (const Word<Value>& known : words) {
    if (is_word(word, known.english, known.portuguese)) return known.value;
    names += (names.empty() ? "" : ", ") + std::string(known.english);
    nearest.offer(known.english);
    nearest.offer(known.portuguese);
  }
  throw CommandError(fmt::format("{} is no {}: {}{}", in_quotes(word), what, names,
                                 nearest.found() ? "; did you mean " + nearest.name() + "?"
                                                 : "; a name with spaces goes in quotes"));
}

template PrimitiveKind value_of(std::span<const Word<PrimitiveKind>>, std::string_view,
                                std::string_view);
template Operation value_of(std::span<const Word<Operation>>, std::string_view, std::string_view);
template Step::Kind value_of(std::span<const Word<Step::Kind>>, std::string_view, std::string_view);
template Aspect value_of(std::span<const Word<Aspect>>, std::string_view, std::string_view);
template CameraWord value_of(std::span<const Word<CameraWord>>, std::string_view, std::string_view);
template LightWord value_of(std::span<const Word<LightWord>>, std::string_view, std::string_view);
template SurfacesWord value_of(std::span<const Word<SurfacesWord>>, std::string_view,
                               std::string_view);
template SurfaceWord value_of(std::span<const Word<SurfaceWord>>, std::string_view,
                              std::string_view);
template bool ViewSettings::*value_of(std::span<const Word<bool ViewSettings::*>>, std::string_view,
                                      std::string_view);
template bool value_of(std::span<const Word<bool>>, std::string_view, std::string_view);
template ScriptWord value_of(std::span<const Word<ScriptWord>>, std::string_view, std::string_view);

namespace {

constexpr std::size_t kForms = 24;  // where the forms begin in the help
constexpr std::size_t kWidth = 76;  // of the forms

// A form in lines: what is long is broken between the ways to say it, or its groups of words.
std::string in_lines(std::string_view form) {
  std::string lines;
  while (form.size() > kWidth) {
    std::size_t at = form.npos;
    int depth = 0;
    for (std::size_t i = 0; i + 1 < form.size() && (i <= kWidth || at == form.npos); ++i) {
      depth += (form[i] == '[') - (form[i] == ']');
      const char next = form[i + 1];
      if (i > 0 && depth == 0 && form[i] == ' ' && (next == '|' || next == '[')) at = i;
    }
    if (at == form.npos) break;
    lines.append(form.substr(0, at)).append("\n").append(kForms, ' ');
    form.remove_prefix(at + 1);
  }
  return lines.append(form);
}

}  // namespace

std::string help_text(const CommandInfo& info) {
  return fmt::format("{}{}{}  ({})\n  {}\n", info.name, info.form.empty() ? "" : " ", info.form,
                     info.portuguese, info.help);
}

std::string help_text() {
  std::string text;
  for (const CommandInfo& info : kCommands)
    text += fmt::format("{:<10} {:<11}  {}\n", info.name, info.portuguese, in_lines(info.form));
  return text +
         "Names with white space or # go in quotes; # begins a comment. help COMMAND says more.\n";
}

}  // namespace sir::modeler
