// What the viewer has to say: whether it is busy, the inspector's lines, the trace's records.
#include <algorithm>

#include <fmt/format.h>

#include "eltek/display_driver.h"
#include "tracer/error.h"
#include "viewer/viewer.h"

namespace sir::viewer {

bool Viewer::busy() const {
  if (player_) return false;
  for (std::size_t i = 0; i < workshop_.count(); ++i)
    if (workshop_.state(i).busy) return true;
  return sides_[0].waiting() || (duel_ && sides_[1].waiting()) || findings_.waiting();
}

std::string Viewer::hopeless() const {
  if (player_ || shown_once_ || workshop_.count() == 0) return {};
  std::string reason;
  for (std::size_t i = 0; i < workshop_.count(); ++i) {
    const Workshop::State state = workshop_.state(i);
    if (!state.picture && !state.failed) return {};
    if (state.picture) {
      const auto oversize =
          sides_[0].station().image_area_only() ? eltek::Oversize::crop : eltek::Oversize::refuse;
      try {
        eltek::place(state.picture->input.string(), state.picture->planes.size, oversize);
        return {};
      } catch (const FileError& error) {
        if (reason.empty()) reason = error.what();
      }
    } else if (reason.empty()) {
      reason = state.message;
    }
  }
  return reason;
}

Findings::Wanted Viewer::wanted_findings() const {
  Findings::Wanted wanted;
  wanted.map = map_;
  wanted.sides = duel_ ? 2 : 1;
  wanted.inspectors = inspector_open_ || panel_open_;
  wanted.judgements = wanted.usage = panel_open_;
  return wanted;
}

std::vector<std::string> Viewer::inspection() const {
  const auto at = inspected();
  if (!at) return {"Inspector", "  point at a pixel; a click keeps it"};
  if (player_) return inspect_machine(*at);
  const int which = side_of(*at);
  const auto pixel = side(which).station().image_pixel(*at);
  if (!pixel)
    return {"Pixel " + std::to_string(at->x) + ", " + std::to_string(at->y) + " of the screen",
            "  beside the image: the entry nearest to black"};
  Inspector* inspector = findings_.inspector(which);
  if (inspector == nullptr) return {"Inspector", "  working it out ..."};
  std::vector<std::string> lines = describe(inspector->inspect(pixel->x, pixel->y));
  if (planes_ != 0xFF && !mask_lifted_) lines.push_back("read mask " + std::to_string(planes_));
  return lines;
}

std::vector<std::string> Viewer::inspect_machine(Place at) const {
  const eltek::Ma120& machine = player_->machine();
  const std::uint8_t index = machine.frame_buffer.read(at.x, at.y);
  const std::uint8_t mask = machine.lut_ports.pixel_mask();
  const auto& code = machine.lut_ports.look_up(index);
  const auto number = [](int value) { return std::to_string(value); };
  return {"Pixel " + number(at.x) + ", " + number(at.y) + " of the screen",
          "  in memory  " + number(index),
          "  under mask " + number(mask) + ": entry " + number(index & mask),
          "  codes      " + number(code[0]) + " " + number(code[1]) + " " + number(code[2])};
}

std::vector<std::string> Viewer::tally() const {
  const Duel* duel = findings_.duel();
  if (duel == nullptr) return {};
  return describe(*duel, std::string(name(sides_[0].shown_method())),
                  std::string(name(sides_[1].shown_method())));
}

std::string Viewer::crt_text() const {
  const eltek::TubeOptions& tube = crt_.tube().options();
  return fmt::format("phosphors {}, white {}, gamma {:g}", eltek::phosphors(tube.phosphors).name,
                     eltek::white(tube.white).name, tube.gamma);
}

void Viewer::replay(eltek::Trace trace, std::string name) {
  player_ = std::make_unique<eltek::TracePlayer>(std::move(trace));
  trace_name_ = std::move(name);
  player_->seek(player_->count());
  viewport_.set_picture(eltek::Ma120::kSize);
  composed_ = false;
  stale_ = true;
}

void Viewer::seek(std::size_t records) {
  if (!player_) return;
  player_->seek(std::min(records, player_->count()));
  const std::size_t at = player_->position();
  say(std::to_string(at) + " of " + std::to_string(player_->count()) + " records; beam at line " +
      std::to_string(player_->raster().position().line()) +
      (at > 0 ? "; " + player_->describe(at - 1) : ""));
  composed_ = false;
}

void Viewer::step(Command command) {
  if (!player_) return say("there is no register trace to step through; see sir replay");
  constexpr std::size_t kLeap = 100;
  const std::size_t at = player_->position(), all = player_->count();
  switch (command) {
    case Command::step_forward: return seek(at + 1);
    case Command::step_back: return seek(at - std::min<std::size_t>(at, 1));
    case Command::leap_forward: return seek(at + kLeap);
    case Command::leap_back: return seek(at - std::min(at, kLeap));
    case Command::trace_start: return seek(0);
    default: return seek(all);
  }
}

}  // namespace sir::viewer
