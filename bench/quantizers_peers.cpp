#include "bench/quantizers_peers.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "bench/child.h"
#include "bench/quantizers_judge.h"
#include "quant/image_pair.h"
#include "quant/lut.h"
#include "viewer/png_file.h"

namespace sir::bench {
namespace {

using Words = std::vector<std::string>;

bool starts(const Words& words) { return child_cpu_seconds(words).has_value(); }

/// Why a program is missing; empty where it starts.
std::string unless_it_starts(const Words& words, const std::string& package) {
  return starts(words) ? "" : words[0] + " is not installed; Debian's package is " + package;
}

/// ImageMagick's own name for its program in Debian, else the common one, which on some machines
/// is a script that starts it and costs more than it does.
std::string image_magick() {
  return starts({"convert-im6", "-version"}) ? "convert-im6" : "convert";
}

/// Whether the help of one of our commands names all of some words.
class OurHelp {
 public:
  OurHelp(std::string sir, std::string scratch) : sir_(std::move(sir)), out_(std::move(scratch)) {
    out_ += "/help";
  }
  bool has(const std::string& command, std::initializer_list<const char*> words) const {
    if (!child_cpu_seconds({sir_, command, "--help"}, out_)) return false;
    std::ifstream file(out_);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const char* word : words)
      if (text.find(word) == std::string::npos) return false;
    return true;
  }

 private:
  std::string sir_, out_;
};

Contender pngquant(std::string name, std::string slug, Reading reading, const Words& options) {
  return {std::move(name), std::move(slug), unless_it_starts({"pngquant", "--version"}, "pngquant"),
          reading, [options](const std::string& picture, const std::string& own) {
            Words words{"pngquant", "--speed", "1"};
            words.insert(words.end(), options.begin(), options.end());
            for (const std::string& word : {std::string("--force"), std::string("--output"),
                                            own + ".png", std::string("256"), picture})
              words.push_back(word);
            return std::vector<Command>{{words}};
          }};
}

Contender imagemagick() {
  const std::string convert = image_magick();
  return {"ImageMagick", "imagemagick", unless_it_starts({convert, "-version"}, "imagemagick"),
          Reading::remapped, [convert](const std::string& picture, const std::string& own) {
            return std::vector<Command>{
                {{convert, picture, "+dither", "-colors", "256", own + ".png"}}};
          }};
}

Contender netpbm() {
  return {"netpbm, mean of pixels", "netpbm",
          unless_it_starts({"pnmcolormap", "--version"}, "netpbm"), Reading::remapped,
          [](const std::string& picture, const std::string& own) {
            const std::string ppm = own + ".ppm", map = own + ".map", mapped = own + ".mapped";
            return std::vector<Command>{{{"pngtopnm", picture}, ppm},
                                        {{"pnmcolormap", "-meanpixel", "256", ppm}, map},
                                        {{"pnmremap", "-mapfile=" + map, ppm}, mapped},
                                        {{"pnmtopng", mapped}, own + ".png"}};
          }};
}

/// `sir lut` and `sir show` with options of both.
Contender ours(std::string name, std::string slug, std::string missing, const std::string& sir,
               const Words& choose, const Words& show) {
  return {std::move(name), std::move(slug), std::move(missing), Reading::as_it_is,
          [=](const std::string& picture, const std::string& own) {
            Words first{sir, "lut", picture, "-o", own + ".LUT"};
            first.insert(first.end(), choose.begin(), choose.end());
            Words second{sir,          "show",   picture, "--lut",
                         own + ".LUT", "--crop", "--png", own + ".png"};
            second.insert(second.end(), show.begin(), show.end());
            return std::vector<Command>{{first}, {second}};
          }};
}

}  // namespace

std::vector<Contender> plain_contenders(const std::string& sir, const std::string& scratch) {
  const OurHelp help(sir, scratch);
  const std::string best =
      help.has("lut", {"best", "--goal"}) ? "" : "this `sir lut` has no --method best --goal";
  const std::string seen = !best.empty() || help.has("show", {"perceptual"})
                               ? best
                               : "this `sir show` has no --map perceptual";
  return {pngquant(kReference, "pngquant", Reading::remapped, {"--nofs"}),
          pngquant(kPosterized, "posterize", Reading::remapped, {"--posterize", "2", "--nofs"}),
          imagemagick(),
          netpbm(),
          ours("sir median, rgb", "rgb", "", sir, {"--method", "median", "--space", "rgb"}, {}),
          ours("sir median, hsv", "hsv", "", sir, {"--method", "median", "--space", "hsv"}, {}),
          ours(kPsnr, "psnr", best, sir, {"--method", "best", "--goal", "psnr"}, {"--map", "rgb"}),
          ours(kPerceptual, "perceptual", seen, sir, {"--method", "best", "--goal", "perceptual"},
               {"--map", "perceptual"})};
}

std::vector<Contender> dithering_contenders(const std::string& sir, const std::string& scratch) {
  const OurHelp help(sir, scratch);
  std::string missing;
  if (!help.has("lut", {"best", "--goal"})) missing = "this `sir lut` has no --method best --goal";
  else if (!help.has("show", {"--dither", "perceptual"}))
    missing = "this `sir show` has no --dither with --map perceptual";
  const Words choose{"--method", "best", "--goal", "perceptual"};
  const auto dithered = [&](const char* name, const char* kind) {
    return ours(name, kind, missing, sir, choose, {"--map", "perceptual", "--dither", kind});
  };
  return {pngquant(kReference, "pngquant", Reading::rounded, {}),
          pngquant(kPosterized, "posterize", Reading::rounded, {"--posterize", "2"}),
          dithered(kFloyd, "floyd"), dithered(kBlueNoise, "blue-noise")};
}

double run_contender(const Contender& contender, const std::string& picture,
                     const std::string& own) {
  double seconds = 0;
  for (const Command& command : contender.commands(picture, own)) {
    const auto used = child_cpu_seconds(command.words, command.out);
    if (!used) {
      std::string line;
      for (const std::string& word : command.words) line += " " + word;
      throw std::runtime_error("fails:" + line);
    }
    seconds += *used;
  }
  return seconds;
}

Planes shown_by(const Contender& contender, const Planes& reference, const std::string& own) {
  Planes shown = viewer::read_png(own + ".png");
  if (shown.size != reference.size)
    throw std::runtime_error(contender.name + " shows an image of another size");
  switch (contender.reading) {
    case Reading::remapped: return through_rounded_palette(reference, shown);
    case Reading::rounded: return on_the_lattice(shown);
    case Reading::as_it_is: break;
  }
  const quant::Lut lut = quant::read_lut(own + ".LUT");
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i < quant::kLutEntries; ++i) colours.insert(quant::packed(lut.seen(i)));
  for (const quant::ColourCount& one : quant::distinct_colours(shown))
    if (!colours.contains(quant::packed(one.colour)))
      throw std::runtime_error(contender.name + " shows a colour that its LUT does not have");
  return shown;
}

}  // namespace sir::bench
