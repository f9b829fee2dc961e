// Targets that move during a reach, with simulated people.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/retargeter.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "core/simulation/person_trial.h"
#include "tests/times.h"

namespace hrt {
namespace {

constexpr Reach gap_of_ten{.real_direction_deg = -5.0, .virtual_direction_deg = 5.0};
const PlatePoint real_place = point_ahead({}, -5.0, 100.0);
const PlatePoint virtual_place = point_ahead({}, 5.0, 100.0);

PlatePoint moved(const PlatePoint& place, double right_mm, double away_mm) {
  return place + PlatePoint{right_mm, away_mm};
}

FingerSample seen(std::int64_t time_ns, const PlatePoint& place) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = place};
}

// A finger that rests for 0.3 s and then moves along the mid-line, 100 mm in 1.5 s.
PlatePoint slid(std::int64_t time_ns) {
  const double u = std::clamp((1e-9 * static_cast<double>(time_ns) - 0.3) / 1.5, 0.0, 1.0);
  return {0.0, 100.0 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u))};
}

RetargeterConfig config_of(ControlMode mode) {
  RetargeterConfig config = people_controller();
  config.mode = mode;
  config.estimator.adapt = true;
  return config;
}

Retargeter slid_until(ControlMode mode, std::int64_t until_ns) {
  Retargeter retargeter(config_of(mode));
  retargeter.begin(gap_of_ten);
  for (std::int64_t time_ns = 0; time_ns <= until_ns; time_ns += 10 * ms)
    retargeter.update(seen(time_ns, slid(time_ns)));
  return retargeter;
}

constexpr ControlMode both_modes[] = {ControlMode::mpc, ControlMode::reach};

// Before the motion, directions are seen from the start.
TEST(Retarget, ARetargetBeforeTheMotion_IsANewReach) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter(config_of(mode));
    retargeter.begin(gap_of_ten);
    const Reach aimed = retargeter.retarget(point_ahead({}, 2.0, 80.0), point_ahead({}, 9.0, 80.0));
    EXPECT_NEAR(aimed.real_direction_deg, 2.0, 1e-9);
    EXPECT_NEAR(aimed.virtual_direction_deg, 9.0, 1e-9);
    EXPECT_NEAR(aimed.real_distance_mm, 80.0, 1e-9);
    Retargeter fresh(config_of(mode));
    fresh.begin({.real_direction_deg = 2.0, .virtual_direction_deg = 9.0, .real_distance_mm = 80.0});
    for (std::int64_t time_ns = 0; time_ns < 1500 * ms; time_ns += 10 * ms) {
      const PlateCommand command = retargeter.update(seen(time_ns, slid(time_ns)));
      EXPECT_NEAR(command.plate_orientation_deg, fresh.update(seen(time_ns, slid(time_ns))).plate_orientation_deg,
                  1e-6);
    }
  }
}

// The finger has moved 50 mm along the mid-line; the person perceives 50 mm at 5 degrees.
TEST(Retarget, ARetarget_IsSeenFromTheTrackedAndThePerceivedPosition) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter = slid_until(mode, 1050 * ms);
    const Reach aimed = retargeter.retarget(moved(real_place, -30.0, 0.0), moved(virtual_place, -30.0, 0.0));
    EXPECT_NEAR(aimed.start.away_mm, 50.0, 2.0);
    EXPECT_NEAR(aimed.real_direction_deg, bearing_deg({0.0, 50.0}, moved(real_place, -30.0, 0.0)), 1.5);
    // The person responds 0.2 s later.
    const PlatePoint felt = point_ahead({}, 5.0, slid(mode == ControlMode::reach ? 1250 * ms : 1050 * ms).away_mm);
    EXPECT_NEAR(aimed.virtual_direction_deg, bearing_deg(felt, moved(virtual_place, -30.0, 0.0)), 5.0);
    const PlateCommand command = retargeter.update(seen(1060 * ms, slid(1060 * ms)));
    EXPECT_NEAR(command.distance_to_go_mm, distance_mm(slid(1060 * ms), moved(real_place, -30.0, 0.0)), 2.0);
  }
}

// If a move of the target makes the gap infeasible, every command from the next one on has `unreachable`.
TEST(Retarget, AGapThatGrowsTooLarge_IsReportedUnreachable) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter = slid_until(mode, 700 * ms);
    EXPECT_FALSE(retargeter.command().unreachable);
    retargeter.retarget(moved(real_place, 60.0, 0.0), virtual_place);
    EXPECT_TRUE(retargeter.update(seen(710 * ms, slid(710 * ms))).unreachable);
  }
}

// Random targets at every sample.
TEST(Retarget, AnyTargets_GiveFiniteCommands) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter(config_of(mode));
    retargeter.begin(gap_of_ten);
    Draws draws(3, 0, 0, 0);
    for (std::int64_t time_ns = 0; time_ns < 4000 * ms; time_ns += 10 * ms) {
      const auto place = [&] { return PlatePoint{200.0 * draws.uniform() - 100.0, 200.0 * draws.uniform() - 100.0}; };
      const Reach aimed = retargeter.retarget(draws.uniform() < 0.1 ? slid(time_ns) : place(), place());
      ASSERT_LT(std::abs(aimed.real_direction_deg - aimed.virtual_direction_deg), 90.0);
      const PlateCommand command = retargeter.update(seen(time_ns, slid(time_ns)));
      for (const double value :
           {command.plate_orientation_deg, command.felt_error_deg, command.predicted_miss_deg, command.time_to_go_s,
            command.distance_to_go_mm, command.aimed_direction_deg, command.nis})
        ASSERT_TRUE(std::isfinite(value));
      const ReachSummary summary = retargeter.summary();
      ASSERT_TRUE(std::isfinite(summary.bearing_error_deg) && std::isfinite(summary.distance_to_target_mm));
    }
  }
}

}  // namespace
}  // namespace hrt
