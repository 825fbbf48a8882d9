// Runs `sir` in front of a terminal of its own, as a person does.
#pragma once

#include <sys/types.h>
#include <termios.h>

#include <filesystem>
#include <string>
#include <vector>

namespace sir::test {

/// A program whose standard streams are a terminal that also controls it; killed where it is still
/// running in the end.
class AtTerminal {
 public:
  /// `folder` is its working directory, `columns` the terminal's width.
  AtTerminal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
             int columns);
  ~AtTerminal();
  AtTerminal(const AtTerminal&) = delete;
  AtTerminal& operator=(const AtTerminal&) = delete;

  /// Waits until `text` has come; false where the program ended without it.
  bool wait_for(const std::string& text);

  /// Types it.
  void type(const std::string& text) const;

  void signal(int number) const;

  /// The terminal's modes before the program began, and now.
  const termios& modes_at_first() const { return at_first_; }
  termios modes() const;

  /// Waits for the end; 128 + number where a signal ended it.
  int finish();

  /// All that was printed, without the carriage returns that a terminal adds.
  std::string shown() const;

 private:
  bool pump();

  pid_t process_ = -1;
  int line_ = -1;
  termios at_first_{};
  std::string got_;
};

}  // namespace sir::test
