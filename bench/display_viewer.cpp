#include "bench/display_viewer.h"

#include <SDL.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <vector>

#include "bench/timing.h"
#include "tests/temp_folder.h"
#include "viewer/glass.h"
#include "viewer/png_file.h"
#include "viewer/viewer.h"

namespace sir::bench {
namespace {

using viewer::Command;
using viewer::Viewer;

const int kRounds = sir::bench::rounds(101);

/// Many colours, and none of them in an order that a predictor could like.
Planes picture(ImageSize size) {
  Planes planes(size);
  std::uint32_t random = 1;
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    random = random * 1664525u + 1013904223u;
    const auto noise = static_cast<std::uint8_t>(random >> 28);
    planes.set(i, {static_cast<std::uint8_t>(i % 240 + noise), static_cast<std::uint8_t>(i / 4096),
                   static_cast<std::uint8_t>(i / 64 % 200 + noise)});
  }
  return planes;
}

/// A software renderer's target, as large as the window that the viewer is told of.
class Target {
 public:
  explicit Target(ImageSize size)
      : surface_(SDL_CreateRGBSurfaceWithFormat(0, size.width, size.height, 32,
                                                SDL_PIXELFORMAT_ARGB8888)),
        renderer_(surface_ != nullptr ? SDL_CreateSoftwareRenderer(surface_) : nullptr) {
    if (renderer_ == nullptr) throw std::runtime_error(SDL_GetError());
  }
  ~Target() {
    SDL_DestroyRenderer(renderer_);
    SDL_FreeSurface(surface_);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  SDL_Renderer* renderer() const { return renderer_; }

 private:
  SDL_Surface* surface_;
  SDL_Renderer* renderer_;
};

void settle(Viewer& viewer) {
  while (viewer.refresh() || viewer.busy())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

struct Case {
  const char* name;
  bool image_area_only;
  std::vector<Command> opened;
};

void time_case(const Case& one, const std::filesystem::path& input) {
  viewer::ViewerOptions options;
  options.image_area_only = one.image_area_only;
  Viewer viewer(std::move(options));
  viewer.set_window(eltek::Ma120::kSize);
  viewer.open(input, true);
  settle(viewer);
  const Target target(eltek::Ma120::kSize);
  viewer::Glass glass(target.renderer());
  viewer.point({400, 300});
  for (const Command command : one.opened) viewer.perform(command);
  std::vector<double> change, convert, draw, both;
  // The first two are made by the workshop; those after them are there already.
  for (int round = -2; round < kRounds; ++round) {
    const Command method = round % 2 == 0 ? Command::rgb_median : Command::hsv_frequency;
    const double change_ms = milliseconds([&] { viewer.perform(method); });
    settle(viewer);
    const double convert_ms = milliseconds([&] { viewer.picture(); });
    const double draw_ms = milliseconds([&] { glass.draw(viewer, 1); });
    if (round < 0) continue;
    change.push_back(change_ms);
    convert.push_back(convert_ms);
    draw.push_back(draw_ms);
    both.push_back(convert_ms + draw_ms);
  }
  std::printf("%-26s %8.3f %8.3f %8.3f %8.3f\n", one.name, median(change), median(convert),
              median(draw), median(both));
}

}  // namespace

void time_viewer() {
  const test::TempFolder folder;
  const auto large = folder / "large.png", small = folder / "small.png";
  viewer::write_rgb_png(large, picture(eltek::Ma120::kSize));
  viewer::write_rgb_png(small, picture({640, 480}));
  // To draw is to upload and to copy from the texture into the window.
  std::printf("\nthe viewer, ms              new LUT  convert     draw     both\n");
  time_case({"whole screen", false, {}}, large);
  time_case({"image area, 640x480", true, {}}, small);
  time_case({"whole screen, an entry", false, {Command::pin_entry}}, large);
  time_case({"whole screen, tube", false, {Command::crt}}, large);
  time_case({"whole screen, true colour", false, {Command::flip_reference}}, large);
  time_case({"duel", false, {Command::split}}, large);
  time_case({"inspector", false, {Command::inspector}}, large);
  time_case({"duel and inspector", false, {Command::split, Command::inspector}}, large);
}

}  // namespace sir::bench
