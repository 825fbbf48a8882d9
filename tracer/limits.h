// How much of a stranger's file the program takes on. Nothing here stands in the thesis, whose
// files came from its own modeler; docs/limits.md tells people of these.
#pragma once

#include <cstddef>
#include <string>

namespace sir {

/// Limits that a person may have cause to lift, by an option that every refusal names.
struct Limits {
  /// Nodes of a tree; also surfaces and lights, each. Read into memory, as many of any of them are
  /// less than 100 megabytes, so that a file that turns out wrong in its last line has cost no
  /// more; and it is more than twice what a chain of 100,000 operations has. (--max-nodes)
  std::size_t nodes = 250'000;

  /// Pixels of an image, read or made: 10,000 x 10,000, more than most cameras take and a hundred
  /// times the MA120's screen. They are 300 megabytes of planes. (--max-pixels)
  std::size_t pixels = 100'000'000;
};

/// The limits in force.
const Limits& limits();

/// Changes them. For programs, at their start: no other thread may be reading anything.
void set_limits(const Limits& limits);

/// The greatest values that the options take: a scene of a hundred million nodes would need 80
/// gigabytes, and pixels up to here have been counted in ints safely.
inline constexpr std::size_t kMostNodes = 100'000'000;
inline constexpr std::size_t kMostPixels = std::size_t{1} << 28;

/// Bytes of a line of a text file. The longest that the program writes, one record of a register
/// trace, is less than half of it.
inline constexpr std::size_t kMaxLine = std::size_t{1} << 20;

/// Bytes of a text file, which is read a piece at a time: what a trace of all the records that a
/// trace may have can take. It bounds time, not memory.
inline constexpr std::size_t kMaxFile = std::size_t{1} << 30;

/// Bytes of a text that is no regular file, such as a pipe's: it can be read only once, and so has
/// to be kept whole until its encoding is known.
inline constexpr std::size_t kMaxStream = std::size_t{64} << 20;

/// What a refusal says of a limit: "at most 250000 nodes are taken; --max-nodes N allows more".
std::string at_most(std::size_t limit, const char* things, const char* option);

}  // namespace sir
