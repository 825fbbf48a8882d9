// "Did you mean": the known name that is nearest to one that is not (the thesis only says that
// there is no such solid).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sir::modeler {

/// Finds the nearest of the names offered: the fewest letters changed, left out, put in or swapped
/// with their neighbour; case and accents count for nothing. Of equally near ones the first.
class NearestName {
 public:
  explicit NearestName(std::string_view wanted);
  void offer(std::string_view known);

  /// Whether one was near enough to be meant: at most a third of its letters are otherwise, or all
  /// of it begins with what was wanted.
  bool found() const { return found_; }
  const std::string& name() const { return name_; }

 private:
  std::string wanted_;  // folded
  std::string name_;
  std::size_t distance_;
  bool found_ = false;
};

}  // namespace sir::modeler
