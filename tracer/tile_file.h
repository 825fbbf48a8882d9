// BASE.tiles: the finished tiles of a render that is not finished (the thesis has none).
//
// All numbers are unsigned, the least byte first. A check is the fnv1a() of what it stands behind.
//
//   header   12 bytes  "SIR tiles 1" and a line feed
//             4        n, the length of the settings, at most kMostSettings
//             n        the settings: a text that is the same for renders of the same bytes
//             8        the check of all before
//   tiles, one behind the other, in the order in which they were finished; each
//             4        stage                      } TileId
//             8        first                      }
//             4        m, its colours, 1 to kMostColours
//            17 x 8    its cost: RayCounts::kMembers, then calls, combinations, envelopes and the
//                      four kinds of primitives of CostCounts
//           m x 3      r g b of each
//             8        the check of this tile's bytes before, begun with the header's check in
//                      place of fnv1a()'s start: no other record's tiles are believed
//
// What ends in the middle of a tile was being written when the render was killed. The first tile
// that is not whole, or whose check is wrong, ends the record: nothing behind it is believed.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tracer/tile_keeper.h"

namespace sir {

/// A record that this process alone may use, as long as the object lives: it is locked (flock).
/// Errors throw FileError. Not for two threads at once, except load().
class TileFile {
 public:
  static constexpr std::uint32_t kMostSettings = 1 << 16;
  static constexpr std::uint32_t kMostColours = 1 << 16;

  /// Opens the record, and makes an empty one where there is none and `create` says so; none
  /// where there is none. Refuses what another process has open, and any file that is not a
  /// record of some version: it is somebody's.
  static std::unique_ptr<TileFile> open(const std::filesystem::path& path, bool create);
  ~TileFile();
  TileFile(const TileFile&) = delete;
  TileFile& operator=(const TileFile&) = delete;

  /// The settings of a whole header; none where it is torn.
  const std::optional<std::string>& settings() const { return settings_; }

  /// Forgets all that is there and writes a header; at most kMostSettings bytes.
  void start(const std::string& settings);

  /// Where a tile's bytes lie.
  struct Place {
    std::uint64_t offset = 0;
    std::uint32_t colours = 0;
  };

  /// Finds the tiles that can be believed, in memory that grows with their number alone. What
  /// lies behind them is cut off: `dropped` bytes.
  std::map<TileId, Place> find_tiles(std::uint64_t& dropped);

  /// Reads a tile's colours, as many as there are, and its cost; false where they are not what
  /// find_tiles() saw.
  bool load(const TileId& tile, const Place& place, std::span<Rgb8> colours, RayCounts& cost) const;

  /// Adds a tile to `tiles` as append() takes it: its check is yet to come, since the file may
  /// be, too.
  static void encode(const TileId& tile, std::span<const Rgb8> colours, const RayCounts& cost,
                     std::string& tiles);

  /// Writes encoded tiles behind the last, with their checks. Where that fails the file ends as it
  /// did before.
  void append(std::string tiles);

  /// Waits until all is on the disk.
  void sync() const;

  std::uint64_t size() const { return size_; }

  /// Removes the file's name.
  void remove();

 private:
  TileFile(std::filesystem::path path, int descriptor);
  void read_header();
  void write(std::string_view bytes);
  std::string read_at(std::uint64_t offset, std::size_t length) const;
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;   // of what is believed, and written
  std::uint64_t check_ = 0;  // the header's
  std::optional<std::string> settings_;
};

}  // namespace sir
