// Targets that move within a reach, over simulated people.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/retargeter.h"
#include "core/simulation/controllers.h"
#include "core/simulation/people.h"
#include "core/simulation/person_trial.h"
#include "tests/core/heap_guard.h"
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

// A finger that rests for 0.3 s and then slides along the mid-line, 10 cm in 1.5 s.
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

// Seen from the start, until the finger moves.
TEST(Retarget, BeforeTheMotionIsAnotherBeginning) {
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

TEST(Retarget, ToTheSameTargetsChangesLittle) {
  Retargeter retargeter = slid_until(ControlMode::reach, 1000 * ms);
  Retargeter undisturbed = retargeter;
  const Reach aimed = retargeter.retarget(real_place, virtual_place);
  EXPECT_NEAR(aimed.virtual_direction_deg, 5.0, 1e-9);
  for (std::int64_t time_ns = 1010 * ms; time_ns < 1700 * ms; time_ns += 10 * ms) {
    const PlateCommand command = retargeter.update(seen(time_ns, slid(time_ns)));
    const PlateCommand other = undisturbed.update(seen(time_ns, slid(time_ns)));
    EXPECT_NEAR(command.plate_orientation_deg, other.plate_orientation_deg, 3.0);
    EXPECT_NEAR(command.distance_to_go_mm, other.distance_to_go_mm, 1e-9);
    EXPECT_NEAR(command.tactile_weight, other.tactile_weight, 1e-6);
  }
}

// The finger has gone 5 cm along the mid-line and is felt to have gone as far at 5 degrees.
TEST(Retarget, DirectionsAreSeenFromTheFingerAndFromWhereItIsFelt) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter = slid_until(mode, 1050 * ms);
    const Reach aimed = retargeter.retarget(moved(real_place, -30.0, 0.0), moved(virtual_place, -30.0, 0.0));
    EXPECT_NEAR(aimed.start.away_mm, 50.0, 2.0);
    EXPECT_NEAR(aimed.real_direction_deg, bearing_deg({0.0, 50.0}, moved(real_place, -30.0, 0.0)), 1.5);
    // A person answers 0.2 s later.
    const PlatePoint felt = point_ahead({}, 5.0, slid(mode == ControlMode::reach ? 1250 * ms : 1050 * ms).away_mm);
    EXPECT_NEAR(aimed.virtual_direction_deg, bearing_deg(felt, moved(virtual_place, -30.0, 0.0)), 5.0);
    const PlateCommand command = retargeter.update(seen(1060 * ms, slid(1060 * ms)));
    EXPECT_NEAR(command.distance_to_go_mm, distance_mm(slid(1060 * ms), moved(real_place, -30.0, 0.0)), 2.0);
  }
}

// What nobody can hold is said so from the next command on.
TEST(Retarget, AGapThatGrowsTooLargeIsUnreachable) {
  for (const ControlMode mode : both_modes) {
    Retargeter retargeter = slid_until(mode, 700 * ms);
    EXPECT_FALSE(retargeter.command().unreachable);
    retargeter.retarget(moved(real_place, 60.0, 0.0), virtual_place);
    EXPECT_TRUE(retargeter.update(seen(710 * ms, slid(710 * ms))).unreachable);
  }
}

// Whatever is asked of a reach at any moment, commands are numbers.
TEST(Retarget, AnyTargetAtAnyMomentGivesNumbers) {
  const HeapGuard guard;
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

// Of people whose illusion is linear and can hold the gap, on the last of `reaches`: how many end within 1.5
// degrees of bearing of the real target, and how many of the others have no flag.
struct Shares {
  double hits = 0.0;
  double unflagged = 0.0;
};

Shares shares(double duration_s, const std::optional<TargetMove>& move, int reaches) {
  const RetargeterConfig controller = people_controller();
  Shares shares;
  int able = 0;
  for (std::uint32_t i = 0; i < 120; ++i) {
    PersonCondition condition = draw_person(people_families()[0], duration_s, 1, i);
    if (!can_hold(condition)) continue;
    ++able;
    condition.move = move;
    const PersonOutcome outcome = simulate_person(condition, &controller, reaches, 1, i).back();
    const bool hit = std::abs(outcome.bearing_error_deg) < near_deg;
    shares.hits += hit;
    shares.unflagged += !hit && !outcome.summary.off_target;
  }
  return {shares.hits / able, shares.unflagged / able};
}

// Both targets move once the finger has gone 30 % of the path; the person answers 0.2 s later.
TEST(Retarget, AMovedTargetIsReachedNearlyAsWellAsAFreshOne) {
  for (const int reaches : {1, 5}) {
    const Shares fresh = shares(3.0, {}, reaches);
    EXPECT_GE(fresh.hits, 0.97);
    for (const double size_mm : {20.0, 40.0}) {
      for (const double direction_deg : {0.0, 90.0}) {
        SCOPED_TRACE(testing::Message() << reaches << " reaches, " << size_mm << " mm at " << direction_deg);
        const Shares led = shares(3.0, TargetMove{0.3, point_ahead({}, direction_deg, size_mm)}, reaches);
        EXPECT_GE(led.hits, fresh.hits - 0.15);
        EXPECT_LE(led.unflagged, 0.045);
      }
    }
  }
}

}  // namespace
}  // namespace hrt
