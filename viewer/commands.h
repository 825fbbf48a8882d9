// Everything that the viewer can be told, in one table: keys, key sheet and command palette come
// from it. The thesis's display program (3.5) knew one command.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "viewer/key.h"

namespace sir::viewer {

enum class Command : std::uint8_t {
  next_image,
  previous_image,
  reload,
  true_colour,
  lut_file,
  rgb_median,
  rgb_frequency,
  hsv_median,
  hsv_frequency,
  best,
  flip_reference,
  heat_map,
  split,
  other_side,
  duel_map,
  plane_1,
  plane_2,
  plane_3,
  plane_4,
  plane_5,
  plane_6,
  plane_7,
  plane_8,
  all_planes,
  read_mask,
  crt,
  image_area,
  zoom_in,
  zoom_out,
  fit,
  actual_size,
  values,
  full_screen,
  pan_left,
  pan_right,
  pan_up,
  pan_down,
  inspector,
  go_to_pixel,
  pin_entry,
  panel,
  screenshot,
  screenshot_as_seen,
  step_forward,
  step_back,
  leap_forward,
  leap_back,
  trace_start,
  trace_end,
  palette,
  key_sheet,
  cancel,
  quit
};

/// A command as a person meets it.
struct CommandInfo {
  Command command;
  std::string_view group;              ///< heading on the key sheet
  std::string_view name;               ///< in the palette
  std::vector<std::string_view> keys;  ///< as parse_key reads them; the first is the one to learn
};

/// All commands, group by group.
std::span<const CommandInfo> commands();

/// Whether a held key does it again and again: moving, zooming and stepping, but no switching.
bool repeats(Command command);

/// Whether it needs pictures: a register trace that is played has none.
bool needs_pictures(Command command);

/// What a key is for; none where it is for nothing.
std::optional<Command> command_for(const Key& key);

/// The commands whose names have all words of the query, in any case, as parts; those that begin
/// with it first. All of them for an empty query.
std::vector<const CommandInfo*> find_commands(std::string_view query);

}  // namespace sir::viewer
