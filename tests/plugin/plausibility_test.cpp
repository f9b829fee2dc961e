// Mistakes of a host (units, axes, clocks), fingers that are not where they should be, and repeated positions.
#include <cmath>
#include <functional>

#include "fixture.h"

namespace hrt::test {
namespace {

class PlausibilityTest : public SessionTest {
 protected:
  /// Runs a reach whose slide, slid_m(), is rotated by `bend_deg`, with a mistake in each sample.
  hrt_reach_summary slide_with(const std::function<void(hrt_sample*)>& mistake, double bend_deg = 0.0) {
    begin_reach();
    for (std::int64_t t = 0; t < 2500; t += 10) {
      hrt_sample sample =
          position_sample(t * ms, -slid_m(t) * sin_deg(bend_deg), -0.05 + slid_m(t) * cos_deg(bend_deg));
      mistake(&sample);
      last = update(sample);
    }
    return end();
  }

  hrt_command last{};
};

TEST_F(PlausibilityTest, MistakesOfUnitsAndAxesAreFlaggedAndLogged) {
  struct Case {
    std::function<void(hrt_sample*)> mistake;
    double bend_deg;
    const char* logged;
  };
  const Case cases[] = {
      {[](hrt_sample* s) { s->time_ns = 7; }, 0.0, "times advance by 0 ns per sample"},
      {[](hrt_sample* s) { s->time_ns /= 1'000'000'000; }, 0.0, "time_ns"},
      {[](hrt_sample* s) { s->time_ns /= 1'000'000; }, 0.0, "times advance by 10 ns per sample"},
      {[](hrt_sample* s) { s->time_ns /= 1'000; }, 0.0, "times advance by 10000 ns per sample"},
      {[](hrt_sample* s) {
         for (double& m : s->finger_position_m) m *= 100.0;
       },
       0.0, "metres"},
      {[](hrt_sample* s) { s->finger_position_m[2] = 0.1 - s->finger_position_m[2]; }, 0.0, "swapped or mirrored axes"},
      {[](hrt_sample* s) { s->finger_position_m[0] += 0.5; }, 0.0, "check the plate's pose"},
      {[](hrt_sample*) {}, 20.0, "counter-clockwise"},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.logged);
    Log log;
    create(session_config());
    EXPECT_EQ(slide_with(c.mistake, c.bend_deg).flags & HRT_COMMAND_IMPLAUSIBLE, HRT_COMMAND_IMPLAUSIBLE);
    EXPECT_EQ(last.flags & HRT_COMMAND_IMPLAUSIBLE, HRT_COMMAND_IMPLAUSIBLE);
    destroy();
    EXPECT_NE(log.text.find(c.logged), std::string::npos) << log.text;
  }
}

TEST_F(PlausibilityTest, DirectionsInRadiansAreFlaggedAndLogged) {
  for (const bool is_mistake : {false, true}) {
    const double unit = is_mistake ? rad_per_deg : 1.0;
    Log log;
    create(session_config());
    const hrt_target real = add(HRT_TARGET_REAL, 0.0), seen = add(HRT_TARGET_VIRTUAL, 5.0 * unit);
    const auto is_flagged = [&] {
      EXPECT_OK(begin(real, seen));
      const bool in_command = (update(position_sample(0, 0.0, -0.05)).flags & HRT_COMMAND_IMPLAUSIBLE) != 0;
      EXPECT_EQ((end().flags & HRT_COMMAND_IMPLAUSIBLE) != 0, in_command);
      return in_command;
    };
    EXPECT_FALSE(is_flagged()) << "a single target may be at a small angle";
    add(HRT_TARGET_VIRTUAL, -10.0 * unit);
    EXPECT_EQ(is_flagged(), is_mistake);
    destroy();
    EXPECT_EQ(log.text.find("radians") != std::string::npos, is_mistake) << log.text;
  }
}

TEST_F(PlausibilityTest, CorrectReachIsNotFlagged) {
  for (const double bend_deg : {-8.0, 0.0, 8.0}) {
    create(session_config());
    EXPECT_EQ(slide_with([](hrt_sample*) {}, bend_deg).flags & HRT_COMMAND_IMPLAUSIBLE, 0u) << bend_deg;
    EXPECT_EQ(last.flags & HRT_COMMAND_ARRIVED, HRT_COMMAND_ARRIVED) << bend_deg;
  }
}

TEST_F(PlausibilityTest, TargetsFarOffThePlateAreFlaggedInTheFirstCommand) {
  ASSERT_OK(begin(add(placed(HRT_TARGET_REAL, 0.0, 0.4)), add(HRT_TARGET_VIRTUAL, 5.0)));
  EXPECT_EQ(update(position_sample(0, 0.0, -0.05)).flags & HRT_COMMAND_IMPLAUSIBLE, HRT_COMMAND_IMPLAUSIBLE);
}

TEST_F(PlausibilityTest, FingerThatRestsElsewhereDoesNotArrive) {
  for (const auto& [right_m, forward_m] : {std::pair{0.0, -0.5}, {0.2, -0.05}, {0.0, -0.15}, {0.0087, 0.0496}}) {
    create(session_config());
    begin_reach();
    hrt_command command{};
    for (std::int64_t t = 0; t < 3000; t += 11) command = update(position_sample(t * ms, right_m, forward_m));
    EXPECT_EQ(command.flags & (HRT_COMMAND_ARRIVED | HRT_COMMAND_NOT_AT_START | HRT_COMMAND_MISS_UNKNOWN),
              HRT_COMMAND_NOT_AT_START | HRT_COMMAND_MISS_UNKNOWN);
    const hrt_reach_summary summary = end();
    EXPECT_EQ(summary.flags & (HRT_COMMAND_NOT_AT_START | HRT_COMMAND_MISS_UNKNOWN),
              HRT_COMMAND_NOT_AT_START | HRT_COMMAND_MISS_UNKNOWN);
    EXPECT_EQ(summary.miss_sd_deg, 180.0);
  }
}

TEST_F(PlausibilityTest, FingerThatMovesAwayIsOffTarget) {
  begin_reach();
  bool off_target = false, arrived = false;
  for (std::int64_t t = 0; t < 4000; t += 11) {
    const double moved_m = 0.1 * std::clamp(static_cast<double>(t - 300) / 1500.0, 0.0, 1.0);
    const hrt_command command = update(position_sample(t * ms, 0.0, -0.05 - moved_m));
    off_target = off_target || (command.flags & HRT_COMMAND_OFF_TARGET) != 0;
    arrived = arrived || (command.flags & HRT_COMMAND_ARRIVED) != 0;
  }
  EXPECT_TRUE(off_target);
  EXPECT_FALSE(arrived);
}

// Passing each position three times gives the same result as passing it once, followed by two dropouts.
TEST_F(PlausibilityTest, RepeatedPositionsAreDropouts) {
  hrt_reach_summary copied{}, dropped{};
  for (const bool copies : {true, false}) {
    create(session_config());
    begin_reach();
    hrt_sample kept{};
    for (int frame = 0; frame < 220; ++frame) {
      const double noise_m = 3e-4 * std::sin(7.0 * frame);
      hrt_sample sample = position_sample(frame * 11 * ms, noise_m, -0.05 + noise_m + slid_m(frame * 11));
      if (frame % 3 == 0) kept = sample;
      if (copies) {
        std::copy(std::begin(kept.finger_position_m), std::end(kept.finger_position_m), sample.finger_position_m);
      } else if (frame % 3 != 0) {
        sample.flags = 0;
      }
      last = update(sample);
    }
    EXPECT_EQ(last.flags & (HRT_COMMAND_ARRIVED | HRT_COMMAND_MISFIT), HRT_COMMAND_ARRIVED);
    (copies ? copied : dropped) = end();
  }
  EXPECT_EQ(copied.miss_deg, dropped.miss_deg);
  EXPECT_EQ(copied.misfit, dropped.misfit);
  EXPECT_EQ(copied.learnt.tracker_noise_m, dropped.learnt.tracker_noise_m);
}

// A tracker that rounds repeats the same position while the finger rests.
TEST_F(PlausibilityTest, RestUnderARoundingTrackerIsDetected) {
  for (const double step_m : {1e-4, 1e-3}) {
    create(session_config());
    slide_with([step_m](hrt_sample* s) {
      for (double& m : s->finger_position_m) m = step_m * std::round(m / step_m);
    });
    EXPECT_EQ(last.flags & HRT_COMMAND_ARRIVED, HRT_COMMAND_ARRIVED) << step_m;
  }
}

}  // namespace
}  // namespace hrt::test
