#include "core/person/person_reach.h"

#include <gtest/gtest.h>

#include "core/simulation/person.h"
#include "tests/times.h"

namespace hrt {
namespace {

constexpr Reach ten_degrees_apart{.real_direction_deg = -5.0, .virtual_direction_deg = 5.0};

FingerSample sample_at(std::int64_t time_ns, const PlatePoint& place) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = place};
}

// A simulated person in a PersonReach, with a plate that follows each command immediately; a sample every 10 ms.
struct Trial {
  explicit Trial(const Person& person, const PersonBelief& belief = unknown_person())
      : reach({.person = belief}, ten_degrees_apart),
        finger(person, {}, ten_degrees_apart.virtual_direction_deg, ten_degrees_apart.real_distance_mm, {1, 0, 0, 0}) {
    for (int i = 0; i < 30; ++i) sample({});
  }

  void sample(const PlatePoint& place) {
    last = reach.update(sample_at(time_ns, place));
    time_ns += 10 * ms;
  }

  void run_for(int milliseconds) {
    for (int i = 0; i < milliseconds && !finger.done(); ++i) {
      finger.advance(reach.command().plate_orientation_deg);
      if (i % 10 == 9) sample(finger.position());
    }
  }

  PersonReach reach;
  SlidingPerson finger;
  std::int64_t time_ns = 0;
  PlateCommand last;
};

Person linear_person(double tactile_weight = 0.25, double duration_s = 1.5) {
  return {.illusion = {.tactile_weight = tactile_weight}, .noise_deg2_per_s = 0.0, .duration_s = duration_s};
}

TEST(PersonReach, PeopleOfTheModel_ReachTheRealTarget) {
  for (const double weight : {0.2, 0.3}) {
    for (const double duration_s : {1.0, 2.0}) {
      Trial trial(linear_person(weight, duration_s));
      trial.run_for(5000);
      EXPECT_NEAR(bearing_deg({}, trial.finger.position()), -5.0, 1.5) << weight << ' ' << duration_s;
      const ReachSummary summary = trial.reach.summary();
      EXPECT_FALSE(summary.unreachable);
      EXPECT_FALSE(summary.misfit);
      EXPECT_FALSE(summary.off_target);
      EXPECT_TRUE(trial.reach.learnt());
      EXPECT_NEAR(summary.bearing_error_deg, bearing_deg({}, trial.finger.position()) + 5.0, 0.2);
    }
  }
}

// The person aims at 5 + 3 degrees. The perceived error is relative to this goal.
TEST(PersonReach, AKnownBias_IsPartOfTheGoal) {
  Person person = linear_person();
  person.bias_deg = 3.0;
  Trial trial(person, known_person(0.25, 3.0));
  trial.run_for(5000);
  EXPECT_NEAR(trial.reach.summary().perceived_error_deg, trial.reach.summary().perceived_direction_deg - 8.0, 1e-12);
}

TEST(PersonReach, ADropoutIsPredicted_AndDuplicatesAreDropped) {
  Trial trial(linear_person());
  trial.run_for(500);
  const double to_go_mm = trial.last.distance_to_go_mm, to_go_s = trial.last.time_to_go_s;
  const std::int64_t dropped = trial.reach.summary().dropped_samples;
  for (int i = 0; i < 10; ++i) {
    const PlateCommand command =
        trial.reach.update({.time_ns = trial.time_ns + i * 10 * ms, .observation = Observation::none});
    EXPECT_TRUE(command.predicted);
    EXPECT_TRUE(command.held);
  }
  EXPECT_LT(trial.reach.command().distance_to_go_mm, to_go_mm - 5.0);
  EXPECT_NEAR(trial.reach.command().time_to_go_s, to_go_s - 0.1, 1e-6);
  EXPECT_EQ(trial.reach.summary().dropped_samples, dropped + 10);

  Trial twice(linear_person());
  twice.run_for(500);
  const PlateCommand once = twice.last;
  const PlateCommand again = twice.reach.update(sample_at(twice.time_ns - 10 * ms, {500.0, 500.0}));
  EXPECT_EQ(again.plate_orientation_deg, once.plate_orientation_deg);
  EXPECT_EQ(again.distance_to_go_mm, once.distance_to_go_mm);
  EXPECT_EQ(twice.reach.summary().dropped_samples, 1);
}

TEST(PersonReach, ASummary_CountsStepsAndSamples) {
  Trial trial(linear_person());
  trial.run_for(5000);
  const ReachSummary summary = trial.reach.summary();
  EXPECT_EQ(summary.samples, 30 + 150);
  EXPECT_EQ(summary.dropped_samples, 0);
  // Steps last 100 ms. Steps before the detection of the onset count as predicted.
  EXPECT_GE(summary.steps, 12);
  EXPECT_NEAR(static_cast<double>(summary.steps + summary.predicted_steps), 15.0, 1.0);
  EXPECT_GE(summary.peak_felt_error_deg, summary.rms_felt_error_deg);
  ASSERT_TRUE(summary.person);
  EXPECT_NEAR(summary.person->duration_s, 1.5, 0.5);
}

}  // namespace
}  // namespace hrt
