#include "viewer/file_watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>

#include "tracer/fnv1a.h"

namespace sir::viewer {
namespace {

using std::chrono::nanoseconds;

nanoseconds time_of(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + nanoseconds(time.tv_nsec);
}

// 0 for what cannot be read.
std::uint64_t hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = in ? fnv1a({}) : 0;
  std::array<char, 1 << 16> part;
  while (in) {
    in.read(part.data(), part.size());
    const auto got = std::span(part).first(static_cast<std::size_t>(in.gcount()));
    hash = fnv1a(std::as_bytes(got), hash);
  }
  return hash;
}

// Whether a change of the contents might leave the other members as they are.
bool is_young(const FileStamp& stamp) { return stamp.age < FileWatch::kYoung; }

bool alike(const FileStamp& a, const FileStamp& b) {
  return a.file == b.file && a.there == b.there && a.device == b.device && a.inode == b.inode &&
         a.bytes == b.bytes && a.modified == b.modified;
}

bool same(const FileStamp& a, const FileStamp& b) {
  return alike(a, b) && (!a.content || !b.content || a.content == b.content);
}

// `before`: the stamp of the look before; its content is compared once more after the file has
// grown old.
FileStamp stamp_of(const std::filesystem::path& file, const FileStamp* before) {
  FileStamp stamp;
  stamp.file = file;
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return stamp;
  stamp.there = true;
  stamp.device = status.st_dev;
  stamp.inode = status.st_ino;
  stamp.bytes = static_cast<std::uint64_t>(status.st_size);
  stamp.modified = time_of(status.st_mtim).count();
  const nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
  stamp.age = now - std::max(time_of(status.st_mtim), time_of(status.st_ctim));
  const bool was_young = before && alike(*before, stamp) && is_young(*before);
  // Opening a pipe would wait for its writer.
  if (S_ISREG(status.st_mode) && (is_young(stamp) || was_young)) stamp.content = hash_of(file);
  return stamp;
}

}  // namespace

void FileWatch::look(const std::vector<std::filesystem::path>& files) {
  std::vector<FileStamp> found;
  for (std::size_t i = 0; i < files.size(); ++i)
    found.push_back(stamp_of(files[i], i < latest_.size() ? &latest_[i] : nullptr));
  const auto untouched = [&](const FileStamp& stamp) { return !stamp.there || stamp.age > rest_; };
  const bool unchanged = looked_ && std::ranges::equal(found, latest_, same);
  at_rest_ = looked_ ? unchanged : std::ranges::all_of(found, untouched);
  changed_ = changed_ || !unchanged;
  looked_ = true;
  latest_ = std::move(found);
}

}  // namespace sir::viewer
