#include "core/tracker/tracker_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/simulation/random.h"

namespace hrt {
namespace {

struct SimulatedTracker {
  const char* name;
  double white_mm;
  double correlated_mm;
  double correlation_s;
  double rate_hz;
  double jitter_share = 0.0;
  double outlier_share = 0.0;
  double step_mm = 0.0;  // positions are rounded to it
};

using Rests = std::vector<std::vector<TimedPoint>>;

Rests simulate_rests(const SimulatedTracker& tracker, int rests, double rest_s, std::uint32_t index) {
  Draws draws(20, 3, index, static_cast<std::uint32_t>(rests));
  const auto rounded = [&](double mm) {
    return tracker.step_mm > 0.0 ? tracker.step_mm * std::round(mm / tracker.step_mm) : mm;
  };
  Rests result;
  for (int r = 0; r < rests; ++r) {
    std::vector<TimedPoint>& rest = result.emplace_back();
    const double place_right_mm = 5.0 * draws.normal();
    const double place_away_mm = 5.0 * draws.normal();
    double right_mm = tracker.correlated_mm * draws.normal();
    double away_mm = tracker.correlated_mm * draws.normal();
    for (double time_s = 0.0; time_s < rest_s;) {
      double seen_right_mm = place_right_mm + right_mm + tracker.white_mm * draws.normal();
      double seen_away_mm = place_away_mm + away_mm + tracker.white_mm * draws.normal();
      if (draws.uniform() < tracker.outlier_share) {
        seen_right_mm += 30.0 * draws.normal();
        seen_away_mm += 30.0 * draws.normal();
      }
      rest.push_back({time_s, {rounded(seen_right_mm), rounded(seen_away_mm)}});
      const double period_s = (1.0 + tracker.jitter_share * (2.0 * draws.uniform() - 1.0)) / tracker.rate_hz;
      time_s += period_s;
      const double kept = std::exp(-period_s / tracker.correlation_s);
      const double fresh_mm = tracker.correlated_mm * std::sqrt(1.0 - kept * kept);
      right_mm = kept * right_mm + fresh_mm * draws.normal();
      away_mm = kept * away_mm + fresh_mm * draws.normal();
    }
  }
  return result;
}

void expect_unknown(const RestNoise& noise) {
  EXPECT_FALSE(noise.white_mm.known);
  EXPECT_FALSE(noise.correlated_mm.known);
  EXPECT_FALSE(noise.correlation_s.known);
}

TEST(TrackerNoise, KnowsNothingFromNothing) {
  expect_unknown(fit_rest_noise({}));
  const Rests empty(3);
  expect_unknown(fit_rest_noise(empty));
  const SimulatedTracker tracker{"white", 1.2, 0.0, 0.1, 90.0};
  expect_unknown(fit_rest_noise(simulate_rests(tracker, 1, 0.5, 0)));
}

// The correlated part goes with its time, and only if there is certainly one.
TEST(TrackerNoise, IsToldToAControllerInPartsIfTheyAreKnown) {
  RestNoise noise{.white_mm = {3.0, 2.0, 4.0, true},
                  .correlated_mm = {4.0, 3.0, 5.0, true},
                  .correlation_s = {0.2, 0.1, 0.3, true}};
  EXPECT_EQ(known_noise(noise)->white_mm, 3.0);
  EXPECT_EQ(known_noise(noise)->correlated_mm, 4.0);
  EXPECT_EQ(known_noise(noise)->correlation_s, 0.2);
  noise.correlation_s.known = false;
  EXPECT_DOUBLE_EQ(known_noise(noise)->white_mm, 5.0);
  EXPECT_EQ(known_noise(noise)->correlated_mm, 0.0);
  noise.correlation_s.known = true;
  noise.correlated_mm.lower = 0.0;
  EXPECT_DOUBLE_EQ(known_noise(noise)->white_mm, 5.0);
  noise.correlated_mm.known = false;
  EXPECT_EQ(known_noise(noise)->white_mm, 3.0);
  noise.white_mm.known = false;
  EXPECT_FALSE(known_noise(noise));
}

TEST(TrackerNoise, KnowsNothingFromAPlaceThatNeverChanges) {
  std::vector<TimedPoint> rest;
  for (int i = 0; i < 500; ++i) rest.push_back({0.01 * i, {100.0, 200.0}});
  expect_unknown(fit_rest_noise({&rest, 1}));
}

TEST(TrackerNoise, SeesAlternatingPlacesAsNoNoiseOfThisKind) {
  std::vector<TimedPoint> rest;
  for (int i = 0; i < 500; ++i) rest.push_back({0.01 * i, {i % 2 ? 1.0 : -1.0, 0.0}});
  expect_unknown(fit_rest_noise({&rest, 1}));
}

TEST(TrackerNoise, SeesATremblingFingerAsNoNoiseOfThisKind) {
  Rests rests = simulate_rests({"white", 0.3, 0.0, 0.1, 90.0}, 10, 1.0, 0);
  for (auto& rest : rests)
    for (TimedPoint& sample : rest) sample.position.right_mm += std::sin(6.283185307 * 10.0 * sample.time_s);
  expect_unknown(fit_rest_noise(rests));
}

TEST(TrackerNoise, WithholdsWhatIsBelowTheRounding) {
  const SimulatedTracker tracker{"coarse", 0.3, 0.0, 0.1, 90.0, 0.0, 0.0, 2.0};
  expect_unknown(fit_rest_noise(simulate_rests(tracker, 20, 0.5, 0)));
}

TEST(TrackerNoise, DoesNotDependOnWhereOrInWhatUnitTheFingerRests) {
  const SimulatedTracker tracker{"mixed", 0.6, 1.04, 0.1, 90.0, 0.3};
  Rests rests = simulate_rests(tracker, 10, 0.5, 1);
  const RestNoise here = fit_rest_noise(rests);
  for (auto& rest : rests)
    for (TimedPoint& sample : rest)
      sample.position = {500.0 + 2.0 * sample.position.away_mm, 2.0 * sample.position.right_mm};
  const RestNoise there = fit_rest_noise(rests);
  EXPECT_NEAR(there.white_mm.value, 2.0 * here.white_mm.value, 1e-5);
  EXPECT_NEAR(there.correlated_mm.upper, 2.0 * here.correlated_mm.upper, 1e-5);
  EXPECT_NEAR(there.correlation_s.value, here.correlation_s.value, 1e-6);
}

// White noise of n values is known to 1 / sqrt(2 n); the interval must be about as wide.
TEST(TrackerNoise, IsAsSureOfWhiteNoiseAsItsVarianceAllows) {
  const SimulatedTracker tracker{"white", 1.2, 0.0, 0.1, 90.0};
  const Rests rests = simulate_rests(tracker, 1, 20.0, 0);
  const RestNoise noise = fit_rest_noise(rests);
  const double min_mm = 2.0 * 1.96 * 1.2 / std::sqrt(2.0 * 2.0 * 1800.0);
  EXPECT_TRUE(noise.white_mm.known);
  EXPECT_GT(noise.white_mm.upper - noise.white_mm.lower, 0.8 * min_mm);
  EXPECT_LT(noise.white_mm.upper - noise.white_mm.lower, 3.0 * min_mm);
  EXPECT_EQ(noise.correlated_mm.lower, 0.0);
  EXPECT_FALSE(noise.correlation_s.known);
}

class TrackerNoiseCoverage : public testing::TestWithParam<SimulatedTracker> {};

// 40 people; of a coverage of 95 % fewer than 32 have a probability of 0.1 %.
TEST_P(TrackerNoiseCoverage, IntervalsCoverWhereverKnown) {
  const SimulatedTracker& tracker = GetParam();
  constexpr int people = 40;
  const double rounding_mm = tracker.step_mm / std::sqrt(12.0);
  struct Count {
    double truth;
    int known = 0;
    int covered = 0;
  };
  Count white{std::hypot(tracker.white_mm, rounding_mm)};
  Count correlated{tracker.correlated_mm};
  Count time{tracker.correlation_s};
  for (int person = 0; person < people; ++person) {
    const RestNoise noise = fit_rest_noise(simulate_rests(tracker, 20, 0.5, static_cast<std::uint32_t>(person)));
    const auto count = [](Count& c, const Interval& interval) {
      EXPECT_LE(interval.lower, interval.value);
      EXPECT_GE(interval.upper, interval.value);
      if (!interval.known) return;
      ++c.known;
      c.covered += interval.lower <= c.truth && c.truth <= interval.upper;
    };
    count(white, noise.white_mm);
    count(correlated, noise.correlated_mm);
    count(time, noise.correlation_s);
  }
  const auto expect_coverage = [](const Count& c) { EXPECT_GE(c.covered, c.known - 8) << c.known; };
  expect_coverage(white);
  expect_coverage(correlated);
  expect_coverage(time);
  std::printf("%-14s of %d: white known %d, covered %d; correlated %d, %d; time %d, %d\n", tracker.name, people,
              white.known, white.covered, correlated.known, correlated.covered, time.known, time.covered);
  if (tracker.correlated_mm > 0.0 && tracker.correlation_s * tracker.rate_hz < 1.5) {
    EXPECT_LE(time.known, people / 20) << "its parts cannot be separated";
    return;
  }
  // Half a second is little of a noise that lasts for long.
  const int min = tracker.correlation_s > 0.2 ? people / 4 : people / 2;
  EXPECT_GE(white.known, min);
  EXPECT_GE(correlated.known, min);
  if (tracker.correlated_mm > 0.0) {
    EXPECT_GE(time.known, min);
  } else {
    EXPECT_LE(time.known, people / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Trackers, TrackerNoiseCoverage,
                         testing::Values(SimulatedTracker{"White", 1.2, 0.0, 0.1, 90.0},
                                         SimulatedTracker{"FineWhite", 0.3, 0.0, 0.1, 120.0, 0.5, 0.03, 0.1},
                                         SimulatedTracker{"Fast30At30Hz", 0.6, 1.04, 0.03, 30.0, 0.3},
                                         SimulatedTracker{"Slow300", 0.0, 1.2, 0.3, 90.0, 0.3},
                                         SimulatedTracker{"Correlated100", 0.0, 1.2, 0.1, 90.0, 0.3},
                                         SimulatedTracker{"Mixed100", 0.6, 1.04, 0.1, 90.0, 0.3, 0.03, 0.1},
                                         SimulatedTracker{"Mixed50Coarse", 0.6, 1.04, 0.05, 120.0, 0.3, 0.03, 0.5}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace hrt
