#include "core/interrupt.hpp"

#include "core/error.hpp"

#include <csignal>

namespace platen::core {
namespace {

volatile std::sig_atomic_t stop = 0;
bool (*host_asked)() = nullptr;

extern "C" void ask_to_stop(int) { stop = 1; }

} // namespace

void watch_for_interrupts() {
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART | SA_RESETHAND; // RESETHAND: whoever asks twice does not want to wait
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that may grow no further (ulimit -f) is an error to report like a full disk, not a reason to die.
  std::signal(SIGXFSZ, SIG_IGN);
}

void ask_for_interrupts(bool (*host)()) { host_asked = host; }

bool interrupted() { return stop != 0 || (host_asked && host_asked()); }

void stop_if_asked() {
  if (interrupted()) throw Interrupted("stopped; nothing was written");
}

} // namespace platen::core
