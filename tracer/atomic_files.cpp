#include "tracer/atomic_files.h"

#include <signal.h>

#include <algorithm>
#include <vector>

namespace sir {
namespace {

// No signal handler runs in this thread meanwhile.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

AtomicFile& AtomicFiles::add(const std::filesystem::path& destination) {
  return files_.emplace_back(destination);
}

void AtomicFiles::commit() {
  for (AtomicFile& file : files_) file.flush();
  {
    const SignalsHeld held;
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
