// Writing the files of thesis 3.6 so that a reader sees the old content or the
// new, never a part.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace sir {

/// A file that is being written beside its destination and takes its place
/// only at commit(). Destroying it without commit() removes the temporary
/// file and leaves the destination as it was. A destination that is not a
/// regular file (a device, a pipe) is written directly, because a rename
/// would replace it.
/// Errors (missing folder, no permission, full disk) throw FileError.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path destination);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Flushes to the disk: what is still to fail shows here, before any name is taken.
  void flush();

  /// Flushes, where that is not done, and renames over the destination.
  void commit();

 private:
  std::filesystem::path destination_;
  std::filesystem::path temporary_;  // empty when writing directly
  int descriptor_ = -1;
  bool flushed_ = false;
};

/// Removes the temporary files of all AtomicFiles that are open: for a signal
/// handler that ends the process at once, in which it may be called.
void remove_temporaries() noexcept;

/// Writes a whole file in one step.
void write_file_atomically(const std::filesystem::path& destination,
                           std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& destination, std::string_view text);

/// Refuses (FileError) to write `output` where it is the same file as
/// `input`: inputs are never overwritten.
void refuse_same_file(const std::filesystem::path& output, const std::filesystem::path& input);

}  // namespace sir
