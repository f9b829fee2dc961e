#include "core/paper/perception.h"

#include <gtest/gtest.h>

#include <array>

namespace hrt {
namespace {

// K_0 = 0.5 / (0.5 + 0.1) = 5/6, var_0 = (1/6)(1/2) = 1/12;
// K_1 = (7/12) / (7/12 + 1/10) = 35/41, var_1 = (6/41)(7/12) = 7/82.
TEST(Perception, FirstGainsOfConditionOne) {
  const Participant participant;
  const FilterGain first = next_gain(participant, 0.0);
  EXPECT_DOUBLE_EQ(first.gain, 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(first.variance_deg2, 1.0 / 12.0);
  const FilterGain second = next_gain(participant, first.variance_deg2);
  EXPECT_DOUBLE_EQ(second.gain, 35.0 / 41.0);
  EXPECT_DOUBLE_EQ(second.variance_deg2, 7.0 / 82.0);
}

TEST(Perception, SteadyGainIsAFixedPointThatTheRecursionReaches) {
  for (const double motor : {0.1, 0.5, 1.0, 2.0}) {
    const Participant participant{.motor_variance_deg2 = motor};
    const FilterGain steady = steady_gain(participant);
    const FilterGain next = next_gain(participant, steady.variance_deg2);
    EXPECT_NEAR(next.gain, steady.gain, 1e-15);
    EXPECT_NEAR(next.variance_deg2, steady.variance_deg2, 1e-15);
    FilterGain step{0.0, 0.0};
    for (int i = 0; i < 100; ++i) step = next_gain(participant, step.variance_deg2);
    EXPECT_NEAR(step.gain, steady.gain, 1e-15);
  }
}

TEST(Perception, WindowHoldsTheGainsAhead) {
  const Participant participant;
  GainWindow window(participant, 3);
  std::array<double, 20> gains{};
  FilterGain step{0.0, participant.initial_variance_deg2};
  for (double& gain : gains) gain = (step = next_gain(participant, step.variance_deg2)).gain;
  for (std::size_t k = 0; k + 3 <= gains.size(); ++k, window.advance()) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(window.data()[i], gains[k + i]) << k << ' ' << i;
  }
}

}  // namespace
}  // namespace hrt
