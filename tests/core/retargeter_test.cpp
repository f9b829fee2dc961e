#include "core/retargeter.h"

#include <gtest/gtest.h>

#include "tests/times.h"

namespace hrt {
namespace {

constexpr Reach reach{.real_direction_deg = -5, .virtual_direction_deg = 5, .plate_orientation_deg = 20};

FingerSample direction(int i) {
  return {.time_ns = i * 100 * ms, .observation = Observation::direction, .direction_deg = 0.5 * i};
}

// A person with a bias of 3 aims at 2 for a target at -1.
TEST(Retargeter, TargetsMoreThan90DegreesFromTheGoal_AreInvalid) {
  const Reach wide{.real_direction_deg = 90, .virtual_direction_deg = -1};
  EXPECT_FALSE(is_valid(wide, goal_direction_deg(Participant{}, -1)));
  EXPECT_TRUE(is_valid(wide, goal_direction_deg(Participant{.bias_deg = 3.0}, -1)));
}

// If directions come before the first position, the paper's controller is used.
TEST(Retargeter, TheFirstObservation_ChoosesTheController) {
  Retargeter retargeter({.mode = ControlMode::reach, .plate = {.max_speed_deg_s = 100.0, .latency_ns = 30 * ms}});
  retargeter.begin(reach);
  EXPECT_TRUE(retargeter.has_person_controller());
  EXPECT_NE(retargeter.command().plate_orientation_deg, 20.0);
  for (const int early : {200, 100, 50}) retargeter.update({.time_ns = -early * ms});
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(retargeter.update(direction(i)).finger_direction_deg, 0.5 * i);
    EXPECT_FALSE(retargeter.has_person_controller());
  }
  EXPECT_EQ(retargeter.summary().final_direction_deg, 4.5);
  EXPECT_EQ(retargeter.summary().samples, 13);
  EXPECT_EQ(retargeter.summary().dropped_samples, 3);
  EXPECT_FALSE(retargeter.learnt());
  retargeter.begin(reach);
  retargeter.update({.time_ns = 0, .observation = Observation::position, .position = {0, 0}});
  retargeter.update(direction(20));
  EXPECT_TRUE(retargeter.has_person_controller());
}

// The finger is away from the expected start: the reach is replaced while the plate moves.
TEST(Retargeter, AReachThatReplacesAnother_KeepsTheMovingPlate) {
  for (const ControlMode mode : {ControlMode::reach, ControlMode::mpc}) {
    Retargeter retargeter({.mode = mode, .plate = {.max_speed_deg_s = 100.0}});
    retargeter.begin(reach);
    retargeter.begin_here(reach);
    EXPECT_EQ(retargeter.summary().samples, 0);
    const double ready_deg = retargeter.command().plate_orientation_deg;
    for (int i = 0; i < 3; ++i) retargeter.update({.time_ns = i * 50 * ms});
    Reach elsewhere = reach;
    elsewhere.start = {10.0, 0.0};
    elsewhere.plate_orientation_deg = ready_deg;  // commanded, but not reached yet
    retargeter.begin_here(elsewhere);
    EXPECT_EQ(retargeter.summary().samples, 0);
    EXPECT_EQ(retargeter.summary().dropped_samples, 0);
    // A model that assumed the commanded orientation would predict another perceived direction.
    const double felt_deg = retargeter.update({.time_ns = 100 * ms}).perceived_direction_deg;
    Retargeter there({.mode = mode, .plate = {.max_speed_deg_s = 100.0}});
    there.begin(elsewhere);
    const double felt_there_deg = there.update({.time_ns = 100 * ms}).perceived_direction_deg;
    EXPECT_EQ(std::abs(felt_deg - felt_there_deg) > 1.0, mode == ControlMode::reach);
  }
}

}  // namespace
}  // namespace hrt
