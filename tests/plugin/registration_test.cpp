// Registration through the C ABI: touches in, the plate's pose out and into the session.
#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/plate/frame_error.h"
#include "core/simulation/random.h"
#include "fixture.h"

namespace hrt::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Centre, start, and four marks on the rim.
const std::vector<Vector3d> marks = {{0.0, 0.0, 0.0},   {0.0, 0.0, 0.05},   {0.075, 0.0, 0.0},
                                     {0.0, 0.0, 0.075}, {-0.075, 0.0, 0.0}, {0.0, 0.0, -0.075}};
const Vector3d place(0.3, 0.75, -2.4);

Eigen::Matrix3d turned(double about_y_deg) {
  return AngleAxisd(about_y_deg * 0.017453292519943295, Vector3d::UnitY()).toRotationMatrix();
}

hrt_mark_touch touch(const Vector3d& mark, const Vector3d& touched) {
  return {{mark.x(), mark.y(), mark.z()}, {touched.x(), touched.y(), touched.z()}};
}

// Of a plate at `place`, turned by 20 degrees, a world whose unit is `scale` of a metre.
std::vector<hrt_mark_touch> touches(double noise_m = 0.0, double scale = 1.0) {
  Draws draws(21, 0, 0, 0);
  std::vector<hrt_mark_touch> result;
  for (const Vector3d& mark : marks)
    result.push_back(touch(mark, scale * (turned(20.0) * mark) + place +
                                     noise_m * Vector3d(draws.normal(), draws.normal(), draws.normal())));
  return result;
}

hrt_registration fit(const std::vector<hrt_mark_touch>& given,
                     const hrt_registration_config* config = nullptr) {
  auto found = output<hrt_registration>();
  EXPECT_OK(hrt_registration_fit(config, given.data(), given.size(), 0, nullptr, &found));
  return found;
}

class RegistrationTest : public SessionTest {};

// Half of 20 degrees: sin 10 about y.
TEST(RegistrationFit, PoseByHand) {
  const hrt_registration found = fit(touches());
  EXPECT_EQ(found.verdict, HRT_REGISTRATION_HOLDS + 0u);
  EXPECT_EQ(found.touches, 6u);
  EXPECT_EQ(found.left_out, -1);
  const double position_m[] = {0.3, 0.75, -2.4};
  const double rotation[] = {0.0, 0.17364817766693033, 0.0, 0.98480775301220802};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found.plate_position_m[i], position_m[i], 1e-12);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(found.plate_rotation[i], rotation[i], 1e-12);
  EXPECT_EQ(found.plate_scale, 1.0);
  EXPECT_NEAR(found.residual_m, 0.0, 1e-12);
  // As core's own test derives it: of exact touches a third of the variance that is expected.
  const double spread_m2 = 4 * 0.075 * 0.075 + 0.05 * 0.05 - 6.0 * std::pow(0.05 / 6.0, 2);
  EXPECT_NEAR(found.turn_sd_deg, 57.29577951308232 * std::sqrt(0.003 * 0.003 * 6.0 / 18.0 / spread_m2), 1e-9);
}

TEST(RegistrationFit, ResidualsOfEachTouchAndTheOneLeftOut) {
  std::vector<hrt_mark_touch> given = touches(0.001);
  given[4].touched_m[0] += 0.05;
  double residuals_m[7] = {0, 0, 0, 0, 0, 0, 77.0};
  auto found = output<hrt_registration>();
  ASSERT_OK(hrt_registration_fit(nullptr, given.data(), 6, 7, residuals_m, &found));
  EXPECT_EQ(found.verdict, HRT_REGISTRATION_HOLDS + 0u);
  EXPECT_EQ(found.left_out, 4);
  double square_sum_m2 = 0.0;
  for (int i = 0; i < 6; ++i) {
    if (i == 4) continue;
    EXPECT_LT(residuals_m[i], 0.006) << i;
    square_sum_m2 += residuals_m[i] * residuals_m[i];
  }
  EXPECT_NEAR(residuals_m[4], 0.05, 0.01);
  EXPECT_NEAR(found.residual_m, std::sqrt(square_sum_m2 / 5.0), 1e-12);
  EXPECT_EQ(residuals_m[6], 77.0);
  expect_error(hrt_registration_fit(nullptr, given.data(), 6, 5, residuals_m, &found),
               HRT_ERROR_BUFFER_TOO_SMALL, "capacity is 5; there are 6 touches");
}

TEST(RegistrationFit, VerdictsAndWhatToDo) {
  std::vector<hrt_mark_touch> given = touches();
  EXPECT_EQ(fit({}).verdict, HRT_REGISTRATION_TOO_FEW + 0u);
  EXPECT_EQ(fit({given[0], given[1]}).verdict, HRT_REGISTRATION_TOO_FEW + 0u);
  EXPECT_EQ(fit({given[0], given[1], given[5]}).verdict, HRT_REGISTRATION_DEGENERATE + 0u);
  std::swap(given[2].touched_m, given[4].touched_m);
  EXPECT_EQ(fit(given).verdict, HRT_REGISTRATION_HOLDS + 0u);  // by a plate upside down
  hrt_registration_config config = hrt_registration_config_init();
  config.flags = HRT_REGISTER_UP;
  EXPECT_EQ(fit(given, &config).verdict, HRT_REGISTRATION_UPSIDE_DOWN + 0u);
  given[2].touched_m[1] += 0.1;
  given[3].touched_m[0] += 0.1;
  EXPECT_EQ(fit(given).verdict, HRT_REGISTRATION_INCONSISTENT + 0u);
  std::vector<std::string> texts;
  for (std::uint32_t verdict = HRT_REGISTRATION_HOLDS; verdict <= HRT_REGISTRATION_UPSIDE_DOWN; ++verdict) {
    texts.emplace_back(hrt_registration_advice(verdict));
    EXPECT_GT(texts.back().size(), 40u);
  }
  EXPECT_EQ(std::string(hrt_registration_advice(0)), "unknown verdict");
  EXPECT_EQ(std::string(hrt_registration_advice(6)), "unknown verdict");
}

TEST(RegistrationFit, RefusesByName) {
  std::vector<hrt_mark_touch> given = touches();
  auto found = output<hrt_registration>();
  found.verdict = 77;
  hrt_registration_config config = hrt_registration_config_init();
  config.flags = HRT_REGISTER_UP;
  config.up[1] = 0.0;
  expect_error(hrt_registration_fit(&config, given.data(), given.size(), 0, nullptr, &found),
               HRT_ERROR_OUT_OF_RANGE, "up is (0, 0, 0)");
  expect_error(hrt_registration_fit(nullptr, given.data(), HRT_TOUCHES_MAX + 1, 0, nullptr, &found),
               HRT_ERROR_OUT_OF_RANGE, "touch_count is 1001");
}

// The finger rests on the registered start: it is seen there.
TEST_F(RegistrationTest, AppliedPoseLocatesTheFinger) {
  for (const double scale : {1.0, 1.04}) {
    create(session_config());
    hrt_registration_config setup = hrt_registration_config_init();
    setup.flags = HRT_REGISTER_SCALE;
    const hrt_registration found = fit(touches(0.0, scale), &setup);
    ASSERT_OK(hrt_registration_apply(session, &found, 123));
    const hrt_session_config config = config_of(session);
    EXPECT_EQ(config.flags, HRT_SESSION_REGISTERED);
    EXPECT_EQ(config.registration_time_ns, 123);
    EXPECT_NEAR(config.plate_scale, scale, 1e-9);
    begin_reach();
    auto sample = output<hrt_sample>();
    sample.flags = HRT_SAMPLE_WORLD_POSITION;
    const Vector3d ahead = scale * (turned(20.0) * Vector3d(0.0, 0.0, -0.05)) + place;
    for (int i = 0; i < 3; ++i) sample.finger_position_m[i] = ahead(i);
    // 10 cm from the start; the real target is 10 cm away at -5 degrees: 2 * 0.1 sin 2.5 apart.
    EXPECT_NEAR(update(sample).distance_to_go_m, 0.2 * 0.043619387365336, 1e-9);
    ASSERT_OK(hrt_reach_cancel(session));
  }
}

TEST_F(RegistrationTest, TargetsInTheWorldFollowTheScale) {
  hrt_session_config config = session_config();
  config.plate_scale = 1.25;
  config.plate_position_m[0] = 1.0;
  create(config);
  hrt_target_config target = target_config(HRT_TARGET_REAL, 0.0);
  target.place = HRT_PLACE_WORLD_POSITION;
  // 4 cm right and 4 cm ahead of the start on the plate, which is 5 cm towards the user.
  target.position_m[0] = 1.0 + 1.25 * 0.04;
  target.position_m[2] = 1.25 * 0.01;
  hrt_target id{};
  ASSERT_OK(hrt_target_add(session, &target, &id));
  auto gap = output<hrt_gap>();
  ASSERT_OK(hrt_gap_query(session, id, add(HRT_TARGET_VIRTUAL, -45.0), &gap));
  EXPECT_NEAR(gap.gap_deg, 0.0, 1e-9);
}

TEST_F(RegistrationTest, UncertaintyGoesIntoTheConfiguration) {
  const hrt_registration found = fit(touches(0.002));
  ASSERT_OK(hrt_registration_apply(session, &found, -5));
  const hrt_session_config config = config_of(session);
  EXPECT_EQ(config.registration_time_ns, -5);
  EXPECT_EQ(config.plate_covariance[0], found.covariance[2]);  // of the turn about y
  EXPECT_GT(config.plate_covariance[2], 0.0);
  EXPECT_GT(config.plate_covariance[5], 0.0);
  ASSERT_OK(hrt_session_set(session, &config));
}

TEST_F(RegistrationTest, ApplyRefusesByNameAndChangesNothing) {
  const hrt_registration good = fit(touches(0.002));
  const hrt_session_config before = config_of(session);
  const auto refused = [&](auto&& spoil, const char* part) {
    hrt_registration bad = good;
    spoil(bad);
    expect_error(hrt_registration_apply(session, &bad, 0), HRT_ERROR_OUT_OF_RANGE, part);
    auto check = output<hrt_touch_check>();
    const hrt_mark_touch seen = touches()[0];
    expect_error(hrt_registration_check(&bad, &seen, &check), HRT_ERROR_OUT_OF_RANGE, part);
  };
  refused([](auto& r) { r.verdict = HRT_REGISTRATION_INCONSISTENT; }, "verdict is 4");
  refused([](auto& r) { r.verdict = 0; }, "verdict is 0");
  refused([](auto& r) { r.plate_position_m[1] = nan; }, "plate_position_m");
  refused([](auto& r) { r.plate_rotation[3] = 2.0; }, "plate_rotation");
  refused([](auto& r) { r.plate_scale = 0.49; }, "plate_scale");
  refused([](auto& r) { r.touch_sd_m = 0.0; }, "touch_sd_m");
  refused([](auto& r) { r.covariance[27] = HUGE_VAL; }, "covariance");
  refused([](auto& r) { r.covariance[2] = -1e-3; }, "covariance is not positive semidefinite");
  const hrt_session_config after = config_of(session);
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
  begin_reach();
  expect_error(hrt_registration_apply(session, &good, 0), HRT_ERROR_WRONG_STATE, "a reach is under way");
  expect_error(hrt_registration_apply(session, nullptr, 0), HRT_ERROR_WRONG_STATE, "a reach is under way");
  ASSERT_OK(hrt_reach_cancel(session));
}

// A scene says where the plate is, and so replaces what was registered.
TEST_F(RegistrationTest, ASceneReplacesIt) {
  const hrt_registration found = fit(touches(0.002));
  ASSERT_OK(hrt_registration_apply(session, &found, 5));
  hrt_scene scene{};
  ASSERT_OK(hrt_scene_load(HRT_DESK_SCENE, nullptr, 0, &scene));
  ASSERT_OK(hrt_scene_register(scene, session, 0, nullptr));
  ASSERT_OK(hrt_scene_destroy(scene));
  const hrt_session_config config = config_of(session);
  EXPECT_EQ(config.flags, 0u);
  EXPECT_EQ(config.registration_time_ns, 0);
  for (const double covariance : config.plate_covariance) EXPECT_EQ(covariance, 0.0);
}

TEST_F(RegistrationTest, ATouchBeforeAReachRenewsItOrEndsIt) {
  const hrt_registration found = fit(touches(0.002));
  const hrt_mark_touch on_mark = touches()[1];
  hrt_mark_touch beside = on_mark;
  beside.touched_m[0] += 0.05;
  auto check = output<hrt_touch_check>();
  expect_error(hrt_registration_confirm(session, &found, &on_mark, 7, &check), HRT_ERROR_OUT_OF_RANGE,
               "registration is not that of the session");
  ASSERT_OK(hrt_registration_apply(session, &found, 1000));
  hrt_session_config config = config_of(session);
  config.max_registration_age_ns = 500;
  ASSERT_OK(hrt_session_set(session, &config));

  const auto flags_at = [&](std::int64_t time_ns) {
    begin_reach();
    const std::uint32_t flags = update(position_sample(time_ns, 0.0, -0.05)).flags;
    EXPECT_OK(hrt_reach_cancel(session));
    return flags & HRT_COMMAND_REGISTRATION;
  };
  EXPECT_EQ(flags_at(1500), 0u);
  EXPECT_EQ(flags_at(1501), HRT_COMMAND_REGISTRATION) << "no check since 1000";
  ASSERT_OK(hrt_registration_confirm(session, &found, &on_mark, 1400, &check));
  EXPECT_EQ(check.holds, 1u);
  EXPECT_EQ(flags_at(1900), 0u);
  ASSERT_OK(hrt_registration_confirm(session, &found, &beside, 1900, &check));
  EXPECT_EQ(check.holds, 0u);
  EXPECT_NEAR(check.distance_m, 0.05, 0.005);
  EXPECT_EQ(config_of(session).flags & HRT_SESSION_REGISTERED, 0u);
  EXPECT_EQ(config_of(session).registration_time_ns, 1400);
  EXPECT_EQ(flags_at(1900), HRT_COMMAND_REGISTRATION);
  // A second touch, on the mark this time, is believed.
  ASSERT_OK(hrt_registration_confirm(session, &found, &on_mark, 2000, &check));
  EXPECT_EQ(flags_at(2500), 0u);

  begin_reach();
  check.holds = 77;
  expect_error(hrt_registration_confirm(session, &found, &on_mark, 0, &check), HRT_ERROR_WRONG_STATE,
               "a reach is under way");
  ASSERT_OK(hrt_reach_cancel(session));
  EXPECT_EQ(check.holds, 77u);
  EXPECT_EQ(config_of(session).registration_time_ns, 2000);
}

// One sample of a reach to a target 100 mm from the start, which is the centre here.
class RegisteredReachTest : public SessionTest {
 protected:
  static constexpr double one_degree = 0.017453292519943295;

  hrt_command command_at(std::int64_t time_ns, const hrt_session_config& config) {
    create(config);
    begin_reach();
    hrt_sample sample = position_sample(time_ns, 0.0, 0.0);
    return update(sample);
  }

  static hrt_session_config turned_by(double sd_deg) {
    hrt_session_config config = session_config();
    config.start_position_m[2] = 0.0;
    config.plate_covariance[0] = sd_deg * one_degree * sd_deg * one_degree;
    config.flags = HRT_SESSION_REGISTERED;
    config.registration_time_ns = 1000;
    return config;
  }
};

TEST_F(RegisteredReachTest, OneDegreeCostsOnePointSevenMillimetresAtTenCentimetres) {
  const double sd_deg = command_at(0, turned_by(1.0)).miss_sd_deg;
  EXPECT_NEAR(sd_deg, 1.0, 1e-9);
  EXPECT_NEAR(0.1 * sd_deg * one_degree, 0.001745, 1e-6);
  EXPECT_EQ(end().miss_sd_deg, sd_deg);
  EXPECT_EQ(command_at(0, session_config()).miss_sd_deg, 0.0);
  hrt_session_config paper = turned_by(1.0);
  paper.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  EXPECT_EQ(command_at(0, paper).miss_sd_deg, 0.0);
}

TEST_F(RegisteredReachTest, OldOnesAreFlagged) {
  hrt_session_config config = turned_by(0.0);
  const auto flagged = [&](std::int64_t time_ns) {
    return (command_at(time_ns, config).flags & HRT_COMMAND_REGISTRATION) != 0;
  };
  EXPECT_FALSE(flagged(INT64_MAX));  // not checked
  config.max_registration_age_ns = 500;
  EXPECT_FALSE(flagged(1500));
  EXPECT_EQ(end().flags & HRT_COMMAND_REGISTRATION, 0u);
  EXPECT_TRUE(flagged(1501));
  EXPECT_EQ(end().flags & HRT_COMMAND_REGISTRATION, HRT_COMMAND_REGISTRATION);
  EXPECT_FALSE(flagged(0));
  EXPECT_FALSE(flagged(INT64_MIN));
  config.registration_time_ns = INT64_MIN;
  EXPECT_TRUE(flagged(INT64_MAX));
  config.max_registration_age_ns = INT64_MAX;
  EXPECT_TRUE(flagged(INT64_MAX));
  EXPECT_FALSE(flagged(-2));
  config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  EXPECT_TRUE(flagged(INT64_MAX));
}

TEST_F(RegisteredReachTest, PoorOrMissingOnesAreFlagged) {
  hrt_session_config config = turned_by(1.0);
  const auto flagged = [&] { return (command_at(1000, config).flags & HRT_COMMAND_REGISTRATION) != 0; };
  config.max_registration_sd_deg = 1.01;
  EXPECT_FALSE(flagged());
  config.max_registration_sd_deg = 0.99;
  EXPECT_TRUE(flagged());
  config.max_registration_sd_deg = 1.01;
  config.flags = 0;
  EXPECT_TRUE(flagged());
  config.max_registration_sd_deg = 0.0;
  EXPECT_FALSE(flagged());
  config.max_registration_age_ns = INT64_MAX;
  EXPECT_TRUE(flagged());
}

TEST_F(RegisteredReachTest, TheLogHasItOnceForAConfiguration) {
  const Log log;
  hrt_session_config config = turned_by(1.0);
  config.max_registration_sd_deg = 0.5;
  create(config);
  begin_reach();
  update(position_sample(0, 0.0, 0.0));
  end();
  EXPECT_EQ(log.text, "");
  config.max_registration_sd_deg = 2.0;
  ASSERT_OK(hrt_session_set(session, &config));
  ASSERT_OK(hrt_session_destroy(session));
  session.value = 0;
  EXPECT_TRUE(log.text.starts_with(std::to_string(HRT_LOG_WARNING) + " ")) << log.text;
  EXPECT_NE(log.text.find("registration of the plate was older or worse than allowed"), std::string::npos);
  EXPECT_EQ(std::count(log.text.begin(), log.text.end(), '\n'), 1);
}

// 1 mm to the side is 0.6 degrees of a target 100 mm off, and 1.9 of one 30 mm off.
TEST_F(RegisteredReachTest, AMovedTargetIsCheckedAnew) {
  hrt_session_config config = turned_by(1.0);
  config.plate_covariance[0] = 0.0;
  config.plate_covariance[2] = 1e-6;
  config.max_registration_sd_deg = 1.0;
  create(config);
  const auto add_ahead = [&](std::uint32_t role, double forward_m) {
    hrt_target_config ahead = target_config(role, 0.0);
    ahead.place = HRT_PLACE_PLATE_POSITION;
    ahead.position_m[2] = -forward_m;
    hrt_target target{};
    EXPECT_OK(hrt_target_add(session, &ahead, &target));
    return target;
  };
  hrt_reach_config reach = hrt_reach_config_init();
  reach.real_target = add_ahead(HRT_TARGET_REAL, 0.1);
  reach.virtual_target = add_ahead(HRT_TARGET_VIRTUAL, 0.1);
  ASSERT_OK(hrt_reach_begin(session, &reach));
  EXPECT_EQ(update(position_sample(0, 0.0, 0.0)).flags & HRT_COMMAND_REGISTRATION, 0u);
  ASSERT_OK(hrt_reach_retarget(session, add_ahead(HRT_TARGET_REAL, 0.03), reach.virtual_target));
  EXPECT_NE(update(position_sample(10'000'000, 0.0, 0.0)).flags & HRT_COMMAND_REGISTRATION, 0u);
  ASSERT_OK(hrt_reach_retarget(session, reach.real_target, reach.virtual_target));
  EXPECT_EQ(update(position_sample(20'000'000, 0.0, 0.0)).flags & HRT_COMMAND_REGISTRATION, 0u);
}

// Seen from a start further back than configured, the same frame turns the target by more.
TEST_F(RegisteredReachTest, StartAtTheFingerIsCheckedThere) {
  hrt_session_config config = turned_by(1.0);
  config.plate_covariance[0] = 0.0;
  config.plate_covariance[2] = 1e-6;  // 1 mm to the side
  config.max_registration_sd_deg = 1.0;
  create(config);
  hrt_target_config ahead = target_config(HRT_TARGET_REAL, 0.0);
  ahead.place = HRT_PLACE_PLATE_POSITION;
  ahead.position_m[2] = -0.07;
  hrt_reach_config reach = hrt_reach_config_init();
  ASSERT_OK(hrt_target_add(session, &ahead, &reach.real_target));
  reach.virtual_target = add(HRT_TARGET_VIRTUAL, 5.0);
  reach.flags = HRT_REACH_START_AT_FINGER;
  ASSERT_OK(hrt_reach_begin(session, &reach));
  // 0.82 degrees from the configured start, 1.15 from 5 cm before the target.
  EXPECT_EQ(update(output<hrt_sample>()).flags & HRT_COMMAND_REGISTRATION, 0u);
  const hrt_command command = update(position_sample(10, 0.0, 0.02));
  EXPECT_EQ(command.flags & HRT_COMMAND_REGISTRATION, HRT_COMMAND_REGISTRATION);
  EXPECT_NEAR(command.miss_sd_deg, 0.001 / 0.05 / one_degree, 0.001);
}

TEST(RegistrationCheck, ALaterTouch) {
  const hrt_registration found = fit(touches(0.002));
  auto check = output<hrt_touch_check>();
  hrt_mark_touch later = touches()[1];
  ASSERT_OK(hrt_registration_check(&found, &later, &check));
  EXPECT_EQ(check.holds, 1u);
  EXPECT_LT(check.distance_m, check.allowed_m);
  later.touched_m[0] += 0.03;
  ASSERT_OK(hrt_registration_check(&found, &later, &check));
  EXPECT_EQ(check.holds, 0u);
  EXPECT_GT(check.distance_m, check.allowed_m);
  EXPECT_NEAR(check.distance_m, 0.03, 0.005);
  later.mark_m[0] = nan;
  expect_error(hrt_registration_check(&found, &later, &check), HRT_ERROR_OUT_OF_RANGE, "touch.mark_m");
}

TEST(FingertipFit, OffsetAndItsRefusals) {
  const Vector3d offset(0.0, -0.008, -0.012);
  std::vector<hrt_joint_touch> given;
  for (int i = 0; i < 9; ++i) {
    const Vector3d axis = Vector3d::Unit(i % 3);
    const int turn = i / 3 - 1;
    const Eigen::Quaterniond q(AngleAxisd(0.5 * turn, axis));
    const Vector3d joint = place - q * offset;
    given.push_back({{joint.x(), joint.y(), joint.z()}, {q.x(), q.y(), q.z(), q.w()}});
  }
  auto found = output<hrt_fingertip>();
  ASSERT_OK(hrt_fingertip_fit(nullptr, given.data(), given.size(), &found));
  EXPECT_EQ(found.known, 1u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.offset_m[i], offset(i), 1e-9);
    EXPECT_GT(found.sd_m[i], 0.0);
  }
  ASSERT_OK(hrt_fingertip_fit(nullptr, given.data(), 2, &found));
  EXPECT_EQ(found.known, 0u);
  EXPECT_EQ(found.offset_m[1], 0.0);
  given[2].rotation[0] = 1.0;
  found.known = 77;
  expect_error(hrt_fingertip_fit(nullptr, given.data(), given.size(), &found), HRT_ERROR_OUT_OF_RANGE,
               "touches[2].rotation");
  given[2].position_m[0] = nan;
  expect_error(hrt_fingertip_fit(nullptr, given.data(), given.size(), &found), HRT_ERROR_OUT_OF_RANGE,
               "touches[2].position_m");
  EXPECT_EQ(found.known, 77u);
}

// A quarter turn about the vertical takes an offset to the right, +x, to one away from the user, -z.
TEST(FingertipPlace, TurnsTheOffsetWithTheJoint) {
  auto fingertip = output<hrt_fingertip>();
  fingertip.known = 1;
  fingertip.offset_m[0] = 0.012;
  fingertip.offset_m[1] = -0.008;
  const double half = std::sqrt(0.5);
  hrt_joint_touch joint{{1.0, 2.0, 3.0}, {0.0, half, 0.0, half}};
  hrt_sample sample = direction_sample(5, 3.0);
  ASSERT_OK(hrt_fingertip_place(&fingertip, &joint, &sample));
  EXPECT_EQ(sample.flags, HRT_SAMPLE_WORLD_POSITION);
  EXPECT_EQ(sample.time_ns, 5);
  EXPECT_NEAR(sample.finger_position_m[0], 1.0, 1e-12);
  EXPECT_NEAR(sample.finger_position_m[1], 1.992, 1e-12);
  EXPECT_NEAR(sample.finger_position_m[2], 2.988, 1e-12);

  const auto refused = [&](hrt_result result, const char* part) {
    expect_error(result, HRT_ERROR_OUT_OF_RANGE, part);
    EXPECT_NEAR(sample.finger_position_m[2], 2.988, 1e-12);
  };
  hrt_joint_touch bad = joint;
  bad.rotation[0] = 1.0;
  refused(hrt_fingertip_place(&fingertip, &bad, &sample), "joint.rotation");
  bad = joint;
  bad.position_m[1] = nan;
  refused(hrt_fingertip_place(&fingertip, &bad, &sample), "joint.position_m");
  hrt_fingertip unknown = fingertip;
  unknown.known = 0;
  refused(hrt_fingertip_place(&unknown, &joint, &sample), "known is 0; allowed: 1 to 1");
  unknown = fingertip;
  unknown.offset_m[2] = nan;
  refused(hrt_fingertip_place(&unknown, &joint, &sample), "offset_m");
}

// A plate that turns by 30 degrees to and fro, faster and faster, and a tracker that is late by a shift of
// whole samples.
std::vector<hrt_sample> carried(int late_by, std::uint32_t kind = HRT_SAMPLE_PLATE_POSITION) {
  std::vector<hrt_sample> samples;
  const auto plate_deg = [](int i) { return 30.0 * std::sin(0.02 * i + 2e-5 * i * i); };
  for (int i = 0; i < 600; ++i) {
    auto sample = output<hrt_sample>();
    sample.flags = kind | HRT_SAMPLE_PLATE_ORIENTATION;
    sample.time_ns = 1'000'000'000'000 + 10'000'000ll * i;
    sample.plate_orientation_deg = plate_deg(i);
    const double was_rad = (plate_deg(i - late_by) + 40.0) / 57.29577951308232;
    sample.finger_position_m[0] = 0.07 * std::cos(was_rad);
    sample.finger_position_m[2] = -0.07 * std::sin(was_rad) + 1e-5 * (i % 7);
    samples.push_back(sample);
  }
  return samples;
}

TEST(LatencyFit, IsThatOfTheShift) {
  for (const std::uint32_t kind : {HRT_SAMPLE_PLATE_POSITION, HRT_SAMPLE_WORLD_POSITION}) {
    std::vector<hrt_sample> samples = carried(6, kind);
    // Lost, lifted and not reported: left out.
    samples[70].flags = 0;
    samples[80].flags |= HRT_SAMPLE_LIFTED;
    samples[80].finger_position_m[1] = 0.5;
    samples[90].flags = kind;
    samples[90].finger_position_m[1] = 0.5;
    auto found = output<hrt_latency>();
    ASSERT_OK(hrt_latency_fit(samples.data(), samples.size(), &found));
    EXPECT_EQ(found.known, 1u);
    EXPECT_NEAR(static_cast<double>(found.latency_ns), 60e6, 0.5e6);
    EXPECT_LE(found.lower_ns, found.latency_ns);
    EXPECT_GE(found.upper_ns, found.latency_ns);
    EXPECT_NEAR(found.radius_m, 0.07, 0.001);
    EXPECT_LT(found.residual_m, 1e-3);
  }
  auto found = output<hrt_latency>();
  ASSERT_OK(hrt_latency_fit(nullptr, 0, &found));
  EXPECT_EQ(found.known, 0u);
  std::vector<hrt_sample> still = carried(0);
  for (hrt_sample& sample : still) sample.plate_orientation_deg = 5.0;
  ASSERT_OK(hrt_latency_fit(still.data(), still.size(), &found));
  EXPECT_EQ(found.known, 0u);
  EXPECT_EQ(found.latency_ns, 0);
}

TEST(LatencyFit, RefusesByName) {
  auto found = output<hrt_latency>();
  found.known = 77;
  const auto refused = [&](hrt_result code, const char* part, auto&& spoil) {
    std::vector<hrt_sample> samples = carried(0);
    spoil(samples);
    expect_error(hrt_latency_fit(samples.data(), samples.size(), &found), code, part);
    EXPECT_EQ(found.known, 77u);
  };
  refused(HRT_ERROR_OUT_OF_RANGE, "samples[5].finger_position_m[1] is",
          [](auto& s) { s[5].finger_position_m[1] = nan; });
  refused(HRT_ERROR_OUT_OF_RANGE, "samples[6].plate_orientation_deg is",
          [](auto& s) { s[6].plate_orientation_deg = 1e9; });
  refused(HRT_ERROR_OUT_OF_RANGE, "samples[7]: flags is",
          [](auto& s) { s[7].flags ^= HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION; });
  refused(HRT_ERROR_TIME_REVERSED, "samples[8]: time_ns", [](auto& s) { s[8].time_ns = 0; });
  refused(HRT_ERROR_STRUCT_SIZE, "samples[9]", [](auto& s) { s[9].struct_size = 12; });
  refused(HRT_ERROR_STRUCT_SIZE, "samples[0]", [](auto& s) { s[0].struct_size = 0; });
  const hrt_sample one = carried(0)[0];
  expect_error(hrt_latency_fit(&one, HRT_LATENCY_SAMPLES_MAX + 1, &found), HRT_ERROR_OUT_OF_RANGE,
               "sample_count is 100001");
}

}  // namespace
}  // namespace hrt::test
