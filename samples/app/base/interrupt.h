#pragma once

#include <atomic>
#include <csignal>
#include <stdexcept>

namespace hrt::app {

/// Thrown when a signal, or a key of the user, has requested that the program end.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// True after SIGINT (Ctrl-C), SIGTERM or SIGHUP (the terminal was closed), if note_interrupts() was called before.
inline std::atomic<bool> interrupt_noted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// Installs handlers that set interrupt_noted. If the same signal arrives again, it ends the program immediately.
inline void note_interrupts() {
  struct sigaction action{};
  action.sa_handler = [](int) { interrupt_noted = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

inline bool is_interrupted() { return interrupt_noted; }

inline void throw_if_interrupted() {
  if (interrupt_noted) throw Interrupted();
}

}  // namespace hrt::app
