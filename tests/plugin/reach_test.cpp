// Reaches under the paper's controller, through the C interface.
#include <cmath>

#include "core/paper_simulation/participant.h"
#include "fixture.h"

namespace hrt::test {
namespace {

using ReachTest = PaperTest;

// In degrees from the virtual target: p is the direction of the finger, p_R that of the real target, t the plate
// orientation, and e_0 the perceived-direction error. core/paper/README.md defines the other symbols. With horizon 3
// and no active bound, the optimal error is e_0 = 3/5 (p - p_R). The first Kalman gain is K_0 = 5/6:
//   K_0 = sigma_u^2/(sigma_u^2 + sigma_h^2),  e_0 = K_0 (w_T t + (1 - w_T) p),
//   t = (0.6 (p - p_R)/K_0 - (1 - w_T) p)/w_T.
// With p_R = -1 (a gap of 1), p = 0 and w_T = 0.15: t = 0.6/(5/6)/0.15 = 4.8.
TEST_F(ReachTest, FirstCommandIsAsDerivedByHand) {
  ASSERT_OK(begin(add(HRT_TARGET_REAL, -1.0), add(HRT_TARGET_VIRTUAL, 0.0)));
  const hrt_command command = update(direction_sample(0, 0.0));
  EXPECT_NEAR(command.plate_orientation_deg, 4.8, 1e-9);
  EXPECT_NEAR(command.perceived_direction_deg, 0.6, 1e-9);
  EXPECT_EQ(command.flags, HRT_COMMAND_MISS_UNKNOWN);
  EXPECT_EQ(command.paper.step, 0);
  EXPECT_EQ(command.tactile_weight, 0.15);
  EXPECT_EQ(command.tactile_weight_sd, 0.0);
}

TEST_F(ReachTest, FlagsTextWritesFlagsAsWords) {
  char words[64];
  std::uint64_t length = 0;
  ASSERT_OK(hrt_flags_text(HRT_COMMAND_UNREACHABLE | HRT_COMMAND_OFF_TARGET, sizeof words, words, &length));
  EXPECT_STREQ(words, "unreachable, off target");
  EXPECT_EQ(length, 23u);
  ASSERT_OK(hrt_flags_text(0, sizeof words, words, &length));
  EXPECT_STREQ(words, "");
  ASSERT_OK(hrt_flags_text(HRT_COMMAND_NOT_AT_START, 0, nullptr, &length));
  EXPECT_EQ(length, 12u);
  expect_error(hrt_flags_text(HRT_COMMAND_NOT_AT_START, 12, words, &length), HRT_ERROR_BUFFER_TOO_SMALL, "12");
  expect_error(hrt_flags_text(UINT32_C(1) << 31, sizeof words, words, &length), HRT_ERROR_OUT_OF_RANGE, "flags");
}

// With positions, the miss is the bearing of the end minus that of the real target. The path is curved, so the
// direction of the last step differs.
TEST_F(ReachTest, FixedDirectionReportsTheMissAsABearing) {
  ASSERT_OK(begin(add(HRT_TARGET_REAL, 5.0), add(HRT_TARGET_VIRTUAL, 8.0)));
  for (int i = 0; i <= 20; ++i) update(position_sample(i * 100 * ms, -0.0002 * i * i, -0.05 + 0.004 * i));
  const hrt_reach_summary summary = end();
  EXPECT_GT(summary.bearing_deg, 30.0);
  EXPECT_NEAR(summary.miss_deg, summary.bearing_deg - 5.0, 1e-9);
  EXPECT_NE(summary.paper.final_direction_deg, summary.bearing_deg);
}

TEST_F(ReachTest, EndWithoutASampleIsRejected) {
  begin_reach();
  auto summary = output<hrt_reach_summary>();
  expect_error(hrt_reach_end(session, &summary), HRT_ERROR_INSUFFICIENT_DATA,
               "the reach has had no sample; hrt_reach_cancel() ends it");
  const hrt_command command = update(direction_sample(0, 3.0));
  EXPECT_EQ(command.time_to_go_s, HRT_NOT_MOVING) << "the paper's controller does not estimate this time";
  ASSERT_OK(hrt_reach_end(session, &summary));
  EXPECT_EQ(summary.counts.samples, 1);
  EXPECT_EQ(summary.miss_deg, summary.paper.miss_deg);
  EXPECT_NE(summary.miss_deg, 0.0);
}

// The plate is at (1, 2, 3) in the world, rotated by 90 degrees to the left about the upward axis, so that its
// mid-line, -z, is the world's -x. A motion along the world's -x is straight ahead.
TEST_F(ReachTest, WorldPositionsGiveTheCommandsOfPlatePositions) {
  double on_plate_deg[21];
  begin_reach();
  for (int i = 0; i <= 20; ++i)
    on_plate_deg[i] = update(position_sample(i * 10 * ms, 0.0, -0.05 + 0.001 * i)).plate_orientation_deg;

  hrt_session_config config = paper_config();
  const double half = std::sqrt(0.5);
  config.plate.position_m[0] = 1.0;
  config.plate.position_m[1] = 2.0;
  config.plate.position_m[2] = 3.0;
  config.plate.rotation[1] = half;
  config.plate.rotation[3] = half;
  create(config);
  begin_reach();
  for (int i = 0; i <= 20; ++i) {
    hrt_sample sample = position_sample(i * 10 * ms, 1.0 + 0.05 - 0.001 * i, -3.0);
    sample.finger_position_m[1] = 2.0;
    sample.flags = HRT_SAMPLE_WORLD_POSITION;
    EXPECT_NEAR(update(sample).plate_orientation_deg, on_plate_deg[i], 1e-9);
  }
  EXPECT_NE(on_plate_deg[20], 0.0);
}

// Finger and plate move together in the world, so the finger is at rest on the plate.
TEST_F(ReachTest, FingerThatMovesWithThePlateIsAtRest) {
  begin_reach();
  for (int i = 0; i <= 20; ++i) {
    hrt_sample sample = position_sample(i * 10 * ms, 0.01 * i, -0.05);
    sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
    sample.plate_position_m[0] = 0.01 * i;
    sample.plate_rotation[3] = 1.0;
    EXPECT_EQ(update(sample).paper.step, -1);
  }
}

TEST_F(ReachTest, FingersAboveOrBeyondThePlateAreFlagged) {
  begin_reach();
  hrt_sample sample = position_sample(0, 0.0, -0.05);
  sample.finger_position_m[1] = 0.02;
  EXPECT_NE(update(sample).flags & HRT_COMMAND_LIFTED, 0u);
  EXPECT_NE(update(position_sample(1, 0.08, 0.0)).flags & HRT_COMMAND_OFF_PLATE, 0u);
}

TEST_F(ReachTest, DropoutsHoldTheCommandAndAreThenPredicted) {
  begin_reach();
  const hrt_command first = update(direction_sample(0, 0.0));
  auto lost = output<hrt_sample>();
  lost.time_ns = step_ns / 2;
  hrt_command command = update(lost);
  EXPECT_EQ(command.plate_orientation_deg, first.plate_orientation_deg);
  EXPECT_EQ(command.flags & HRT_COMMAND_PREDICTED, 0u);
  lost.time_ns = 5 * step_ns;
  command = update(lost);
  EXPECT_EQ(command.plate_orientation_deg, first.plate_orientation_deg);
  EXPECT_NE(command.flags & HRT_COMMAND_PREDICTED, 0u);
  command = update(direction_sample(5 * step_ns + 1, -5.0));
  EXPECT_EQ(command.flags & HRT_COMMAND_PREDICTED, 0u);
  EXPECT_EQ(command.paper.step, 5);
  const hrt_reach_summary summary = end();
  EXPECT_EQ(summary.counts.dropped_samples, 2);
  EXPECT_EQ(summary.paper.predicted_steps, 4);
}

TEST_F(ReachTest, DirectionOfALiftedFingerIsIgnored) {
  begin_reach();
  hrt_sample lifted = direction_sample(0, 10.0);
  lifted.flags |= HRT_SAMPLE_LIFTED;
  const hrt_command command = update(lifted);
  EXPECT_EQ(command.paper.step, -1);
  EXPECT_NE(command.flags & HRT_COMMAND_LIFTED, 0u);
  EXPECT_EQ(end().counts.steps, 0);
}

TEST_F(ReachTest, FixedPlateStaysAtItsOrientation) {
  hrt_session_config config = paper_config();
  config.control = HRT_CONTROL_FIXED_PLATE;
  config.fixed_plate_orientation_deg = -30.0;
  create(config);
  begin_reach();
  for (int step = 0; step < 30; ++step)
    EXPECT_EQ(update(direction_sample(step * step_ns, step)).plate_orientation_deg, -30.0);
}

TEST_F(ReachTest, UnreachablePairIsFlagged) {
  ASSERT_OK(begin(add(HRT_TARGET_REAL, -15.0), add(HRT_TARGET_VIRTUAL, 15.0)));
  hrt_command command = update(direction_sample(0, 0.0));
  EXPECT_NE(command.flags & HRT_COMMAND_UNREACHABLE, 0u);
  EXPECT_NE(command.flags & HRT_COMMAND_SATURATED, 0u);
  // 99.5 and -80.5 degrees are equivalent, and -80.5 is nearer to 0.
  EXPECT_NEAR(command.plate_orientation_deg, 15.0 + 84.5 - 180.0, 1e-9);
  const hrt_reach_summary summary = end();
  EXPECT_EQ(summary.counts.saturated_steps, 1);
  EXPECT_NE(summary.flags & HRT_COMMAND_UNREACHABLE, 0u);
}

TEST_F(ReachTest, PlateTurnsAtItsSpeedFromTheLastCommandOrTheGivenOrientation) {
  create(paper_config(), [](auto& c) { c.plate.max_speed_deg_s = 100.0; });
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), virtual_target = add(HRT_TARGET_VIRTUAL, 5.0);
  ASSERT_OK(begin(real, virtual_target));
  const hrt_command first = update(direction_sample(0, 0.0));
  EXPECT_NEAR(first.plate_orientation_deg, 10.0, 1e-9);
  EXPECT_NE(first.flags & HRT_COMMAND_RATE_LIMITED, 0u);
  end();
  ASSERT_OK(begin(real, virtual_target));
  EXPECT_NEAR(update(direction_sample(0, 0.0)).plate_orientation_deg, 20.0, 1e-9);
  end();
  hrt_reach_config reach = reach_config(real, virtual_target, HRT_REACH_PLATE_ORIENTATION);
  reach.plate_orientation_deg = -20.0;
  ASSERT_OK(hrt_reach_begin(session, &reach));
  EXPECT_NEAR(update(direction_sample(0, 0.0)).plate_orientation_deg, -10.0, 1e-9);
}

TEST_F(ReachTest, MeasuredPlateOrientationReplacesTheExpectedOne) {
  create(paper_config(), [](auto& c) { c.plate.max_speed_deg_s = 100.0; });
  begin_reach();
  hrt_sample sample = direction_sample(0, 0.0);
  sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
  sample.plate_orientation_deg = 25.0;
  EXPECT_NEAR(update(sample).plate_orientation_deg, 35.0, 1e-9);
}

// The participant's w_T differs from the configured one. The controller estimates it within a reach, and reaches the
// real target; with CARRIED, the estimate is written to the configuration.
TEST_F(ReachTest, AdaptationEstimatesTheTactileWeightAndCarriesIt) {
  create(paper_config(), [](auto& c) { c.adaptation = HRT_ADAPTATION_CARRIED; });
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), virtual_target = add(HRT_TARGET_VIRTUAL, 5.0);
  const auto reach = [&] {
    EXPECT_OK(begin(real, virtual_target));
    SimulatedParticipant participant({.tactile_weight = 0.22}, 5.0);
    for (int step = 0; step < 30; ++step) {
      const hrt_command command = update(direction_sample(step * step_ns, participant.finger_direction_deg()));
      participant.step(command.plate_orientation_deg, 0.0);
    }
    return end();
  };
  const hrt_reach_summary first = reach();
  EXPECT_NEAR(first.learnt.tactile_weight, 0.22, 0.02);
  EXPECT_GT(first.learnt.tactile_weight_sd, 0.0);
  EXPECT_LT(first.learnt.tactile_weight_sd, 0.05);
  EXPECT_NEAR(first.paper.miss_deg, 0.0, 0.5);
  EXPECT_EQ(first.paper.final_direction_deg, first.paper.miss_deg - 5.0);
  EXPECT_EQ(first.counts.steps, 30);
  const hrt_session_config learnt = config_of(session);
  EXPECT_EQ(learnt.person.tactile_weight, first.learnt.tactile_weight);
  EXPECT_EQ(learnt.person.tactile_weight_sd, std::max(first.learnt.tactile_weight_sd, 0.01));

  create(paper_config());
  begin_reach();
  update(direction_sample(0, 0.0));
  EXPECT_EQ(end().learnt.tactile_weight, 0.15);
}

TEST_F(ReachTest, CommandsStayBetweenTheStops) {
  for (const std::uint32_t guidance : {HRT_GUIDANCE_FIXED_DIRECTION, HRT_GUIDANCE_ARRIVAL})
    for (const double lower_deg : {-180.0, -100.0, -90.0, -20.0, 10.0}) {
      hrt_session_config config = paper_config();
      config.guidance = guidance;
      config.plate.lower_stop_deg = lower_deg;
      config.plate.upper_stop_deg = lower_deg + 180.0;
      create(config);
      ASSERT_OK(begin(add(HRT_TARGET_REAL, 20.0), add(HRT_TARGET_VIRTUAL, 32.0)));
      for (std::int64_t t = 0; t < 2000; t += 10) {
        const double plate_deg = slide(t, t + 10).plate_orientation_deg;
        EXPECT_GE(plate_deg, lower_deg);
        EXPECT_LE(plate_deg, lower_deg + 180.0);
      }
    }
}

TEST_F(ReachTest, CallsOutOfOrderAreRejected) {
  auto command = output<hrt_command>();
  auto summary = output<hrt_reach_summary>();
  const hrt_sample sample = direction_sample(0, 0.0);
  expect_error(hrt_reach_update(session, &sample, &command), HRT_ERROR_WRONG_STATE);
  expect_error(hrt_reach_end(session, &summary), HRT_ERROR_WRONG_STATE);
  begin_reach();
  expect_error(begin({1}, {2}), HRT_ERROR_WRONG_STATE);
  const hrt_session_config config = paper_config();
  expect_error(hrt_session_set(session, &config), HRT_ERROR_WRONG_STATE);
  ASSERT_OK(hrt_reach_cancel(session));
  expect_error(hrt_reach_end(session, &summary), HRT_ERROR_WRONG_STATE);
}

TEST_F(ReachTest, DecreasingTimeIsRejectedAndChangesNothing) {
  begin_reach();
  update(direction_sample(1000, 0.0));
  auto command = output<hrt_command>();
  command.paper.step = 77;
  const hrt_sample early = direction_sample(999, 0.0);
  expect_error(hrt_reach_update(session, &early, &command), HRT_ERROR_TIME_REVERSED, "time_ns");
  EXPECT_EQ(command.paper.step, 77);
  update(direction_sample(1000, 0.0));
  EXPECT_EQ(end().counts.samples, 2);
}

TEST_F(ReachTest, SamplesWithTwoPositionsOrWithoutAPoseAreRejected) {
  begin_reach();
  const hrt_command before = update(direction_sample(0, 0.0));
  const auto refused = [&](hrt_sample sample, const char* part) {
    auto command = output<hrt_command>();
    command.paper.step = 77;
    expect_error(hrt_reach_update(session, &sample, &command), HRT_ERROR_OUT_OF_RANGE, part);
    EXPECT_EQ(command.paper.step, 77);
  };
  hrt_sample sample = direction_sample(1, 0.0);
  sample.flags = HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION;
  refused(sample, "flags");
  sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
  refused(sample, "plate_rotation");
  EXPECT_EQ(update(direction_sample(0, 0.0)).plate_orientation_deg, before.plate_orientation_deg);
  EXPECT_EQ(end().counts.samples, 2);
}

TEST_F(ReachTest, FieldsThatFlagsDoNotNameAreNotRead) {
  begin_reach();
  hrt_sample sample = direction_sample(0, 0.0);
  sample.finger_position_m[0] = sample.plate_orientation_deg = std::nan("");
  EXPECT_TRUE(std::isfinite(update(sample).plate_orientation_deg));
}

TEST_F(ReachTest, InvalidPairsAreRejected) {
  const hrt_target real = add(HRT_TARGET_REAL, -50.0), virtual_target = add(HRT_TARGET_VIRTUAL, 45.0);
  expect_error(begin(real, virtual_target), HRT_ERROR_OUT_OF_RANGE, "-50 degrees");
  expect_error(begin(virtual_target, real), HRT_ERROR_OUT_OF_RANGE, "real_target");
  expect_error(begin({0}, virtual_target), HRT_ERROR_INVALID_HANDLE, "real_target");
}

}  // namespace
}  // namespace hrt::test
