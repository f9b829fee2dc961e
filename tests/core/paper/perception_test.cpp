#include "core/paper/perception.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

// var- = var + q and var = r var- / (var- + r) give var-^2 - q var- - q r = 0; its positive root.
TEST(Perception, GainsSettleWhereTheRecursionStands) {
  for (const double q : {0.1, 0.5, 1.0, 2.0}) {
    const Participant participant{.motor_variance_deg2 = q};
    const double r = participant.sensory_variance_deg2;
    const double prior_deg2 = 0.5 * (q + std::sqrt(q * (q + 4.0 * r)));
    FilterGain step{0.0, 0.0};
    for (int i = 0; i < 100; ++i) step = next_gain(participant, step.variance_deg2);
    EXPECT_NEAR(step.gain, prior_deg2 / (prior_deg2 + r), 1e-15);
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
