#include <cmath>

#include "core/plate/plate_frame.h"
#include "core/simulation/person.h"
#include "fixture.h"

namespace hrt::test {
namespace {

class RetargetTest : public SessionTest {
 protected:
  hrt_target add_at(std::uint32_t role, double right_m, double forward_m) {
    return add(placed(role, right_m, forward_m));
  }

  hrt_result begin_at_finger(hrt_target real_target, hrt_target virtual_target) {
    return begin(real_target, virtual_target, HRT_REACH_START_AT_FINGER);
  }

  void expect_state(std::uint32_t expected) const {
    std::uint32_t state = 99;
    EXPECT_OK(hrt_session_get(session, nullptr, &state));
    EXPECT_EQ(state, expected);
  }
};

TEST_F(RetargetTest, StateFollowsTargetsReachesAndSetups) {
  expect_state(0);
  const hrt_target real = add(HRT_TARGET_REAL, -5.0);
  expect_state(0);
  const hrt_target cup = add(HRT_TARGET_VIRTUAL, 5.0);
  expect_state(HRT_STATE_READY);
  change(cup, target_config(HRT_TARGET_REAL, 5.0));
  expect_state(0);
  change(cup, target_config(HRT_TARGET_VIRTUAL, 5.0));
  ASSERT_OK(hrt_target_remove(session, add(HRT_TARGET_REAL, -10.0, "second")));
  expect_state(HRT_STATE_READY);
  ASSERT_OK(hrt_target_remove(session, real));
  expect_state(0);
  const hrt_target real_again = add(HRT_TARGET_REAL, -5.0);
  const std::string path = testing::TempDir() + "hrt_state.csv";
  ASSERT_OK(hrt_recording_start(session, path.c_str()));
  expect_state(HRT_STATE_READY | HRT_STATE_RECORDING);
  ASSERT_OK(begin(real_again, cup));
  expect_state(HRT_STATE_REACHING | HRT_STATE_RECORDING);
  ASSERT_OK(hrt_target_remove(session, cup));
  expect_state(HRT_STATE_REACHING | HRT_STATE_RECORDING);
  ASSERT_OK(hrt_reach_cancel(session));
  auto status = output<hrt_recording_status>();
  ASSERT_OK(hrt_recording_stop(session, &status));
  std::remove(path.c_str());
  expect_state(0);
  std::uint32_t state = 0;
  expect_error(hrt_session_get({7}, nullptr, &state), HRT_ERROR_INVALID_HANDLE, "session 7");
}

TEST_F(RetargetTest, CancelledReachChangesNoEstimate) {
  const hrt_session_config before = config_of(session);
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0);
  ASSERT_OK(begin(real, cup));
  slide(0, 2200);
  ASSERT_OK(hrt_reach_cancel(session));
  EXPECT_TRUE(same(config_of(session), before));
  ASSERT_OK(begin(real, cup)) << "another one may begin";
  slide(0, 2200);
  end();
  EXPECT_FALSE(same(config_of(session), before)) << "a reach that ends teaches";
}

TEST_F(RetargetTest, NextReachStartsAtTheLastCommandOfACancelledOne) {
  create(paper_config());
  ASSERT_OK(begin(add(HRT_TARGET_REAL, -5.0), add(HRT_TARGET_VIRTUAL, 5.0)));
  const double left_deg = update(direction_sample(0, 1.0)).plate_orientation_deg;
  ASSERT_NE(left_deg, 0.0);
  ASSERT_OK(hrt_reach_cancel(session));
  ASSERT_OK(begin(add(HRT_TARGET_REAL, 0.0), add(HRT_TARGET_VIRTUAL, 0.0)));
  EXPECT_EQ(update(output<hrt_sample>()).plate_orientation_deg, left_deg);
}

TEST_F(RetargetTest, RetargetRejectsTheSamePairsAsBegin) {
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, 5.0),
                   behind = add(HRT_TARGET_REAL, 170.0);
  expect_error(hrt_reach_retarget(session, real, cup), HRT_ERROR_WRONG_STATE);
  ASSERT_OK(begin(real, cup));
  slide(0, 900);
  expect_error(hrt_reach_retarget(session, {0}, cup), HRT_ERROR_INVALID_HANDLE, "real_target");
  expect_error(hrt_reach_retarget(session, real, {12}), HRT_ERROR_INVALID_HANDLE, "virtual_target");
  expect_error(hrt_reach_retarget(session, cup, cup), HRT_ERROR_OUT_OF_RANGE, "real_target");
  expect_error(hrt_reach_retarget(session, real, real), HRT_ERROR_OUT_OF_RANGE, "virtual_target");
  expect_error(hrt_reach_retarget(session, behind, cup), HRT_ERROR_OUT_OF_RANGE, "90 degrees apart");
  const double to_go_m = slide(900, 910).distance_to_go_m;
  EXPECT_NEAR(to_go_m, slide(910, 920).distance_to_go_m, 0.003) << "the reach continues as before";
}

TEST_F(RetargetTest, DistanceToGoIsThatToTheNewTarget) {
  for (const std::uint32_t guidance : {HRT_GUIDANCE_FIXED_DIRECTION, HRT_GUIDANCE_ARRIVAL}) {
    create(session_config(), [&](auto& c) { c.guidance = guidance; });
    const hrt_target real = add_at(HRT_TARGET_REAL, 0.009, 0.05), cup = add_at(HRT_TARGET_VIRTUAL, -0.009, 0.05);
    ASSERT_OK(begin(real, cup));
    const double before_m = slide(0, 900).distance_to_go_m;
    change(real, placed(HRT_TARGET_REAL, -0.02, 0.05));
    change(cup, placed(HRT_TARGET_VIRTUAL, -0.035, 0.05));
    EXPECT_NEAR(slide(900, 910).distance_to_go_m, before_m, 0.002) << "not before the retarget";
    ASSERT_OK(hrt_reach_retarget(session, real, cup));
    const hrt_command command = slide(910, 920);
    const PlatePoint finger{0.0, mm_per_m * slid_m(910) - 50.0};
    EXPECT_NEAR(command.distance_to_go_m, distance_mm(finger, {-20.0, 50.0}) / mm_per_m, 0.003);
    if (guidance == HRT_GUIDANCE_FIXED_DIRECTION) {
      EXPECT_NEAR(command.paper.aimed_direction_deg, bearing_deg(finger, {-20.0, 50.0}), 3.0);
    }
    slide(920, 2200);
    EXPECT_NEAR(end().distance_to_target_m, 0.02, 0.002);
  }
}

TEST_F(RetargetTest, StartAtFingerMeasuresFromTheFirstPosition) {
  const hrt_target real = add_at(HRT_TARGET_REAL, 0.03, 0.04), cup = add_at(HRT_TARGET_VIRTUAL, 0.02, 0.04);
  for (const std::uint32_t guidance : {HRT_GUIDANCE_FIXED_DIRECTION, HRT_GUIDANCE_ARRIVAL}) {
    hrt_session_config config = config_of(session);
    config.guidance = guidance;
    ASSERT_OK(hrt_session_set(session, &config));
    ASSERT_OK(begin_at_finger(real, cup));
    update(output<hrt_sample>());
    const hrt_command first = update(position_sample(10 * ms, 0.02, -0.02));
    EXPECT_NEAR(first.distance_to_go_m, distance_mm({20.0, -20.0}, {30.0, 40.0}) / mm_per_m, 1e-9);
    if (guidance == HRT_GUIDANCE_FIXED_DIRECTION) {
      EXPECT_NEAR(first.paper.aimed_direction_deg, bearing_deg({20.0, -20.0}, {30.0, 40.0}), 1e-9);
    }
    end();
  }
}

TEST_F(RetargetTest, FingerOnTheTargetDoesNotStartTheReach) {
  const hrt_target real = add_at(HRT_TARGET_REAL, 0.03, 0.04), cup = add_at(HRT_TARGET_VIRTUAL, 0.02, 0.04);
  ASSERT_OK(begin_at_finger(real, cup));
  auto command = output<hrt_command>();
  hrt_sample sample = position_sample(0, 0.03, 0.04);
  expect_error(hrt_reach_update(session, &sample, &command), HRT_ERROR_OUT_OF_RANGE, "real_target");
  sample = position_sample(0, 0.02, 0.04);
  expect_error(hrt_reach_update(session, &sample, &command), HRT_ERROR_OUT_OF_RANGE, "virtual_target");
  sample = position_sample(0, 0.025, 0.04);
  expect_error(hrt_reach_update(session, &sample, &command), HRT_ERROR_OUT_OF_RANGE, "90 degrees apart");
  update(position_sample(0, 0.0, -0.05));
  update(position_sample(1, 0.03, 0.04));
  end();
}

TEST_F(RetargetTest, RemovedTargetsRemainInAReachThatWaitsForTheFinger) {
  const hrt_target real = add_at(HRT_TARGET_REAL, 0.03, 0.04), cup = add_at(HRT_TARGET_VIRTUAL, 0.02, 0.04);
  ASSERT_OK(begin_at_finger(real, cup));
  ASSERT_OK(hrt_target_remove(session, real));
  ASSERT_OK(hrt_target_remove(session, cup));
  EXPECT_NEAR(update(position_sample(0, 0.02, -0.02)).distance_to_go_m, std::hypot(0.01, 0.06), 1e-9);
}

// The targets move by 3 cm to the left in the middle of the motion.
TEST_F(RetargetTest, SteersAPersonToTheMovedTarget) {
  create(session_config(), [](auto& c) { c.plate.max_speed_deg_s = 400.0; });
  const PlatePoint start{0.0, -50.0};
  const PlatePoint real_place = point_ahead(start, -5.0, 100.0), seen_place = point_ahead(start, 5.0, 100.0);
  const hrt_target real = add_at(HRT_TARGET_REAL, real_place.right_mm / mm_per_m, real_place.away_mm / mm_per_m),
                   cup = add_at(HRT_TARGET_VIRTUAL, seen_place.right_mm / mm_per_m, seen_place.away_mm / mm_per_m);
  const PlatePoint shift{-30.0, 0.0};
  const PlatePoint moved = real_place + shift, seen_now = seen_place + shift;
  SlidingPerson person({.illusion = {.tactile_weight = 0.25}, .noise_deg2_per_s = 0.0, .duration_s = 2.0}, start, 5.0,
                       100.0, {1, 0, 0, 0});
  ASSERT_OK(begin(real, cup));
  double plate_deg = 0.0;
  for (std::int64_t t = 0; !person.done(); ++t) {
    if (t > 500) person.advance(plate_deg);
    if (t == 500 + 900) {
      change(real, placed(HRT_TARGET_REAL, moved.right_mm / mm_per_m, moved.away_mm / mm_per_m));
      change(cup, placed(HRT_TARGET_VIRTUAL, seen_now.right_mm / mm_per_m, seen_now.away_mm / mm_per_m));
      ASSERT_OK(hrt_reach_retarget(session, real, cup));
      person.retarget(seen_now);
    }
    if (t % 10 == 0)
      plate_deg =
          update(position_sample(t * ms, person.position().right_mm / mm_per_m, person.position().away_mm / mm_per_m))
              .plate_orientation_deg;
  }
  EXPECT_NEAR(bearing_deg(start, person.position()), bearing_deg(start, moved), 1.5);
  const hrt_reach_summary summary = end();
  EXPECT_EQ(summary.flags, 0u);
  EXPECT_NEAR(summary.miss_deg, bearing_deg(start, person.position()) - bearing_deg(start, moved), 0.2);
}

}  // namespace
}  // namespace hrt::test
