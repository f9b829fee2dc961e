#pragma once

#include <memory>
#include <thread>

#if !defined(_WIN32)
#include <csignal>
#endif

namespace hrt {

/// Starts a thread that blocks all signals, so that only the host's threads receive signals.
template <class Run>
std::thread start_thread_with_signals_blocked(Run run) {
#if defined(_WIN32)
  return std::thread(run);
#else
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const auto restore = [](const sigset_t* mask) { pthread_sigmask(SIG_SETMASK, mask, nullptr); };
  const std::unique_ptr<const sigset_t, decltype(restore)> restored(&before, restore);  // also if std::thread throws
  return std::thread(run);
#endif
}

}  // namespace hrt
