#include "cli/input_wait.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <stop_token>

#include "cli/interrupt.h"

namespace sir::cli {
namespace {

// A descriptor that can be read once a stop was requested. A signal that comes just before a read
// would not end that; this is still there when poll() looks.
class StopEvent {
 public:
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = ::eventfd(0, EFD_CLOEXEC);
  std::stop_callback<std::function<void()>> callback_{interruption(), [this] {
                                                        const std::uint64_t one = 1;
                                                        // It can only fail where it is there
                                                        // already.
                                                        (void)!::write(descriptor_, &one,
                                                                       sizeof one);
                                                      }};
};

}  // namespace

bool wait_for_input(int descriptor) {
  static const StopEvent stop;
  for (;;) {
    std::array<pollfd, 2> ready{{{descriptor, POLLIN, 0}, {stop.descriptor(), POLLIN, 0}}};
    const int count = ::poll(ready.data(), ready.size(), -1);
    if (interrupted() || ready[1].revents != 0) return false;
    if (count > 0 || errno != EINTR) return true;
  }
}

}  // namespace sir::cli
