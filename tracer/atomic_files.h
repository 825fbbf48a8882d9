// Files that change together: the planes and the PNG of an image, the four files of a scene.
#pragma once

#include <filesystem>
#include <list>

#include "tracer/atomic_file.h"

namespace sir {

/// Several AtomicFiles with one commit(). All are written and flushed to the disk before the first
/// takes its name: what can be foreseen to fail (a full disk, a protected folder, a pipe that is
/// closed) leaves all of them as they were.
///
/// Then they are renamed one straight after the other, and last their folders are synchronised.
/// No file system renames several files at once: who is killed, or reads, or loses power between
/// the first rename and the last has some of the new files and some of the old. Each is whole;
/// that they belong together is not promised for that moment. Nor where a rename fails though the
/// folder can be written (another's file in a folder with the sticky bit, a file that is a mount
/// point): the error names that file, those before it are new. Catchable signals wait until the
/// renames are done, if they are for the committing thread.
class AtomicFiles {
 public:
  /// A further file; what is written to it shows after commit(). The reference holds as long as
  /// this. Throws FileError.
  AtomicFile& add(const std::filesystem::path& destination);

  void commit();

 private:
  std::list<AtomicFile> files_;  // in which they stay where they are
};

}  // namespace sir
