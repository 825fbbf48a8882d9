#include "viewer/commands.h"

#include <algorithm>
#include <string>

namespace sir::viewer {
namespace {

constexpr std::string_view kPictures = "Pictures", kColours = "Colours", kMachine = "The MA120",
                           kView = "View", kTools = "Tools", kTrace = "Register trace";

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool has_all_words(const std::string& name, std::string_view query) {
  while (!query.empty()) {
    const std::size_t end = query.find(' ');
    const std::string_view word = query.substr(0, end);
    if (name.find(word) == std::string::npos) return false;
    query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
  }
  return true;
}

}  // namespace

std::span<const CommandInfo> commands() {
  using enum Command;
  static const std::vector<CommandInfo> table{
      {next_image, kPictures, "Next picture", {"Page Down", "Right", "Down", "N"}},
      {previous_image, kPictures, "Previous picture", {"Page Up", "Left", "Up"}},
      {reload, kPictures, "Read the files again", {"F5", "Ctrl+R"}},
      {screenshot, kPictures, "Save the screen: indexed PNG, LUT order kept", {"S", "Ctrl+S"}},
      {screenshot_as_seen, kPictures, "Save the picture as it is seen: RGB PNG", {"Shift+S"}},

      {true_colour, kColours, "True colour", {"T"}},
      {rgb_median, kColours, "Median cut in RGB", {"R"}},
      {rgb_frequency, kColours, "Frequency in RGB", {"Shift+R"}},
      {hsv_median, kColours, "Median cut in HSV", {"H"}},
      {hsv_frequency, kColours, "Frequency in HSV", {"Shift+H"}},
      {best, kColours, "Best: chosen on the DAC's lattice", {"B"}},
      {lut_file, kColours, "LUT file", {"L"}},
      {flip_reference, kColours, "Reference while held (or right button)", {"Space"}},
      {heat_map, kColours, "Difference heat map", {"D"}},
      {split, kColours, "LUT duel: two methods side by side", {"V"}},
      {other_side, kColours, "Duel: keys choose for the other side", {"Tab"}},
      {duel_map, kColours, "Duel: which method wins each pixel", {"W"}},

      {plane_1, kMachine, "Plane 1 on or off", {"1"}},
      {plane_2, kMachine, "Plane 2 on or off", {"2"}},
      {plane_3, kMachine, "Plane 3 on or off", {"3"}},
      {plane_4, kMachine, "Plane 4 on or off", {"4"}},
      {plane_5, kMachine, "Plane 5 on or off", {"5"}},
      {plane_6, kMachine, "Plane 6 on or off", {"6"}},
      {plane_7, kMachine, "Plane 7 on or off", {"7"}},
      {plane_8, kMachine, "Plane 8 on or off", {"8"}},
      {all_planes, kMachine, "All planes on", {"0"}},
      {read_mask, kMachine, "Read mask: lift it, or put it back", {"M"}},
      {crt, kMachine, "Monitor: CRT or ideal", {"C"}},

      {zoom_in, kView, "Larger", {"+", "="}},
      {zoom_out, kView, "Smaller", {"-"}},
      {fit, kView, "Largest multiple that fits", {"F", "Ctrl+0"}},
      {actual_size, kView, "One to one", {"Ctrl+1"}},
      {values, kView, "Values on large pixels", {"G"}},
      {image_area, kView, "The image's area alone", {"A"}},
      {full_screen, kView, "Full screen", {"F11"}},
      {pan_left, kView, "Move left", {"Shift+Left"}},
      {pan_right, kView, "Move right", {"Shift+Right"}},
      {pan_up, kView, "Move up", {"Shift+Up"}},
      {pan_down, kView, "Move down", {"Shift+Down"}},

      {inspector, kTools, "Inspector: why this colour (arrows move it)", {"I"}},
      {go_to_pixel, kTools, "Go to pixel ...", {"Ctrl+G"}},
      {pin_entry, kTools, "Show where the pixel's LUT entry is used", {"E"}},
      {panel, kTools, "Panel: LUT, histogram, metrics", {"P"}},

      {step_forward, kTrace, "One register access on", {"."}},
      {step_back, kTrace, "One register access back", {","}},
      {leap_forward, kTrace, "On by 100", {">"}},
      {leap_back, kTrace, "Back by 100", {"<"}},
      {trace_start, kTrace, "To the start", {"Home"}},
      {trace_end, kTrace, "To the end", {"End"}},

      {palette, kTools, "Find a command ...", {"Ctrl+P", ":"}},
      {key_sheet, kTools, "This sheet of keys", {"?", "F1"}},
      {cancel, kTools, "Close what is open, else the window", {"Esc"}},
      {quit, kTools, "Close the window", {"Q", "Ctrl+Q"}},
  };
  return table;
}

bool repeats(Command command) {
  using enum Command;
  switch (command) {
    case next_image:
    case previous_image:
    case zoom_in:
    case zoom_out:
    case pan_left:
    case pan_right:
    case pan_up:
    case pan_down:
    case step_forward:
    case step_back:
    case leap_forward:
    case leap_back: return true;
    default: return false;
  }
}

bool needs_pictures(Command command) {
  using enum Command;
  switch (command) {
    case zoom_in:
    case zoom_out:
    case fit:
    case actual_size:
    case values:
    case full_screen:
    case pan_left:
    case pan_right:
    case pan_up:
    case pan_down:
    case inspector:
    case go_to_pixel:
    case panel:
    case screenshot:
    case screenshot_as_seen:
    case step_forward:
    case step_back:
    case leap_forward:
    case leap_back:
    case trace_start:
    case trace_end:
    case palette:
    case key_sheet:
    case cancel:
    case quit: return false;
    default: return true;
  }
}

std::optional<Command> command_for(const Key& key) {
  for (const CommandInfo& info : commands())
    for (const std::string_view text : info.keys)
      if (parse_key(text) == key) return info.command;
  return std::nullopt;
}

std::vector<const CommandInfo*> find_commands(std::string_view query) {
  const std::string wanted = lower(query);
  std::vector<const CommandInfo*> found;
  for (const CommandInfo& info : commands())
    if (has_all_words(lower(info.name), wanted)) found.push_back(&info);
  std::stable_partition(found.begin(), found.end(), [&](const CommandInfo* info) {
    return lower(info->name).starts_with(wanted);
  });
  return found;
}

}  // namespace sir::viewer
