#include "core/learning.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

TEST(Learning, WhatAReachLearntIsAssumedInTheNext) {
  RetargeterConfig config;
  config.participant.bias_deg = 2.0;
  const RetargeterConfig next = carried(config, {.tactile_weight = 0.2,
                                                 .tactile_weight_sd = 0.02,
                                                 .motor_variance_deg2 = 0.7,
                                                 .motor_variance_sd_deg2 = 0.3});
  EXPECT_EQ(next.participant.tactile_weight, 0.2);
  EXPECT_EQ(next.estimator.tactile_weight_sd, 0.02);
  EXPECT_EQ(next.participant.motor_variance_deg2, 0.7);
  EXPECT_EQ(next.estimator.motor_variance_sd_deg2, 0.3);
  EXPECT_EQ(next.participant.bias_deg, 2.0);
}

TEST(Learning, WhatIsCarriedIsNeverTooSure) {
  const RetargeterConfig next = carried({}, {.tactile_weight = 0.2,
                                             .tactile_weight_sd = 1e-6,
                                             .motor_variance_deg2 = 0.5,
                                             .motor_variance_sd_deg2 = 1e-6});
  EXPECT_EQ(next.estimator.tactile_weight_sd, least_carried_weight_sd);
  EXPECT_EQ(next.estimator.motor_variance_sd_deg2, least_carried_motor_variance_sd_deg2);
}

// From 0.5 to 1 at most; its deviation stays as it was.
TEST(Learning, AVarianceFarFromWhatWasAssumedIsClamped) {
  const RetargeterConfig next =
      carried({}, {.tactile_weight = 0.2, .motor_variance_deg2 = 3.0, .motor_variance_sd_deg2 = 0.2});
  EXPECT_EQ(next.participant.motor_variance_deg2, 1.0);
  EXPECT_EQ(next.estimator.motor_variance_sd_deg2, 0.5);
}

}  // namespace
}  // namespace hrt
