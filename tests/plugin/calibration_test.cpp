// Calibration through the C ABI: slides streamed in, a user's parameters out and into the session.
#include "core/calibrate/calibration.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/paper_simulation/paper_slide.h"
#include "core/simulation/slide.h"
#include "fixture.h"

namespace hrt::test {
namespace {

constexpr double angles_deg[] = {-60.0, -30.0, 0.0, 30.0, 60.0};

// At 30 Hz, as what a fit takes grows with its samples.
std::vector<CalibrationTrial> simulate(CalibrationCondition condition, int trials_an_angle) {
  condition.tracker_rate_hz = 30.0;
  std::vector<CalibrationTrial> trials;
  std::uint32_t trial = 0;
  for (const double angle_deg : angles_deg) {
    for (int i = 0; i < trials_an_angle; ++i)
      trials.push_back(
          simulate_calibration_trial(condition, angle_deg, {.seed = 1, .condition = 0, .trial = trial++}));
  }
  return trials;
}

hrt_calibration_config calibration_config() {
  hrt_calibration_config config = hrt_calibration_config_init();
  return config;
}

class CalibrationTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    make(calibration_config());
  }
  void TearDown() override {
    EXPECT_OK(hrt_calibration_destroy(calibration));
    SessionTest::TearDown();
  }

  void make(const hrt_calibration_config& config) {
    if (calibration.value != 0) {
      ASSERT_OK(hrt_calibration_destroy(calibration));
    }
    calibration.value = 0;
    ASSERT_OK(hrt_calibration_create(session, &config, &calibration));
  }

  hrt_result add(const hrt_sample& sample) const { return hrt_calibration_add_sample(calibration, &sample); }

  void stream(const CalibrationTrial& trial) const {
    ASSERT_OK(hrt_calibration_begin_trial(calibration, trial.plate_orientation_deg));
    for (std::size_t i = 0; i < trial.samples.size(); ++i) {
      const TimedPoint& seen = trial.samples[i];
      hrt_sample sample = position_sample(seen.time_ns, seen.position.right_m, seen.position.away_m);
      if (!trial.plate_deg.empty() && (i == 0 || trial.plate_deg[i] != trial.plate_deg[i - 1])) {
        sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
        sample.plate_orientation_deg = trial.plate_deg[i];
      }
      ASSERT_OK(add(sample));
    }
    ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
  }

  void stream(const std::vector<CalibrationTrial>& trials) const {
    for (const CalibrationTrial& trial : trials) stream(trial);
  }

  hrt_calibration_result solve() const {
    auto result = output<hrt_calibration_result>();
    EXPECT_OK(hrt_calibration_solve(calibration, &result));
    return result;
  }

  void expect_refusal(const char* part) const {
    auto result = output<hrt_calibration_result>();
    result.trials = 77;
    expect_error(hrt_calibration_solve(calibration, &result), HRT_ERROR_INSUFFICIENT_DATA, part);
    EXPECT_EQ(result.trials, 77u);
  }

  hrt_session_config config() const { return config_of(session); }

  hrt_calibration calibration{0};
};

void expect_same(const hrt_interval& streamed, const Interval& known) {
  EXPECT_NEAR(streamed.value, known.value, 1e-9);
  EXPECT_NEAR(streamed.lower, known.lower, 1e-9);
  EXPECT_NEAR(streamed.upper, known.upper, 1e-9);
  EXPECT_EQ(streamed.known, known.known ? 1u : 0u);
}

void expect_same(const hrt_calibration_result& streamed, const std::vector<CalibrationTrial>& trials,
                 double goal_direction_deg) {
  const auto whole = std::get<Calibration>(calibrate(trials, goal_direction_deg));
  EXPECT_EQ(streamed.trials, trials.size());
  EXPECT_EQ(streamed.trials_used, whole.slides.size());
  expect_same(streamed.tactile_weight, whole.tactile_weight);
  expect_same(streamed.bias_deg, whole.bias_deg);
  expect_same(streamed.tracker_noise_m, whole.noise.white_m);
  expect_same(streamed.habit_deg, whole.habit_deg);
  expect_same(streamed.max_gap_deg, whole.max_gap_deg);
  expect_same(streamed.person_weight, whole.slope);
  expect_same(streamed.person_curve, whole.curve);
  EXPECT_EQ(streamed.angle_p, whole.lack_of_fit.angle_p);
  EXPECT_EQ(streamed.slides_outlying, whole.count(SlideVerdict::outlying));
}

TEST_F(CalibrationTest, StreamedTrialsGiveWhatWholeOnesGive) {
  CalibrationCondition condition{.participant = {.bias_deg = 2.0}, .goal_direction_deg = 4.0};
  condition.participant.tactile_weight = 0.2;
  const auto trials = simulate(condition, 3);
  hrt_calibration_config setup = calibration_config();
  setup.goal_direction_deg = 4.0;
  make(setup);
  stream(trials);
  const hrt_calibration_result result = solve();
  expect_same(result, trials, 4.0);
  EXPECT_NEAR(result.tactile_weight.value, 0.2, 0.03);
  EXPECT_NEAR(result.bias_deg.value, 2.0, 1.0);
  EXPECT_NEAR(result.tracker_noise_m.value, 0.0012, 0.0003);
}

TEST_F(CalibrationTest, TrialsMayBeAddedAndTheFitRepeated) {
  const auto trials = simulate({}, 3);
  const std::vector<CalibrationTrial> first(trials.begin(), trials.begin() + 12);
  const std::vector<CalibrationTrial> rest(trials.begin() + 12, trials.end());
  stream(first);
  expect_same(solve(), first, {});
  stream(rest);
  expect_same(solve(), trials, {});
}

// Dropouts, lifted fingers and samples sent twice are left out; a cancelled trial is as if it had never been.
TEST_F(CalibrationTest, SamplesWithoutAPositionAreLeftOut) {
  const auto trials = simulate({}, 2);
  for (const CalibrationTrial& trial : trials) {
    ASSERT_OK(hrt_calibration_begin_trial(calibration, trial.plate_orientation_deg));
    for (const TimedPoint& sample : trial.samples) {
      auto lost = output<hrt_sample>();
      lost.time_ns = sample.time_ns;
      ASSERT_OK(add(lost));
      hrt_sample lifted = position_sample(sample.time_ns, 0.5, 0.5);
      lifted.flags |= HRT_SAMPLE_LIFTED;
      ASSERT_OK(add(lifted));
      hrt_sample high = position_sample(sample.time_ns, 0.0, 0.0);
      high.finger_position_m[1] = 0.1;
      ASSERT_OK(add(high));
      hrt_sample seen = position_sample(sample.time_ns, sample.position.right_m, sample.position.away_m);
      seen.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
      ASSERT_OK(add(seen));
      ASSERT_OK(add(position_sample(sample.time_ns, 1.0, 1.0)));
    }
    ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
    ASSERT_OK(hrt_calibration_begin_trial(calibration, 45.0));
    ASSERT_OK(add(position_sample(0, 0.0, 0.0)));
    ASSERT_OK(hrt_calibration_end_trial(calibration, 0));
  }
  expect_same(solve(), trials, {});
}

// The plate at (1, 2, 3) in the world and turned by 90 degrees, as the session's configuration has it, or as
// the samples do.
TEST_F(CalibrationTest, WorldPositionsAreTakenToThePlate) {
  hrt_session_config moved = session_config();
  moved.plate_position_m[0] = 1.0;
  moved.plate_position_m[1] = 2.0;
  moved.plate_position_m[2] = 3.0;
  moved.plate_rotation[1] = moved.plate_rotation[3] = std::sqrt(0.5);
  create(moved);
  make(calibration_config());
  const auto trials = simulate({}, 2);
  for (const CalibrationTrial& trial : trials) {
    ASSERT_OK(hrt_calibration_begin_trial(calibration, trial.plate_orientation_deg));
    for (const TimedPoint& sample : trial.samples) {
      auto world = output<hrt_sample>();
      world.flags = HRT_SAMPLE_WORLD_POSITION;
      world.time_ns = sample.time_ns;
      world.finger_position_m[0] = 1.0 - sample.position.away_m;
      world.finger_position_m[1] = 2.0;
      world.finger_position_m[2] = 3.0 - sample.position.right_m;
      if (trial.plate_orientation_deg > 0.0) {
        world.flags |= HRT_SAMPLE_PLATE_POSE;
        world.finger_position_m[0] += 5.0;
        std::memcpy(world.plate_position_m, moved.plate_position_m, sizeof world.plate_position_m);
        std::memcpy(world.plate_rotation, moved.plate_rotation, sizeof world.plate_rotation);
        world.plate_position_m[0] += 5.0;
      }
      ASSERT_OK(add(world));
    }
    ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
  }
  const auto whole = std::get<Calibration>(calibrate(trials));
  EXPECT_NEAR(solve().tactile_weight.value, whole.tactile_weight.value, 1e-6);
}

TEST_F(CalibrationTest, TooFewDataAreRefusedWithTheReason) {
  expect_refusal(
      "hrt_calibration_solve: 0 of 0 trials have a slide of at least 30 mm over a plate at rest; at least 10 "
      "are needed");
  const auto trials = simulate({}, 3);
  stream({trials.begin(), trials.begin() + 9});
  expect_refusal("9 of 9 trials");
  make(calibration_config());
  for (CalibrationTrial trial : trials) {
    trial.plate_orientation_deg = 30.0;
    stream(trial);
  }
  expect_refusal("1 different angles; at least 3 that span 40 degrees are needed");
}

TEST_F(CalibrationTest, CallsOutOfOrderAreRefused) {
  auto result = output<hrt_calibration_result>();
  const hrt_sample sample = position_sample(0, 0.0, 0.0);
  expect_error(add(sample), HRT_ERROR_WRONG_STATE, "no trial");
  expect_error(hrt_calibration_end_trial(calibration, 1), HRT_ERROR_WRONG_STATE, "no trial");
  expect_error(hrt_calibration_end_trial(calibration, 0), HRT_ERROR_WRONG_STATE, "no trial");
  ASSERT_OK(hrt_calibration_begin_trial(calibration, 0.0));
  expect_error(hrt_calibration_begin_trial(calibration, 0.0), HRT_ERROR_WRONG_STATE, "under way");
  expect_error(hrt_calibration_solve(calibration, &result), HRT_ERROR_WRONG_STATE, "under way");
}

TEST_F(CalibrationTest, BadArgumentsAreRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity, 3600.1})
    expect_error(hrt_calibration_begin_trial(calibration, bad), HRT_ERROR_OUT_OF_RANGE,
                 "plate_orientation_deg");
  ASSERT_OK(hrt_calibration_begin_trial(calibration, 0.0));
  ASSERT_OK(add(position_sample(1000, 0.0, 0.0)));
  expect_error(add(position_sample(999, 0.0, 0.0)), HRT_ERROR_TIME_REVERSED, "allowed: from");
  expect_error(add(position_sample(1001, std::nan(""), 0.0)), HRT_ERROR_OUT_OF_RANGE, "finger_position_m");
  expect_error(add(direction_sample(1001, 0.0)), HRT_ERROR_OUT_OF_RANGE,
               "allowed: PLATE_POSITION or WORLD_POSITION");
  hrt_sample sample = position_sample(1001, 0.0, 0.0);
  sample.flags = 1u << 31;
  expect_error(add(sample), HRT_ERROR_OUT_OF_RANGE, "flags");
  ASSERT_OK(add(position_sample(1001, 0.0, 0.0)));
  ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
  // Another trial, another clock.
  ASSERT_OK(hrt_calibration_begin_trial(calibration, 0.0));
  ASSERT_OK(add(position_sample(std::numeric_limits<int64_t>::min(), 0.0, 0.0)));
  ASSERT_OK(add(position_sample(std::numeric_limits<int64_t>::max(), 0.0, 0.0)));
  ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
}

TEST_F(CalibrationTest, CreationIsChecked) {
  hrt_calibration_config narrow = calibration_config();
  narrow.upper_plate_deg = -40.0;
  hrt_calibration out{};
  expect_error(hrt_calibration_create(session, &narrow, &out), HRT_ERROR_OUT_OF_RANGE,
               "at least 40 above lower_plate_deg, -75");
}

TEST_F(CalibrationTest, LimitsAreKept) {
  hrt_calibration_config small = calibration_config();
  small.max_trials = 10;
  small.max_samples = 100;
  make(small);
  ASSERT_OK(hrt_calibration_begin_trial(calibration, 0.0));
  for (int i = 0; i < 100; ++i) ASSERT_OK(add(position_sample(i, 0.0, 0.0)));
  expect_error(add(position_sample(100, 0.0, 0.0)), HRT_ERROR_LIMIT_REACHED, "max_samples samples, 100");
  ASSERT_OK(hrt_calibration_end_trial(calibration, 0));
  for (int i = 0; i < 10; ++i) {
    ASSERT_OK(hrt_calibration_begin_trial(calibration, 0.0));
    for (int k = 0; k < 10; ++k) ASSERT_OK(add(position_sample(k, 0.0, 0.0)));
    ASSERT_OK(hrt_calibration_end_trial(calibration, 1));
  }
  expect_error(hrt_calibration_begin_trial(calibration, 0.0), HRT_ERROR_LIMIT_REACHED,
               "max_trials trials, 10");
  expect_refusal("0 of 10 trials");
}

TEST_F(CalibrationTest, HandlesAreChecked) {
  const hrt_calibration old = calibration;
  make(calibration_config());
  for (const hrt_calibration bad : {old, hrt_calibration{session.value}})
    expect_error(hrt_calibration_begin_trial(bad, 0.0), HRT_ERROR_INVALID_HANDLE, "calibration");
  const hrt_calibration_config config = calibration_config();
  std::vector<hrt_calibration> all(HRT_CALIBRATIONS_MAX - 1);
  for (hrt_calibration& one : all) ASSERT_OK(hrt_calibration_create(session, &config, &one));
  hrt_calibration one_more{42};
  expect_error(hrt_calibration_create(session, &config, &one_more), HRT_ERROR_LIMIT_REACHED, "16");
  EXPECT_EQ(one_more.value, 42u);
  for (const hrt_calibration one : all) ASSERT_OK(hrt_calibration_destroy(one));
}

TEST_F(CalibrationTest, OutlivesItsSession) {
  ASSERT_OK(hrt_session_destroy(session));
  session.value = 0;
  stream(simulate({}, 2));
  EXPECT_EQ(solve().trials_used, 10u);
}

hrt_calibration_result all_known() {
  auto result = output<hrt_calibration_result>();
  result.tactile_weight = {0.2, 0.1608, 0.2392, 1, 0};
  result.bias_deg = {-3.0, -4.0, -2.0, 1, 0};
  result.tracker_noise_m = {0.001, 0.0009, 0.0011, 1, 0};
  return result;
}

TEST_F(CalibrationTest, CorrelatedNoiseGoesIntoTheSessionWithItsTime) {
  hrt_calibration_result result = all_known();
  result.correlated_noise_m = {0.0012, 0.001, 0.0014, 1, 0};
  result.noise_correlation_s = {0.3, 0.2, 0.45, 1, 0};
  ASSERT_OK(hrt_calibration_apply(session, &result));
  EXPECT_EQ(config().tracker_noise_m, 0.001);
  EXPECT_EQ(config().tracker_correlated_noise_m, 0.0012);
  EXPECT_EQ(config().tracker_correlation_s, 0.3);
  // Without its time, or if there may be none, the whole noise is all that is known.
  result.noise_correlation_s.known = 0;
  ASSERT_OK(hrt_calibration_apply(session, &result));
  EXPECT_DOUBLE_EQ(config().tracker_noise_m, std::hypot(0.001, 0.0012));
  EXPECT_EQ(config().tracker_correlated_noise_m, 0.0);
  result.noise_correlation_s.known = 1;
  result.correlated_noise_m = {0.0002, 0.0, 0.0004, 1, 0};
  ASSERT_OK(hrt_calibration_apply(session, &result));
  EXPECT_DOUBLE_EQ(config().tracker_noise_m, std::hypot(0.001, 0.0002));
  EXPECT_EQ(config().tracker_correlated_noise_m, 0.0);
  result.correlated_noise_m.upper = 0.0001;
  expect_error(hrt_calibration_apply(session, &result), HRT_ERROR_OUT_OF_RANGE, "correlated_noise_m");
}

// A plate that is reported where it rests is at rest, half a turn is none, and a sample without a report has
// the last one's.
TEST_F(CalibrationTest, SlidesOverATurningPlateAreLeftOut) {
  std::vector<CalibrationTrial> trials = simulate({}, 2);
  CalibrationTrial turning = trials[3];
  turning.plate_deg.assign(turning.samples.size(), turning.plate_orientation_deg);
  std::fill(turning.plate_deg.begin() + 50, turning.plate_deg.end(), turning.plate_orientation_deg + 6.0);
  ASSERT_OK(hrt_calibration_begin_trial(calibration, 45.0));
  for (const TimedPoint& seen : turning.samples) {
    hrt_sample sample = position_sample(seen.time_ns, seen.position.right_m, seen.position.away_m);
    sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    sample.plate_orientation_deg = 1e-6 * static_cast<double>(seen.time_ns);
    ASSERT_OK(add(sample));
  }
  ASSERT_OK(hrt_calibration_end_trial(calibration, 0));
  stream(trials[0]);
  stream(turning);
  for (std::size_t i = 1; i < trials.size(); ++i) {
    CalibrationTrial reported = trials[i];
    reported.plate_deg.assign(reported.samples.size(), reported.plate_orientation_deg + 20.0);
    std::fill(reported.plate_deg.begin() + 50, reported.plate_deg.end(),
              reported.plate_orientation_deg + 200.0);
    stream(reported);
  }
  const hrt_calibration_result result = solve();
  EXPECT_EQ(result.trials, 11u);
  EXPECT_EQ(result.slides_turning, 1u);
  EXPECT_EQ(result.trials_used, 10u);
  expect_same(result.tactile_weight, std::get<Calibration>(calibrate(trials)).tactile_weight);
}

TEST_F(CalibrationTest, SlidesAreNamedAfterASolution) {
  auto slide = output<hrt_calibration_slide>();
  expect_error(hrt_calibration_get_residual(calibration, 0, &slide), HRT_ERROR_WRONG_STATE, "no solution");
  auto trials = simulate({}, 3);
  for (TimedPoint& sample : trials[4].samples) sample.position.right_m += 0.7 * sample.position.away_m;
  stream(trials);
  EXPECT_EQ(solve().slides_outlying, 1u);
  ASSERT_OK(hrt_calibration_get_residual(calibration, 4, &slide));
  EXPECT_EQ(slide.verdict, HRT_SLIDE_OUTLYING);
  EXPECT_EQ(slide.trial, 4u);
  EXPECT_EQ(slide.plate_deg, -30.0);
  EXPECT_NEAR(slide.residual_deg, slide.direction_deg - slide.fitted_deg, 1e-12);
  EXPECT_LT(slide.residual_deg, -15.0);
  expect_error(hrt_calibration_get_residual(calibration, 15, &slide), HRT_ERROR_OUT_OF_RANGE,
               "slide is 15; allowed: 0 to 14");
}

TEST_F(CalibrationTest, TheNextAngleIsWithinTheRange) {
  hrt_calibration_config setup = calibration_config();
  setup.goal_direction_deg = 10.0;
  setup.lower_plate_deg = -50.0;
  setup.upper_plate_deg = 40.0;
  make(setup);
  const auto trials = simulate({.goal_direction_deg = 10.0}, 3);
  for (const CalibrationTrial& trial : trials) {
    double angle_deg = std::nan("");
    uint32_t enough = 7;
    ASSERT_OK(hrt_calibration_next_angle(calibration, &angle_deg, &enough));
    EXPECT_GE(angle_deg, -40.0);
    EXPECT_LE(angle_deg, 50.0);
    EXPECT_EQ(enough, 0u);
    stream(trial);
  }
  double angle_deg = 7.0;
  uint32_t enough = 7;
  ASSERT_OK(hrt_calibration_begin_trial(calibration, 0.0));
  expect_error(hrt_calibration_next_angle(calibration, &angle_deg, &enough), HRT_ERROR_WRONG_STATE,
               "under way");
  ASSERT_OK(hrt_calibration_end_trial(calibration, 0));
  EXPECT_EQ(angle_deg, 7.0);
  EXPECT_EQ(enough, 7u);
}

// A known curve, bias and habit become the person whom reaches begin with, and the peak their motion bound.
TEST_F(CalibrationTest, AKnownCurveBecomesThePerson) {
  hrt_calibration_result result = all_known();
  result.person_weight = {0.25, 0.2108, 0.2892, 1, 0};
  result.person_curve = {0.05, 0.0108, 0.0892, 1, 0};
  result.weight_curve_correlation = 0.5;
  result.habit_deg = {4.0, 2.0, 6.0, 1, 0};
  result.peak_offset_deg = 62.0;
  ASSERT_OK(hrt_calibration_apply(session, &result));
  EXPECT_EQ(config().person_mean[HRT_PERSON_WEIGHT], 0.25);
  EXPECT_EQ(config().person_mean[HRT_PERSON_CURVE], 0.05);
  EXPECT_EQ(config().person_mean[HRT_PERSON_BIAS], -3.0);
  EXPECT_EQ(config().person_mean[HRT_PERSON_HABIT], 4.0);
  EXPECT_NEAR(config().person_covariance[0], 0.02 * 0.02, 1e-7);
  EXPECT_NEAR(config().person_covariance[1], 0.5 * 0.02 * 0.02, 1e-7);
  EXPECT_EQ(config().motion_bound_deg, 62.0);
  EXPECT_EQ(config().tactile_weight, 0.2);
  const hrt_session_config before = config();
  result.peak_offset_deg = 0.0;
  expect_error(hrt_calibration_apply(session, &result), HRT_ERROR_OUT_OF_RANGE, "peak_offset_deg is 0");
  const hrt_session_config after = config();
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
}

// The interval is 2 times 1.96 times 0.02 wide.
TEST_F(CalibrationTest, ResultBecomesTheSessionsConfiguration) {
  const hrt_calibration_result result = all_known();
  ASSERT_OK(hrt_calibration_apply(session, &result));
  EXPECT_EQ(config().tactile_weight, 0.2);
  EXPECT_NEAR(config().tactile_weight_sd, 0.02, 1e-6);
  EXPECT_EQ(config().bias_deg, -3.0);
  EXPECT_EQ(config().tracker_noise_m, 0.001);
}

TEST_F(CalibrationTest, WhatIsNotKnownStaysAsItIs) {
  hrt_calibration_result result = all_known();
  result.tactile_weight.known = result.bias_deg.known = result.tracker_noise_m.known = 0;
  result.bias_deg.value = std::nan("");
  hrt_session_config before = config();
  ASSERT_OK(hrt_calibration_apply(session, &result));
  const hrt_session_config after = config();
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
  // No data make a user surer than this: people change.
  result.tactile_weight = {0.2, 0.2, 0.2, 1, 0};
  ASSERT_OK(hrt_calibration_apply(session, &result));
  EXPECT_EQ(config().tactile_weight_sd, 0.01);
}

TEST_F(CalibrationTest, BadResultsAreRefusedAndChangeNothing) {
  const hrt_session_config before = config();
  const auto refused = [&](auto change, const char* part) {
    hrt_calibration_result result = all_known();
    change(result);
    expect_error(hrt_calibration_apply(session, &result), HRT_ERROR_OUT_OF_RANGE, part);
  };
  refused([](auto& r) { r.tactile_weight.value = std::nan(""); }, "tactile_weight is NaN");
  refused([](auto& r) { r.tactile_weight = {0.6, 0.5, 0.7, 1, 0}; }, "tactile_weight is 0.6; allowed");
  refused([](auto& r) { r.tactile_weight = {0.2, -5.0, 5.0, 1, 0}; }, "tactile_weight_sd");
  refused([](auto& r) { r.bias_deg.lower = std::nan(""); }, "bias_deg is -3 in an interval from NaN");
  refused([](auto& r) { r.bias_deg = {-90.0, -91.0, -89.0, 1, 0}; }, "bias_deg is -90; allowed: -45 to 45");
  refused([](auto& r) { r.tactile_weight.upper = std::numeric_limits<double>::infinity(); },
          "tactile_weight_sd");
  refused([](auto& r) { r.tracker_noise_m.known = 2; }, "tracker_noise_m.known is 2");
  refused([](auto& r) { r.tracker_noise_m.reserved = 1; }, "reserved");
  begin_reach();
  const auto result = all_known();
  expect_error(hrt_calibration_apply(session, &result), HRT_ERROR_WRONG_STATE, "under way");
  const hrt_session_config after = config();
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
}

constexpr hrt_interval known(double value, double width) {
  return {value, value - width / 2.0, value + width / 2.0, 1, 0};
}

hrt_calibration_result result_of(double tactile_weight) {
  auto result = output<hrt_calibration_result>();
  result.tactile_weight = known(tactile_weight, 0.02);
  result.max_gap_deg = known(10.0, 1.0);
  result.bias_deg = known(1.0, 0.5);
  result.tracker_noise_m = known(0.001, 0.0001);
  return result;
}

// The interval of a difference of equally known values is wider by the root of two.
TEST(CalibrationComparison, NamesWhatDiffers) {
  auto comparison = output<hrt_calibration_comparison>();
  const hrt_calibration_result first = result_of(0.2), second = result_of(0.25);
  ASSERT_OK(hrt_calibration_compare(&first, &second, &comparison));
  EXPECT_EQ(comparison.differing, HRT_DIFFERS_TACTILE_WEIGHT);
  EXPECT_EQ(comparison.tactile_weight.known, 1u);
  EXPECT_NEAR(comparison.tactile_weight.value, 0.05, 1e-12);
  EXPECT_NEAR(comparison.tactile_weight.lower, 0.05 - 0.01 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(comparison.tactile_weight.upper, 0.05 + 0.01 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(comparison.max_gap_deg.value, 0.0);
  EXPECT_EQ(comparison.habit_deg.known, 0u) << "known to neither";
  ASSERT_OK(hrt_calibration_compare(&first, &first, &comparison));
  EXPECT_EQ(comparison.differing, 0u);
}

TEST(CalibrationComparison, BadResultsAreRefusedByField) {
  auto comparison = output<hrt_calibration_comparison>();
  comparison.differing = 77;
  const hrt_calibration_result good = result_of(0.2);
  hrt_calibration_result bad = good;
  bad.bias_deg = {2.0, 0.0, 1.0, 1, 0};
  expect_error(hrt_calibration_compare(&good, &bad, &comparison), HRT_ERROR_OUT_OF_RANGE, "bias_deg is 2");
  bad.bias_deg = {0.0, -std::numeric_limits<double>::infinity(), 1.0, 1, 0};
  expect_error(hrt_calibration_compare(&bad, &good, &comparison), HRT_ERROR_OUT_OF_RANGE, "bias_deg is -Inf");
  bad.bias_deg = {std::nan(""), 0.0, 1.0, 1, 0};
  expect_error(hrt_calibration_compare(&bad, &good, &comparison), HRT_ERROR_OUT_OF_RANGE, "bias_deg is NaN");
  bad.bias_deg.known = 2;
  expect_error(hrt_calibration_compare(&bad, &good, &comparison), HRT_ERROR_OUT_OF_RANGE,
               "bias_deg.known is 2");
  EXPECT_EQ(comparison.differing, 77u);
}

}  // namespace
}  // namespace hrt::test
