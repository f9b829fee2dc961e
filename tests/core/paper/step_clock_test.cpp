#include "core/paper/step_clock.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace hrt {
namespace {

std::vector<std::int64_t> ends_until(StepClock& clock, std::int64_t time_ns) {
  std::vector<std::int64_t> ends;
  clock.advance(time_ns, [&](std::int64_t end_ns) { ends.push_back(end_ns); });
  return ends;
}

TEST(StepClock, EndsTheStepsThatEndByThen) {
  StepClock clock(100);
  EXPECT_EQ(clock.step(), -1);
  clock.start(1000);
  EXPECT_EQ(clock.step(), 0);
  EXPECT_TRUE(ends_until(clock, 1099).empty());
  EXPECT_EQ(ends_until(clock, 1250), (std::vector<std::int64_t>{1100, 1200}));
  EXPECT_EQ(clock.step(), 2);
  EXPECT_EQ(clock.end_ns(), 1300);
}

TEST(StepClock, AWaitMakesTheStepLonger) {
  StepClock clock(100);
  clock.start(0);
  clock.wait(30);
  EXPECT_TRUE(ends_until(clock, 129).empty());
  EXPECT_EQ(ends_until(clock, 130), (std::vector<std::int64_t>{130}));
}

TEST(StepClock, CatchesUpWithSoManyAndCountsTheRest) {
  StepClock clock(1);
  clock.start(std::numeric_limits<std::int64_t>::min());
  std::int64_t ended = 0;
  const std::int64_t skipped =
      clock.advance(std::numeric_limits<std::int64_t>::min() + 100, [&](std::int64_t) { ++ended; });
  EXPECT_EQ(ended, 64);
  EXPECT_EQ(skipped, 36);
  EXPECT_EQ(clock.step(), 100);
}

}  // namespace
}  // namespace hrt
