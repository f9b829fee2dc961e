#include "core/simulation/tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/math/elementary.h"

namespace hrt {
namespace {

constexpr PlatePoint tracked_start{0.0, 0.0};

// Samples of a finger at `finger(time)`.
template <class Finger>
std::vector<FingerSample> seen(const TrackerModel& model, std::uint32_t reach, double duration_s, Finger&& finger) {
  Tracker tracker(model, tracked_start, Draws(1, 0, 0, reach));
  std::vector<FingerSample> samples;
  for (int ms = 0; ms < static_cast<int>(1e3 * duration_s); ++ms) {
    tracker.sample_if_due(1e-3 * ms, finger(1e-3 * ms));
    while (const auto sample = tracker.arrived(1'000'000LL * ms)) samples.push_back(*sample);
  }
  return samples;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// A motion at 100 mm/s from 0.5 s to 1.5 s.
PlatePoint slide(double time_s) { return {0.0, 100.0 * std::min(1.0, std::max(0.0, time_s - 0.5))}; }

// Half of the mean square difference at a lag t, for a process with two time constants a and b, is sigma^2 (1 - (a
// e^(-t / a) - b e^(-t / b)) / (a - b)): at 14 ms about a quarter of the value with the time constant a alone.
TEST(SimulatedTracker, SmoothedNoise_HasItsSdAndSmallSteps) {
  TrackerModel model{.rate_hz = 1000.0 / 14.0, .white_mm = 0.0, .correlated_mm = 1.3, .correlation_s = 0.131};
  model.smoothing_s = 0.022;
  std::vector<double> places, steps;
  for (std::uint32_t reach = 0; reach < 40; ++reach) {
    const auto samples = seen(model, reach, 10.0, [](double) { return tracked_start; });
    for (std::size_t i = 1; i < samples.size(); ++i) {
      places.push_back(samples[i].position.right_mm);
      steps.push_back(samples[i].position.right_mm - samples[i - 1].position.right_mm);
    }
  }
  EXPECT_NEAR(root_mean_square(places), 1.3, 0.05);
  EXPECT_NEAR(root_mean_square(steps) / std::sqrt(2.0), 0.24, 0.06) << "0.21 mm were measured";
}

TEST(SimulatedTracker, TheBearingOfAReach_HasItsSd) {
  TrackerModel model{.white_mm = 0.0};
  model.bearing_sd_deg = 2.9;
  std::vector<double> errors_deg;
  for (std::uint32_t reach = 0; reach < 400; ++reach)
    errors_deg.push_back(bearing_deg(tracked_start, seen(model, reach, 2.0, slide).back().position));
  EXPECT_NEAR(root_mean_square(errors_deg), 2.9, 0.3);
}

TEST(SimulatedTracker, AStop_IsFollowedByCreep) {
  TrackerModel model{.rate_hz = 100.0, .white_mm = 0.0};
  model.creep_mm = 6.0;
  const auto samples = seen(model, 0, 2.5, slide);
  const auto off_mm = [&](double time_s) {
    const FingerSample& sample = samples[static_cast<std::size_t>(100.0 * time_s)];
    return distance_mm(sample.position, slide(time_s));
  };
  EXPECT_EQ(off_mm(0.4), 0.0);
  EXPECT_NEAR(off_mm(1.0), 6.0, 1.1);  // includes the motion within a sample
  EXPECT_NEAR(off_mm(1.7), 6.0 * std::exp(-1.0), 0.4);
  EXPECT_LT(off_mm(2.4), 0.1);
}

TEST(SimulatedTracker, TheConfiguredFractionOfReaches_LosesTrackingAtTheEnd) {
  TrackerModel model{.rate_hz = 71.0, .white_mm = 0.0};
  model.end_loss_share = 0.14;
  model.excursions_hz = 1.0 / 12.0;
  int lost = 0;
  double excursions_s = 0.0;
  for (std::uint32_t reach = 0; reach < 500; ++reach) {
    bool is_lost = false;
    for (const FingerSample& sample : seen(model, reach, 3.0, slide)) {
      const double time_s = 1e-9 * static_cast<double>(sample.time_ns);
      const double off_mm = distance_mm(sample.position, slide(time_s));
      if (time_s < 0.5) excursions_s += off_mm > 5.0 ? 1.0 / 71.0 : 0.0;
      is_lost = is_lost || (time_s > 1.5 && off_mm > 100.0);
      EXPECT_LT(off_mm, 902.0) << "an excursion is at most 900 mm, and the finger moves within a sample";
    }
    lost += is_lost;
  }
  EXPECT_NEAR(lost / 500.0, 0.14, 0.05);
  EXPECT_GT(excursions_s, 0.0);
  EXPECT_LT(excursions_s, 500.0 * 0.5 / 12.0 * 0.1);
}

TEST(SimulatedTracker, ABurst_DisplacesItsSamples) {
  TrackerModel model{.white_mm = 0.0};
  model.burst_mm = 100.0;
  model.burst_at_s = 0.2;
  model.burst_samples = 2;
  const auto samples = seen(model, 0, 0.4, [](double) { return tracked_start; });
  for (const FingerSample& sample : samples) {
    const bool displaced = sample.time_ns >= 200'000'000 && sample.time_ns < 220'000'000;
    EXPECT_NEAR(distance_mm(tracked_start, sample.position), displaced ? 100.0 : 0.0, 1e-9) << sample.time_ns;
  }
}

TEST(SimulatedTracker, LateSamples_HaveAnUnequalLatency) {
  TrackerModel model{.rate_hz = 100.0, .latency_s = 0.03, .late_s = 0.008};
  double earliest_s = 1.0, latest_s = 0.0;
  for (const FingerSample& sample : seen(model, 0, 3.0, slide)) {
    const double late_s = std::remainder(1e-9 * static_cast<double>(sample.time_ns) - 0.034, 0.01) + 0.034;
    earliest_s = std::min(earliest_s, late_s);
    latest_s = std::max(latest_s, late_s);
  }
  EXPECT_NEAR(earliest_s, 0.03, 1e-3);
  EXPECT_NEAR(latest_s, 0.038, 1e-3);
}

}  // namespace
}  // namespace hrt
