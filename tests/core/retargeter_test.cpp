#include "core/retargeter.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr Reach reach{.real_direction_deg = -5, .virtual_direction_deg = 5, .plate_orientation_deg = 20};

FingerSample position(int i) {
  return {.time_ns = i * 10 * ms, .observation = Observation::position, .position = {0, 0.0005 * i}};
}

FingerSample direction(int i) {
  return {.time_ns = i * 100 * ms, .observation = Observation::direction, .direction_deg = 0.5 * i};
}

// A person with a bias of 3 who sees the target at -1 goes for 2.
TEST(Retargeter, TargetsMustBeWithinNinetyDegreesOfTheGoal) {
  const Reach wide{.real_direction_deg = 90, .virtual_direction_deg = -1};
  EXPECT_FALSE(is_valid(wide, Participant{}));
  EXPECT_TRUE(is_valid(wide, Participant{.bias_deg = 3.0}));
}

TEST(Retargeter, PositionsAreLedByTheControllerForPeople) {
  Retargeter retargeter({.mode = ControlMode::reach});
  EXPECT_FALSE(retargeter.learnt());
  PersonReach person({.person = unknown_person()}, reach);
  for (int pass = 0; pass < 2; ++pass) {  // the second starts anew
    retargeter.begin(reach);
    EXPECT_TRUE(retargeter.leads_person());
    EXPECT_EQ(retargeter.command().plate_orientation_deg, person.command().plate_orientation_deg);
  }
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(retargeter.update(position(i)).plate_orientation_deg,
              person.update(position(i)).plate_orientation_deg);
  retargeter.update(direction(20));
  EXPECT_TRUE(retargeter.leads_person()) << "a position has been seen";
}

// Before a sample the plate stands where it stood; after one it was commanded to what suits a person.
TEST(Retargeter, DirectionsAreLedByThePapersController) {
  for (const bool commanded : {false, true}) {
    Retargeter retargeter({.mode = ControlMode::reach});
    retargeter.begin(reach);
    const double ready_deg = retargeter.command().plate_orientation_deg;
    EXPECT_NE(ready_deg, 20.0);
    if (commanded) retargeter.update({.time_ns = -100 * ms});
    PaperReach paper({}, reach, commanded ? std::optional(ready_deg) : std::nullopt);
    for (int i = 0; i < 10; ++i) {
      const PlateCommand command = retargeter.update(direction(i));
      EXPECT_FALSE(retargeter.leads_person());
      EXPECT_EQ(command.plate_orientation_deg, paper.update(direction(i)).plate_orientation_deg);
      EXPECT_EQ(command.finger_direction_deg, 0.5 * i);
    }
    EXPECT_EQ(retargeter.summary().final_direction_deg, 4.5);
    EXPECT_FALSE(retargeter.learnt());
  }
}

TEST(Retargeter, AFixedPlateStays) {
  Retargeter retargeter({.mode = ControlMode::fixed_plate, .fixed_plate_orientation_deg = 30.0});
  retargeter.begin(reach);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(retargeter.update(direction(i)).plate_orientation_deg, 30.0);
}

}  // namespace
}  // namespace hrt
