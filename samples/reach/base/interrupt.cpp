#include "samples/reach/base/interrupt.h"

#include <atomic>
#include <csignal>

namespace hrt::reach {
namespace {

// A signal may come to any thread.
std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void note_interrupts() {
  struct sigaction action{};
  action.sa_handler = [](int) { noted = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool is_interrupted() { return noted; }

void throw_if_interrupted() {
  if (noted) throw Interrupted();
}

}  // namespace hrt::reach
