#include "viewer/folder_listing.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "tracer/text_file.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;

bool has_one_of(const fs::path& file, const std::vector<std::string>& suffixes) {
  const std::string suffix = fold_keyword(readable(file.extension().string()));
  return std::any_of(suffixes.begin(), suffixes.end(), [&](const std::string& wanted) {
    return suffix == "." + fold_keyword(wanted);
  });
}

fs::path plain_path(const fs::path& path) {
  std::error_code failure;
  const fs::path whole = fs::absolute(path, failure).lexically_normal();
  // "a/" is the folder a, whose parent is not a.
  return whole.has_filename() || !whole.has_relative_path() ? whole : whole.parent_path();
}

}  // namespace

FolderListing list_folder(const fs::path& folder, const std::vector<std::string>& suffixes) {
  FolderListing listing{plain_path(folder), {}, {}};
  std::error_code failure;
  fs::directory_iterator at(listing.folder, failure);
  for (; !failure && at != fs::directory_iterator(); at.increment(failure)) {
    const fs::path name = at->path().filename();
    if (name.native().starts_with('.')) continue;
    std::error_code ignored;
    const bool is_folder = at->is_directory(ignored);
    if (!is_folder && !suffixes.empty() && !has_one_of(name, suffixes)) continue;
    listing.entries.push_back({name, readable(name.native()), is_folder});
  }
  if (failure) {
    listing.entries.clear();
    listing.error = readable(listing.folder.native()) + ": " + failure.message();
  }
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) {
              if (a.folder != b.folder) return a.folder;
              const std::string one = fold_keyword(a.shown), other = fold_keyword(b.shown);
              return one != other ? one < other : a.name.native() < b.name.native();
            });
  return listing;
}

std::string readable(std::string_view name) {
  std::string clean(name);
  for (char& letter : clean)
    if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7F') letter = '?';
  TextFile text("-", clean);
  // White space at its ends is a name's own; where nothing else is there, so is nothing at all.
  if (!text.next()) return clean;
  const std::size_t first = clean.find_first_not_of(' '), last = clean.find_last_not_of(' ');
  return clean.substr(0, first) + std::string(text.line()) + clean.substr(last + 1);
}

fs::path named_in(const FolderListing& listing, const std::string& typed) {
  for (const FolderEntry& entry : listing.entries)
    if (entry.shown == typed) return listing.folder / entry.name;
  if (typed == "~" || typed.starts_with("~/")) {
    const char* home = std::getenv("HOME");
    if (home != nullptr)
      return plain_path(fs::path(home) / typed.substr(std::min<std::size_t>(2, typed.size())));
  }
  return plain_path(listing.folder / typed);
}

fs::path with_one_of(const fs::path& file, const std::vector<std::string>& suffixes) {
  if (suffixes.empty() || has_one_of(file, suffixes)) return file;
  return fs::path(file.native() + "." + suffixes.front());
}

fs::path as_written(const fs::path& file) {
  std::error_code failure;
  const fs::path here = fs::current_path(failure);
  if (failure) return file;
  const fs::path near = plain_path(file).lexically_relative(here);
  return near.empty() || *near.begin() == ".." ? plain_path(file) : near;
}

}  // namespace sir::viewer
