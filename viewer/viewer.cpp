#include "viewer/viewer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "quant/dac_parse.h"
#include "tracer/scene_path.h"
#include "viewer/argb.h"
#include "viewer/composition.h"

namespace sir::viewer {
namespace {

std::string planes_text(std::uint8_t planes) {
  std::string text = planes == 0 ? "no planes" : "planes";
  for (int plane = 0; plane < 8; ++plane)
    if (((planes >> plane) & 1) != 0) text.append(" ").append(std::to_string(plane + 1));
  return text;
}

std::string lut_text(const Side& side) {
  if (side.true_colour()) return "true colour";
  if (!side.rendition()) return {};
  std::string text = "LUT " + side.rendition()->lut_name;
  if (const auto& dac = side.station().dac(); dac != quant::DacBits{})
    text += ", DAC " + quant::bits_text(dac);
  return text;
}

}  // namespace

Viewer::Viewer(ViewerOptions options)
    : options_(std::move(options)),
      workshop_(options_.workshop),
      sides_{Side(options_.image_area_only), Side(options_.image_area_only)},
      findings_(workshop_.worker()),
      crt_on_(options_.crt.has_value()),
      crt_(options_.crt.value_or(eltek::CrtOptions{})),
      tube_(eltek::CrtOptions{.tube = crt_.options().tube}) {
  if (options_.listener != nullptr) sides_[0].station().add_listener(*options_.listener);
  viewport_.set_picture(sides_[0].station().seen_area().size);
  split_column_ = eltek::Ma120::kSize.width / 2;
}

void Viewer::open(const std::filesystem::path& input, bool show) {
  if (player_) return say("a register trace is played; sir show opens pictures");
  const std::size_t number = workshop_.open(input);
  inputs_.push_back(input);
  if (show) turn_to(number);
}

void Viewer::set_window(ImageSize window) {
  if (window == viewport_.window()) return;
  viewport_.set_window(window);
  stale_ = true;
}

void Viewer::turn_to(std::size_t number) {
  number_ = number;
  pinned_.reset();
  entry_.reset();
  refresh();
}

bool Viewer::refresh() {
  if (workshop_.count() == 0) return false;
  const RenditionOptions& how = options_.workshop.rendition;
  bool changed = sides_[0].update(workshop_, number_, how);
  if (duel_ && sides_[1].update(workshop_, number_, how)) changed = true;
  if (findings_.update(wanted_findings(), sides_, how.map)) changed = true;
  workshop_.end_drawing(number_);
  tell_default();
  const ImageSize size = sides_[0].station().seen_area().size;
  if (changed) {
    composed_ = false;
    viewport_.set_picture(size);
    split_column_ = std::clamp(split_column_, 0, size.width);
    if (pinned_ && (pinned_->x >= size.width || pinned_->y >= size.height)) pinned_.reset();
  }
  shown_once_ = shown_once_ || sides_[0].picture();
  std::string news = workshop_.state(number_).message;
  for (const Side& side : sides_)
    if (news.empty()) news = side.error();
  if (news != news_) {
    // What was said of something else stays until a key goes down.
    if (!news.empty() || message_ == news_) message_ = news;
    // What ends the window is said by whoever opened it.
    const bool failed = workshop_.state(number_).failed || !sides_[0].error().empty();
    if (failed && hopeless().empty()) options_.report(news);
    news_ = std::move(news);
    changed = true;
  }
  stale_ |= changed;
  return changed;
}

// Once for each picture, what was chosen for a person who chose nothing.
void Viewer::tell_default() {
  const Side& side = sides_[0];
  if (!side.rendition() || side.chosen() || !side.fits() || !told_.insert(number_).second) return;
  const std::string input = inputs_[number_].string();
  const Rendition& shown = *side.rendition();
  if (shown.method != Method::lut_file)
    options_.report(input + ": there is no " + with_suffix(side.picture()->base, "LUT").string() +
                    "; shown with a LUT " + shown.lut_name);
  if (shown.lut.dac != quant::DacBits{})
    options_.report(input + ": shown through a DAC of " + quant::bits_text(shown.lut.dac) +
                    " bits, which the MA120 did not have");
}

const Frame& Viewer::picture() {
  if (!composed_) {
    compose();
    ++picture_version_;
  }
  composed_ = true;
  return frame_;
}

void Viewer::compose() {
  if (player_) return compose_trace();
  frame_.size = sides_[0].station().seen_area().size;
  frame_.words.resize(frame_.size.pixels());
  const bool both = duel_ && sides_[1].station().seen_area().size == frame_.size;
  const int split = both ? std::clamp(split_column_, 0, frame_.size.width) : frame_.size.width;
  compose_side(0, {0, split});
  compose_side(1, {split, frame_.size.width});
}

void Viewer::compose_side(int which, const Columns& columns) {
  if (columns.first >= columns.end) return;
  const Side& shown = side(which);
  const Station& station = shown.station();
  const bool image_there = shown.picture() && shown.fits();
  const Planes* over = nullptr;
  Planes on_tube;
  if (image_there) {
    const bool truth = reference_held_ || shown.true_colour();
    over = truth ? &shown.picture()->planes : findings_.map(which);
    if (truth && crt_on_) over = &(on_tube = through_tube(*over));
  }
  // An entry is one of the active side's LUT; to the other its index means another colour.
  const bool stands_out = image_there && over == nullptr && entry() && (!duel_ || which == active_);
  if (over != nullptr && over->size != shown.picture()->planes.size) over = nullptr;
  // What is covered need not be scanned out.
  if (over == nullptr || station.placement().on_screen != station.seen_area()) {
    IndexWords words = station.seen_words(crt_on_ ? &tube_ : nullptr);
    if (stands_out) leave_entry(words, station.mask(), *entry());
    station.scan_out(frame_, words, columns);
  }
  if (over != nullptr) lay_over(frame_, *over, station.placement(), station.seen_area(), columns);
}

// Colours without a LUT on the same monitor, so that a flip compares colours and no monitors.
Planes Viewer::through_tube(const Planes& image) const {
  eltek::Screen screen{image.size, std::vector<Rgb8>(image.size.pixels())};
  for (std::size_t i = 0; i < screen.pixels.size(); ++i) screen.pixels[i] = image.at(i);
  return eltek::to_planes(tube_.show(screen));
}

void Viewer::compose_trace() {
  const eltek::Screen screen = player_->raster().frame();
  frame_.size = screen.size;
  frame_.words.resize(screen.pixels.size());
  std::transform(screen.pixels.begin(), screen.pixels.end(), frame_.words.begin(),
                 [](Rgb8 colour) { return argb(colour); });
}

std::string Viewer::title() const {
  std::string title = player_ ? trace_name_ + " - register trace" : "SIR";
  if (workshop_.count() > 0) {
    title = sides_[0].picture() ? sides_[0].picture()->base.filename().string()
                                : inputs_[number_].filename().string();
    if (const std::string lut = lut_text(sides_[0]); !lut.empty()) title += " - " + lut;
    if (duel_) title += " | " + lut_text(sides_[1]);
    if (reference_held_) title += " - reference";
    if (workshop_.count() > 1)
      title +=
          " (" + std::to_string(number_ + 1) + " of " + std::to_string(workshop_.count()) + ")";
  }
  if (planes_ != 0xFF) title += " - " + (mask_lifted_ ? "read mask lifted" : planes_text(planes_));
  title += " - " + std::to_string(viewport_.multiple()) + "x";
  if (!message_.empty()) title += " - " + message_;
  return title;
}

void Viewer::say(const std::string& message) {
  message_ = message;
  stale_ = true;
}

void Viewer::hover_entry(std::optional<std::uint8_t> entry) {
  if (entry == entry_hovered_) return;
  entry_hovered_ = entry;
  composed_ = false;
  stale_ = true;
}

void Viewer::pin_entry(std::optional<std::uint8_t> entry) {
  entry_ = entry;
  composed_ = false;
  stale_ = true;
}

}  // namespace sir::viewer
