// Tests the detectors of touches and slides, the diagnosis of mistakes, and the store of slides.
#include <gtest/gtest.h>

#include <cmath>

#include "core/setup/setup.h"
#include "core/setup/setup_progress.h"
#include "core/simulation/random.h"
#include "tests/times.h"

namespace hrt {
namespace {

constexpr PlatePoint slide_start{0.0, -50.0};

SetupSample at(std::int64_t time_ms, double right_mm, double away_mm) {
  SetupSample sample{.time_ns = time_ms * ms, .tracked_mm = Eigen::Vector3d(right_mm, 0.0, -away_mm)};
  sample.on_plate = {.time_ns = sample.time_ns,
                     .observation = Observation::position,
                     .position = {right_mm, away_mm},
                     .plate_orientation_deg = 0.0};
  return sample;
}

SetupSample lost(std::int64_t time_ms) {
  SetupSample sample{.time_ns = time_ms * ms};
  sample.on_plate = {.time_ns = sample.time_ns, .plate_orientation_deg = 0.0};
  return sample;
}

TEST(MarkTouches, AMotionAndARest_AreOneTouch) {
  MarkTouches touches;
  touches.begin(2);
  int t = 0;
  for (; t <= 900; t += 10) touches.observe(at(t, 0.0, 0.0));
  EXPECT_EQ(touches.count(), 0) << "the finger rested there before the request";
  for (; t <= 1800; t += 10) touches.observe(at(t, 20.0, 0.0));
  ASSERT_EQ(touches.count(), 1);
  EXPECT_NEAR(touches[0].touched_mm.x(), 20.0, 1e-9);
  for (; t <= 2700; t += 10) touches.observe(at(t, 20.0, 0.0));
  EXPECT_EQ(touches.count(), 1) << "the same rest";
  for (; t <= 2800; t += 10) touches.observe(lost(t));
  for (; t <= 3600; t += 10) touches.observe(at(t, 20.0, 0.0));
  EXPECT_TRUE(touches.complete()) << "the finger was lost, and may have touched again";
}

// Touches of one mark with lifts of 40 mm at 0.4 m/s: each rest is one touch, and the reversal at the top is not.
TEST(MarkTouches, ABriefLift_SeparatesTwoTouches) {
  for (const int period_ms : {4, 11, 17, 33}) {
    Draws draws(6, 0, 0, 0);
    MarkTouches touches;
    touches.begin(MarkTouches::max_touches);
    int held = 0, t = 0;
    for (; t < 10 * 1600; t += period_ms) {  // 0.2 s of motion, 1.4 s of rest
      const double height_mm = std::max(0.0, 40.0 - 0.4 * std::abs(t % 1600 - 100));
      SetupSample sample = at(t, 1.2 * draws.normal(), 1.2 * draws.normal());
      sample.tracked_mm->y() = height_mm + 1.2 * draws.normal();
      const int before = touches.count();
      touches.observe(sample);
      EXPECT_TRUE(touches.count() == before || t % 1600 > 800) << period_ms;
      held += touches.holding() && t % 1600 < 200;
    }
    EXPECT_EQ(touches.count(), 10) << period_ms;
    EXPECT_EQ(held, 0) << period_ms;
  }
}

class SlideWatchTest : public ::testing::Test {
 protected:
  SlideWatchTest() {
    watch.begin(slide_start, 100.0, 0.0);
    for (; t < 700; t += 10) watch.observe(at(t, 0.0, -50.0));
    EXPECT_EQ(watch.phase(), SlideWatch::Phase::slide);
  }

  void go(double right_mm, double away_mm, int duration_ms) {
    for (const int began = t; t <= began + duration_ms; t += 10) {
      const double share = static_cast<double>(t - began) / duration_ms;
      watch.observe(at(t, share * right_mm, -50.0 + share * (away_mm + 50.0)));
    }
  }
  void stay(double right_mm, double away_mm, int duration_ms) {
    for (const int began = t; t <= began + duration_ms; t += 10) watch.observe(at(t, right_mm, away_mm));
  }
  void expect_problem(SetupProblem problem) const {
    EXPECT_EQ(watch.problem(), problem);
    EXPECT_NE(watch.phase(), SlideWatch::Phase::slide);
    EXPECT_NE(watch.phase(), SlideWatch::Phase::done);
  }

  SlideWatch watch;
  int t = 0;
};

TEST_F(SlideWatchTest, ARestAfterASlide_EndsIt) {
  go(0.0, 50.0, 1000);
  EXPECT_EQ(watch.phase(), SlideWatch::Phase::slide);
  stay(0.0, 50.0, 700);
  EXPECT_EQ(watch.phase(), SlideWatch::Phase::done);
}

TEST_F(SlideWatchTest, ALongPause_StopsTheSlideAndAShortOneDoesNot) {
  go(0.0, -20.0, 400);
  stay(0.0, -20.0, 800);
  EXPECT_EQ(watch.phase(), SlideWatch::Phase::slide);
  stay(0.0, -20.0, 1200);
  expect_problem(SetupProblem::stopped);
}

struct BadSlide {
  double right_mm, away_mm;
  int moving_ms, resting_ms;
  SetupProblem problem;
};

class BadSlideTest : public SlideWatchTest, public ::testing::WithParamInterface<BadSlide> {};

TEST_P(BadSlideTest, ABadSlide_HasItsProblem) {
  const BadSlide& slide = GetParam();
  go(slide.right_mm, slide.away_mm, slide.moving_ms);
  stay(slide.right_mm, slide.away_mm, slide.resting_ms);
  expect_problem(slide.problem);
}

INSTANTIATE_TEST_SUITE_P(Slides, BadSlideTest,
                         ::testing::Values(BadSlide{60.0, -40.0, 1000, 2000, SetupProblem::stopped},
                                           BadSlide{0.0, 50.0, 150, 600, SetupProblem::too_fast},
                                           BadSlide{0.0, 50.0, 9400, 0, SetupProblem::too_slow}));

TEST_F(SlideWatchTest, ALift_FailsTheSlide) {
  go(0.0, 0.0, 500);
  for (int i = 0; i < 20; ++i, t += 10) {
    SetupSample sample = at(t, 0.0, 0.0);
    sample.on_plate.observation = Observation::lifted;
    watch.observe(sample);
  }
  expect_problem(SetupProblem::left_plate);
}

TEST_F(SlideWatchTest, ALongDropout_FailsTheSlideAndAShortOneDoesNot) {
  go(0.0, 0.0, 500);
  for (int i = 0; i < 40; ++i, t += 10) watch.observe(lost(t));
  EXPECT_EQ(watch.phase(), SlideWatch::Phase::slide) << "a dropout";
  for (int i = 0; i < 20; ++i, t += 10) watch.observe(lost(t));
  expect_problem(SetupProblem::lost);
}

TEST_F(SlideWatchTest, ARotatingPlate_FailsTheSlide) {
  go(0.0, 0.0, 500);
  SetupSample sample = at(t, 0.0, 0.0);
  sample.on_plate.plate_orientation_deg = 184.0;
  watch.observe(sample);
  EXPECT_EQ(watch.phase(), SlideWatch::Phase::slide) << "the same ridges";
  sample.on_plate.plate_orientation_deg = 6.0;
  watch.observe(sample);
  expect_problem(SetupProblem::moved);
}

TEST_F(SlideWatchTest, OneOutlier_IsNoSlide) {
  watch.observe(at(t, 0.0, 50.0));
  stay(0.0, -50.0, 2000);
  EXPECT_EQ(watch.phase(), SlideWatch::Phase::slide);
  EXPECT_FALSE(watch.has_left());
}

TEST(Setup, PlannedAngles_AlternateAndDiffer) {
  for (int i = 0; i < first_slides; ++i) {
    EXPECT_LE(std::abs(planned_share(i)), 0.8);
    if (i > 0 && planned_share(i) * planned_share(i - 1) != 0.0) {
      EXPECT_LT(planned_share(i) * planned_share(i - 1), 0.0) << i;
    }
    for (int k = 0; k < i; ++k) EXPECT_NE(planned_share(i), planned_share(k));
    EXPECT_EQ(planned_share(i + first_slides), -planned_share(i));
  }
}

TEST(SetupProgress, AFingerThatDoesNotRestAtItsMark_IsReportedAfter20Seconds) {
  SetupProgress progress;
  for (int t = 0; t <= 25'000; t += 100) {
    progress.observe(at(t, 0.0, 0.0));
    const Observed found = progress.observed(PlatePoint{10.0, 0.0}, std::nullopt);
    EXPECT_EQ(found.kind, t < 20'000 ? Observed::Kind::none : Observed::Kind::no_rest) << t;
    EXPECT_EQ(found.first, 0.0);
  }
}

TEST(SlideStore, ALongRest_IsShortened) {
  SlideStore store(16, 600);
  store.begin(0.0);
  for (int t = 0; t < 60'000; t += 4) {
    ASSERT_TRUE(store.add(at(t, 0.0, 0.0).on_plate));
    store.shorten_rest();
  }
  store.end();
  const auto trials = store.trials();
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_GE(trials[0].samples.size(), 250u);
  EXPECT_EQ(trials[0].samples.size(), trials[0].plate_deg.size());
  EXPECT_EQ(trials[0].samples.back().time_s, 59.996);
}

}  // namespace
}  // namespace hrt
