#include "core/simulation/own_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/simulation/people.h"
#include "core/simulation/person.h"

namespace hrt {
namespace {

double sd_about_zero(const std::vector<double>& values) {
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
                   static_cast<double>(values.size()));
}

Draws draws_of(std::uint32_t person, std::uint32_t reach = 0) { return {1, PersonStream::drawn, person, reach}; }

// SDs of the direction in recordings: of the means of 72 pairs of person and target, and of 1683 reaches about them.
TEST(SimulationOwnPath, DrawnPaths_HaveTheSdOfRecordedReaches) {
  constexpr double fractions[] = {0.05, 0.2, 0.4, 0.6, 0.8, 0.95};
  constexpr double mean_sd_deg[] = {8.7, 4.9, 2.7, 2.2, 5.1, 9.4};
  constexpr double within_sd_deg[] = {11.0, 5.6, 3.9, 3.8, 6.3, 14.0};
  for (std::size_t i = 0; i < std::size(fractions); ++i) {
    std::vector<double> means_deg, deviations_deg;
    for (std::uint32_t person = 0; person < 4000; ++person) {
      Draws draws = draws_of(person);
      const OwnPath path = draw_own_path(1.0, draws);
      means_deg.push_back(own_direction_deg(path, path.mean_deg, fractions[i]));
      deviations_deg.push_back(own_direction_deg(path, draw_shape(path, draws), fractions[i]) - means_deg.back());
    }
    EXPECT_NEAR(sd_about_zero(means_deg), mean_sd_deg[i], 0.1 * mean_sd_deg[i] + 0.2) << fractions[i];
    EXPECT_NEAR(sd_about_zero(deviations_deg), within_sd_deg[i], 0.15 * within_sd_deg[i]) << fractions[i];
  }
}

TEST(SimulationOwnPath, MeanDeflection_IsZeroUnlessReturnsIsFalse) {
  const PathShape shape{3.0, -5.0, 7.0, 11.0};
  const auto mean_deg = [&](const OwnPath& path) {
    double sum_deg = 0.0;
    for (int i = 0; i < 10'000; ++i) sum_deg += own_direction_deg(path, shape, (i + 0.5) / 10'000.0) / 10'000.0;
    return sum_deg;
  };
  EXPECT_NEAR(mean_deg({}), 0.0, 1e-5);
  EXPECT_GT(std::abs(mean_deg({.returns = false})), 0.2);
  EXPECT_EQ(own_direction_deg({.returns = false}, shape, 0.6), 0.0);
  EXPECT_DOUBLE_EQ(own_direction_deg({.returns = false}, shape, 0.45), 0.5 * own_direction_deg({}, shape, 0.45));
}

// The mean square of 1 - 2 s is 1/3, hence the factor 3.
TEST(SimulationOwnPath, TheMeanHabit_IsTheProjectionOfTheMeanPath) {
  const OwnPath path{.mean_deg = {3.0, -5.0, 7.0, 11.0}};
  double habit_deg = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const double s = (i + 0.5) / 10'000.0;
    habit_deg += 3.0 * (1.0 - 2.0 * s) * own_direction_deg(path, path.mean_deg, s) / 10'000.0;
  }
  EXPECT_NEAR(mean_habit_deg(path), habit_deg, 1e-5);
}

// Two recordings that differ from 6 (1 - 2 s) by 2 degrees to either side.
TEST(SimulationOwnPath, RecordedReaches_GiveTheirHabitAndScatter) {
  std::vector<RecordedReach> reaches(2);
  for (std::size_t i = 0; i < 21; ++i) {
    const double mean_deg = 6.0 * (1.0 - 0.1 * static_cast<double>(i));
    reaches[0].direction_deg[i] = mean_deg + 2.0;
    reaches[1].direction_deg[i] = mean_deg - 2.0;
  }
  const OwnPath path = own_path_of(reaches);
  EXPECT_NEAR(mean_habit_deg(path), 6.0, 1e-12);
  EXPECT_NEAR(wander_sd_deg(path), 2.0, 1e-12);
}

TEST(SimulationOwnPath, WithoutIllusion_TheOwnPathEndsAtTheTarget) {
  Person person{.noise_deg2_per_s = 0.0, .start_direction_deg = 5.0, .pace = Pace::recorded};
  person.illusion = {.family = IllusionFamily::dead_band, .tactile_weight = 0.2, .scale_deg = 90.0};
  person.own_path.mean_deg = {8.0, 4.0, 5.0, 10.0};
  SlidingPerson sliding(person, {0.0, 0.0}, 5.0, 100.0, draws_of(0));
  double furthest_mm = 0.0;
  while (!sliding.done()) {
    sliding.advance(0.0);
    furthest_mm = std::max(furthest_mm, std::abs(distance_mm({0.0, 0.0}, sliding.position()) *
                                                 std::sin((bearing_deg({0.0, 0.0}, sliding.position()) - 5.0) / 57.3)));
  }
  EXPECT_GT(furthest_mm, 2.0);
  EXPECT_NEAR(bearing_deg({0.0, 0.0}, sliding.position()), 5.0, 0.2);
}

// In recordings, the median peak of the speed is at 36 % of the time between the points of 5 % of the peak, and 1.6 %
// of the reaches have a stop.
TEST(SimulationOwnPath, DrawnPaces_PeakEarlyAndCoverThePath) {
  std::vector<double> peaks;
  int stops = 0;
  for (std::uint32_t reach = 0; reach < 1000; ++reach) {
    Draws draws = draws_of(7, reach);
    const RecordedPace pace = draw_pace(0.15, draws);
    EXPECT_NEAR(pace.path_fraction(1.0), 1.0, 1e-12);
    double fastest = 0.0, peak_at = 0.0;
    bool stopped = false;
    for (int i = 1; i < 200; ++i) {
      const double speed = pace.path_fraction(i / 200.0) - pace.path_fraction((i - 1) / 200.0);
      EXPECT_GE(speed, 0.0);
      stopped = stopped || (speed == 0.0 && i < 180);
      if (speed > fastest) fastest = speed, peak_at = i / 200.0;
    }
    peaks.push_back(peak_at * recorded_tail_scale);
    stops += stopped;
  }
  std::nth_element(peaks.begin(), peaks.begin() + 500, peaks.end());
  EXPECT_NEAR(peaks[500], 0.36, 0.05);
  EXPECT_NEAR(stops, 16, 12);
}

}  // namespace
}  // namespace hrt
