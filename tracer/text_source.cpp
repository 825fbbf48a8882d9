#include "tracer/text_source.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "tracer/error.h"
#include "tracer/limits.h"
#include "tracer/utf8.h"

namespace sir {

TextSource::TextSource(const std::filesystem::path& path) : name_(path.string()) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail(0, "is a folder");
  file_.reset(std::fopen(name_.c_str(), "rb"));
  if (!file_) fail(0, std::string("cannot be read: ") + std::strerror(errno));
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // it is read in large pieces anyway
  struct stat status {};
  const bool regular = ::fstat(::fileno(file_.get()), &status) == 0 && S_ISREG(status.st_mode);
  const std::size_t stated = regular ? static_cast<std::size_t>(status.st_size) : 0;
  const bool keep = !regular || stated <= kKept;
  look_through(keep, stated, regular ? kMaxFile : kMaxStream);
  if (keep) file_.reset();
  else std::rewind(file_.get());
}

void TextSource::look_through(bool keep, std::size_t stated, std::size_t most) {
  std::array<char, kPiece + 4> bytes;
  static_assert(kPiece <= kMaxLine);
  // Not twice the room, as when it grows; what is not filled costs nothing.
  if (keep) kept_.reserve(stated > 0 ? stated : most);
  std::size_t unfinished = 0;   // bytes of a character whose rest comes in the next piece
  std::size_t line_length = 0;  // of the last line so far
  while (const std::size_t got = std::fread(&bytes[unfinished], 1, kPiece, file_.get())) {
    // Checked while reading, so that a line of gigabytes costs a megabyte. Lines that begin and
    // end in one piece are short enough.
    const std::string_view piece(&bytes[unfinished], got);
    const auto first_end = piece.find('\n');
    if (line_length + std::min(first_end, got) > kMaxLine)
      fail(current_line(), "the line is longer than " + std::to_string(kMaxLine) + " bytes");
    line_length = first_end == piece.npos ? line_length + got : got - 1 - piece.rfind('\n');
    size_ += got;
    // What is too long by its own statement may still have a line to tell of at its beginning.
    if (size_ > most || (stated > most && size_ > kMaxLine))
      fail(0, "the file is longer than " + std::to_string(most) + " bytes");
    if (keep) kept_ += piece;
    if (!utf8_) continue;
    const std::string_view all(bytes.data(), unfinished + got);
    unfinished = unfinished_utf8(all);
    utf8_ = is_utf8(all.substr(0, all.size() - unfinished));
    if (utf8_) std::memmove(bytes.data(), bytes.data() + all.size() - unfinished, unfinished);
    else unfinished = 0;
  }
  if (std::ferror(file_.get())) fail(current_line(), "cannot be read further");
  utf8_ = utf8_ && unfinished == 0;
}

// Counted only where it is to be told.
std::size_t TextSource::current_line() {
  const auto ends_in = [](std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  };
  std::size_t line = 1 + ends_in(kept_);
  if (!kept_.empty()) return line;
  std::rewind(file_.get());
  std::array<char, kPiece> bytes;
  for (std::size_t left = size_; left > 0;) {
    const auto got = std::fread(bytes.data(), 1, std::min(left, bytes.size()), file_.get());
    if (got == 0) break;
    line += ends_in({bytes.data(), got});
    left -= got;
  }
  return line;
}

bool TextSource::read(std::string& text, std::size_t line) {
  if (!file_) {
    if (kept_.empty()) return false;
    if (text.empty()) text = std::move(kept_);
    else text += kept_;
    kept_.clear();
    return true;
  }
  std::array<char, kPiece> bytes;
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), file_.get());
  if (std::ferror(file_.get())) fail(line, "cannot be read further");
  text.append(bytes.data(), got);
  return got > 0;
}

void TextSource::fail(std::size_t line, const std::string& reason) const {
  throw FileError(name_, line, reason);
}

}  // namespace sir
