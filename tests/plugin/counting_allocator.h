#pragma once

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <limits>

#include "tests/plugin/fixture.h"

#if defined(_WIN32)
#define malloc_usable_size _msize
#endif

namespace hrt::test {

/// The allocator of the library during the lifetime of the object. Counts requests, blocks and bytes. Fails at request
/// number `fail_at` and, with `fail_on`, at all later ones; also beyond `budget` bytes.
class CountingAllocator {
 public:
  CountingAllocator() {
    hrt_host host = hrt_host_init();
    host.context = this;
    host.allocate = [](void* context, std::size_t size, std::size_t) -> void* {
      auto& self = *static_cast<CountingAllocator*>(context);
      const long request = ++self.requests;
      if (request == self.fail_at || (self.fail_on && self.fail_at > 0 && request > self.fail_at)) return nullptr;
      if (self.bytes + static_cast<long>(size) > self.budget) return nullptr;
      void* memory = std::malloc(size);
      ++self.held;
      self.bytes += static_cast<long>(malloc_usable_size(memory));
      return memory;
    };
    host.release = [](void* context, void* memory) {
      auto& self = *static_cast<CountingAllocator*>(context);
      --self.held;
      self.bytes -= static_cast<long>(malloc_usable_size(memory));
      std::free(memory);
    };
    EXPECT_OK(hrt_host_set(&host));
  }
  ~CountingAllocator() { EXPECT_OK(hrt_host_set(nullptr)); }
  CountingAllocator(const CountingAllocator&) = delete;
  CountingAllocator& operator=(const CountingAllocator&) = delete;

  std::atomic<long> requests{0};
  std::atomic<long> held{0};
  std::atomic<long> fail_at{0};
  std::atomic<bool> fail_on{false};
  std::atomic<long> bytes{0};
  std::atomic<long> budget{std::numeric_limits<long>::max()};
};

}  // namespace hrt::test
