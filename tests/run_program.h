// Runs `sir` as a script or a person at a terminal does.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sir::test {

/// How a program is started.
struct Start {
  std::string in;                ///< its standard input; ends unless `keep_in_open`
  std::string in_file;           ///< its standard input comes from there; empty: `in`
  std::filesystem::path folder;  ///< its working directory; empty: ours
  std::string out_file;          ///< its standard output goes there, e.g. /dev/full
  bool out_closed = false;       ///< nobody reads its standard output
  bool keep_in_open = false;
  bool err_is_terminal = false;
};

/// What is left of it.
struct Ended {
  int exit_code = -1;  ///< 128 + number where a signal ended it
  std::string out, err;
  long peak_kilobytes = 0;  ///< of memory
};

/// Whether a terminal can be had here; a bare root without /dev/pts has none.
bool terminals_exist();

/// A program that is running; killed where it is still running in the end.
class Program {
 public:
  Program(const std::string& path, const std::vector<std::string>& arguments, const Start& start);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Waits until `text` has come on standard output or standard error; false
  /// where the program ended without it.
  bool wait_for(std::string_view text);

  void signal(int number) const;

  /// Waits for the end.
  Ended finish();

 private:
  bool pump();
  void close_all();

  pid_t process_ = -1;
  std::string in_;
  bool keep_in_open_;
  int in_pipe_ = -1, out_pipe_ = -1, err_pipe_ = -1;
  Ended ended_;
};

/// Runs the built `sir` to its end.
Ended run_sir(const std::vector<std::string>& arguments, const Start& start = {});

}  // namespace sir::test
