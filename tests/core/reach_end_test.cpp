#include "core/reach_end.h"

#include <gtest/gtest.h>

#include "core/person/person_model.h"
#include "core/simulation/tracker.h"
#include "tests/times.h"

namespace hrt {
namespace {

constexpr PlatePoint start, target{0.0, 100.0};

FingerSample position_at(std::int64_t time_ns, const PlatePoint& position) {
  return {.time_ns = time_ns, .observation = Observation::position, .position = position};
}

// Passes samples to ReachEnd and to the phase detector that ReachEnd needs.
class ObservedReach {
 public:
  explicit ObservedReach(bool start_is_felt = false) : end_(start, target, start_is_felt) {}

  void observe(const FingerSample& sample) {
    if (sample.observation == Observation::lifted) finger_.lift();
    if (sample.observation == Observation::position) finger_.observe(sample.time_ns, sample.position);
    end_.observe(sample, finger_);
  }
  void retarget(const PlatePoint& to, const PlatePoint& finger) { end_.retarget(to, finger); }
  const ReachProgress& progress() const { return end_.progress(); }
  bool came_to_start() const { return end_.came_to_start(); }

 private:
  FingerPhase finger_;
  ReachEnd end_;
};

// Observes a finger at `place` from `from_ms` to `to_ms`. Returns the time, in ms, at which the reach was over, or -1.
int rest(ObservedReach& end, const PlatePoint& place, int from_ms, int to_ms) {
  for (int t = from_ms; t < to_ms; t += 10) {
    end.observe(position_at(t * ms, place));
    if (end.progress().arrived) return t;
  }
  return -1;
}

struct Rest {
  PlatePoint place;
  int over_ms;  // time from the arrival at the position; -1: never
  bool off_target;
};

// The finger rests at the start, jumps to a position and rests there.
TEST(ReachEnd, RestsAtPositions_EndTheReachAfterTheDocumentedTimes) {
  for (const Rest& expected :
       {Rest{{0.0, 91.0}, 400, false}, Rest{{0.0, 89.0}, 2000, false}, Rest{{20.0, 98.0}, 400, false},
        Rest{{0.0, 31.0}, 2000, true}, Rest{{0.0, 29.0}, -1, false}, Rest{{0.0, 130.0}, 2000, true},
        Rest{{0.0, -100.0}, -1, true}, Rest{{100.0, 0.0}, -1, true}, Rest{{0.0, -20.0}, -1, false}}) {
    ObservedReach end;
    EXPECT_EQ(rest(end, start, 0, 500), -1);
    EXPECT_FALSE(end.progress().not_at_start);
    const int over_ms = rest(end, expected.place, 500, 4000);
    EXPECT_NEAR(over_ms, expected.over_ms < 0 ? -1 : 500 + expected.over_ms, 30) << expected.place.away_mm;
    EXPECT_EQ(end.progress().off_target, expected.off_target)
        << expected.place.right_mm << ' ' << expected.place.away_mm;
  }
}

// A finger that rests elsewhere from the beginning has not arrived, even at the target.
TEST(ReachEnd, ARestAwayFromTheStart_DoesNotBeginTheReach) {
  for (const PlatePoint& place : {target, PlatePoint{0.0, 500.0}, PlatePoint{200.0, 0.0}, PlatePoint{0.0, -100.0}}) {
    ObservedReach end;
    EXPECT_EQ(rest(end, place, 0, 4000), -1);
    EXPECT_TRUE(end.progress().not_at_start);
  }
}

TEST(ReachEnd, AFingerThatComesToTheStart_BeginsTheReach) {
  ObservedReach end;
  EXPECT_EQ(rest(end, {0.0, -100.0}, 0, 1000), -1);
  bool came = false;
  for (int t = 1000; t < 3000; t += 10) {
    end.observe(position_at(t * ms, {0.0, std::min(0.0, -100.0 + 0.1 * (t - 1000))}));
    came = came || end.came_to_start();
  }
  EXPECT_TRUE(came);
  EXPECT_FALSE(end.progress().not_at_start);
}

// The user feels the start, which is tracked 30 mm to the right.
TEST(ReachEnd, AFeltStart_IsTheRestPosition) {
  ObservedReach end(true);
  EXPECT_EQ(rest(end, {30.0, 0.0}, 0, 500), -1);
  EXPECT_FALSE(end.progress().not_at_start);
  for (int t = 500; t < 1000; t += 10) end.observe(position_at(t * ms, {30.0, 0.196 * (t - 500)}));
  EXPECT_NEAR(rest(end, {30.0, 98.0}, 1000, 3000), 1400, 100);
}

TEST(ReachEnd, ASmallRetarget_KeepsTheRestAndAJumpRestartsIt) {
  ObservedReach end;
  rest(end, start, 0, 500);
  for (int t = 500; t < 900; t += 10) {
    end.retarget({0.0, 100.0 + 1e-3 * t}, {0.0, 100.0});
    end.observe(position_at(t * ms, {0.0, 100.0}));
  }
  EXPECT_NEAR(rest(end, {0.0, 100.0}, 900, 2000), 900, 30);
  end.retarget({40.0, 100.0}, {0.0, 100.0});
  EXPECT_EQ(rest(end, {0.0, 100.0}, 2000, 6000), -1);
  EXPECT_NEAR(rest(end, {39.0, 100.0}, 6000, 9000), 6400, 30);
}

TEST(ReachEnd, ACreepingFinger_RestsAndASlidingOneDoesNot) {
  for (const double speed_mm_s : {2.0, 40.0}) {
    ObservedReach end;
    rest(end, start, 0, 500);
    for (int t = 500; t < 1100; t += 10) end.observe(position_at(t * ms, {0.0, 93.0 + 1e-3 * speed_mm_s * (t - 500)}));
    EXPECT_EQ(end.progress().arrived, speed_mm_s < 10.0);
  }
}

TEST(ReachEnd, LiftsAndGaps_AreNoRest) {
  for (const bool lifted : {true, false}) {
    ObservedReach end;
    rest(end, start, 0, 500);
    for (int t = 600; t < 3600; t += 10) {
      FingerSample sample = position_at(t * ms, target);
      if (lifted && t % 300 == 0) sample.observation = Observation::lifted;
      if (lifted || t % 600 < 250) end.observe(sample);
    }
    EXPECT_FALSE(end.progress().arrived) << lifted;
  }
}

// A minimum-jerk motion with a pause of 0.3 s at 70 % of its duration. At 80 %, 94 % of the path are covered.
TEST(ReachEnd, AMotion_EndsSoonAfterItsStopAndNotBefore) {
  int early = 0;
  for (const double rate_hz : {30.0, 90.0, 1000.0}) {
    for (const double noise_mm : {0.0, 1.2, 3.0}) {
      for (const double duration_s : {0.8, 1.5, 3.0}) {
        for (std::uint32_t i = 0; i < 40; ++i) {
          ObservedReach end;
          Tracker tracker({.rate_hz = rate_hz, .white_mm = noise_mm}, {}, Draws(3, i, 0, 0));
          const double pause_s = 0.7 * duration_s;
          for (int t = 0; t < 1000.0 * duration_s + 1600.0; ++t) {
            const double moved_s = 1e-3 * (t - 300);
            const double clock_s = moved_s < pause_s ? moved_s : std::max(pause_s, moved_s - 0.3);
            tracker.sample_if_due(1e-3 * t, {0.0, 100.0 * progress(0.0, clock_s / duration_s).share});
            while (const auto sample = tracker.arrived(t * ms)) end.observe(*sample);
            early += clock_s < 0.8 * duration_s && end.progress().arrived;
          }
          EXPECT_TRUE(end.progress().arrived) << rate_hz << ' ' << noise_mm << ' ' << duration_s;
        }
      }
    }
  }
  EXPECT_EQ(early, 0);
}

}  // namespace
}  // namespace hrt
