// Keeps a long render's finished tiles in a file, and gives them back to the one that continues it
// (the thesis has none).
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>

#include "tracer/tile_file.h"

namespace sir {

/// A short render leaves no trace: tiles wait in memory, for `patience` seconds from when the
/// object is made, or until they are many. Then they go to the file, in which tiles of an
/// earlier render are forgotten; and from then on at most kWriteSeconds after those before them, or
/// with the next tile that is finished, whichever is later. They are on the disk (fsync) at
/// most kSyncSeconds later, in the same sense. So a render that is killed loses the
/// tiles that are under way, and those of the last tenth of a second; a machine that stops, those
/// of the last ten seconds.
///
/// What goes wrong with the file, or is wrong with it, ends the keeping and not the render: `warn`
/// is told once, in any thread.
class TileRecord : public TileKeeper {
 public:
  static constexpr double kWriteSeconds = 0.1, kSyncSeconds = 10;
  /// A record does not grow beyond this and four times its image's pixels.
  static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;

  struct Options {
    std::filesystem::path path;
    std::function<std::string()> settings;  ///< as in tile_file.h; called when there is need
    double patience = 5;                    ///< seconds
    std::uint64_t most_bytes = kMostBytes;
    std::function<void(const std::string& reason)> warn = [](const std::string&) {};
  };
  explicit TileRecord(Options options);
  ~TileRecord() override;

  enum class Found : std::uint8_t {
    nothing,  ///< no record, or none that was begun
    other,    ///< one of other settings
    tiles     ///< one that is continued from now on
  };
  struct Resumed {
    Found found = Found::nothing;
    std::string settings;       ///< those of the record
    std::size_t tiles = 0;      ///< that can be believed
    std::uint64_t dropped = 0;  ///< bytes that cannot
  };

  /// Before the render: opens the record of an earlier one. Throws FileError for what cannot be
  /// opened or is no record.
  Resumed resume();

  /// Whether there is a record of the same settings that nobody uses. Throws nothing.
  bool can_resume() const;

  bool take(const TileId& tile, std::span<Rgb8> colours) override;
  void keep(const TileId& tile, std::span<const Rgb8> colours, const RayCounts& cost) override;
  RayCounts taken_counts() const override;

  /// The settings of this render.
  std::string settings() const { return options_.settings(); }

  /// Whether there is a file that holds what was kept; it is written to the end.
  bool flush();

  /// The render has been written: removes its record, and one of the same settings that an earlier
  /// one left.
  void remove();

  std::size_t taken() const { return taken_; }  ///< tiles
  std::size_t kept() const { return kept_; }    ///< tiles

  /// Of all colours taken and kept so far, the share of those taken, in [0,1].
  double taken_share() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::unique_ptr<TileFile> open_same() const;
  void begin();
  void write();
  void give_up(const std::string& reason);

  const Options options_;
  const Clock::time_point start_ = Clock::now();
  mutable std::mutex mutex_;
  std::unique_ptr<TileFile> file_;
  std::map<TileId, TileFile::Place> found_;  // not changed once the render runs
  std::string pending_;                      // encoded tiles
  std::optional<Clock::time_point> written_, synced_;
  bool given_up_ = false;
  RayCounts taken_counts_;
  std::atomic<std::size_t> taken_{0}, kept_{0};
  std::atomic<std::uint64_t> taken_colours_{0}, kept_colours_{0};
};

}  // namespace sir
