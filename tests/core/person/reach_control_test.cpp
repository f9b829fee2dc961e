#include "core/person/reach_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrt {
namespace {

using X = PersonState;

constexpr double gap_deg = 5.0;
constexpr double sensory_delay_s = Tuning{}.sensory_delay_s;

PersonBelief person_of(double sign) {
  PersonBelief belief = unknown_person();
  belief.mean(PersonState::bias) *= sign;
  belief.mean(PersonState::habit) *= sign;
  return belief;
}

// Returns the filter 0.5 s after the onset of a motion of 2 s to a virtual target at `sign` times 8 degrees.
PersonFilter under_way(double sign) {
  PersonFilter filter(person_of(sign), sign * 8.0, 100.0, {});
  filter.begin(-std::log(2.0), 0.02, 0.3);
  for (int i = 0; i < 50; ++i) filter.move(0.01, sign * 35.0);
  return filter;
}

// Returns a plan. `plate_deg`: plate orientation whose effect the person perceives in the dead time.
ReachPlan plan(const ReachControlConfig& config, const PersonFilter& filter, double plate_deg,
               const PlatePoint& target = {0.0, 100.0}, double dead_s = 0.09) {
  return plan_reach(config, filter, target, bearing_deg({}, target), dead_s, plate_deg);
}

TEST(ReachControl, MirroredInput_GivesAMirroredPlan) {
  const ReachPlan left = plan({}, under_way(1.0), 35.0, {3.0, 100.0});
  const ReachPlan right = plan({}, under_way(-1.0), -35.0, {-3.0, 100.0});
  EXPECT_NEAR(left.plate_deg, -right.plate_deg, 1e-9);
  EXPECT_NEAR(left.miss_mm, -right.miss_mm, 1e-9);
  EXPECT_NEAR(left.felt_error_deg, -right.felt_error_deg, 1e-9);
}

TEST(ReachControl, FarTargets_KeepTheErrorWithinItsLimit) {
  for (const double limit_deg : {0.5, 2.0, 5.0, 20.0}) {
    for (const double right_mm : {-60.0, -10.0, 0.0, 10.0, 60.0}) {
      // With a strong illusion, the limit of the error is reached before the plate's bound.
      PersonBelief belief = unknown_person();
      belief.mean(PersonState::weight) = 0.6;
      belief.mean(PersonState::curve) = 0.0;
      PersonFilter filter(belief, 0.0, 100.0, {});
      filter.begin(-std::log(2.0), 0.02, 0.3);
      const ReachPlan planned = plan({.max_felt_error_deg = limit_deg}, filter, 0.0, {right_mm, 100.0});
      EXPECT_LE(std::abs(planned.felt_error_deg), limit_deg + 1e-9);
    }
  }
}

TEST(ReachControl, FarTargets_KeepThePlateWithinTheBound) {
  for (const double bound_deg : {1.0, 40.0, 75.0, 89.0}) {
    for (const double right_mm : {-200.0, 0.0, 200.0}) {
      const PersonFilter filter = under_way(1.0);
      // Without dead time, the plate's bound is relative to the present direction.
      const ReachPlan planned =
          plan({.bound_deg = bound_deg, .max_felt_error_deg = 90.0}, filter, 35.0, {right_mm, 100.0}, 0.0);
      EXPECT_LE(std::abs(planned.plate_deg - filter.direction_deg()), bound_deg + 1e-9);
      EXPECT_EQ(planned.active != ActiveBound::none, right_mm != 0.0 || bound_deg < 40.0)
          << bound_deg << ' ' << right_mm;
    }
  }
}

// The filter itself is the person, with known traits and no noise.
TEST(ReachControl, PeopleOfTheModel_ArriveAtTheTarget) {
  for (const double duration_s : {1.0, 1.5, 3.0}) {
    for (const double virtual_deg : {-gap_deg, 0.0, gap_deg, 2.0 * gap_deg}) {
      PersonBelief belief = known_person(0.25, 0.0);
      belief.mean(PersonState::log_rate) = -std::log(duration_s);
      PersonFilter person(belief, virtual_deg, 100.0, {});
      person.begin(-std::log(duration_s), 0.0, 0.0);
      constexpr double step_s = 0.01;
      PlateTrace trace;
      double plate_deg = ready_orientation_deg({}, person, {0.0, 100.0});
      trace.add(0.0, plate_deg);
      double time_s = 0.0;
      while (person.mean(X::phase) < 1.0) {
        plate_deg = plan({}, person, trace.at(time_s - 0.5 * sensory_delay_s), {0.0, 100.0}, sensory_delay_s).plate_deg;
        trace.add(time_s, plate_deg);
        person.move(step_s, trace.at(time_s + 0.5 * step_s - sensory_delay_s));
        time_s += step_s;
      }
      EXPECT_NEAR(person.mean(X::right), 0.0, 0.3) << duration_s << ' ' << virtual_deg;
    }
  }
}

TEST(ReachControl, TheReadyOrientation_IsThatOfTheFirstPlan) {
  const PersonFilter filter(unknown_person(), 10.0, 100.0, {});
  const double ready_deg = ready_orientation_deg({}, filter, {0.0, 100.0});
  const ReachPlan first = plan({}, filter, ready_deg, {0.0, 100.0}, 0.0);
  EXPECT_NEAR(first.plate_deg, ready_deg, 2.0);
  EXPECT_GT(ready_deg, 20.0);
}

TEST(ReachControl, NoGap_KeepsTheRidgesAcrossTheMotion) {
  const PersonFilter filter(unknown_person(), 0.0, 100.0, {});
  EXPECT_NEAR(ready_orientation_deg({}, filter, {0.0, 100.0}), 0.0, 1e-9);
}

}  // namespace
}  // namespace hrt
