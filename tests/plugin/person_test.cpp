// Reaches of simulated people through the C interface.
#include <cmath>
#include <limits>
#include <utility>

#include "core/plate/plate_model.h"
#include "core/simulation/people.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {
namespace {

constexpr std::int64_t rest_ns = 500 * ms;
constexpr double start_forward_m = -0.05;

bool has_begun(const hrt_command& command) { return (command.flags & HRT_COMMAND_MISS_UNKNOWN) == 0; }

struct ReachOutcome {
  double bearing_error_deg = 0.0;  ///< true final bearing of the finger, minus that of the real target
  std::vector<hrt_command> commands;
  hrt_reach_summary summary{};
};

class PersonTest : public SessionTest {
 protected:
  /// Returns the default configuration with the speed limit and latency of a servo plate: 400 deg/s, 30 ms.
  static hrt_session_config servo_config() {
    hrt_session_config config = session_config();
    config.plate.max_speed_deg_s = 400.0;
    config.plate.latency_ns = 30 * ms;
    return config;
  }

  /// Returns a person with a linear illusion and w_T = 0.2, and a tracker without noise.
  static PersonCondition steady_person() {
    PersonCondition condition;
    condition.person.noise_deg2_per_s = 0.0;
    condition.tracker.white_mm = 0.0;
    return condition;
  }

  static PersonCondition drawn_person(const char* family, double duration_s, std::uint32_t index) {
    return draw_person(*people_family(family), duration_s, 5, index);
  }

  /// Runs reach `number` of this person, until `ended_ns` at the latest.
  ReachOutcome run_reach(const PersonCondition& condition, std::uint32_t number = 0, double duration_s = 0.0,
                         std::int64_t ended_ns = std::numeric_limits<std::int64_t>::max()) {
    hrt_reach_config config =
        reach_config(add(HRT_TARGET_REAL, condition.real_direction_deg),
                     add(HRT_TARGET_VIRTUAL, condition.virtual_direction_deg), HRT_REACH_PLATE_ORIENTATION);
    config.duration_s = duration_s;
    EXPECT_OK(hrt_reach_begin(session, &config));

    const PlatePoint start{0.0, mm_per_m * start_forward_m};
    SlidingPerson person(condition.person, start, condition.virtual_direction_deg, condition.distance_mm,
                         Draws(3, 0, number, 0));
    Draws tracker(3, 1, number, 0);
    PlateModel plate(condition.plate, 0.0);
    ReachOutcome outcome;
    std::int64_t stopped_ns = std::numeric_limits<std::int64_t>::max();
    for (std::int64_t now_ns = 0; now_ns < std::min(ended_ns, stopped_ns); now_ns += ms) {
      plate.advance(now_ns);
      if (now_ns > rest_ns && !person.done()) person.advance(plate.orientation_deg());
      if (person.done() && stopped_ns - now_ns > 300 * ms) stopped_ns = now_ns + 300 * ms;
      if (now_ns % (11 * ms) != 0) continue;
      const double right_m = (person.position().right_mm + condition.tracker.white_mm * tracker.normal()) / mm_per_m;
      const double forward_m = (person.position().away_mm + condition.tracker.white_mm * tracker.normal()) / mm_per_m;
      const hrt_command command = update(position_sample(now_ns, right_m, forward_m));
      // A host does not need to send a command that repeats the last one.
      if ((command.flags & HRT_COMMAND_HELD) == 0) plate.command(command.plate_orientation_deg);
      outcome.commands.push_back(command);
    }
    outcome.summary = end();
    outcome.bearing_error_deg = bearing_deg(start, person.position()) - condition.real_direction_deg;
    EXPECT_OK(hrt_target_remove(session, config.real_target));
    EXPECT_OK(hrt_target_remove(session, config.virtual_target));
    return outcome;
  }
};

bool is_same_person(const hrt_session_config& a, const hrt_session_config& b) {
  return same(a.person.mean, b.person.mean) && same(a.person.covariance, b.person.covariance);
}

bool is_unknown(const hrt_session_config& config) {
  return std::all_of(std::begin(config.person.covariance), std::end(config.person.covariance),
                     [](double value) { return value == 0.0; });
}

// With a plate at 0, this person would end near the virtual target, about 10 degrees from the real one.
TEST_F(PersonTest, DefaultSessionSteersAPersonToTheRealTarget) {
  for (const double virtual_deg : {5.0, -5.0}) {
    PersonCondition condition = steady_person();
    condition.virtual_direction_deg = virtual_deg;
    condition.real_direction_deg = -virtual_deg;
    condition.plate = {};
    create(session_config());
    const ReachOutcome outcome = run_reach(condition);
    EXPECT_LT(std::abs(outcome.bearing_error_deg), 1.5);
    EXPECT_NEAR(outcome.summary.miss_deg, outcome.bearing_error_deg, 0.3);
    EXPECT_EQ(outcome.summary.flags, 0u);
    EXPECT_NEAR(outcome.summary.duration_s, condition.person.duration_s, 0.3);
    EXPECT_GT(outcome.summary.peak_felt_error_deg, outcome.summary.rms_felt_error_deg);
    EXPECT_GT(outcome.summary.rms_felt_error_deg, 0.0);
    EXPECT_EQ(outcome.commands.front().time_to_go_s, HRT_NOT_MOVING);
    EXPECT_EQ(outcome.commands.back().time_to_go_s, HRT_ARRIVED);
    EXPECT_GT(outcome.commands[outcome.commands.size() / 2].time_to_go_s, 0.1);
  }
}

// To steer a finger to the right, the ridges must shift the perceived direction to the left, so their normal is to the
// left of the motion. By default, it is at most 75 degrees from the motion.
TEST_F(PersonTest, PlateIsTurnedBeforeTheMotion) {
  hrt_session_config config = servo_config();
  config.adaptation = HRT_ADAPTATION_OFF;
  create(config);
  const ReachOutcome ready = run_reach(steady_person());
  const hrt_command& first = ready.commands.front();
  EXPECT_FALSE(has_begun(first));
  EXPECT_EQ(first.flags & HRT_COMMAND_HELD, 0u) << "hosts need not send held commands";
  EXPECT_GT(first.plate_orientation_deg, 10.0);
  EXPECT_LE(first.plate_orientation_deg, 75.0);
  for (const hrt_command& command : ready.commands) {
    if (has_begun(command)) break;
    EXPECT_EQ(command.plate_orientation_deg, first.plate_orientation_deg);
  }

  config.flags = HRT_SESSION_PLATE_WAITS;
  create(config);
  const ReachOutcome waiting = run_reach(steady_person());
  for (const hrt_command& command : waiting.commands) {
    if (has_begun(command)) break;
    EXPECT_EQ(command.plate_orientation_deg, 0.0);
    EXPECT_NE(command.flags & HRT_COMMAND_HELD, 0u);
  }
  EXPECT_GT(waiting.commands[waiting.commands.size() / 2].plate_orientation_deg, 10.0);
  EXPECT_LT(std::abs(waiting.bearing_error_deg), 1.5);
}

// Compares the elapsed time plus the time to go, at the first prediction, with the motion's duration of 3 s.
TEST_F(PersonTest, ConfiguredDurationSetsTheTimeToGo) {
  PersonCondition condition = steady_person();
  condition.person.duration_s = 3.0;
  const auto expected_s = [&](double duration_s) {
    create(servo_config());
    const ReachOutcome outcome = run_reach(condition, 0, duration_s);
    std::size_t i = 0;
    while (i + 1 < outcome.commands.size() && outcome.commands[i].time_to_go_s == HRT_NOT_MOVING) ++i;
    return outcome.commands[i].time_to_go_s + 0.011 * static_cast<double>(i) - 1e-9 * rest_ns;
  };
  EXPECT_NEAR(expected_s(3.0), 3.0, 0.3);
  EXPECT_NEAR(expected_s(0.0), 3.0, 0.3) << "the duration is estimated";
  EXPECT_LT(expected_s(1.5), expected_s(3.0) - 0.3);
}

// They differ from the summary's estimates, because the motion is filtered again, with the observed wander.
TEST_F(PersonTest, EstimatesAreWrittenToTheConfiguration) {
  create(servo_config());
  PersonCondition condition = steady_person();
  condition.person.bias_deg = 2.0;
  const hrt_reach_summary summary = run_reach(condition).summary;
  const hrt_session_config after = config_of(session);
  EXPECT_FALSE(is_unknown(after));
  EXPECT_NEAR(after.person.mean[HRT_PERSON_CURVE], summary.learnt.illusion_curve, 0.01);
  EXPECT_LT(after.person.mean[HRT_PERSON_LOG_WANDER], 1.6) << "the person is steadier than the prior";
  EXPECT_GT(after.person.mean[HRT_PERSON_BIAS],
            0.5 * summary.learnt.bias_deg);  // the rest is attributed to the scatter of this reach
  EXPECT_LT(after.person.mean[HRT_PERSON_BIAS], 2.0);
  EXPECT_NEAR(std::exp(-after.person.mean[HRT_PERSON_LOG_RATE]), summary.duration_s, 0.1);
  EXPECT_NEAR(after.person.tactile_weight, summary.learnt.tactile_weight, 0.01);
  EXPECT_NEAR(after.person.tactile_weight_sd, summary.learnt.tactile_weight_sd, 0.002);
  // Indices of the diagonal in a lower triangle by rows: 0, 2, 5, 9, 14.
  EXPECT_LT(std::sqrt(after.person.covariance[9]), 4.0) << "less than before the reach";
  EXPECT_LT(std::sqrt(after.person.covariance[0]), 0.08) << "less than before the reach";
}

TEST_F(PersonTest, ProfileRestoresThePersonBitForBit) {
  create(servo_config());
  run_reach(drawn_person("mixture", 1.5, 1), 1);
  run_reach(drawn_person("mixture", 1.5, 1), 2);
  const hrt_session_config learnt = config_of(session);
  ASSERT_FALSE(is_unknown(learnt));
  const std::string profile = save_profile();
  const ReachOutcome here = run_reach(drawn_person("mixture", 1.5, 1), 3);

  create(servo_config());
  ASSERT_OK(load_profile(profile));
  EXPECT_TRUE(is_same_person(config_of(session), learnt));
  EXPECT_EQ(config_of(session).person.tactile_weight, learnt.person.tactile_weight);
  const ReachOutcome there = run_reach(drawn_person("mixture", 1.5, 1), 3);
  expect_same(here.commands, there.commands);

  // A profile without person_mean resets the estimates.
  ASSERT_OK(load_profile(profile_with(",\"tactile_weight\":0.25,\"tactile_weight_sd\":0.02")));
  EXPECT_TRUE(is_unknown(config_of(session)));
  EXPECT_EQ(config_of(session).person.mean[HRT_PERSON_BIAS], 0.0);
  EXPECT_EQ(config_of(session).person.tactile_weight, 0.25);
}

TEST_F(PersonTest, AdaptationOffKeepsTheConfiguredWeight) {
  hrt_session_config config = servo_config();
  config.adaptation = HRT_ADAPTATION_OFF;
  config.person.tactile_weight = 0.26;
  create(config);
  const ReachOutcome outcome = run_reach(steady_person());  // whose tactile weight is 0.2
  for (const hrt_command& command : outcome.commands) {
    EXPECT_NEAR(command.tactile_weight, 0.26, 0.01);
    EXPECT_LT(command.tactile_weight_sd, 0.01);
  }
  EXPECT_TRUE(same(config_of(session), config));
}

// The finger rests for 0.5 s and moves for 0.5 s, which is a third of the motion's duration.
TEST_F(PersonTest, ReachThatEndsEarlyChangesNoEstimate) {
  create(servo_config());
  const hrt_session_config before = config_of(session);
  const ReachOutcome outcome = run_reach(steady_person(), 0, 0.0, rest_ns + 500 * ms);
  EXPECT_TRUE(has_begun(outcome.commands.back()));
  EXPECT_TRUE(same(config_of(session), before));
  run_reach(steady_person());
  EXPECT_FALSE(is_unknown(config_of(session)));
}

// With the plate at 75 degrees to the motion, a weight of 0.2 gives a shift of 15 degrees: a gap of 30 is not feasible.
// If the weight of the person is half of the configured one, the target is missed.
TEST_F(PersonTest, UnreachableAndMissedTargetsAreFlagged) {
  create(servo_config());
  PersonCondition condition = steady_person();
  condition.virtual_direction_deg = 15.0;
  condition.real_direction_deg = -15.0;
  const ReachOutcome far = run_reach(condition);
  EXPECT_GT(std::abs(far.bearing_error_deg), 1.5);
  EXPECT_NE(far.summary.flags & HRT_COMMAND_UNREACHABLE, 0u);
  EXPECT_NE(far.summary.flags & HRT_COMMAND_OFF_TARGET, 0u);
  EXPECT_NE(far.commands.back().flags & HRT_COMMAND_OFF_TARGET, 0u);
  EXPECT_GT(std::abs(far.commands.back().predicted_miss_deg), 1.5);

  condition = steady_person();
  condition.person.illusion.tactile_weight = 0.1;
  create(servo_config(), [](auto& c) { c.adaptation = HRT_ADAPTATION_OFF; });
  const ReachOutcome weak = run_reach(condition);
  EXPECT_GT(std::abs(weak.bearing_error_deg), 1.5);
  EXPECT_EQ(weak.summary.flags & HRT_COMMAND_UNREACHABLE, 0u);
  EXPECT_NE(weak.summary.flags & HRT_COMMAND_OFF_TARGET, 0u);
}

// The finger swings by 15 mm to each side of the path, with a period of 0.12 s.
TEST_F(PersonTest, ImpossibleMotionIsAMisfitAndChangesNoEstimate) {
  create(servo_config());
  const hrt_session_config before = config_of(session);
  begin_reach();
  std::uint32_t flags = 0;
  double innovation = 0.0;
  for (int i = 0; i < 220; ++i) {
    const double moved = std::max(0, i - 40) / 180.0;
    const double right_m = moved > 0.0 ? 0.015 * std::sin(0.6 * i) : 0.0;
    const hrt_command command = update(position_sample(i * 11 * ms, right_m, start_forward_m + 0.1 * moved));
    flags |= command.flags;
    innovation = std::max(innovation, command.misfit);
  }
  const hrt_reach_summary summary = end();
  EXPECT_NE(flags & HRT_COMMAND_MISFIT, 0u);
  EXPECT_NE(summary.flags & HRT_COMMAND_MISFIT, 0u);
  EXPECT_GE(innovation, 4.5);
  EXPECT_EQ(summary.misfit, innovation);
  EXPECT_TRUE(same(config_of(session), before));
}

// The finger rests for 0.6 s half way: the plate stops, and the reach continues afterwards.
TEST_F(PersonTest, RestWithinAReachStopsThePlate) {
  create(servo_config());
  PersonCondition condition = steady_person();
  condition.person.pace = Pace::pause;
  const ReachOutcome outcome = run_reach(condition);
  std::size_t resting = 0;
  for (std::size_t i = 1; i < outcome.commands.size(); ++i) {
    const hrt_command &now = outcome.commands[i], &before = outcome.commands[i - 1];
    if ((now.flags & before.flags & HRT_COMMAND_RESTING) == 0) continue;
    ++resting;
    EXPECT_EQ(now.plate_orientation_deg, before.plate_orientation_deg);
  }
  EXPECT_GE(resting, 20u);  // of the 54 samples of the rest
  EXPECT_EQ(outcome.commands.front().flags & HRT_COMMAND_RESTING, 0u) << "not within the reach";
  EXPECT_LT(std::abs(outcome.bearing_error_deg), 1.5);
}

TEST_F(PersonTest, InvalidMeanOrCovarianceIsRejectedAndChangesNothing) {
  create(servo_config());
  run_reach(steady_person());
  const hrt_session_config learnt = config_of(session);
  using Change = void (*)(hrt_session_config&);
  const std::pair<Change, const char*> invalid[] = {
      {[](auto& c) { c.person.covariance[0] = 0.0; }, "person_covariance"},  // a variance of 0 with correlations
      {[](auto& c) { c.person.covariance[2] = -c.person.covariance[2]; }, "person_covariance"},
      {[](auto& c) { c.person.covariance[44] = std::nan(""); }, "person_covariance[44]"},
      {[](auto& c) { c.person.mean[HRT_PERSON_WEIGHT] = 0.61; }, "person_mean[HRT_PERSON_WEIGHT]"},
      {[](auto& c) { c.person.mean[HRT_PERSON_BIAS] = HUGE_VAL; }, "person_mean[3]"},
  };
  for (const auto& [change, part] : invalid) {
    hrt_session_config config = learnt;
    change(config);
    expect_error(hrt_session_set(session, &config), HRT_ERROR_OUT_OF_RANGE, part);
    EXPECT_TRUE(is_same_person(config_of(session), learnt));
  }
  hrt_session_config config = learnt;
  std::fill(std::begin(config.person.covariance), std::end(config.person.covariance), 0.0);
  EXPECT_OK(hrt_session_set(session, &config));
  config.person.mean[0] = std::nan("");  // not read without a covariance, but written by recordings
  expect_error(hrt_session_set(session, &config), HRT_ERROR_OUT_OF_RANGE, "person_mean[0]");
}

TEST_F(PersonTest, DirectionsOnlyGiveTheCommandsOfFixedDirection) {
  const auto outcome = [&](std::uint32_t guidance) {
    create(servo_config(), [&](auto& c) { c.guidance = guidance; });
    std::vector<hrt_command> commands;
    for (int reach = 0; reach < 2; ++reach) {
      begin_reach();
      for (int i = 0; i < 60; ++i) {
        auto sample = direction_sample((3'000 * reach + 50 * i) * ms, 4.0 - 0.15 * i);
        if (i > 0 && i % 7 == 0) sample.flags = 0;
        commands.push_back(update(sample));
      }
      EXPECT_EQ(end().duration_s, 0.0);
    }
    EXPECT_TRUE(is_unknown(config_of(session)));
    EXPECT_NE(config_of(session).person.tactile_weight, 0.2) << "the estimate is carried";
    return commands;
  };
  expect_same(outcome(HRT_GUIDANCE_ARRIVAL), outcome(HRT_GUIDANCE_FIXED_DIRECTION));
}

TEST_F(PersonTest, ReachWithoutSamplesDoesNotMoveThePlate) {
  hrt_session_config config = servo_config();
  config.plate.max_speed_deg_s = 100.0;
  config.plate.latency_ns = 0;
  create(config);
  begin_reach();
  ASSERT_OK(hrt_reach_cancel(session));
  begin_reach();
  EXPECT_NEAR(update(direction_sample(0, 0.0)).plate_orientation_deg, 10.0, 1e-9) << "0.1 s at 100 degrees/s from 0";
}

}  // namespace
}  // namespace hrt::test
