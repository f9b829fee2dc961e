// Set-ups through the C interface, with a simulated person who makes mistakes.
#include <functional>

#include "tests/plugin/guided_person.h"
#include "tests/plugin/recording/recording_fixture.h"

namespace hrt::test {
namespace {

constexpr std::uint32_t everything = HRT_SETUP_FINGERTIP | HRT_SETUP_REGISTRATION | HRT_SETUP_CALIBRATION;

class SetupTest : public RecordingTest {
 protected:
  void SetUp() override {
    RecordingTest::SetUp();
    create(session_config());
  }

  hrt_setup_step update(GuidedPerson& person, const hrt_setup_step& step) {
    const hrt_sample sample = person.follow(step);
    auto next = output<hrt_setup_step>();
    EXPECT_OK(hrt_setup_update(session, &sample, &next));
    problems |= 1u << next.problem;
    return next;
  }

  hrt_setup_result run(
      GuidedPerson& person, const std::function<bool(const hrt_setup_step&)>& watch = [](const auto&) { return true; },
      const std::function<void(hrt_sample&)>& mistake = [](auto&) {}) {
    const auto note = [&](const hrt_setup_step& step) {
      problems |= 1u << step.problem;
      return watch(step);
    };
    return run_setup(session, &person, note, mistake);
  }

  void begin_setup(std::uint32_t what, const hrt_setup_config* config = nullptr) {
    ASSERT_OK(hrt_setup_begin(session, what, config));
  }

  std::uint32_t problems = 0;  // bit n is set if a step had HRT_PROBLEM_* n
};

double turn_error_deg(const hrt_session_config& config, const GuidedPerson& person) {
  const double(&q)[4] = config.plate.rotation;
  const Eigen::Matrix3d found = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
  const Eigen::Vector3d ahead = found.transpose() * (person.rotation * Eigen::Vector3d(0.0, 0.0, -1.0));
  return atan2_deg(-ahead.x(), -ahead.z());
}

TEST_F(SetupTest, AllMissingMeasuresEveryPart) {
  int fingertips = 0, turns = 0, weights = 0, biases = 0;
  double squares = 0.0;
  constexpr int people = 20;
  for (std::uint32_t i = 0; i < people; ++i) {
    create(session_config());
    GuidedPerson person(i);
    const hrt_setup_result result = set_up(session, HRT_SETUP_ALL_MISSING, &person);
    const hrt_session_config config = config_of(session);
    EXPECT_EQ(result.done & ~std::uint32_t{HRT_SETUP_CALIBRATION}, everything & ~std::uint32_t{HRT_SETUP_CALIBRATION})
        << i;
    const Eigen::Vector3d tip_m(config.fingertip_offset_m[0], config.fingertip_offset_m[1],
                                config.fingertip_offset_m[2]);
    fingertips += (tip_m - person.offset_m).norm() < 3.0 * result.fingertip_sd_m;
    const double turn_deg = turn_error_deg(config, person);
    turns += std::abs(turn_deg) < 2.0 * result.registration_turn_sd_deg;
    squares += std::pow(turn_deg / result.registration_turn_sd_deg, 2);
    // The family's illusion is linear. An error of the frame's rotation adds to the bias.
    const hrt_interval& weight = result.tactile_weight;
    const double true_weight = person.condition.person.illusion.tactile_weight;
    weights += weight.known && weight.lower <= true_weight && true_weight <= weight.upper;
    const double bias_deg = person.condition.person.bias_deg + turn_deg;
    biases += result.bias_deg.known && result.bias_deg.lower <= bias_deg && bias_deg <= result.bias_deg.upper;
    if (weight.known) {
      EXPECT_NEAR(config.person.tactile_weight, weight.value, 1e-12);
      EXPECT_NE(config.person.covariance[0], 0.0);
    }
    EXPECT_NE(config.flags & HRT_SESSION_REGISTERED, 0u);
  }
  EXPECT_GE(fingertips, 18);
  EXPECT_GE(turns, 17);
  EXPECT_LT(squares / people, 2.0);
  EXPECT_GE(weights, 17);
  EXPECT_GE(biases, 16);
}

class SetupFrameRate : public SetupTest, public testing::WithParamInterface<int> {};

TEST_P(SetupFrameRate, AllMissingMeasuresEveryPart) {
  GuidedPerson person(3);
  person.frame_ms = GetParam();
  person.noise_m = 0.0012;
  const hrt_setup_result result = set_up(session, HRT_SETUP_ALL_MISSING, &person);
  EXPECT_EQ(result.done, everything) << "dropped " << result.dropped;
}
INSTANTIATE_TEST_SUITE_P(Milliseconds, SetupFrameRate, testing::Values(4, 11, 17, 33));

TEST_F(SetupTest, AllMissingSkipsKnownPartsAndPartsWithoutData) {
  GuidedPerson person = quiet_person(true);
  hrt_session_config config = session_config();
  know_person(&config, {0.2, 0.0, 9.0});
  create(config);
  begin_setup(HRT_SETUP_ALL_MISSING);
  std::uint32_t state = 0;
  ASSERT_OK(hrt_session_get(session, nullptr, &state));
  EXPECT_EQ(state, HRT_STATE_SETTING_UP);
  const hrt_setup_result result = run(person);
  EXPECT_EQ(result.done, 0u);
  EXPECT_EQ(result.slides, 0u);
  ASSERT_OK(hrt_session_get(session, nullptr, &state));
  EXPECT_EQ(state, 0u);
}

TEST_F(SetupTest, WrongSlidesAreReportedAndRepeated) {
  GuidedPerson person = quiet_person(true);
  begin_setup(HRT_SETUP_CALIBRATION);
  int frames = 0;
  std::uint32_t lifted_at = 0;
  run(person, [&](const hrt_setup_step& step) {
    frames = step.instruction == HRT_STEP_SLIDE ? frames + 1 : 0;
    if (frames == 90 && step.done == 2 && lifted_at == 0) {  // after 1 s, in the middle of the slide
      person.lift(300);
      lifted_at = step.done;
    }
    if (step.done == 4) person.condition.person.duration_s = 0.2;
    if (problems & (1u << HRT_PROBLEM_TOO_FAST)) person.condition.person.duration_s = 1.5;
    return step.done < 6;
  });
  EXPECT_EQ(problems, 1u << HRT_PROBLEM_NONE | 1u << HRT_PROBLEM_LEFT_PLATE | 1u << HRT_PROBLEM_TOO_FAST);
  EXPECT_OK(hrt_setup_cancel(session));
  EXPECT_EQ(hrt_setup_cancel(session), HRT_ERROR_WRONG_STATE);
}

// The person touches the marks, at first with left and right confused.
TEST_F(SetupTest, ConfusedMarksAreReportedAndTouchedAgain) {
  GuidedPerson person = quiet_person();
  begin_setup(HRT_SETUP_REGISTRATION);
  auto step = output<hrt_setup_step>();
  auto result = output<hrt_setup_result>();
  result.left = 1;
  for (int frame = 0; result.left != 0 && frame < 10'000; ++frame) {
    hrt_setup_step misheard = step;
    if ((problems & (1u << HRT_PROBLEM_UPSIDE_DOWN | 1u << HRT_PROBLEM_DISAGREES)) == 0) misheard.place_m[0] *= -1.0;
    step = update(person, misheard);
    if (step.instruction == HRT_STEP_FINISH) {
      ASSERT_OK(hrt_setup_finish(session, &result));
    }
  }
  EXPECT_EQ(problems, 1u << HRT_PROBLEM_NONE | 1u << HRT_PROBLEM_UPSIDE_DOWN);
  EXPECT_EQ(result.done, HRT_SETUP_REGISTRATION);
  EXPECT_NEAR(turn_error_deg(config_of(session), person), 0.0, 0.01);

  // The plate has not moved in the first check, and has moved before the second.
  EXPECT_EQ(set_up(session, HRT_SETUP_CHECK, &person).done, HRT_SETUP_CHECK);
  problems = 0;
  person.position_m.x() += 0.03;
  add(HRT_TARGET_REAL, 0.0);
  begin_setup(HRT_SETUP_CHECK | HRT_SETUP_GUIDES);
  result = run(person);
  EXPECT_EQ(result.done, 0u);
  EXPECT_EQ(result.left, 0u) << "no guides on a plate that has moved";
  EXPECT_NEAR(result.check_distance_m, 0.03, 0.002);
  EXPECT_NE(problems & 1u << HRT_PROBLEM_DISAGREES, 0u) << "a second touch decides";
  EXPECT_EQ(result.dropped, HRT_SETUP_CHECK | HRT_SETUP_GUIDES);
  EXPECT_NE(std::string(result.reason).find("Please register it again."), std::string::npos) << result.reason;
  EXPECT_EQ(config_of(session).flags & HRT_SESSION_REGISTERED, 0u);
  expect_error(hrt_setup_begin(session, HRT_SETUP_CHECK, nullptr), HRT_ERROR_WRONG_STATE, "HRT_SETUP_REGISTRATION");
}

// A mistake of the host (axes, units, clock), or a fault of tracker or plate.
struct Mistake {
  const char* name;
  std::uint32_t part;
  void (*make)(hrt_sample&);
  std::uint32_t observed;  // HRT_OBSERVED_* of the steps
  std::uint32_t dropped;   // parts that the result drops; 0: the set-up waits for the user
  const char* reason;      // part of the result's reason or, if nothing is dropped, of the last step's text
};

class SetupMistake : public SetupTest, public ::testing::WithParamInterface<Mistake> {};

TEST_P(SetupMistake, IsReportedAndTheSetupEnds) {
  const Mistake& mistake = GetParam();
  GuidedPerson person = quiet_person(mistake.part == HRT_SETUP_CALIBRATION);
  begin_setup(mistake.part);
  auto last = output<hrt_setup_step>();
  std::uint32_t observed = 0;
  int frames = 0;
  const auto watch = [&](const hrt_setup_step& step) {
    last = step;
    if (step.observed != HRT_OBSERVED_NONE) observed |= 1u << step.observed;
    return ++frames < 12'000;
  };
  const hrt_setup_result result = run(person, watch, mistake.make);
  EXPECT_EQ(observed != 0, mistake.observed != 0) << last.text;
  EXPECT_EQ(observed & 1u << mistake.observed, mistake.observed ? 1u << mistake.observed : 0u) << last.text;
  EXPECT_EQ(result.left == 0, mistake.dropped != 0) << "the set-up waits for the user";
  EXPECT_EQ(result.dropped, mistake.dropped);
  EXPECT_EQ(result.done, 0u);
  EXPECT_NE(std::string(mistake.dropped ? result.reason : last.text).find(mistake.reason), std::string::npos)
      << result.reason << "; " << last.text;
}

INSTANTIATE_TEST_SUITE_P(
    All, SetupMistake,
    ::testing::Values(
        Mistake{"centimetres", HRT_SETUP_REGISTRATION,
                [](hrt_sample& s) {
                  for (double& x : s.finger_position_m) x *= 100.0;
                },
                0, HRT_SETUP_REGISTRATION, "metres"},
        Mistake{"left_handed", HRT_SETUP_REGISTRATION, [](hrt_sample& s) { s.finger_position_m[2] *= -1.0; }, 0,
                HRT_SETUP_REGISTRATION, "an axis is mirrored"},
        Mistake{"microseconds", HRT_SETUP_REGISTRATION, [](hrt_sample& s) { s.time_ns /= 1000; }, HRT_OBSERVED_TIME, 0,
                "time_ns"},
        Mistake{"no_finger", HRT_SETUP_REGISTRATION, [](hrt_sample& s) { s.flags &= HRT_SAMPLE_PLATE_ORIENTATION; },
                HRT_OBSERVED_NO_FINGER, 0, "tracker"},
        Mistake{"stuck_plate", HRT_SETUP_CALIBRATION, [](hrt_sample& s) { s.plate_orientation_deg = 0.0; },
                HRT_OBSERVED_PLATE, HRT_SETUP_CALIBRATION, "The plate reports 0 degrees, but"},
        Mistake{"far_away", HRT_SETUP_CALIBRATION, [](hrt_sample& s) { s.finger_position_m[0] += 5.2; },
                HRT_OBSERVED_FAR, 0, "The finger is 5.2 m from the requested position"},
        Mistake{"backwards", HRT_SETUP_CALIBRATION,
                [](hrt_sample& s) {
                  s.finger_position_m[0] *= -1.0;
                  s.finger_position_m[2] = 0.1 - s.finger_position_m[2];
                },
                HRT_OBSERVED_WRONG_WAY, HRT_SETUP_CALIBRATION, "check for swapped or mirrored axes"}),
    [](const auto& param) { return std::string(param.param.name); });

TEST_F(SetupTest, ASimulatedPersonFollowsEveryPart) {
  hrt_person person{};
  ASSERT_OK(hrt_person_create(nullptr, 1, &person));
  expect_error(hrt_person_begin(person, session, {0}), HRT_ERROR_WRONG_STATE, "no set-up");
  add(HRT_TARGET_REAL, -10.0);
  add(HRT_TARGET_REAL, 15.0);
  std::int64_t time_ns = 0;
  for (const std::uint32_t what :
       {HRT_SETUP_ALL_MISSING, HRT_SETUP_CHECK | HRT_SETUP_GUIDES, HRT_SETUP_RETEST | HRT_SETUP_CHECK}) {
    begin_setup(what);
    ASSERT_OK(hrt_person_begin(person, session, {0}));
    auto step = output<hrt_setup_step>();
    auto result = output<hrt_setup_result>();
    result.left = what;
    for (int frame = 0; frame < 30'000 && result.left != 0; ++frame) {
      auto sample = output<hrt_sample>();
      ASSERT_OK(hrt_person_move(person, time_ns += 11'111'111, step.plate_orientation_deg, &sample));
      ASSERT_OK(hrt_setup_update(session, &sample, &step));
      if (step.instruction == HRT_STEP_FINISH) {
        ASSERT_OK(hrt_setup_finish(session, &result));
      }
    }
    EXPECT_EQ(result.left, 0u) << step.text;
    EXPECT_EQ(result.done, what == HRT_SETUP_ALL_MISSING ? everything : what) << result.reason;
    EXPECT_EQ(result.dropped, 0u) << result.reason;
  }
  const hrt_session_config config = config_of(session);
  EXPECT_NEAR(config.plate.position_m[0], 0.3, 0.003);
  EXPECT_NEAR(config.fingertip_offset_m[2], -0.012, 0.003);
  auto sample = output<hrt_sample>();
  ASSERT_OK(hrt_session_destroy(session));
  expect_error(hrt_person_move(person, time_ns, 0.0, &sample), HRT_ERROR_INVALID_HANDLE, "session");
  ASSERT_OK(hrt_person_destroy(person));
  session = {};
}

TEST_F(SetupTest, LostFingerRestartsTheTouch) {
  GuidedPerson person = quiet_person();
  begin_setup(HRT_SETUP_REGISTRATION);
  auto step = output<hrt_setup_step>();
  while (step.instruction != HRT_STEP_HOLD_STILL) step = update(person, step);
  auto lost = output<hrt_sample>();
  lost.time_ns = person.time_ns();
  ASSERT_OK(hrt_setup_update(session, &lost, &step));
  EXPECT_EQ(step.problem, HRT_PROBLEM_LOST);
  EXPECT_EQ(step.done, 0u);
  while (step.done == 0) step = update(person, step);
  EXPECT_EQ(step.problem, HRT_PROBLEM_NONE);
}

TEST_F(SetupTest, CanBeCancelledAtEachStep) {
  std::uint32_t seen = 0;
  for (const std::uint32_t part : {HRT_SETUP_REGISTRATION, HRT_SETUP_CALIBRATION}) {
    for (std::uint32_t instruction = 0; instruction <= HRT_STEP_FINISH; ++instruction) {
      create(session_config());
      GuidedPerson person = quiet_person(part == HRT_SETUP_CALIBRATION);
      begin_setup(part);
      int frames = 0;
      run(person, [&](const hrt_setup_step& step) {
        return step.instruction != instruction && ++frames < 3000 && step.instruction != HRT_STEP_FINISH;
      });
      seen |= frames < 3000 ? 1u << instruction : 0;
      auto command = output<hrt_command>();
      const hrt_sample sample = position_sample(person.time_ns(), 0.0, 0.0);
      const hrt_session_config config = session_config();
      EXPECT_EQ(hrt_session_set(session, &config), HRT_ERROR_WRONG_STATE);
      EXPECT_EQ(hrt_reach_update(session, &sample, &command), HRT_ERROR_WRONG_STATE);
      ASSERT_OK(hrt_setup_cancel(session));
      EXPECT_OK(hrt_session_set(session, &config));
    }
  }
  EXPECT_EQ(seen, (2u << HRT_STEP_FINISH) - 1);
}

TEST_F(SetupTest, RetestReportsDifferencesForAnotherPerson) {
  GuidedPerson person = quiet_person(true);
  person.noise_m = 0.0003;
  EXPECT_EQ(set_up(session, HRT_SETUP_CALIBRATION, &person).done, HRT_SETUP_CALIBRATION);
  EXPECT_EQ(set_up(session, HRT_SETUP_RETEST, &person).differing, 0u);
  person.condition.person.illusion.tactile_weight = 0.28;
  const hrt_setup_result result = set_up(session, HRT_SETUP_RETEST, &person);
  EXPECT_NE(result.differing & HRT_RETEST_TACTILE_WEIGHT, 0u);
  EXPECT_NEAR(config_of(session).person.tactile_weight, 0.28, 0.02);
}

TEST_F(SetupTest, CalibrationReplacesTheEstimatesOfReaches) {
  hrt_session_config before = session_config();
  before.person.motion_bound_deg = 30.0;
  know_person(&before, {0.5, 0.0, 9.0});
  create(before);
  auto residual = output<hrt_setup_residual>();
  expect_error(hrt_setup_get_residual(session, 0, &residual), HRT_ERROR_WRONG_STATE, "HRT_SETUP_CALIBRATION");
  GuidedPerson person = quiet_person(true);
  person.noise_m = 0.001;
  person.condition.person.bias_deg = 3.0;
  const hrt_setup_result result = set_up(session, HRT_SETUP_CALIBRATION, &person);
  ASSERT_EQ(result.done, HRT_SETUP_CALIBRATION);
  const hrt_session_config config = config_of(session);
  const double weight = person.condition.person.illusion.tactile_weight;
  EXPECT_NEAR(result.tactile_weight.value, weight, 0.02);
  EXPECT_EQ(config.person.tactile_weight, result.tactile_weight.value);
  const double sd = (result.tactile_weight.upper - result.tactile_weight.lower) / 3.92;
  EXPECT_NEAR(config.person.tactile_weight_sd, std::max(sd, 0.01), 1e-5) << "at least 0.01, because people change";
  EXPECT_NEAR(config.person.mean[HRT_PERSON_WEIGHT], weight, 0.05);
  EXPECT_NEAR(config.person.mean[HRT_PERSON_BIAS], 3.0, 1.0);
  EXPECT_EQ(config.person.mean[HRT_PERSON_BIAS], result.bias_deg.value);
  EXPECT_EQ(config.person.bias_deg, result.bias_deg.value);
  EXPECT_NE(config.person.covariance[0], 0.01);
  EXPECT_NE(config.person.covariance[1], 0.0) << "covariance of weight and curve";
  EXPECT_NEAR(config.tracker.noise_m, 0.001, 0.0002);
  EXPECT_GT(config.person.motion_bound_deg, 40.0);

  double worst_deg = 0.0;
  for (std::uint32_t i = 0; i < result.slides; ++i) {
    ASSERT_OK(hrt_setup_get_residual(session, i, &residual));
    EXPECT_EQ(residual.residual_deg, residual.direction_deg - residual.fitted_deg);
    EXPECT_NEAR(residual.direction_deg, (3.0 - weight * residual.plate_deg) / (1.0 - weight), 12.0);
    if (residual.verdict == HRT_SLIDE_USED) worst_deg = std::max(worst_deg, std::abs(residual.residual_deg));
  }
  EXPECT_GT(worst_deg, 0.0);
  EXPECT_LT(worst_deg, 5.0);
  expect_error(hrt_setup_get_residual(session, result.slides, &residual), HRT_ERROR_OUT_OF_RANGE, "slide is");
}

// The weight changes from 0.1 to 0.35 after eight slides, which the model cannot fit.
TEST_F(SetupTest, LackOfFitLeavesThePersonUnchanged) {
  GuidedPerson person = quiet_person(true);
  hrt_setup_config setup = hrt_setup_config_init();
  setup.max_slides = 16;
  begin_setup(HRT_SETUP_CALIBRATION, &setup);
  const hrt_setup_result result = run(person, [&](const hrt_setup_step& step) {
    person.condition.person.illusion.tactile_weight = step.done < 8 ? 0.1 : 0.35;
    return true;
  });
  EXPECT_EQ(result.done, 0u);
  EXPECT_EQ(result.tactile_weight.known, 0u);
  EXPECT_NE(result.lack_of_fit & HRT_LACK_OF_FIT_ORDER, 0u);
  const hrt_session_config config = config_of(session);
  EXPECT_EQ(config.person.tactile_weight, session_config().person.tactile_weight);
  EXPECT_EQ(config.person.bias_deg, 0.0);
  EXPECT_EQ(config.person.covariance[0], 0.0);
}

TEST_F(SetupTest, FitScaleEstimatesTheTrackersUnit) {
  GuidedPerson person = quiet_person();
  person.scale = 1.04;
  hrt_setup_config setup = hrt_setup_config_init();
  setup.fit_scale = 1;
  const hrt_setup_result result = set_up(session, HRT_SETUP_REGISTRATION, &person, setup);
  const hrt_session_config config = config_of(session);
  EXPECT_NEAR(config.plate.scale, 1.04, 1e-3);
  EXPECT_NEAR(deg_per_rad * std::sqrt(config.plate.covariance[0]), result.registration_turn_sd_deg,
              0.02 * result.registration_turn_sd_deg);
  EXPECT_GT(config.plate.covariance[2], 0.0);
  EXPECT_GT(config.registration.time_ns, 0);
}

TEST_F(SetupTest, SetupReplaysBitForBit) {
  GuidedPerson person(3);
  ASSERT_OK(hrt_recording_start(session, path().c_str()));
  begin_setup(HRT_SETUP_ALL_MISSING);
  auto early = output<hrt_setup_result>();
  EXPECT_EQ(hrt_setup_finish(session, &early), HRT_ERROR_WRONG_STATE);
  run(person);
  begin_setup(HRT_SETUP_CHECK);
  ASSERT_OK(hrt_setup_cancel(session));
  stop();
  const std::string text = read(path());
  const hrt_replay_report report = replay(text);
  expect_same(report);
  EXPECT_GT(report.rows, 5000u);
  // A changed number in a result of the set-up is detected.
  std::string altered = text;
  altered.replace(altered.find("weight=0"), 8, "weight=1");
  EXPECT_NE(replay(altered).first_different_line, 0u);
}

TEST_F(SetupTest, InvalidConfigurationsAreRejectedNamingTheField) {
  const auto refuse = [&](std::uint32_t what, void (*spoil)(hrt_setup_config&), const char* name) {
    hrt_setup_config config = hrt_setup_config_init();
    spoil(config);
    expect_error(hrt_setup_begin(session, what, &config), HRT_ERROR_OUT_OF_RANGE, name);
  };
  refuse(HRT_SETUP_REGISTRATION, [](auto& c) { c.mark_count = 3; }, "marks_m");  // all marks are at one point
  refuse(HRT_SETUP_REGISTRATION, [](auto& c) { c.mark_count = 3, c.check_mark = 3; }, "check_mark is 3");
  refuse(HRT_SETUP_CALIBRATION, [](auto& c) { c.upper_plate_deg = -40.0; }, "upper_plate_deg is -40");
  refuse(HRT_SETUP_CALIBRATION | HRT_SETUP_RETEST, [](auto&) {}, "what is 48");
  refuse(HRT_SETUP_ALL_MISSING | HRT_SETUP_GUIDES, [](auto&) {}, "what is 72");
  refuse(0, [](auto&) {}, "what is 0");

  const hrt_sample sample = position_sample(5, 0.0, 0.0), earlier = position_sample(4, 0.0, 0.0);
  auto step = output<hrt_setup_step>();
  EXPECT_EQ(hrt_setup_update(session, &sample, &step), HRT_ERROR_WRONG_STATE);
  begin_setup(HRT_SETUP_REGISTRATION);
  expect_error(hrt_setup_update(session, &sample, &step), HRT_ERROR_OUT_OF_RANGE, "WORLD_POSITION");
  ASSERT_OK(hrt_setup_cancel(session));
  begin_setup(HRT_SETUP_CALIBRATION);
  ASSERT_OK(hrt_setup_update(session, &sample, &step));
  EXPECT_EQ(hrt_setup_update(session, &earlier, &step), HRT_ERROR_TIME_REVERSED);
  const hrt_sample direction = direction_sample(5, 0.0);
  expect_error(hrt_setup_update(session, &direction, &step), HRT_ERROR_OUT_OF_RANGE, "flags is 1");
  hrt_sample joint = sample;
  joint.flags |= HRT_SAMPLE_JOINT_ROTATION;
  expect_error(hrt_setup_update(session, &joint, &step), HRT_ERROR_OUT_OF_RANGE, "JOINT_ROTATION");
  joint.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_JOINT_ROTATION;
  expect_error(hrt_setup_update(session, &joint, &step), HRT_ERROR_OUT_OF_RANGE, "joint_rotation is");
  expect_error(hrt_setup_begin(session, HRT_SETUP_CALIBRATION, nullptr), HRT_ERROR_WRONG_STATE, "set-up");
  ASSERT_OK(hrt_setup_cancel(session));
  create(session_config(), [](auto& c) { c.start_position_m[2] = -0.05; });
  expect_error(hrt_setup_begin(session, HRT_SETUP_CALIBRATION, nullptr), HRT_ERROR_OUT_OF_RANGE, "start_position_m");
}

}  // namespace
}  // namespace hrt::test
