// Effects of the plate's registration on gaps and commands: uncertainty and age.
#include <cmath>

#include "fixture.h"

namespace hrt::test {
namespace {

class RegistrationTest : public SessionTest {};

// The target is 10 cm ahead of the start and 5 cm ahead of the plate's centre. A rotation of 2 degrees about the centre
// changes its bearing by 1 degree. With an SD of 1 degree, 13.4 % of reaches end more than 1.5 degrees off.
TEST_F(RegistrationTest, GapHasTheBearingSdOfRegistrationAndTracker) {
  const hrt_target real = add(HRT_TARGET_REAL, 0.0), felt = add(HRT_TARGET_VIRTUAL, 5.0);
  const auto gap_with = [&](double turn_deg, double shift_m, double tracker_deg = 0.0) {
    hrt_session_config config = session_config();
    config.tracker.bearing_sd_deg = tracker_deg;
    config.plate.covariance[0] = std::pow(turn_deg * rad_per_deg, 2);
    config.plate.covariance[2] = shift_m * shift_m;
    EXPECT_OK(hrt_session_set(session, &config));
    return gap_of(real, felt);
  };
  EXPECT_EQ(gap_with(0.0, 0.0).bearing_sd_deg, 0.0);
  EXPECT_EQ(gap_with(0.0, 0.0).miss_share, 0.0);
  EXPECT_NEAR(gap_with(2.0, 0.0).bearing_sd_deg, 1.0, 1e-9);
  EXPECT_NEAR(gap_with(2.0, 0.0).miss_share, 0.133614, 1e-6);
  EXPECT_NEAR(gap_with(0.0, 0.002).bearing_sd_deg, 0.002 / 0.1 * deg_per_rad, 1e-9);
  EXPECT_NEAR(gap_with(0.0, 0.0, 2.9).miss_share, 0.604988, 1e-6);  // 40 % end within 1.5 degrees
  EXPECT_NEAR(gap_with(6.0, 0.0, 4.0).bearing_sd_deg, 5.0, 1e-9);
}

// Reaches from the centre of the plate.
class RegisteredReachTest : public SessionTest {
 protected:
  hrt_command command_at(std::int64_t time_ns, const hrt_session_config& config) {
    create(config);
    begin_reach();
    return update(position_sample(time_ns, 0.0, 0.0));
  }

  static hrt_session_config turned_by(double sd_deg) {
    hrt_session_config config = session_config();
    config.start_position_m[2] = 0.0;
    config.plate.covariance[0] = std::pow(sd_deg * rad_per_deg, 2);
    config.flags = HRT_SESSION_REGISTERED;
    config.registration.time_ns = 1000;
    return config;
  }

  /// Creates a session with an SD of the plate's position of 1 mm to the side, and with an allowed SD of 1 degree.
  void create_shifted_by_1_mm() {
    hrt_session_config config = turned_by(0.0);
    config.plate.covariance[2] = 1e-6;
    config.registration.max_sd_deg = 1.0;
    create(config);
  }
};

TEST_F(RegisteredReachTest, RotationSdOfOneDegreeIsPartOfTheMissSd) {
  hrt_command command = command_at(0, turned_by(1.0));
  EXPECT_EQ(command.flags & HRT_COMMAND_MISS_UNKNOWN, HRT_COMMAND_MISS_UNKNOWN) << "before the finger moves";
  EXPECT_EQ(command.miss_sd_deg, 180.0);
  for (int i = 1; i <= 80; ++i) command = update(position_sample(i * 11'000'000, 0.0, 0.00125 * i));
  EXPECT_EQ(command.flags & HRT_COMMAND_MISS_UNKNOWN, 0u);
  EXPECT_GT(command.miss_sd_deg, 1.0);
  EXPECT_NEAR(command.miss_sd_deg, 1.0, 0.3) << "with the noise of a tracker that is not known";
  EXPECT_EQ(end().miss_sd_deg, command.miss_sd_deg);
  hrt_session_config paper = turned_by(1.0);
  paper.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  command = command_at(0, paper);
  EXPECT_EQ(command.flags & HRT_COMMAND_MISS_UNKNOWN, HRT_COMMAND_MISS_UNKNOWN);
  EXPECT_EQ(command.miss_sd_deg, 180.0);
}

TEST_F(RegisteredReachTest, OldRegistrationIsFlagged) {
  hrt_session_config config = turned_by(0.0);
  const auto flagged = [&](std::int64_t time_ns) {
    return (command_at(time_ns, config).flags & HRT_COMMAND_REGISTRATION) != 0;
  };
  EXPECT_FALSE(flagged(INT64_MAX)) << "max_age_ns is 0, which means any age";
  config.registration.max_age_ns = 500;
  EXPECT_FALSE(flagged(1500));
  EXPECT_EQ(end().flags & HRT_COMMAND_REGISTRATION, 0u);
  EXPECT_TRUE(flagged(1501));
  EXPECT_EQ(end().flags & HRT_COMMAND_REGISTRATION, HRT_COMMAND_REGISTRATION);
  EXPECT_FALSE(flagged(0));
  EXPECT_FALSE(flagged(INT64_MIN));
  config.registration.time_ns = INT64_MIN;
  EXPECT_TRUE(flagged(INT64_MAX));
  config.registration.max_age_ns = INT64_MAX;
  EXPECT_TRUE(flagged(INT64_MAX));
  EXPECT_FALSE(flagged(-2));
  config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  EXPECT_TRUE(flagged(INT64_MAX));
}

TEST_F(RegisteredReachTest, InaccurateOrMissingRegistrationIsFlagged) {
  hrt_session_config config = turned_by(1.0);
  const auto flagged = [&] { return (command_at(1000, config).flags & HRT_COMMAND_REGISTRATION) != 0; };
  config.registration.max_sd_deg = 1.01;
  EXPECT_FALSE(flagged());
  config.registration.max_sd_deg = 0.99;
  EXPECT_TRUE(flagged());
  config.registration.max_sd_deg = 1.01;
  config.flags = 0;
  EXPECT_TRUE(flagged());
  config.registration.max_sd_deg = 0.0;
  EXPECT_FALSE(flagged());
  config.registration.max_age_ns = INT64_MAX;
  EXPECT_TRUE(flagged());
}

TEST_F(RegisteredReachTest, PoorRegistrationIsLoggedOncePerConfiguration) {
  for (const bool by_profile : {false, true}) {
    const Log log;
    hrt_session_config config = turned_by(1.0);
    config.registration.max_sd_deg = 0.5;
    create(config);
    begin_reach();
    update(position_sample(0, 0.0, 0.0));
    end();
    EXPECT_EQ(log.text, "");
    config.registration.max_sd_deg = 2.0;
    ASSERT_OK(by_profile ? load_profile(save_profile()) : hrt_session_set(session, &config));
    destroy();
    EXPECT_TRUE(log.text.starts_with(std::to_string(HRT_LOG_WARNING) + " ")) << log.text;
    EXPECT_NE(log.text.find("registration of the plate"), std::string::npos);
    EXPECT_EQ(std::count(log.text.begin(), log.text.end(), '\n'), 1);
  }
}

// 1 mm to the side is 0.6 degrees at a distance of 100 mm, and 1.9 degrees at 30 mm.
TEST_F(RegisteredReachTest, RetargetChecksTheRegistrationAgain) {
  create_shifted_by_1_mm();
  const hrt_target real = add(placed(HRT_TARGET_REAL, 0.0, 0.1)), seen = add(placed(HRT_TARGET_VIRTUAL, 0.0, 0.1));
  ASSERT_OK(begin(real, seen));
  EXPECT_EQ(update(position_sample(0, 0.0, 0.0)).flags & HRT_COMMAND_REGISTRATION, 0u);
  ASSERT_OK(hrt_reach_retarget(session, add(placed(HRT_TARGET_REAL, 0.0, 0.03)), seen));
  EXPECT_NE(update(position_sample(10'000'000, 0.0, 0.0)).flags & HRT_COMMAND_REGISTRATION, 0u);
  ASSERT_OK(hrt_reach_retarget(session, real, seen));
  EXPECT_EQ(update(position_sample(20'000'000, 0.0, 0.0)).flags & HRT_COMMAND_REGISTRATION, 0u);
}

// From a start that is nearer to the target than the configured one, the same error is a larger angle.
TEST_F(RegisteredReachTest, StartAtFingerChecksTheRegistrationFromThere) {
  create_shifted_by_1_mm();
  ASSERT_OK(begin(add(placed(HRT_TARGET_REAL, 0.0, 0.07)), add(HRT_TARGET_VIRTUAL, 5.0), HRT_REACH_START_AT_FINGER));
  // 1 mm is 0.82 degrees from the configured start, and 1.15 degrees from 5 cm before the target.
  EXPECT_EQ(update(output<hrt_sample>()).flags & HRT_COMMAND_REGISTRATION, 0u);
  const hrt_command command = update(position_sample(10, 0.0, 0.02));
  EXPECT_EQ(command.flags & HRT_COMMAND_REGISTRATION, HRT_COMMAND_REGISTRATION);
}

}  // namespace
}  // namespace hrt::test
