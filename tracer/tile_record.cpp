#include "tracer/tile_record.h"

#include "tracer/error.h"

namespace sir {
namespace {

// Bytes that wait in memory: before the file is begun, and between two times of writing.
constexpr std::size_t kMostWaiting = std::size_t{1} << 26, kMostPending = std::size_t{1} << 20;

}  // namespace

TileRecord::TileRecord(Options options) : options_(std::move(options)) {}

TileRecord::~TileRecord() { flush(); }

TileRecord::Resumed TileRecord::resume() {
  auto file = TileFile::open(options_.path, false);
  if (!file) return {};
  Resumed result;
  const std::string settings = options_.settings();
  if (!file->settings()) {
    // Nothing to be lost: it was being begun, or is of a format that is not read any more.
  } else if (*file->settings() != settings) {
    result.found = Found::other;
    result.settings = *file->settings();
    return result;
  } else {
    found_ = file->find_tiles(result.dropped);
    result.found = Found::tiles;
    result.settings = settings;
    result.tiles = found_.size();
    file_ = std::move(file);
  }
  return result;
}

bool TileRecord::can_resume() const { return open_same() != nullptr; }

std::unique_ptr<TileFile> TileRecord::open_same() const {
  try {
    auto file = TileFile::open(options_.path, false);
    if (file && file->settings() && *file->settings() == options_.settings()) return file;
  } catch (const FileError&) {
    // Nobody's loss: it is not ours.
  }
  return nullptr;
}

bool TileRecord::take(const TileId& tile, std::span<Rgb8> colours) {
  const auto place = found_.find(tile);
  if (place == found_.end() || place->second.colours != colours.size()) return false;
  RayCounts cost;
  try {
    if (!file_->load(tile, place->second, colours, cost)) return false;
  } catch (const FileError&) {
    return false;
  }
  const std::scoped_lock lock(mutex_);
  taken_counts_ += cost;
  ++taken_;
  taken_colours_ += colours.size();
  return true;
}

void TileRecord::keep(const TileId& tile, std::span<const Rgb8> colours, const RayCounts& cost) {
  const std::scoped_lock lock(mutex_);
  ++kept_;
  kept_colours_ += colours.size();
  if (given_up_) return;
  TileFile::encode(tile, colours, cost, pending_);
  const auto now = Clock::now();
  const auto older = [&](const std::optional<Clock::time_point>& time, double seconds) {
    return !time || std::chrono::duration<double>(now - *time).count() >= seconds;
  };
  try {
    if (!file_) {
      if (!older(start_, options_.patience) && pending_.size() < kMostWaiting) return;
      begin();
    }
    if (!older(written_, kWriteSeconds) && pending_.size() < kMostPending) return;
    write();
    written_ = now;
    if (!synced_) synced_ = now;
    if (!older(synced_, kSyncSeconds)) return;
    file_->sync();
    synced_ = now;
  } catch (const FileError& error) {
    give_up(error.what());
  }
}

RayCounts TileRecord::taken_counts() const {
  const std::scoped_lock lock(mutex_);
  return taken_counts_;
}

bool TileRecord::flush() {
  const std::scoped_lock lock(mutex_);
  if (!file_) return false;
  if (given_up_) return true;
  try {
    write();
    file_->sync();
  } catch (const FileError& error) {
    give_up(error.what());
  }
  return true;
}

void TileRecord::remove() {
  const std::scoped_lock lock(mutex_);
  pending_.clear();
  if (!file_) file_ = open_same();
  if (file_) file_->remove();
  file_.reset();
}

double TileRecord::taken_share() const {
  const double taken = double(taken_colours_), kept = double(kept_colours_);
  return taken > 0 ? taken / (taken + kept) : 0;
}

void TileRecord::begin() {
  auto file = TileFile::open(options_.path, true);
  try {
    file->start(options_.settings());
  } catch (const FileError&) {
    file->remove();  // what was there before is lost already
    throw;
  }
  file_ = std::move(file);
}

void TileRecord::write() {
  if (pending_.empty()) return;
  if (file_->size() + pending_.size() > options_.most_bytes) {
    give_up(options_.path.string() + ": has grown to its limit");
    return;
  }
  file_->append(std::move(pending_));
  pending_.clear();
}

void TileRecord::give_up(const std::string& reason) {
  given_up_ = true;
  pending_.clear();
  pending_.shrink_to_fit();
  options_.warn(reason);
}

}  // namespace sir
