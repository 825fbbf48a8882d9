// What a killed process leaves beside its output, and how it is told from what a live one is
// writing.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string_view>

namespace sir {

/// DESTINATION.sir-PID-N.tmp: unique on a machine, and no other program's.
std::filesystem::path temporary_beside(const std::filesystem::path& destination);

/// Whether `name`, without folder, is one that temporary_beside() gives for a destination called
/// `destination`, in whatever process.
bool is_temporary_of(std::string_view name, std::string_view destination);

/// Marks a new temporary file as being written, by a lock (flock) that goes with its descriptor,
/// and so with its process. False where remove_stale_temporaries() was quicker: the file is gone
/// or about to be, and another has to be made. Where the file system has no locks the file is
/// simply not marked.
bool mark_as_written(int descriptor);

/// Removes the temporary files of `destination` whose writers are gone. A file goes only if all
/// this holds: it has such a name, is a regular file and this user's, and nobody has it locked. The
/// process number in the name counts for nothing: it may be another process's by now, or one of
/// another machine or container. On file systems that are not known to be local, where a mount
/// may keep locks to itself, it must also be an hour older than `newest`, a descriptor of a file
/// that was just made there: that file's time is by the same clock. What cannot be removed stays:
/// nothing is thrown.
void remove_stale_temporaries(const std::filesystem::path& destination, int newest) noexcept;

}  // namespace sir
