#include "tracer/tile_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "tracer/error.h"
#include "tracer/fnv1a.h"

namespace sir {
namespace {

constexpr std::string_view kAnyMagic = "SIR tiles ", kMagic = "SIR tiles 1\n";
constexpr std::size_t kCounts = 17, kCheck = 8;
constexpr std::size_t kTileHead = 4 + 8 + 4 + 8 * kCounts;

std::string system_reason() { return std::strerror(errno); }

template <typename Number>
void put(std::string& text, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    text += static_cast<char>(static_cast<std::uint8_t>(number >> (8 * i)));
}

template <typename Number>
Number get(std::string_view text, std::size_t at) {
  Number number = 0;
  for (std::size_t i = sizeof number; i-- > 0;)
    number = static_cast<Number>(number << 8 | static_cast<std::uint8_t>(text[at + i]));
  return number;
}

std::uint64_t check_of(std::string_view text) {
  return fnv1a(std::as_bytes(std::span(text.data(), text.size())));
}

std::uint64_t check_of(std::string_view text, std::uint64_t start) {
  return fnv1a(std::as_bytes(std::span(text.data(), text.size())), start);
}

// All numbers of the counts, in the file's order.
template <typename Counts, typename Visit>
void for_each_count(Counts& counts, Visit&& visit) {
  for (const auto member : RayCounts::kMembers) visit(counts.*member);
  visit(counts.costs.calls);
  visit(counts.costs.combinations);
  visit(counts.costs.envelopes);
  for (auto& primitives : counts.costs.primitives) visit(primitives);
}

bool same_file(int descriptor, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

std::unique_ptr<TileFile> TileFile::open(const std::filesystem::path& path, bool create) {
  const auto failed = [&](const std::string& reason) -> FileError {
    return {path.string(), 0, reason};
  };
  // A record that is removed between opening and locking it is not the one that has the name.
  for (;;) {
    // Never waits, as for a pipe's other end.
    const int flags =
        O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | O_NOFOLLOW | (create ? O_CREAT : 0);
    const int descriptor = ::open(path.c_str(), flags, 0666);
    if (descriptor < 0 && errno == ENOENT && !create) return nullptr;
    if (descriptor < 0) throw failed("cannot be opened: " + system_reason());
    std::unique_ptr<TileFile> file(new TileFile(path, descriptor));
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) throw failed("cannot be read: " + system_reason());
    if (!S_ISREG(status.st_mode)) throw failed("is no record of finished tiles");
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
      throw failed(errno == EWOULDBLOCK ? "is in use by another render"
                                        : "cannot be locked: " + system_reason());
    if (!same_file(descriptor, path)) continue;
    file->read_header();
    return file;
  }
}

TileFile::TileFile(std::filesystem::path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

TileFile::~TileFile() { ::close(descriptor_); }

void TileFile::read_header() {
  const std::string start = read_at(0, kMagic.size() + 4);
  const std::string_view seen(start);
  const std::size_t known = std::min(seen.size(), kAnyMagic.size());
  if (seen.substr(0, known) != kAnyMagic.substr(0, known)) fail("is no record of finished tiles");
  if (!seen.starts_with(kMagic) || seen.size() < kMagic.size() + 4) return;
  const auto length = get<std::uint32_t>(seen, kMagic.size());
  if (length > kMostSettings) return;
  const std::size_t end = seen.size() + length;
  const std::string all = read_at(0, end + kCheck);
  if (all.size() < end + kCheck) return;
  const std::string_view checked = std::string_view(all).substr(0, end);
  if (check_of(checked) != get<std::uint64_t>(all, end)) return;
  check_ = check_of(checked);
  settings_ = checked.substr(seen.size());
  size_ = all.size();
}

void TileFile::start(const std::string& settings) {
  if (settings.size() > kMostSettings) fail("cannot hold settings of that length");
  if (::ftruncate(descriptor_, 0) != 0) fail("cannot be written: " + system_reason());
  size_ = 0;
  std::string header(kMagic);
  put(header, static_cast<std::uint32_t>(settings.size()));
  header += settings;
  check_ = check_of(header);
  put(header, check_);
  write(header);
  settings_ = settings;
}

std::map<TileId, TileFile::Place> TileFile::find_tiles(std::uint64_t& dropped) {
  std::map<TileId, Place> tiles;
  dropped = 0;
  if (!settings_) return tiles;
  for (;;) {
    const std::string head = read_at(size_, kTileHead);
    if (head.size() < kTileHead) break;
    const TileId tile{get<std::uint32_t>(head, 0), get<std::uint64_t>(head, 4)};
    const Place place{size_, get<std::uint32_t>(head, 12)};
    if (place.colours == 0 || place.colours > kMostColours) break;
    std::vector<Rgb8> colours(place.colours);
    RayCounts cost;
    if (!load(tile, place, colours, cost)) break;
    tiles[tile] = place;
    size_ += kTileHead + std::size_t{3} * place.colours + kCheck;
  }
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail("cannot be read: " + system_reason());
  dropped = static_cast<std::uint64_t>(status.st_size) - size_;
  if (dropped > 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0)
    fail("cannot be written: " + system_reason());
  return tiles;
}

bool TileFile::load(const TileId& tile, const Place& place, std::span<Rgb8> colours,
                    RayCounts& cost) const {
  const std::size_t end = kTileHead + 3 * colours.size();
  const std::string bytes = read_at(place.offset, end + kCheck);
  if (bytes.size() < end + kCheck) return false;
  const TileId seen{get<std::uint32_t>(bytes, 0), get<std::uint64_t>(bytes, 4)};
  if (seen != tile || get<std::uint32_t>(bytes, 12) != colours.size()) return false;
  const std::string_view checked = std::string_view(bytes).substr(0, end);
  if (check_of(checked, check_) != get<std::uint64_t>(bytes, end)) return false;
  std::size_t at = 16;
  for_each_count(cost, [&](std::uint64_t& count) {
    count = get<std::uint64_t>(bytes, at);
    at += 8;
  });
  for (Rgb8& colour : colours) {
    colour = {static_cast<std::uint8_t>(bytes[at]), static_cast<std::uint8_t>(bytes[at + 1]),
              static_cast<std::uint8_t>(bytes[at + 2])};
    at += 3;
  }
  return true;
}

void TileFile::encode(const TileId& tile, std::span<const Rgb8> colours, const RayCounts& cost,
                      std::string& text) {
  put(text, tile.stage);
  put(text, tile.first);
  put(text, static_cast<std::uint32_t>(colours.size()));
  for_each_count(cost, [&](std::uint64_t count) { put(text, count); });
  for (const Rgb8& colour : colours) {
    text += static_cast<char>(colour.r);
    text += static_cast<char>(colour.g);
    text += static_cast<char>(colour.b);
  }
  text.append(kCheck, '\0');
}

void TileFile::append(std::string tiles) {
  for (std::size_t at = 0; at < tiles.size(); at += kCheck) {
    const std::size_t length = kTileHead + std::size_t{3} * get<std::uint32_t>(tiles, at + 12);
    std::string check;
    put(check, check_of(std::string_view(tiles).substr(at, length), check_));
    at += length;
    tiles.replace(at, kCheck, check);
  }
  write(tiles);
}

void TileFile::write(std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done,
                                     static_cast<off_t>(size_ + done));
    if (written < 0) {
      if (errno == EINTR) continue;
      const std::string reason = system_reason();
      (void)!::ftruncate(descriptor_, static_cast<off_t>(size_));
      fail("cannot be written: " + reason);
    }
    done += static_cast<std::size_t>(written);
  }
  size_ += bytes.size();
}

void TileFile::sync() const {
  if (::fsync(descriptor_) != 0) fail("cannot be written: " + system_reason());
}

void TileFile::remove() {
  // Locked, so that the name is still this file's.
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

std::string TileFile::read_at(std::uint64_t offset, std::size_t length) const {
  std::string bytes(length, '\0');
  std::size_t done = 0;
  while (done < length) {
    const ssize_t got =
        ::pread(descriptor_, bytes.data() + done, length - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot be read: " + system_reason());
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

void TileFile::fail(const std::string& reason) const { throw FileError(path_.string(), 0, reason); }

}  // namespace sir
