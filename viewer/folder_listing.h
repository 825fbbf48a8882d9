// What a folder holds, for a person who chooses a file there: the thesis's modeler asks for a name
// and leaves it at that (salva and carrega sólido, 3.2.2.7, 3.2.2.8).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sir::viewer {

/// A line of a listing.
struct FolderEntry {
  std::filesystem::path name;  ///< in the folder, its bytes as they are on the disk
  std::string shown;           ///< the same as readable() has it
  bool folder = false;
};

struct FolderListing {
  std::filesystem::path folder;      ///< absolute, without . and ..
  std::vector<FolderEntry> entries;  ///< folders first, each kind by name, without case and accents
  std::string error;                 ///< why it cannot be read; "" where it can
};

/// Folders, and files with one of these suffixes ("CSG"; in any case; none: all of them). Names
/// that begin with a dot are left out. What cannot be read has an error and no entries.
FolderListing list_folder(const std::filesystem::path& folder,
                          const std::vector<std::string>& suffixes);

/// A name as UTF-8 to be read by a person: bytes that are none are taken as ISO-8859-1, control
/// characters are "?".
std::string readable(std::string_view name);

/// The file that a typed name stands for: an entry that is shown so, else the name itself in the
/// listing's folder, or wherever an absolute one says. "~" at its start is the home folder.
std::filesystem::path named_in(const FolderListing& listing, const std::string& typed);

/// With the first suffix where it has none of them; as it is where there are none.
std::filesystem::path with_one_of(const std::filesystem::path& file,
                                  const std::vector<std::string>& suffixes);

/// The file as a command names it, so that a script says no more than it must: relative to the
/// working folder where it is in there, else absolute.
std::filesystem::path as_written(const std::filesystem::path& file);

}  // namespace sir::viewer
