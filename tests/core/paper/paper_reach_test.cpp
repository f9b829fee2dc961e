#include "core/paper/paper_reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/paper/step_clock.h"
#include "core/paper_simulation/participant.h"
#include "core/simulation/random.h"
#include "core/simulation/sliding_finger.h"
#include "tests/times.h"

namespace hrt {
namespace {

double final_direction_deg(const PaperReachConfig& config, const Reach& reach) {
  PaperReach controller(config, reach);
  SimulatedParticipant participant(config.participant, reach.virtual_direction_deg);
  for (int k = 0; k < 30; ++k)
    participant.step(controller.step(participant.finger_direction_deg()).plate_orientation_deg, 0.0);
  return participant.finger_direction_deg();
}

// Paper Fig. 8: with the plate at 0, the finger settles at P = theta_V / (1 - w_T) = -5.88.
TEST(PaperReach, AControlledPlate_SteersToTheRealTargetAndAFixedOneDoesNot) {
  const Reach reach{.real_direction_deg = 5, .virtual_direction_deg = -5};
  EXPECT_NEAR(final_direction_deg({}, reach), 5.0, 1e-9);
  EXPECT_NEAR(final_direction_deg({.fixed_plate_orientation_deg = 0.0}, reach), -5.0 / 0.85, 1e-9);
}

FingerSample position(std::int64_t time_ns, const PlatePoint& place) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = place};
}

FingerSample direction(std::int64_t time_ns, double direction_deg) {
  return {.time_ns = time_ns, .observation = Observation::direction, .direction_deg = direction_deg};
}

// A participant without noise who slides at 33.3 mm/s. Samples begin `phase_ns` before the motion.
struct StreamedReach {
  double rate_hz = 90.0;
  std::int64_t phase_ns = 0;

  ReachSummary summary{};
  double final_direction_deg = 0.0;

  void run() {
    PaperReach controller({}, {.real_direction_deg = 5, .virtual_direction_deg = -5, .start = {0.0, -50.0}});
    SimulatedParticipant participant(Participant{}, -5.0);
    SlidingFinger finger({0.0, -50.0}, 100.0, 3.0);
    const auto move_to = [&](std::int64_t time_ns) {
      finger.slide(static_cast<double>(time_ns) * 1e-9, participant.finger_direction_deg());
    };
    int step = 0;
    for (int i = 0; step < 30; ++i) {
      const std::int64_t time_ns = -phase_ns + static_cast<std::int64_t>(i * 1e9 / rate_hz);
      while (step < 30 && time_ns >= (step + 1) * 100 * ms) {
        move_to((step + 1) * 100 * ms);
        participant.step(controller.command().plate_orientation_deg, 0.0);
        ++step;
      }
      move_to(time_ns);
      controller.update(position(time_ns, finger.place()));
    }
    summary = controller.summary();
    final_direction_deg = participant.finger_direction_deg();
  }
};

TEST(PaperReach, PositionsAtAnyRateAndPhase_SteerToTheRealTarget) {
  for (const double rate_hz : {40.0, 90.0, 240.0, 1000.0}) {
    for (const std::int64_t phase_ns : {0 * ms, 7 * ms, 50 * ms, 1234 * ms}) {
      StreamedReach reach{.rate_hz = rate_hz, .phase_ns = phase_ns};
      reach.run();
      EXPECT_NEAR(reach.final_direction_deg, 5.0, 0.2) << rate_hz << ' ' << phase_ns;
      EXPECT_EQ(reach.summary.predicted_steps, 0) << rate_hz << ' ' << phase_ns;
    }
  }
}

TEST(PaperReach, PositionsAfterDirections_SetTheDistanceToGo) {
  const Reach reach{.real_direction_deg = 5, .virtual_direction_deg = -5, .start = {0.0, -50.0}};
  PaperReach controller({}, reach);
  for (int k = 0; k < 10; ++k) controller.update(direction(k * 100 * ms, 1.0));
  for (int k = 0; k < 20; ++k) {
    const PlatePoint place{0.0, -10.0 + 0.5 * k};
    const PlateCommand command = controller.update(position(1000 * ms + k * 11 * ms, place));
    EXPECT_NEAR(command.distance_to_go_mm, distance_mm(place, point_ahead(reach.start, 5.0, reach.real_distance_mm)),
                1.0);
  }
  EXPECT_EQ(controller.summary().dropped_samples, 0);
}

TEST(PaperReach, ALiftedOrRestingFinger_SuspendsTheSteps) {
  PaperReach controller({}, {.real_direction_deg = 0, .virtual_direction_deg = 10});
  const auto sample = [](std::int64_t time_ns, Observation observation) {
    return FingerSample{.time_ns = time_ns, .observation = observation, .direction_deg = 2.0};
  };
  // The lift lasts from almost the smallest to the largest time.
  constexpr std::int64_t start_ns = std::numeric_limits<std::int64_t>::min();
  controller.update(sample(start_ns, Observation::direction));
  controller.update(sample(start_ns + 50 * ms, Observation::lifted));
  const PlateCommand command = controller.update(sample(std::numeric_limits<std::int64_t>::max(), Observation::lifted));
  EXPECT_EQ(command.step, 0);
  EXPECT_TRUE(command.held);

  PaperReach resting({}, {.real_direction_deg = 5, .virtual_direction_deg = -5});
  for (int i = 0; i < 50; ++i) resting.update(position(i * 10 * ms, {0, 0.3 * i}));
  for (int i = 50; i < 400; ++i) resting.update(position(i * 10 * ms, {0, 15.0}));
  EXPECT_TRUE(resting.command().held);
  EXPECT_LT(resting.command().step, 12);
}

// Without samples, the predicted finger follows the model, P_k+1 = P_k - K (w_T t + (1 - w_T) p), from 3 degrees, with
// the plate at rest; t and p are the directions of ridge normal and finger, relative to the goal. Step 2 is the first
// step without a sample, so commands are `predicted` from step 3 on.
TEST(PaperReach, MissingSamples_GiveThePredictedFinger) {
  PaperReach controller({}, {.real_direction_deg = 5, .virtual_direction_deg = -5});
  for (int k = 0; k < 2; ++k) controller.update(direction(k * 100 * ms, 3.0 * k));
  const double plate_deg = controller.command().plate_orientation_deg;
  const Participant participant;
  FilterGain step = next_gain(participant, next_gain(participant, 0.0).variance_deg2);
  double finger_deg = 3.0;
  const auto felt_error_deg = [&] { return step.gain * (0.15 * (plate_deg + 5.0) + 0.85 * (finger_deg + 5.0)); };
  for (int k = 2; k < 8; ++k) {
    finger_deg -= felt_error_deg();
    step = next_gain(participant, step.variance_deg2);
    const PlateCommand command = controller.update({.time_ns = k * 100 * ms});
    EXPECT_EQ(command.predicted, k > 2);
    EXPECT_EQ(command.plate_orientation_deg, plate_deg);
    if (k == 2) continue;
    EXPECT_NEAR(command.finger_direction_deg, finger_deg, 1e-9) << k;
    EXPECT_NEAR(command.perceived_direction_deg, -5.0 + felt_error_deg(), 1e-9) << k;
    const ReachSummary summary = controller.summary();
    EXPECT_EQ(summary.final_direction_deg, command.finger_direction_deg);
    EXPECT_EQ(summary.final_miss_deg, command.finger_direction_deg - 5.0);
    EXPECT_EQ(summary.perceived_direction_deg, command.perceived_direction_deg);
  }
  EXPECT_NEAR(finger_deg, 4.65, 0.005);
}

// A finger at 33 mm/s, whose tracking is lost at 33 mm of 100 mm: the distance to go decreases with the predicted
// finger, and is constant while the finger is lifted.
TEST(PaperReach, ADropout_ReducesThePredictedDistanceToGo) {
  PaperReach controller({}, {.real_direction_deg = 0, .virtual_direction_deg = 0});
  int t = 0;
  for (; t < 1000; t += 10) controller.update(position(t * ms, {0, 33e-3 * t}));
  const double seen_mm = controller.command().distance_to_go_mm;
  EXPECT_NEAR(seen_mm, 100.0 - 33.0, 1.0);
  for (; t < 1500; t += 10) controller.update({.time_ns = t * ms});
  EXPECT_TRUE(controller.command().predicted);
  const double predicted_mm = controller.command().distance_to_go_mm;
  EXPECT_NEAR(predicted_mm, seen_mm - 33.0 * 0.5, 2.0);
  EXPECT_EQ(controller.summary().distance_to_target_mm, predicted_mm);
  for (; t < 2000; t += 10) controller.update({.time_ns = t * ms, .observation = Observation::lifted});
  EXPECT_EQ(controller.command().distance_to_go_mm, predicted_mm);
}

TEST(PaperReach, DuplicateSamples_CountOnce) {
  const auto run = [](int times) {
    PaperReach controller({}, {.real_direction_deg = 5, .virtual_direction_deg = -5});
    for (int i = 0; i < 100; ++i)
      for (int repeat = 0; repeat < times; ++repeat) controller.update(position(i * 10 * ms, {0, 0.3 * i}));
    return controller.command().plate_orientation_deg;
  };
  EXPECT_EQ(run(1), run(3));
}

TEST(PaperReach, StopsWithoutTheCommand_GiveAnEquivalentOrientation) {
  PaperReachConfig config{.plate = {.max_speed_deg_s = 400.0, .stops = {90.0, 270.0}}};
  const Reach reach{.real_direction_deg = -5, .virtual_direction_deg = 5, .plate_orientation_deg = 0.0};
  PaperReach stays(config, reach);
  EXPECT_EQ(stays.update({.time_ns = 0}).plate_orientation_deg, 90.0);

  // Between the stops, the orientation with the same ridges as 0 is 180.
  config.fixed_plate_orientation_deg = 0.0;
  PaperReach fixed(config, reach);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(fixed
                  .update({.time_ns = i * 100 * ms,
                           .observation = i == 0 ? Observation::none : Observation::direction,
                           .direction_deg = 0.0})
                  .plate_orientation_deg,
              180.0);
  }
}

// +90 and -90 degrees have the same ridges, and are equally far from 0. Reports that change sign must not make the
// command switch between these orientations.
TEST(PaperReach, ReportsThatChangeSign_DoNotFlipAFixedPlate) {
  PaperReach fixed({.fixed_plate_orientation_deg = 90.0, .plate = {.max_speed_deg_s = 400.0, .latency_ns = 500 * ms}},
                   {.real_direction_deg = -5, .virtual_direction_deg = 5});
  const double first_deg = fixed.command().plate_orientation_deg;
  EXPECT_EQ(std::abs(first_deg), 90.0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(fixed
                  .update({.time_ns = i * 100 * ms,
                           .observation = Observation::direction,
                           .direction_deg = 0.0,
                           .plate_orientation_deg = i % 2 == 0 ? 0.1 : -0.1})
                  .plate_orientation_deg,
              first_deg);
  }
}

TEST(PaperReach, ALiftBeforeTheMotion_DoesNotDelayTheSteps) {
  std::vector<std::int64_t> steps;
  for (const Observation before : {Observation::none, Observation::lifted}) {
    PaperReach controller({}, {.real_direction_deg = -5, .virtual_direction_deg = 5});
    for (int i = 0; i < 20; ++i) controller.update({.time_ns = i * 10 * ms, .observation = before});
    int step_one = 0;
    for (int i = 20; step_one == 0 && i < 200; ++i)
      if (controller.update(position(i * 10 * ms, {0.0, 0.5 * std::max(0, i - 60)})).step == 1) step_one = i;
    steps.push_back(step_one);
  }
  EXPECT_GT(steps[0], 60);
  EXPECT_EQ(steps[0], steps[1]);
}

// The finger moves at 33 mm/s.
TEST(PaperReach, TenSecondsWithoutSamples_ArePredictedForTwo) {
  PaperReach controller({}, {.real_direction_deg = -5, .virtual_direction_deg = 5, .real_distance_mm = 1000.0});
  int i = 0;
  for (; i < 150; ++i) controller.update(position(i * 10 * ms, {0.0, 0.33 * std::max(0, i - 50)}));
  const double seen_mm = controller.command().distance_to_go_mm;
  for (; i < 1150; ++i) controller.update({.time_ns = i * 10 * ms});
  EXPECT_NEAR(seen_mm - controller.command().distance_to_go_mm, 2.0 * 33.0, 10.0);
}

TEST(StepClock, ALongGap_EndsSixtyFourStepsAndSkipsTheRest) {
  StepClock clock(1);
  clock.start(std::numeric_limits<std::int64_t>::min());
  std::int64_t ended = 0;
  const std::int64_t skipped =
      clock.advance(std::numeric_limits<std::int64_t>::min() + 100, [&](std::int64_t) { ++ended; });
  EXPECT_EQ(ended, 64);
  EXPECT_EQ(skipped, 36);
  EXPECT_EQ(clock.step(), 100);
}

}  // namespace

}  // namespace hrt
