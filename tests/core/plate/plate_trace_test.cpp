#include "core/plate/plate_trace.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

TEST(PlateTrace, IsLinearBetweenEntriesAndConstantBeyond) {
  PlateTrace trace;
  trace.add(1.0, 10.0);
  EXPECT_EQ(trace.at(0.0), 10.0);
  EXPECT_EQ(trace.at(2.0), 10.0);
  trace.add(1.1, 30.0);
  EXPECT_NEAR(trace.at(1.025), 15.0, 1e-9);
  EXPECT_EQ(trace.at(1.1), 30.0);
  EXPECT_EQ(trace.at(9.0), 30.0);
  EXPECT_EQ(trace.at(-1e300), 10.0);
}

TEST(PlateTrace, OfEqualTimesTheLastCounts) {
  PlateTrace trace;
  for (const double plate_deg : {1.0, 2.0, 3.0, 4.0}) trace.add(5.0, plate_deg);
  EXPECT_EQ(trace.at(5.0), 4.0);
  EXPECT_EQ(trace.at(6.0), 4.0);
  trace.add(5.1, 5.0);
  EXPECT_NEAR(trace.at(5.05), 4.5, 1e-9);
}

// A plate that turns at 100 degrees/s, seen at any rate: known over the last second at least.
TEST(PlateTrace, KeepsASecondAtAnyRate) {
  for (const double rate_hz : {90.0, 240.0, 1000.0, 2000.0}) {
    PlateTrace trace;
    const int samples = static_cast<int>(3.0 * rate_hz);
    for (int i = 0; i <= samples; ++i) trace.add(i / rate_hz, 100.0 * i / rate_hz);
    const double now_s = samples / rate_hz;
    for (double back_s = 0.0; back_s <= 1.0; back_s += 0.013)
      EXPECT_NEAR(trace.at(now_s - back_s), 100.0 * (now_s - back_s), 1e-6) << rate_hz << ' ' << back_s;
  }
}

TEST(PlateTrace, ForgetsWhenCleared) {
  PlateTrace trace;
  trace.add(0.0, 50.0);
  trace.clear();
  trace.add(1.0, 20.0);
  EXPECT_EQ(trace.at(0.0), 20.0);
}

}  // namespace
}  // namespace hrt
