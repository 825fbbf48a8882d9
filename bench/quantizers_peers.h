// The programs that `quantizers` compares: how each is called, and how its output is read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tracer/planes.h"

namespace sir::bench {

/// A program with its arguments, and the file of its standard output.
struct Command {
  std::vector<std::string> words;
  std::string out = "/dev/null";
};

/// What becomes of a contender's PNG.
enum class Reading {
  remapped,  ///< its colours are rounded to the DAC's 6 bits; each pixel takes the nearest of them
  rounded,  ///< each pixel stays what it is, rounded to 6 bits: dither would not survive the former
  as_it_is  ///< ours: the PNG is what the monitor shows; beside it stands the LUT
};

struct Contender {
  std::string name;     ///< as in the tables
  std::string slug;     ///< its files are called so
  std::string missing;  ///< why it does not take part, empty where it does
  Reading reading = Reading::remapped;
  /// From the picture's file to own + ".png" (ours: also own + ".LUT"), files and all.
  std::function<std::vector<Command>(const std::string& picture, const std::string& own)> commands;
};

inline constexpr const char* kReference = "pngquant";  ///< the ratios are to this one
/// Told that only 6 bits of each primary count.
inline constexpr const char* kPosterized = "pngquant, posterize 2";
inline constexpr const char* kPerceptual = "sir best, perceptual";
inline constexpr const char* kPsnr = "sir best, psnr";
inline constexpr const char* kFloyd = "sir floyd";
inline constexpr const char* kBlueNoise = "sir blue-noise";

/// Those that map each pixel to a colour of its own; `sir` is our program.
std::vector<Contender> plain_contenders(const std::string& sir, const std::string& scratch);

/// Those that dither.
std::vector<Contender> dithering_contenders(const std::string& sir, const std::string& scratch);

/// CPU seconds, user's and system's, of all of a contender's commands. Throws std::runtime_error
/// where one fails.
double run_contender(const Contender& contender, const std::string& picture,
                     const std::string& own);

/// The image that the monitor shows by a contender that has run. Throws std::runtime_error where
/// one of ours shows a colour that its LUT does not have.
Planes shown_by(const Contender& contender, const Planes& reference, const std::string& own);

}  // namespace sir::bench
