#include "plugin/src/abi/fork.h"

#include <atomic>
#include <new>

#if !defined(_WIN32) && !defined(__EMSCRIPTEN__)
#include <pthread.h>
#endif

#include "plugin/src/abi/host.h"

namespace hrt::plugin {
namespace {

constinit std::atomic<std::uint32_t> fork_count{0};

}  // namespace

void watch_forks() {
#if !defined(_WIN32) && !defined(__EMSCRIPTEN__)
  static const bool watched = [] {
    const auto in_child = [] {
      fork_count.fetch_add(1, std::memory_order_relaxed);
      reset_log_mutex_after_fork();
    };
    if (pthread_atfork(nullptr, nullptr, in_child) != 0) throw std::bad_alloc();
    return true;
  }();
  static_cast<void>(watched);
#endif
}

std::uint32_t forks() { return fork_count.load(std::memory_order_relaxed); }

}  // namespace hrt::plugin
