#include "tracer/atomic_files.h"

#include <algorithm>
#include <vector>

#include "tracer/all_signals_held.h"

namespace sir {
AtomicFile& AtomicFiles::add(const std::filesystem::path& destination) {
  return files_.emplace_back(destination);
}

void AtomicFiles::commit() {
  for (AtomicFile& file : files_) file.flush();
  {
    const AllSignalsHeld held;
    for (AtomicFile& file : files_) file.take_name();
  }
  std::vector<std::filesystem::path> synced;
  for (const AtomicFile& file : files_) {
    const auto folder = file.destination_.parent_path();
    if (std::find(synced.begin(), synced.end(), folder) != synced.end()) continue;
    file.sync_folder();
    if (!file.direct_) synced.push_back(folder);
  }
}

}  // namespace sir
