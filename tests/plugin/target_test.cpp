#include <cmath>

#include "fixture.h"

namespace hrt::test {
namespace {

using TargetTest = SessionTest;
using GapTest = PaperTest;

TEST_F(TargetTest, GetReturnsTheAddedTarget) {
  const hrt_target_config config = target_config(HRT_TARGET_VIRTUAL, 12.5, "cup");
  const hrt_target target = add(config);
  auto back = output<hrt_target_config>();
  ASSERT_OK(hrt_target_get(session, target, &back));
  EXPECT_TRUE(same(back, config));
}

TEST_F(TargetTest, NameIsTakenUntilItsTargetIsRenamed) {
  const hrt_target target = add(HRT_TARGET_REAL, 0.0, "cup");
  const hrt_target_config taken = target_config(HRT_TARGET_VIRTUAL, 5.0, "cup");
  hrt_target other{7};
  expect_error(hrt_target_add(session, &taken, &other), HRT_ERROR_NAME_TAKEN, "\"cup\"");
  EXPECT_EQ(other.value, 7u);
  change(target, target_config(HRT_TARGET_REAL, 0.0, "mug"));
  add(taken);
  expect_error(hrt_target_set(session, target, &taken), HRT_ERROR_NAME_TAKEN, "\"cup\"");
}

TEST_F(TargetTest, RemovedTargetIsNeverValidAgain) {
  const hrt_target target = add(HRT_TARGET_REAL, 0.0, "cup");
  ASSERT_OK(hrt_target_remove(session, target));
  expect_error(hrt_target_remove(session, target), HRT_ERROR_INVALID_HANDLE, "target");
  const hrt_target again = add(HRT_TARGET_REAL, 0.0, "cup");
  EXPECT_NE(again.value, target.value);
  auto config = output<hrt_target_config>();
  expect_error(hrt_target_get(session, target, &config), HRT_ERROR_INVALID_HANDLE, "target");
}

TEST_F(TargetTest, TargetOfAnotherSessionIsRejected) {
  const hrt_target ours = add(HRT_TARGET_REAL, 0.0);
  const hrt_session_config config = session_config();
  hrt_session other{};
  ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &other));
  EXPECT_EQ(hrt_target_remove(other, ours), HRT_ERROR_INVALID_HANDLE);
  EXPECT_EQ(hrt_target_remove(other, {session.value}), HRT_ERROR_INVALID_HANDLE);
  EXPECT_EQ(hrt_session_destroy({ours.value}), HRT_ERROR_INVALID_HANDLE);
  EXPECT_OK(hrt_session_destroy(other));
}

TEST_F(TargetTest, ListReturnsTargetsInTheOrderOfAddition) {
  const hrt_target a = add(HRT_TARGET_REAL, 0.0), b = add(HRT_TARGET_VIRTUAL, 1.0), c = add(HRT_TARGET_REAL, 2.0);
  ASSERT_OK(hrt_target_remove(session, a));
  const hrt_target d = add(HRT_TARGET_REAL, 3.0);
  uint64_t count = 0;
  ASSERT_OK(hrt_target_list(session, 0, 0, nullptr, &count));
  ASSERT_EQ(count, 3u);
  std::vector<hrt_target> listed(3);
  ASSERT_OK(hrt_target_list(session, 0, 3, listed.data(), &count));
  EXPECT_EQ(listed[0].value, b.value);
  EXPECT_EQ(listed[1].value, c.value);
  EXPECT_EQ(listed[2].value, d.value);
  ASSERT_OK(hrt_target_list(session, HRT_TARGET_REAL, 3, listed.data(), &count));
  EXPECT_EQ(count, 2u);
  EXPECT_EQ(listed[0].value, c.value);

  count = 99;
  expect_error(hrt_target_list(session, 0, 2, listed.data(), &count), HRT_ERROR_BUFFER_TOO_SMALL, "3");
  EXPECT_EQ(count, 99u);
}

TEST_F(TargetTest, InvalidPositionsAndNamesAreRejected) {
  const auto refused = [&](auto change, const char* part) {
    hrt_target_config config = target_config(HRT_TARGET_REAL, 0.0);
    change(config);
    hrt_target target{7};
    expect_error(hrt_target_add(session, &config, &target), HRT_ERROR_OUT_OF_RANGE, part);
    EXPECT_EQ(target.value, 7u);
  };
  refused(
      [](hrt_target_config& c) {
        c.place = HRT_PLACE_PLATE_POSITION;
        c.position_m[2] = 0.05;
      },
      "from the start");
  refused([](hrt_target_config& c) { c.served_by.value = 1; }, "served_by");
  refused([](hrt_target_config& c) { std::memset(c.name, 'x', sizeof c.name); }, "name");
  refused([](hrt_target_config& c) { std::strcpy(c.name, "\xff"); }, "UTF-8");
  refused([](hrt_target_config& c) { std::strcpy(c.name, "\xed\xa0\x80"); }, "UTF-8");
  refused([](hrt_target_config& c) { std::strcpy(c.name, "\xc0\x80"); }, "UTF-8");
  refused([](hrt_target_config& c) { std::strcpy(c.name, "caf\xc3"); }, "UTF-8");
  for (const char* name : {"a\nb", "a\x7f", "a\xc2\x80", "\xc2\x9f"})
    refused([&](hrt_target_config& c) { std::strcpy(c.name, name); }, "control character");
}

TEST_F(TargetTest, NamesMayBeInAnyScript) {
  for (const char* name : {"caf\xc3\xa9", "\xc2\xa0", "\xe6\x9d\xaf", "\xf0\x9f\x8d\xb5"}) {
    auto config = output<hrt_target_config>();
    ASSERT_OK(hrt_target_get(session, add(HRT_TARGET_REAL, 0.0, name), &config));
    EXPECT_STREQ(config.name, name);
  }
}

// To keep the finger at -5 degrees while the user perceives 5 degrees, the plate must be turned away from the virtual
// direction by 10 x (1 - w_T)/w_T degrees: by 56.67 for w_T = 0.15.
TEST_F(GapTest, GapOfAPairIsAsDerivedByHand) {
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), virtual_target = add(HRT_TARGET_VIRTUAL, 5.0);
  hrt_gap gap = gap_of(real, virtual_target);
  EXPECT_EQ(gap.reachable, 1u);
  EXPECT_DOUBLE_EQ(gap.gap_deg, 10.0);
  EXPECT_NEAR(gap.max_gap_deg, 84.5 * 0.15 / 0.85, 1e-12);
  EXPECT_NEAR(gap.margin_deg, 84.5 * 0.15 / 0.85 - 10.0, 1e-12);
  EXPECT_NEAR(gap.plate_orientation_deg, 5.0 + 10.0 * 0.85 / 0.15, 1e-12);
  EXPECT_NEAR(gap.settling_direction_deg, -5.0, 1e-12);
  expect_error(hrt_gap_query(session, virtual_target, real, &gap), HRT_ERROR_OUT_OF_RANGE,
               "real_target: target " + std::to_string(virtual_target.value) + " is virtual");
  // Behind the user, the directions of a pair are on both sides of 180 degrees: the gap is the smaller angle.
  const hrt_target real_behind = add(HRT_TARGET_REAL, 175.0), virtual_behind = add(HRT_TARGET_VIRTUAL, -175.0);
  EXPECT_NEAR(gap_of(real_behind, virtual_behind).gap_deg, 10.0, 1e-12);
  EXPECT_OK(begin(real_behind, virtual_behind));
}

// A linear illusion of weight 0.15 shifts the perceived direction by 0.15 times the angle between plate and motion: by
// 11.25 degrees at 75 degrees, and by 10 at 66.67. In the paper, the plate's bound is relative to the virtual
// direction, and the largest gap is 84.5 x 0.15/0.85 = 14.91 degrees.
TEST_F(GapTest, BoundIsRelativeToTheMotionUnderArrival) {
  hrt_session_config config = session_config();
  config.person.tactile_weight = 0.15;
  config.adaptation = HRT_ADAPTATION_OFF;
  create(config);
  const hrt_target real = add(HRT_TARGET_REAL, -5.0), virtual_target = add(HRT_TARGET_VIRTUAL, 5.0);
  hrt_gap gap = gap_of(real, virtual_target);
  EXPECT_EQ(gap.reachable, 1u);
  EXPECT_NEAR(gap.max_gap_deg, 11.25, 1e-9);
  EXPECT_NEAR(gap.margin_deg, 1.25, 1e-9);
  EXPECT_NEAR(gap.plate_orientation_deg, -5.0 + 10.0 / 0.15, 1e-6);
  EXPECT_NEAR(gap.settling_direction_deg, -5.0, 1e-12);
  EXPECT_NEAR(gap.paper_max_gap_deg, 84.5 * 0.15 / 0.85, 1e-12);
  gap = gap_of(add(HRT_TARGET_REAL, -7.0), virtual_target);
  EXPECT_EQ(gap.reachable, 0u);
  EXPECT_NEAR(gap.settling_direction_deg, 5.0 - 11.25, 1e-9);

  // A curvature of 0.05 reduces the shift at 75 degrees by a quarter: 0.2 t - 0.05 t (t/75)^2 is 11.25 at t = 75. A
  // bias of 2 degrees increases the gap.
  config = session_config();
  know_person(&config, {0.2, 0.05, 9.0, 2.0});
  ASSERT_OK(hrt_session_set(session, &config));
  gap = gap_of(real, virtual_target);
  EXPECT_NEAR(gap.gap_deg, 12.0, 1e-12);
  EXPECT_NEAR(gap.max_gap_deg, 11.25, 1e-9);
  EXPECT_NEAR(gap.paper_max_gap_deg, 84.5 * 0.2 / 0.8, 1e-12);
}

// The default start is 5 cm from the centre, towards the user. From there, a target 5 cm to the right of the centre is
// 45 degrees to the right.
TEST_F(GapTest, DirectionsAreMeasuredFromTheStart) {
  hrt_target_config ahead = placed(HRT_TARGET_VIRTUAL, 0.0, 0.0);
  ahead.position_m[1] = 0.3;
  const hrt_gap gap = gap_of(add(placed(HRT_TARGET_REAL, 0.05, 0.0)), add(ahead));
  EXPECT_NEAR(gap.gap_deg, 45.0, 1e-12);
  EXPECT_EQ(gap.reachable, 0u);
  EXPECT_NEAR(gap.settling_direction_deg, -84.5 * 0.15 / 0.85, 1e-12);
}

// The plate's mid-line is the world's -x (see reach_test.cpp), and the start is at x = 0.05 m: a target at x = -0.05 m
// and z = -0.1 m, relative to the plate, is 0.1 m ahead and 0.1 m to the right.
TEST_F(GapTest, WorldTargetsAreConvertedToPlateCoordinates) {
  hrt_session_config config = paper_config();
  config.plate.rotation[1] = config.plate.rotation[3] = std::sqrt(0.5);
  config.plate.scale = 1.25;
  create(config);
  hrt_target_config target = target_config(HRT_TARGET_REAL, 0.0);
  target.place = HRT_PLACE_WORLD_POSITION;
  target.position_m[0] = 1.25 * -0.05;
  target.position_m[2] = 1.25 * -0.1;
  EXPECT_NEAR(gap_of(add(target), add(HRT_TARGET_VIRTUAL, 0.0)).gap_deg, 45.0, 1e-9);
}

class AssignTest : public SessionTest {
 protected:
  std::vector<hrt_gap> assign(const std::vector<hrt_target>& virtuals, const std::vector<hrt_target>& reals,
                              std::uint32_t flags) const {
    std::vector<hrt_gap> out(virtuals.size(), output<hrt_gap>());
    EXPECT_OK(hrt_gap_assign(session, virtuals.data(), virtuals.size(), reals.data(), reals.size(), flags, out.size(),
                             out.data()));
    return out;
  }
};

TEST_F(AssignTest, AssignsTheNearestRealTargetOrOneEachIfExclusive) {
  const std::vector<hrt_target> reals{add(HRT_TARGET_REAL, 0.0), add(HRT_TARGET_REAL, 8.0)},
      virtuals{add(HRT_TARGET_VIRTUAL, 5.0), add(HRT_TARGET_VIRTUAL, 9.0)};
  const auto shared = assign(virtuals, reals, 0), exclusive = assign(virtuals, reals, HRT_ASSIGN_EXCLUSIVE);
  EXPECT_EQ(shared[0].real_target.value, reals[1].value);
  EXPECT_EQ(shared[1].real_target.value, reals[1].value);
  EXPECT_EQ(exclusive[0].real_target.value, reals[0].value);
  EXPECT_EQ(exclusive[1].real_target.value, reals[1].value);
  EXPECT_TRUE(same(exclusive[0], gap_of(reals[0], virtuals[0])));
}

// At the same duration, a finger moves faster to a farther target: less of the cue of touch decays between ridges, so
// the feasible gap is larger.
TEST_F(AssignTest, AssignsTheSmallestRatioInAnyOrder) {
  hrt_session_config config = session_config();
  know_person(&config, {0.25, 0.0, 10.0, 0.0, 0.0, 0.3, -0.4, 0.6, 1.0}, 1e-4);
  ASSERT_OK(hrt_session_set(session, &config));
  const auto real_at = [&](double direction_deg, double distance_m) {
    hrt_target_config target = target_config(HRT_TARGET_REAL, direction_deg);
    target.distance_m = distance_m;
    return add(target);
  };
  const hrt_target one = real_at(7.0, 0.02), other = real_at(7.5, 0.30), seen = add(HRT_TARGET_VIRTUAL, 0.0);
  const auto share = [](const hrt_gap& gap) { return std::abs(gap.gap_deg) / gap.max_gap_deg; };
  const bool is_one = share(gap_of(one, seen)) < share(gap_of(other, seen));
  EXPECT_NE(is_one, std::abs(gap_of(one, seen).gap_deg) < std::abs(gap_of(other, seen).gap_deg));
  for (const std::uint32_t flags : {0U, HRT_ASSIGN_EXCLUSIVE})
    for (const auto& reals : {std::vector{one, other}, {other, one}})
      EXPECT_EQ(assign({seen}, reals, flags)[0].real_target.value, (is_one ? one : other).value) << flags;
}

TEST_F(AssignTest, VirtualTargetsWithoutAFeasibleGapAreMarked) {
  const std::vector<hrt_target> reals{add(HRT_TARGET_REAL, -40.0), add(HRT_TARGET_REAL, 0.0)},
      virtuals{add(HRT_TARGET_VIRTUAL, 50.0), add(HRT_TARGET_VIRTUAL, 2.0), add(HRT_TARGET_VIRTUAL, 4.0)};
  const auto shared = assign(virtuals, reals, 0), exclusive = assign(virtuals, reals, HRT_ASSIGN_EXCLUSIVE);
  for (const auto& assigned : {shared, exclusive}) {
    EXPECT_EQ(assigned[0].reachable, 0u);
    EXPECT_EQ(assigned[0].real_target.value, 0u);
    EXPECT_EQ(assigned[0].virtual_target.value, virtuals[0].value);
    EXPECT_NEAR(assigned[0].gap_deg, 50.0, 1e-9);
    EXPECT_LT(assigned[0].margin_deg, 0.0);
  }
  EXPECT_EQ(shared[1].reachable + shared[2].reachable, 2u);
  EXPECT_EQ(exclusive[1].reachable + exclusive[2].reachable, 1u) << "only one real target is near them";
  EXPECT_EQ(exclusive[1].reachable, 1u) << "its gap is smaller";
}

TEST_F(AssignTest, MissingOrRepeatedTargetsAreRejected) {
  const hrt_target real = add(HRT_TARGET_REAL, 0.0), cup = add(HRT_TARGET_VIRTUAL, 5.0);
  const hrt_target reals[]{real, real}, cups[]{cup, cup}, none[]{{0}, {0}};
  hrt_gap out[2]{output<hrt_gap>(), output<hrt_gap>()};
  const hrt_gap before = out[0];
  const auto assign = [&](const hrt_target* v, std::uint64_t vs, const hrt_target* r, std::uint64_t rs,
                          std::uint32_t flags, std::uint64_t capacity,
                          hrt_gap* to) { return hrt_gap_assign(session, v, vs, r, rs, flags, capacity, to); };
  expect_error(assign(cups, 0, reals, 1, 0, 2, out), HRT_ERROR_OUT_OF_RANGE, "virtual_targets");
  expect_error(assign(cups, 1, reals, 1001, 0, 2, out), HRT_ERROR_OUT_OF_RANGE, "allowed: 1 to 1000");
  expect_error(assign(cups, 2, reals, 1, 0, 2, out), HRT_ERROR_OUT_OF_RANGE, "virtual_targets: target");
  expect_error(assign(cups, 1, reals, 2, 0, 2, out), HRT_ERROR_OUT_OF_RANGE, "real_targets: target");
  expect_error(assign(none, 1, reals, 1, 0, 2, out), HRT_ERROR_INVALID_HANDLE, "virtual_targets[0]");
  expect_error(assign(reals, 1, reals, 1, 0, 2, out), HRT_ERROR_OUT_OF_RANGE, "virtual_targets[0]");
  expect_error(assign(cups, 1, reals, 1, 2, 2, out), HRT_ERROR_OUT_OF_RANGE, "flags");
  expect_error(assign(cups, 1, reals, 1, 0, 0, out), HRT_ERROR_BUFFER_TOO_SMALL, "capacity");
  EXPECT_TRUE(same(out[0], before));
}

// The caller was compiled with later headers, so that its array has larger elements.
TEST_F(AssignTest, OutputElementsHaveTheCallersStructSize) {
  const std::vector<hrt_target> reals{add(HRT_TARGET_REAL, 0.0)},
      virtuals{add(HRT_TARGET_VIRTUAL, 5.0), add(HRT_TARGET_VIRTUAL, 6.0)};
  constexpr std::uint32_t later_size = sizeof(hrt_gap) + 8;
  alignas(8) unsigned char out[2 * later_size + 8]{};
  std::memcpy(out, &later_size, sizeof later_size);
  out[2 * later_size] = 77;
  ASSERT_OK(hrt_gap_assign(session, virtuals.data(), 2, reals.data(), 1, 0, 2, reinterpret_cast<hrt_gap*>(out)));
  hrt_target second{};
  std::memcpy(&second, out + later_size + offsetof(hrt_gap, virtual_target), sizeof second);
  EXPECT_EQ(second.value, virtuals[1].value);
  EXPECT_EQ(out[2 * later_size], 77);
}

}  // namespace
}  // namespace hrt::test
