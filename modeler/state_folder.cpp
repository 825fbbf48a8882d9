#include "modeler/state_folder.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "tracer/error.h"

namespace sir::modeler {

std::filesystem::path state_folder() {
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  std::filesystem::path folder = variable("XDG_STATE_HOME");
  // The convention has it that a relative path counts for nothing.
  if (!folder.is_absolute()) {
    const std::filesystem::path home = variable("HOME");
    if (!home.is_absolute()) return {};
    folder = home / ".local" / "state";
  }
  return folder / "sir";
}

void make_state_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  if (folder.has_parent_path()) std::filesystem::create_directories(folder.parent_path(), failure);
  if (!failure && ::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    failure.assign(errno, std::generic_category());
  if (failure) throw FileError(folder.string(), 0, "cannot be made: " + failure.message());
}

}  // namespace sir::modeler
