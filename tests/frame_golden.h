// Frames of the MA120 that must stay as they are, stage by stage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eltek/screen.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::test {

/// An image's way to the screen, each stage made of those before.
struct Frame {
  std::string name;  ///< for messages and files
  Planes planes;
  quant::Lut lut;
  std::vector<std::uint8_t> indices;
  eltek::Screen screen;  ///< all 1024x780 pixels as seen
};

/// eltek::hash of each stage.
struct FrameHashes {
  std::uint64_t planes, lut, indices, screen;
  friend bool operator==(const FrameHashes&, const FrameHashes&) = default;
};

FrameHashes hashes(const Frame& frame);

/// As it stands in the list of golden frames.
std::string row(const std::string& name, const FrameHashes& hashes);

/// The screen by the definitions alone, nothing shared with quant/ and eltek/: for each pixel of
/// the centred image the entry of least squared distance, lowest index on ties, seen as
/// round(255 e / 63); around it the entry nearest to black. For images that fit.
eltek::Screen plain_screen(const Planes& planes, const quant::Lut& lut);

/// Empty where the frame is as ever. Else the message for one who sees the test fail: which stage
/// is the first to depart, whether the screen is what the definitions say, the row that would
/// accept the change, and the pictures, which are written into `folder`:
/// NAME-ACTUAL.png, NAME-PLAIN.png (plain_screen) and NAME-DIFF.png, black where those two agree,
/// brighter the more they differ.
std::string judge(const Frame& frame, const FrameHashes& golden,
                  const std::filesystem::path& folder);

}  // namespace sir::test
