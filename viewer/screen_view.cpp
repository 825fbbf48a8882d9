#include "viewer/screen_view.h"

#include <stdexcept>
#include <utility>

#include "quant/dac_parse.h"
#include "viewer/png_file.h"

namespace sir::viewer {

ScreenView::ScreenView(std::vector<ShownImage> images, bool image_area_only,
                       eltek::BusListener* listener)
    : images_(std::move(images)),
      oversize_(image_area_only ? eltek::Oversize::crop : eltek::Oversize::refuse) {
  if (images_.empty()) throw std::invalid_argument("a view needs an image");
  // All are tried at once, so that none is refused in the middle of a show.
  for (const ShownImage& image : images_) eltek::place(image.base.string(), image.size, oversize_);
  if (listener != nullptr) bus_.add_listener(*listener);
  show(0);
}

void ScreenView::next() { show((current_ + 1) % images_.size()); }

void ScreenView::previous() { show((current_ + images_.size() - 1) % images_.size()); }

void ScreenView::toggle_plane(int plane) {
  planes_ = static_cast<std::uint8_t>(planes_ ^ (1u << plane));
  bus_.write(eltek::Port::pixel_mask, planes_);
}

void ScreenView::all_planes() {
  planes_ = 0xFF;
  bus_.write(eltek::Port::pixel_mask, planes_);
}

eltek::Screen ScreenView::picture() const { return crop(monitor_.scan_out(), area_); }

eltek::IndexedScreen ScreenView::capture() const { return crop(monitor_.capture(), area_); }

std::string ScreenView::title() const {
  std::string title = image().base.filename().string() + " - LUT " + image().lut_name;
  if (monitor_.dac() != quant::DacBits{}) title += ", DAC " + quant::bits_text(monitor_.dac());
  if (images_.size() > 1)
    title += " (" + std::to_string(current_ + 1) + " of " + std::to_string(images_.size()) + ")";
  if (planes_ == 0xFF) return title;
  title += planes_ == 0 ? " - no planes" : " - planes";
  for (int plane = 0; plane < 8; ++plane)
    if (((planes_ >> plane) & 1) != 0) title.append(" ").append(std::to_string(plane + 1));
  return title;
}

std::filesystem::path ScreenView::save_capture(const std::filesystem::path& folder) const {
  const std::string stem = image().base.filename().string() + "-screen";
  std::filesystem::path path = (folder / (stem + ".png")).lexically_normal();
  for (int number = 2; std::filesystem::exists(path); ++number)
    path.replace_filename(stem + "-" + std::to_string(number) + ".png");
  write_indexed_png(path, capture());
  return path;
}

void ScreenView::show(std::size_t number) {
  current_ = number;
  const ShownImage& shown = images_[number];
  if (monitor_.dac() != shown.lut.dac) bus_.power_cycle(shown.lut.dac);
  area_ = show_image(bus_, {shown.base.string(), shown.size, shown.indices}, shown.lut, oversize_,
                     shown.reserved);
  if (oversize_ == eltek::Oversize::refuse) area_ = {0, 0, eltek::Ma120::kSize};
  bus_.write(eltek::Port::pixel_mask, planes_);
}

}  // namespace sir::viewer
