// How long does the MA120's screen take on its way to the window, where everything changes from
// frame to frame: a new LUT through the registers, conversion, upload to a streaming texture?
// Usage: display_bench   (no arguments, no display: SDL draws to none)
// Ways are run in turn; medians, and the medians of the ratios to the plain way, are printed; then
// the medians of the viewer's own way, part by part.
// Exit code 1 where two ways give different pixels.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "eltek/display_driver.h"
#include "eltek/ma120.h"
#include "viewer/argb.h"
#ifdef SIR_WITH_SDL
#include <SDL.h>

#include "bench/display_viewer.h"
#endif

namespace {

using sir::bench::median;
using sir::bench::milliseconds;
using sir::eltek::Bus;
using sir::eltek::Ma120;

const int kRounds = sir::bench::rounds(101);
constexpr int kWidth = Ma120::kSize.width, kHeight = Ma120::kSize.height;

// All indices, in no order that a cache or a predictor could like.
void draw(Bus& bus) {
  std::uint32_t random = 1;
  std::vector<std::uint8_t> indices(Ma120::kSize.pixels());
  for (std::uint8_t& index : indices) {
    random = random * 1664525u + 1013904223u;
    index = static_cast<std::uint8_t>(random >> 24);
  }
  bus.write_pixels(indices);
}

sir::quant::Lut lut_of(int frame) {
  sir::quant::Lut lut;
  for (std::size_t i = 0; i < lut.entry.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      lut.entry[i][c] =
          static_cast<std::uint8_t>((i * (c + 3) + static_cast<std::size_t>(frame)) % 64);
  return lut;
}

// By the definition: colours, then words.
void plain(const Ma120& machine, std::vector<std::uint32_t>& words) {
  const sir::eltek::Screen screen = machine.scan_out();
  words.resize(screen.pixels.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const sir::Rgb8 c = screen.pixels[i];
    words[i] = 0xFF000000u | std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | c.b;
  }
}

// By a table of words, into whatever memory.
void by_table(const Ma120& machine, std::span<std::uint32_t> words, std::size_t stride = kWidth) {
  const std::array<sir::Rgb8, 256> seen = machine.seen();
  std::array<std::uint32_t, 256> table;
  std::transform(seen.begin(), seen.end(), table.begin(),
                 [](sir::Rgb8 colour) { return sir::viewer::argb(colour); });
  machine.scan_out_words({0, 0, Ma120::kSize}, table, words, stride);
}

struct Times {
  const char* name;
  std::vector<double> ms, ratio = {};
};

void print(const std::vector<Times>& all) {
  for (const Times& times : all)
    std::printf("%-44s %7.3f ms   plain/this %6.2f\n", times.name, median(times.ms),
                median(times.ratio));
}

#ifdef SIR_WITH_SDL

void check(bool worked, const char* what) {
  if (!worked) throw std::runtime_error(std::string(what) + ": " + SDL_GetError());
}

// A texture of a software renderer; no window is needed.
class Texture {
 public:
  Texture() {
    surface_ = SDL_CreateRGBSurfaceWithFormat(0, kWidth, kHeight, 32, SDL_PIXELFORMAT_ARGB8888);
    check(surface_ != nullptr, "surface");
    renderer_ = SDL_CreateSoftwareRenderer(surface_);
    check(renderer_ != nullptr, "renderer");
    texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING,
                                 kWidth, kHeight);
    check(texture_ != nullptr, "texture");
  }
  ~Texture() {
    SDL_DestroyTexture(texture_);
    SDL_DestroyRenderer(renderer_);
    SDL_FreeSurface(surface_);
  }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  void update(const std::vector<std::uint32_t>& words) {
    check(SDL_UpdateTexture(texture_, nullptr, words.data(), 4 * kWidth) == 0, "update");
  }

  template <typename Draw>
  void lock(const Draw& draw) {
    void* pixels = nullptr;
    int pitch = 0;
    check(SDL_LockTexture(texture_, nullptr, &pixels, &pitch) == 0, "lock");
    const std::size_t stride = static_cast<std::size_t>(pitch) / sizeof(std::uint32_t);
    draw(std::span(static_cast<std::uint32_t*>(pixels), stride * kHeight), stride);
    SDL_UnlockTexture(texture_);
  }

  // What was uploaded, as it is drawn.
  std::vector<std::uint32_t> drawn() {
    std::vector<std::uint32_t> words(Ma120::kSize.pixels());
    check(SDL_RenderCopy(renderer_, texture_, nullptr, nullptr) == 0, "copy");
    check(SDL_RenderReadPixels(renderer_, nullptr, SDL_PIXELFORMAT_ARGB8888, words.data(),
                               4 * kWidth) == 0,
          "read back");
    return words;
  }

 private:
  SDL_Surface* surface_;
  SDL_Renderer* renderer_;
  SDL_Texture* texture_;
};

#endif

int run() {
  Ma120 machine;
  Bus bus(machine);
  draw(bus);
  std::vector<std::uint32_t> words(Ma120::kSize.pixels()), reference;
  bool equal = true;
  int frame = 0;
  // A frame: the LUT first, which each way pays for.
  const auto time = [&](Times& times, double plain_ms, const auto& work) {
    const sir::quant::Lut lut = lut_of(++frame);
    times.ms.push_back(milliseconds([&] {
      load_lut(bus, lut);
      work();
    }));
    times.ratio.push_back((plain_ms > 0 ? plain_ms : times.ms.back()) / times.ms.back());
    return times.ms.back();
  };
  const auto compare = [&](const std::vector<std::uint32_t>& shown) {
    plain(machine, reference);
    equal = equal && shown == reference;
  };

  std::vector<Times> all{{"convert: scan_out and words", {}}, {"convert: scan_out_words", {}}};
#ifdef SIR_WITH_SDL
  Texture texture;
  all.push_back({"plain: scan_out, words, SDL_UpdateTexture", {}});
  all.push_back({"scan_out_words, SDL_UpdateTexture", {}});
  all.push_back({"scan_out_words into SDL_LockTexture", {}});
#endif
  for (int round = 0; round < kRounds; ++round) {
    const double convert = time(all[0], 0, [&] { plain(machine, words); });
    time(all[1], convert, [&] { by_table(machine, words); });
    compare(words);
#ifdef SIR_WITH_SDL
    const double whole = time(all[2], 0, [&] {
      plain(machine, words);
      texture.update(words);
    });
    time(all[3], whole, [&] {
      by_table(machine, words);
      texture.update(words);
    });
    compare(texture.drawn());
    time(all[4], whole, [&] {
      texture.lock([&](std::span<std::uint32_t> pixels, std::size_t stride) {
        by_table(machine, pixels, stride);
      });
    });
    compare(texture.drawn());
#endif
  }
  print(all);
#ifdef SIR_WITH_SDL
  sir::bench::time_viewer();
#endif
  if (!equal) std::printf("DIFFERENT\n");
  return equal ? 0 : 1;
}

}  // namespace

int main() try { return run(); } catch (const std::exception& error) {
  std::fprintf(stderr, "display_bench: %s\n", error.what());
  return 1;
}
