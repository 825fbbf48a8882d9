#include "cli/interrupt.h"

#include <semaphore.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "tracer/atomic_file.h"

namespace sir::cli {
namespace {

std::stop_source& source() {
  static std::stop_source instance;
  return instance;
}

sem_t arrived;
volatile sig_atomic_t count = 0;

// A stop_source may not be touched in a signal handler; a semaphore may.
extern "C" void on_signal(int) {
  if (count != 0) {
    remove_temporaries();
    _exit(130);
  }
  count = 1;
  sem_post(&arrived);
}

}  // namespace

void install_signal_handlers() {
  source();
  sem_init(&arrived, 0, 0);
  // Signals are for the main thread, whose reading they end.
  sigset_t ours, before;
  sigemptyset(&ours);
  sigaddset(&ours, SIGINT);
  sigaddset(&ours, SIGTERM);
  sigaddset(&ours, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &ours, &before);
  std::thread([] {
    while (sem_wait(&arrived) != 0 && errno == EINTR) {
    }
    source().request_stop();
  }).detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_mask = ours;  // one at a time: the second must see that there was a first
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction inherited {};
  sigaction(SIGHUP, nullptr, &inherited);
  if (inherited.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes: writing fails and says so
}

std::stop_token interruption() { return source().get_token(); }

bool interrupted() { return count != 0; }

}  // namespace sir::cli
