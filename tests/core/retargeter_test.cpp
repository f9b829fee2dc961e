#include "core/retargeter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/participant.h"
#include "core/simulation/random.h"

namespace hrt {
namespace {

double final_direction_deg(const RetargeterConfig& config, const Reach& reach, double noise_scale,
                           std::uint32_t trial) {
  Retargeter retargeter(config);
  retargeter.begin(reach);
  SimulatedParticipant participant(config.participant, reach.virtual_direction_deg);
  for (std::uint32_t k = 0; k < 30; ++k) {
    const PlateCommand command = retargeter.step(participant.finger_direction_deg());
    participant.step(command.plate_orientation_deg,
                     noise_scale * standard_normal({.seed = 1, .condition = 0, .trial = trial, .step = k}));
  }
  return participant.finger_direction_deg();
}

TEST(Retargeter, LeadsAParticipantWithoutNoiseToTheRealTarget) {
  const RetargeterConfig config;
  EXPECT_NEAR(final_direction_deg(config, {.real_direction_deg = 5, .virtual_direction_deg = -5}, 0.0, 0),
              5.0, 1e-9);
}

// Paper Fig. 8: with the plate at 0 the finger ends at P = theta_V / (1 - w_T) = -5.88.
TEST(Retargeter, FixedPlateDoesNotCorrect) {
  const RetargeterConfig config{.mode = ControlMode::fixed_plate};
  EXPECT_NEAR(final_direction_deg(config, {.real_direction_deg = 5, .virtual_direction_deg = -5}, 0.0, 0),
              -5.0 / 0.85, 1e-9);
}

// Condition 1 of Table I: 92.8 % within 1.5 degrees; 4 standard errors of 2,000 trials are 2.3 %.
TEST(Retargeter, ConditionOneOfTableOne) {
  const RetargeterConfig config;
  int hits = 0;
  for (std::uint32_t trial = 0; trial < 2000; ++trial) {
    const double final_deg =
        final_direction_deg(config, {.real_direction_deg = -5, .virtual_direction_deg = 5}, 1.0, trial);
    hits += std::abs(final_deg + 5.0) <= 1.5;
  }
  EXPECT_NEAR(hits / 2000.0, 0.928, 0.023);
}

}  // namespace
}  // namespace hrt
