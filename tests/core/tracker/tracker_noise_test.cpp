#include "core/tracker/tracker_noise.h"

#include <gtest/gtest.h>

#include <cmath>
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
  double step_mm = 0.0;  // step to which positions are rounded
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

TEST(TrackerNoise, NoOrShortRests_GiveUnknownNoise) {
  expect_unknown(fit_rest_noise({}));
  const Rests empty(3);
  expect_unknown(fit_rest_noise(empty));
  const SimulatedTracker tracker{"white", 1.2, 0.0, 0.1, 90.0};
  expect_unknown(fit_rest_noise(simulate_rests(tracker, 1, 0.5, 0)));
}

// The correlated part is given only if its interval excludes 0 and its time constant is known.
TEST(TrackerNoise, KnownParts_AreGivenToTheController) {
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

TEST(TrackerNoise, AConstantPosition_GivesUnknownNoise) {
  std::vector<TimedPoint> rest;
  for (int i = 0; i < 500; ++i) rest.push_back({0.01 * i, {100.0, 200.0}});
  expect_unknown(fit_rest_noise({&rest, 1}));
}

TEST(TrackerNoise, AlternatingPositions_GiveUnknownNoise) {
  std::vector<TimedPoint> rest;
  for (int i = 0; i < 500; ++i) rest.push_back({0.01 * i, {i % 2 ? 1.0 : -1.0, 0.0}});
  expect_unknown(fit_rest_noise({&rest, 1}));
}

TEST(TrackerNoise, ATremor_GivesUnknownNoise) {
  Rests rests = simulate_rests({"white", 0.3, 0.0, 0.1, 90.0}, 10, 1.0, 0);
  for (auto& rest : rests)
    for (TimedPoint& sample : rest) sample.position.right_mm += std::sin(6.283185307 * 10.0 * sample.time_s);
  expect_unknown(fit_rest_noise(rests));
}

TEST(TrackerNoise, NoiseBelowTheRounding_IsUnknown) {
  const SimulatedTracker tracker{"coarse", 0.3, 0.0, 0.1, 90.0, 0.0, 0.0, 2.0};
  expect_unknown(fit_rest_noise(simulate_rests(tracker, 20, 0.5, 0)));
}

TEST(TrackerNoise, AnotherPositionAndUnit_ScalesTheNoise) {
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

// The SD of n values of white noise has a relative error of 1 / sqrt(2 n), which gives the width min_mm.
TEST(TrackerNoise, WhiteNoise_HasAnIntervalOfTheExpectedWidth) {
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

struct Coverage {
  double truth;
  int known = 0;    // number of people for whom the value is known
  int covered = 0;  // number of these people whose interval covers the truth

  void count(const Interval& interval) {
    EXPECT_LE(interval.lower, interval.value);
    EXPECT_GE(interval.upper, interval.value);
    known += interval.known;
    covered += interval.known && interval.lower <= truth && truth <= interval.upper;
  }
};

// With a coverage of 95 %, the probability that more than 8 of 40 intervals miss the truth is below 0.1 %.
TEST_P(TrackerNoiseCoverage, SimulatedTrackers_LieWithinTheKnownIntervals) {
  const SimulatedTracker& tracker = GetParam();
  constexpr int people = 40;
  Coverage white{std::hypot(tracker.white_mm, tracker.step_mm / std::sqrt(12.0))};
  Coverage correlated{tracker.correlated_mm}, time{tracker.correlation_s};
  for (std::uint32_t person = 0; person < people; ++person) {
    const RestNoise noise = fit_rest_noise(simulate_rests(tracker, 20, 0.5, person));
    white.count(noise.white_mm);
    correlated.count(noise.correlated_mm);
    time.count(noise.correlation_s);
  }
  for (const Coverage& coverage : {white, correlated, time}) EXPECT_GE(coverage.covered, coverage.known - 8);
  if (tracker.correlated_mm > 0.0 && tracker.correlation_s * tracker.rate_hz < 1.5) {
    EXPECT_LE(time.known, people / 20) << "white and correlated noise cannot be separated";
    return;
  }
  // Rests of half a second are short for a noise with a long time constant.
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
                         testing::Values(SimulatedTracker{"FineWhite", 0.3, 0.0, 0.1, 120.0, 0.5, 0.03, 0.1},
                                         SimulatedTracker{"Fast30At30Hz", 0.6, 1.04, 0.03, 30.0, 0.3},
                                         SimulatedTracker{"Slow300", 0.0, 1.2, 0.3, 90.0, 0.3},
                                         SimulatedTracker{"Mixed50Coarse", 0.6, 1.04, 0.05, 120.0, 0.3, 0.03, 0.5}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace hrt
