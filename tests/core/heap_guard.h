// Fails a test on any use of the heap, by operator new, malloc or Eigen, in this program or a library.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

namespace hrt {

/// Heap allocations that this thread has made so far; that all threads have, without the GNU C library.
std::int64_t heap_allocations();

/// Forbids the heap to this thread while it lives: its end fails the test if anything was allocated.
class HeapGuard {
 public:
  HeapGuard() : before_(heap_allocations()) {}
  ~HeapGuard() { EXPECT_EQ(heap_allocations() - before_, 0) << "heap allocations"; }
  HeapGuard(const HeapGuard&) = delete;
  HeapGuard& operator=(const HeapGuard&) = delete;

 private:
  std::int64_t before_;
};

}  // namespace hrt
