// Choosing a file: folders, names, and a question before anything is replaced. The thesis's
// modeler asks for a name (3.2.2.7). Only in builds with Dear ImGui.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/folder_listing.h"

namespace sir::viewer {

/// A dialog over the whole window, one at a time. Between two it stays in the folder it was in.
class FileDialog {
 public:
  struct Wanted {
    std::string title;
    std::string button = {};            ///< what it does: "Open", "Save"
    std::vector<std::string> suffixes;  ///< in upper case; what has none of them gets the first
    bool to_save = false;       ///< a file that need not be there, and is asked about where it is
    std::string proposed = {};  ///< a name to begin with
    std::function<void(const std::filesystem::path& file)> chosen = {};  ///< absolute
  };

  /// Begins with the next drawing; in `folder`, if that is not empty, else where the last one was.
  void open(Wanted wanted, const std::filesystem::path& folder = {});
  bool is_open() const { return wanted_.has_value(); }

  /// Draws it where it is open. `note` hears of every part that can be clicked, right behind it.
  void draw(const std::function<void(const std::string& label)>& note);

 private:
  using Note = std::function<void(const std::string&)>;

  void draw_folder(const Note& note);
  void draw_entries(const Note& note);
  void draw_name(const Note& note);
  void draw_question(const Note& note);
  void go_to(std::filesystem::path folder);
  void name(const std::string& text);
  void accept();
  void finish(const std::filesystem::path& file);

  std::optional<Wanted> wanted_;
  FolderListing listing_;
  std::array<char, 1024> name_{};
  int names_ = 0;  // that were put there
  std::string error_;
  std::optional<std::filesystem::path> replaced_;  // what is asked about
  bool opening_ = false, to_name_ = false;
};

}  // namespace sir::viewer
