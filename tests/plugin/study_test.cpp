// The simulated person of person.h: parameters follow from the seed, and the plate deflects the finger.
#include <cmath>
#include <numbers>

#include "fixture.h"

namespace hrt::test {
namespace {

constexpr int frames = 220;  // at 90 Hz: 0.6 s of rest, 1.5 s of motion, and a rest

class SimulatedPersonTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    real = add(HRT_TARGET_REAL, -5.0);
    seen = add(HRT_TARGET_VIRTUAL, 5.0);
  }

  void TearDown() override {
    for (const hrt_person person : people) EXPECT_OK(hrt_person_destroy(person));
    SessionTest::TearDown();
  }

  hrt_person person_of(std::uint64_t seed, const hrt_person_config* config = nullptr) {
    EXPECT_OK(hrt_person_create(config, seed, &people.emplace_back()));
    return people.back();
  }

  struct Slide {
    hrt_person_state end;
    std::vector<double> seen_right_m;
  };

  /// Runs one reach of the person. If `led` is false, the plate stays at 0.
  Slide slide(hrt_person person, bool led = true) {
    if (led) {
      EXPECT_OK(begin(real, seen));
    }
    EXPECT_OK(hrt_person_begin(person, session, seen));
    auto command = output<hrt_command>();
    Slide slide{.end = output<hrt_person_state>(), .seen_right_m = {}};
    for (int frame = 0; frame < frames; ++frame) {
      auto sample = output<hrt_sample>();
      EXPECT_OK(hrt_person_move(person, frame * 11'111'111LL, command.plate_orientation_deg, &sample));
      slide.seen_right_m.push_back(sample.finger_position_m[0]);
      if (led) {
        EXPECT_OK(hrt_reach_update(session, &sample, &command));
      }
    }
    EXPECT_OK(hrt_person_get_state(person, &slide.end));
    if (led) {
      EXPECT_OK(hrt_reach_cancel(session));
    }
    return slide;
  }

  // Returns the bearing from the start, which is 5 cm from the centre, towards the user.
  static double bearing_deg(const double (&position_m)[3]) {
    return std::atan2(-position_m[0], 0.05 - position_m[2]) * 180.0 / std::numbers::pi;
  }

  hrt_target real{}, seen{};
  std::vector<hrt_person> people;
};

TEST_F(SimulatedPersonTest, IsSteeredToTheRealTargetAndPerceivesTheVirtualOne) {
  int on_target = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const hrt_person person = person_of(seed);
    const Slide led = slide(person);
    EXPECT_EQ(led.end.done, 1u);
    on_target += std::abs(bearing_deg(led.end.position_m) + 5.0) < 1.5;
    EXPECT_NEAR(bearing_deg(led.end.felt_position_m), 5.0, 4.0) << seed;
  }
  EXPECT_GE(on_target, 33);  // if 92 % of people are on target, 99 % of such tests have at least 33 of 40
}

// The finger rests for 0.6 s, and moves for 1.5 s, by only 1 mm in the last tenth of this time. ARRIVED requires a rest
// of 0.4 s.
TEST_F(SimulatedPersonTest, ArrivesSoonAfterTheMotion) {
  for (const std::uint32_t guidance : {HRT_GUIDANCE_ARRIVAL, HRT_GUIDANCE_FIXED_DIRECTION}) {
    hrt_session_config config = session_config();
    config.guidance = guidance;
    ASSERT_OK(hrt_session_set(session, &config));
    const hrt_person person = person_of(1);
    ASSERT_OK(begin(real, seen));
    ASSERT_OK(hrt_person_begin(person, session, seen));
    auto command = output<hrt_command>();
    auto sample = output<hrt_sample>();
    int frame = 0;
    for (; frame < 400 && (command.flags & HRT_COMMAND_ARRIVED) == 0; ++frame) {
      ASSERT_OK(hrt_person_move(person, frame * 11'111'111LL, command.plate_orientation_deg, &sample));
      ASSERT_OK(hrt_reach_update(session, &sample, &command));
    }
    EXPECT_NEAR(frame / 90.0, 2.45, 0.25) << guidance;
    sample.time_ns += 11'111'111;
    sample.finger_position_m[2] += 0.05;
    ASSERT_OK(hrt_reach_update(session, &sample, &command));
    EXPECT_NE(command.flags & HRT_COMMAND_ARRIVED, 0u) << "ARRIVED remains set";
    ASSERT_OK(hrt_reach_retarget(session, real, seen));
    sample.finger_position_m[2] -= 0.05;
    ASSERT_OK(hrt_reach_update(session, &sample, &command));
    EXPECT_NE(command.flags & HRT_COMMAND_ARRIVED, 0u) << "a retarget to the same targets keeps ARRIVED";
    change(real, target_config(HRT_TARGET_REAL, 5.0));
    ASSERT_OK(hrt_reach_retarget(session, real, seen));
    ASSERT_OK(hrt_reach_update(session, &sample, &command));
    EXPECT_EQ(command.flags & HRT_COMMAND_ARRIVED, 0u);
    change(real, target_config(HRT_TARGET_REAL, -5.0));
    ASSERT_OK(hrt_reach_cancel(session));
  }
}

TEST_F(SimulatedPersonTest, ReachesTheVirtualTargetOverAFixedPlate) {
  const hrt_person person = person_of(3);
  EXPECT_NEAR(bearing_deg(slide(person, false).end.felt_position_m), 5.0, 1.5);
}

TEST_F(SimulatedPersonTest, MotionsFollowFromTheSeed) {
  const hrt_person one = person_of(7), same = person_of(7), other = person_of(8);
  const Slide first = slide(one, false);
  EXPECT_EQ(first.seen_right_m, slide(same, false).seen_right_m);
  EXPECT_NE(first.seen_right_m, slide(other, false).seen_right_m);
  EXPECT_NE(first.seen_right_m, slide(one, false).seen_right_m) << "the noise differs from reach to reach";
}

TEST_F(SimulatedPersonTest, HasTheConfiguredBiasAndDuration) {
  auto config = output<hrt_person_config>();
  config.bias_deg = 6.0;
  config.duration_s = 1.0;
  config.tracker_noise_m = 1e-9;
  const hrt_person person = person_of(3, &config);
  const Slide biased = slide(person, false);
  EXPECT_NEAR(biased.end.felt_error_deg, 6.0, 2.0);
  const double end_m = biased.end.position_m[0];
  EXPECT_NE(std::abs(biased.seen_right_m[100] - end_m), 0.0);
  EXPECT_NEAR(biased.seen_right_m[146], end_m, 1e-7);  // at 1.6 s
}

TEST_F(SimulatedPersonTest, PlateHasTheConfiguredLatencyAndSpeed) {
  auto config = output<hrt_person_config>();
  config.plate_max_speed_deg_s = 100.0;
  config.plate_latency_ns = 50'000'000;
  const hrt_person person = person_of(1, &config);
  ASSERT_OK(hrt_person_begin(person, session, seen));
  auto sample = output<hrt_sample>();
  ASSERT_OK(hrt_person_move(person, 1'000'000'000, 20.0, &sample));
  EXPECT_EQ(sample.plate_orientation_deg, 20.0);  // the plate starts at the first command
  ASSERT_OK(hrt_person_move(person, 1'050'000'000, 60.0, &sample));
  EXPECT_EQ(sample.plate_orientation_deg, 20.0);
  ASSERT_OK(hrt_person_move(person, 1'150'000'000, 60.0, &sample));
  EXPECT_NEAR(sample.plate_orientation_deg, 30.0, 1e-9);
  ASSERT_OK(hrt_person_move(person, 2'000'000'000, 10130.0, &sample));  // equivalent to 50 degrees
  ASSERT_OK(hrt_person_move(person, 3'000'000'000, 10130.0, &sample));
  EXPECT_NEAR(sample.plate_orientation_deg, 50.0, 1e-9);
}

TEST_F(SimulatedPersonTest, CallsOutOfOrderAreRejected) {
  const hrt_person person = person_of(1);
  auto sample = output<hrt_sample>();
  auto state = output<hrt_person_state>();
  expect_error(hrt_person_move(person, 0, 0.0, &sample), HRT_ERROR_WRONG_STATE);
  expect_error(hrt_person_get_state(person, &state), HRT_ERROR_WRONG_STATE);
  expect_error(hrt_person_begin(person, session, real), HRT_ERROR_OUT_OF_RANGE, "virtual_target");
  ASSERT_OK(hrt_person_begin(person, session, seen));
  ASSERT_OK(hrt_person_move(person, 100, 0.0, &sample));
  expect_error(hrt_person_move(person, 99, 0.0, &sample), HRT_ERROR_TIME_REVERSED, "99");
  expect_error(hrt_person_move(person, 100, std::nan(""), &sample), HRT_ERROR_OUT_OF_RANGE, "plate_orientation_deg");
}

}  // namespace
}  // namespace hrt::test
