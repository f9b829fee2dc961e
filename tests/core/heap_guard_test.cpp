#include "tests/core/heap_guard.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <memory>

namespace hrt {
namespace {

template <class Allocate>
std::int64_t allocations_in(const Allocate& allocate) {
  const std::int64_t before = heap_allocations();
  allocate();
  return heap_allocations() - before;
}

// A guard that sees nothing would let every test pass.
TEST(HeapGuard, SeesNewMallocAndEigen) {
  double kept = 0.0;
  EXPECT_EQ(allocations_in([&] {
              const volatile auto on_heap = std::make_unique<double>(1.0).release();
              kept += *on_heap;
              delete on_heap;
            }),
            1);
  EXPECT_EQ(allocations_in([&] {
              void* volatile memory = std::malloc(16);
              std::free(memory);
            }),
            1);
  Eigen::Index size = 40;
  EXPECT_EQ(allocations_in([&] { kept += Eigen::VectorXd::Ones(size).eval().sum(); }), 1);
  EXPECT_EQ(allocations_in([&] { kept += 1.0; }), 0);
  EXPECT_DOUBLE_EQ(kept, 42.0);
}

}  // namespace
}  // namespace hrt
