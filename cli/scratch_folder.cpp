#include "cli/scratch_folder.h"

#include <stdlib.h>

#include <string>

#include "tracer/error.h"

namespace sir::cli {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::error_code failure;
  std::string name = (fs::temp_directory_path(failure) / "sir-XXXXXX").string();
  if (failure || !mkdtemp(name.data())) throw FileError(name, 0, "cannot be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace sir::cli
