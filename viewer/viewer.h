// The viewer without its window: pictures on one or two MA120s, and what a person does to them
// (thesis 3.5). Everything here is tested without a display.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "eltek/crt.h"
#include "eltek/trace_player.h"
#include "viewer/commands.h"
#include "viewer/findings.h"
#include "viewer/frame.h"
#include "viewer/key.h"
#include "viewer/prompt.h"
#include "viewer/side.h"
#include "viewer/viewport.h"
#include "viewer/workshop.h"

namespace sir::viewer {

struct ViewerOptions {
  WorkshopOptions workshop;
  bool image_area_only = false;             ///< see Station
  std::filesystem::path screenshots = ".";  ///< folder of the screenshots
  std::optional<eltek::CrtOptions> crt;     ///< start with that monitor; none: ideal
  eltek::BusListener* listener = nullptr;   ///< hears all that happens to the MA120 of side 0
  /// Told where a screenshot went, or why it went nowhere, and what else a person should know.
  std::function<void(const std::string&)> report = [](const std::string&) {};
};

enum class Button : std::uint8_t { left, middle, right };

/// One for the window's thread. What takes time is the workshop's (viewer/workshop.h); whoever
/// owns a viewer calls refresh() when the workshop wakes him, and draws when stale() says so.
///
/// Places are in window pixels, from its upper left corner.
class Viewer {
 public:
  explicit Viewer(ViewerOptions options);

  /// Opens a further picture in the background and turns to it where `show` says so.
  void open(const std::filesystem::path& input, bool show);

  /// Plays a register trace on an MA120 of its own instead of showing pictures: those that are
  /// opened from then on are refused with a message. `name` is for titles and screenshots.
  void replay(eltek::Trace trace, std::string name);

  /// A key goes down: to an open prompt, else to the command that it is for. Returns whether it
  /// was for anything.
  bool press(const Key& key);
  void release(const Key& key);

  /// Text as the keyboard's layout makes it; characters such as ? that need other keys on other
  /// keyboards are commands, too, unless press() has just taken the key.
  void type(std::string_view text);

  void point(Place at);
  void press(Button button, Place at);
  void release(Button button, Place at);
  void wheel(int steps, Place at);

  void perform(Command command);

  /// The part of the window that is the picture's, in pixels.
  void set_window(ImageSize window);

  /// Takes in what the workshop has ready. Returns whether anything is to be drawn anew.
  bool refresh();

  /// Whether something is to be drawn anew. picture() does not change that; whoever draws calls
  /// drawn(), after which a change makes it stale again.
  bool stale() const { return stale_; }
  void drawn() { stale_ = false; }

  /// What is seen, one word a pixel of the picture.
  const Frame& picture();

  /// Grows with each picture() that is another than the one before.
  std::uint64_t picture_version() const { return picture_version_; }

  /// How it lies in the window.
  const Viewport& viewport() const { return viewport_; }

  /// Picture, LUT, the DAC where it is not the MA120's, the number among several, the planes where
  /// some are off, the multiple, and the message.
  std::string title() const;

  /// The latest thing to know: where a screenshot went, how far a render is, why a file cannot be
  /// shown; empty where there is nothing.
  const std::string& message() const { return message_; }

  /// Whether what is on the screen is not yet all that was asked for.
  bool busy() const;

  /// Why there is nothing to look at and will not be; empty: there is, or was, or may be. What has
  /// been seen once stays, with a message, whatever becomes of the files.
  std::string hopeless() const;

  bool closed() const { return closed_; }
  bool full_screen() const { return full_screen_; }
  bool panel_open() const { return panel_open_; }

  /// Whether the window has a panel beside the picture, which then says what the overlay would.
  bool panel_shown() const { return panel_shown_; }
  void set_panel_shown(bool shown) { panel_shown_ = shown; }
  bool inspector_open() const { return inspector_open_; }
  bool key_sheet_open() const { return key_sheet_open_; }
  bool values_on() const { return values_on_; }
  const Prompt& prompt() const { return prompt_; }

  std::size_t number() const { return number_; }
  const Workshop& workshop() const { return workshop_; }
  std::uint8_t planes() const { return planes_; }
  bool mask_lifted() const { return mask_lifted_; }

  /// Side 0 is the MA120; side 1 is the other half of a duel. Keys choose for the active one.
  const Side& side(int which) const { return sides_[static_cast<std::size_t>(which)]; }
  int active_side() const { return active_; }
  bool duel() const { return duel_; }

  /// The first column of the right side, in pixels of the picture.
  int split_column() const { return split_column_; }
  /// The side on which a pixel of the picture lies.
  int side_of(Place pixel) const { return duel_ && pixel.x >= split_column_ ? 1 : 0; }

  /// What is laid over the screen.
  bool shows_reference() const { return reference_held_; }
  Map map() const { return map_; }
  bool crt_on() const { return crt_on_; }
  const Findings& findings() const { return findings_; }

  /// The lines of the inspector; of no pixel, how to get one.
  std::vector<std::string> inspection() const;

  /// Who wins the duel, while its map is shown; else empty.
  std::vector<std::string> tally() const;

  /// The trace that is played; null where pictures are shown.
  const eltek::TracePlayer* player() const { return player_.get(); }
  void seek(std::size_t records);

  /// The pixel of the picture that the inspector is about: pinned by a click or the arrows, else
  /// under the mouse.
  std::optional<Place> inspected() const { return pinned_ ? pinned_ : hovered(); }
  bool pixel_pinned() const { return pinned_.has_value(); }

  /// The LUT entry whose pixels stand out: the one that is pointed at in the panel, else the one
  /// that is pinned.
  std::optional<std::uint8_t> entry() const { return entry_hovered_ ? entry_hovered_ : entry_; }
  std::optional<std::uint8_t> pinned_entry() const { return entry_; }
  void hover_entry(std::optional<std::uint8_t> entry);
  void pin_entry(std::optional<std::uint8_t> entry);

 private:
  /// Under the mouse, wherever the picture has gone meanwhile.
  std::optional<Place> hovered() const {
    return mouse_ ? viewport_.pixel_at(*mouse_) : std::nullopt;
  }
  Side& active() { return sides_[static_cast<std::size_t>(active_)]; }
  void turn_to(std::size_t number);
  void choose(Method method);
  void set_masks();
  void show_map(Map map);
  void toggle_duel();
  void toggle_area();
  void toggle_crt();
  void toggle_panel();
  void hold_reference(bool held);
  int middle_column() const;
  std::string crt_text() const;
  void nudge(int right, int down);
  void arrow(const Key& key);
  void answer_prompt();
  void go_to(Place image_pixel);
  void pin_entry_of_pixel();
  void zoom(int steps, std::optional<Place> anchor = {});
  std::string stem(const Side& shown) const;  // of the names of its screenshots
  void save_screen();
  void save_as_seen();
  void cancel();
  void step(Command command);
  Findings::Wanted wanted_findings() const;
  void say(const std::string& message);
  void tell_default();
  void compose();
  std::vector<std::string> inspect_machine(Place at) const;
  void compose_trace();
  Planes through_tube(const Planes& image) const;
  void compose_side(int which, const Columns& columns);

  ViewerOptions options_;
  Workshop workshop_;
  std::vector<std::filesystem::path> inputs_;  // by number
  std::size_t number_ = 0;
  std::set<std::size_t> told_;
  std::array<Side, 2> sides_;
  int active_ = 0;
  bool duel_ = false;
  int split_column_ = 0;
  std::uint8_t planes_ = 0xFF;
  bool mask_lifted_ = false;
  bool reference_held_ = false;
  Map map_ = Map::none;
  Findings findings_;
  bool crt_on_ = false;
  eltek::Crt crt_, tube_;  // with all its effects, and with those that follow every key
  std::unique_ptr<eltek::TracePlayer> player_;
  std::string trace_name_;
  Viewport viewport_;
  Frame frame_;
  std::uint64_t picture_version_ = 0;
  Prompt prompt_;
  std::string message_, news_;
  std::optional<Place> mouse_, pinned_, drag_from_;  // pinned_: in the picture, else the window
  bool dragging_split_ = false, dragged_ = false;
  std::optional<std::uint8_t> entry_, entry_hovered_;
  bool inspector_open_ = false, key_sheet_open_ = false, panel_open_ = false, values_on_ = true;
  bool panel_shown_ = false, full_screen_ = false, closed_ = false, stale_ = true,
       composed_ = false, shown_once_ = false;
  bool key_taken_ = false;
};

}  // namespace sir::viewer
