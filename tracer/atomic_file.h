// Writing the files of thesis 3.6 so that a reader sees the old content or the
// new, never a part.
#pragma once

#include <sys/types.h>

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
///
/// Whenever the process is killed, the destination is whole: the old or the new. When the power
/// fails as well, once commit() has returned the new one is there, as far as the disk keeps its
/// word; the folder is synchronised too, where it may be read and its file system can. A process
/// that is killed leaves its temporary file, which the next AtomicFile for that destination
/// removes (see stale_temporaries.h). Several files that change together: atomic_files.h.
///
/// Errors (missing folder, no permission, full disk) throw FileError.
class AtomicFile {
 public:
  /// `mode`: the permissions of a file that is new, less the umask; those of one that is there
  /// are kept.
  explicit AtomicFile(std::filesystem::path destination, mode_t mode = 0666);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// What will be replaced: the end of a chain of symbolic links.
  const std::filesystem::path& destination() const { return destination_; }

  /// Flushes to the disk: what is still to fail shows here, before any name is taken.
  void flush();

  /// Flushes, where that is not done, renames over the destination and synchronises the folder.
  void commit();

 private:
  friend class AtomicFiles;
  void make_temporary(mode_t mode);
  void take_name();
  void sync_folder() const;
  [[noreturn]] void fail(int code) const;

  std::filesystem::path destination_;
  std::filesystem::path temporary_;  // empty when writing directly
  bool direct_ = false;
  int descriptor_ = -1;
  bool flushed_ = false;
};

/// Throws the FileError that an AtomicFile for `destination` would, and leaves nothing there: so
/// that long work is not begun for an output that cannot be written. Pipes and devices are not
/// opened, for whoever reads them would take that for the end.
void require_writable(const std::filesystem::path& destination);

/// Sends a file's name to the disk, where a power cut does not reach it; errno where that failed,
/// 0 where it is done or cannot be asked for.
int sync_folder_of(const std::filesystem::path& file);

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
