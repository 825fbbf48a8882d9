// What each command does to the viewer.
#include <algorithm>

#include "tracer/error.h"
#include "viewer/png_file.h"
#include "viewer/screenshot.h"
#include "viewer/viewer.h"

namespace sir::viewer {

void Viewer::perform(Command command) {
  using enum Command;
  stale_ = true;
  composed_ = false;
  if (player_ && needs_pictures(command))
    return say("a register trace is played, which has no pictures; see sir show");
  const std::size_t count = workshop_.count();
  switch (command) {
    case next_image:
      if (count > 0) turn_to((number_ + 1) % count);
      return;
    case previous_image:
      if (count > 0) turn_to((number_ + count - 1) % count);
      return;
    case reload:
      if (count > 0) workshop_.reload(number_);
      return;
    case true_colour: return choose(Method::true_colour);
    case lut_file: return choose(Method::lut_file);
    case rgb_median: return choose(Method::rgb_median);
    case rgb_frequency: return choose(Method::rgb_frequency);
    case hsv_median: return choose(Method::hsv_median);
    case hsv_frequency: return choose(Method::hsv_frequency);
    case best: return choose(Method::best);
    case flip_reference: reference_held_ = !reference_held_; return;
    case heat_map: return show_map(Map::heat);
    case duel_map: return show_map(Map::duel);
    case split: return toggle_duel();
    case other_side:
      if (!duel_) toggle_duel();
      active_ = 1 - active_;
      return say(active_ == 0 ? "keys choose for the left side" : "keys choose for the right side");
    case plane_1:
    case plane_2:
    case plane_3:
    case plane_4:
    case plane_5:
    case plane_6:
    case plane_7:
    case plane_8: {
      const int plane = static_cast<int>(command) - static_cast<int>(plane_1);
      planes_ = static_cast<std::uint8_t>(planes_ ^ (1u << plane));
      mask_lifted_ = false;
      return set_masks();
    }
    case all_planes:
      planes_ = 0xFF;
      mask_lifted_ = false;
      return set_masks();
    case read_mask: mask_lifted_ = !mask_lifted_; return set_masks();
    case crt: return toggle_crt();
    case image_area: return toggle_area();
    case zoom_in: return zoom(+1);
    case zoom_out: return zoom(-1);
    case fit: return viewport_.fit();
    case actual_size: return viewport_.set_multiple(1);
    case values: values_on_ = !values_on_; return;
    case full_screen: full_screen_ = !full_screen_; return;
    case pan_left: return viewport_.pan(viewport_.window().width / 8, 0);
    case pan_right: return viewport_.pan(-viewport_.window().width / 8, 0);
    case pan_up: return viewport_.pan(0, viewport_.window().height / 8);
    case pan_down: return viewport_.pan(0, -viewport_.window().height / 8);
    case inspector:
      inspector_open_ = !inspector_open_;
      refresh();
      return;
    case go_to_pixel: return prompt_.ask(Prompt::Kind::pixel);
    case pin_entry: return pin_entry_of_pixel();
    case panel: return toggle_panel();
    case screenshot: return save_screen();
    case screenshot_as_seen: return save_as_seen();
    case step_forward:
    case step_back:
    case leap_forward:
    case leap_back:
    case trace_start:
    case trace_end: return step(command);
    case palette: return prompt_.ask(Prompt::Kind::command);
    case key_sheet: key_sheet_open_ = !key_sheet_open_; return;
    case cancel: return this->cancel();
    case quit: closed_ = true; return;
  }
}

void Viewer::choose(Method method) {
  active().choose(method);
  if (map_ != Map::none && method == Method::true_colour) map_ = Map::none;
  refresh();
}

void Viewer::toggle_duel() {
  duel_ = !duel_;
  if (!duel_) {
    active_ = 0;
    if (map_ == Map::duel) map_ = Map::none;
    return;
  }
  // Two sides of the same would tell nothing: the thesis's own comparison to begin with.
  if (!sides_[1].chosen())
    sides_[1].choose(sides_[0].shown_method() == Method::rgb_median ? Method::hsv_median
                                                                    : Method::rgb_median);
  split_column_ = viewport_.window().width > 0 ? middle_column() : split_column_;
  set_masks();
  refresh();
}

int Viewer::middle_column() const {
  const auto middle =
      viewport_.pixel_at({viewport_.window().width / 2, viewport_.window().height / 2});
  return middle ? middle->x : sides_[0].station().seen_area().size.width / 2;
}

void Viewer::show_map(Map map) {
  map_ = map_ == map ? Map::none : map;
  if (map_ == Map::duel && !duel_) toggle_duel();
  const auto true_colour = [&](int side) {
    return sides_[static_cast<std::size_t>(side)].chosen() == Method::true_colour;
  };
  const bool a = true_colour(0), b = true_colour(duel_ ? 1 : 0);
  if ((map_ == Map::duel && (a || b)) || (map_ == Map::heat && a && b)) {
    map_ = Map::none;
    say("true colour is what maps compare with: choose a method first");
  }
  refresh();
}

void Viewer::set_masks() {
  const std::uint8_t mask = mask_lifted_ ? 0xFF : planes_;
  for (Side& side : sides_) side.station().set_planes(mask);
}

void Viewer::toggle_area() {
  const bool only = !sides_[0].station().image_area_only();
  for (Side& side : sides_) {
    side.station().set_image_area_only(only);
    side.show_again();
  }
  pinned_.reset();
  viewport_.set_picture(sides_[0].station().seen_area().size);
  split_column_ = middle_column();
}

void Viewer::zoom(int steps, std::optional<Place> anchor) {
  int multiple = viewport_.multiple();
  for (; steps > 0; --steps) multiple = next_multiple(multiple);
  for (; steps < 0; ++steps) multiple = previous_multiple(multiple);
  viewport_.set_multiple(multiple, anchor);
}

void Viewer::nudge(int right, int down) {
  const ImageSize size = sides_[0].station().seen_area().size;
  const Place from = inspected().value_or(Place{size.width / 2, size.height / 2});
  pinned_ = Place{std::clamp(from.x + right, 0, size.width - 1),
                  std::clamp(from.y + down, 0, size.height - 1)};
  viewport_.reveal(*pinned_);
  stale_ = true;
}

void Viewer::go_to(Place image_pixel) {
  if (!player_ && !sides_[0].picture()) return say("there is no picture yet");
  const ImageSize size = player_ ? eltek::Ma120::kSize : sides_[0].picture()->planes.size;
  if (image_pixel.x < 0 || image_pixel.y < 0 || image_pixel.x >= size.width ||
      image_pixel.y >= size.height)
    return say(std::string(player_ ? "the screen" : "the image") + " has columns 0 to " +
               std::to_string(size.width - 1) + " and rows 0 to " +
               std::to_string(size.height - 1));
  const auto seen = player_ ? image_pixel : sides_[0].station().seen_pixel(image_pixel);
  if (!seen) return say("that pixel is beyond the screen's edge, which cuts the image");
  pinned_ = *seen;
  inspector_open_ = true;
  viewport_.reveal(*seen);
}

void Viewer::pin_entry_of_pixel() {
  if (entry_) return pin_entry(std::nullopt);
  const auto at = inspected();
  if (!at) return say("point at a pixel first");
  const auto screen = side(side_of(*at)).station().capture();
  // The right side may still have a picture of another size.
  if (at->x >= screen.size.width || at->y >= screen.size.height)
    return say("that side has no such pixel yet");
  if (duel_) active_ = side_of(*at);
  pin_entry(
      screen.indices[static_cast<std::size_t>(at->y) * static_cast<std::size_t>(screen.size.width) +
                     static_cast<std::size_t>(at->x)]);
}

std::string Viewer::stem(const Side& shown) const {
  if (player_) return trace_name_;
  return shown.picture() ? shown.picture()->base.filename().string() : "sir";
}

// The show goes on where a screenshot cannot be written.
void Viewer::save_screen() {
  try {
    const Side& shown = active();
    if (!player_ && !shown.picture()) return say("there is nothing to save yet");
    const auto screen = player_ ? player_->raster().capture() : shown.station().capture();
    if (!screen) return say("the frame has more than one palette; Shift+S saves it as it is seen");
    const auto path = free_name(options_.screenshots, stem(shown) + "-screen");
    write_indexed_png(path, *screen);
    say("saved " + path.string());
  } catch (const FileError& error) {
    say(error.what());
  }
  options_.report(message_);
}

void Viewer::save_as_seen() {
  try {
    const auto path = free_name(options_.screenshots, stem(sides_[0]) + "-seen");
    // The tube's spot, scan lines and shape are too dear to follow every key.
    const bool alone = crt_on_ && !duel_ && !player_ && map_ == Map::none && !reference_held_ &&
                       !sides_[0].true_colour() && !entry();
    if (alone && !crt_.options().is_colour_map())
      write_rgb_png(path, eltek::to_planes(crt_.show(sides_[0].station().capture())));
    else write_rgb_png(path, to_planes(picture()));
    say("saved " + path.string());
  } catch (const FileError& error) {
    say(error.what());
  }
  options_.report(message_);
}

void Viewer::toggle_panel() {
#ifdef SIR_WITH_IMGUI
  panel_open_ = !panel_open_;
  hover_entry(std::nullopt);  // there is no field left to leave
  refresh();
#else
  say("this build has no panel (it was made without Dear ImGui)");
#endif
}

void Viewer::toggle_crt() {
  crt_on_ = !crt_on_;
  say(crt_on_ ? "monitor: a tube (" + crt_text() + ")"
              : "monitor: ideal, code e is byte round(255 e / 63)");
}

void Viewer::cancel() {
  if (key_sheet_open_) key_sheet_open_ = false;
  else if (entry_) pin_entry(std::nullopt);
  else if (pinned_) pinned_.reset();
  else if (map_ != Map::none) map_ = Map::none;
  else if (inspector_open_) inspector_open_ = false;
  else if (panel_open_) toggle_panel();
  else if (full_screen_) full_screen_ = false;
  else closed_ = true;
}

}  // namespace sir::viewer
