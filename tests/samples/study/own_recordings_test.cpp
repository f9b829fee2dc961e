#include "samples/study/people/own_recordings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/math/elementary.h"
#include "core/simulation/minimum_jerk.h"
#include "samples/study/cli/arguments.h"
#include "tests/samples/text.h"

namespace hrt::study {
namespace {

// Returns a reach of 300 mm in 0.8 s, with rests of 0.3 s before and after. At the fraction s of the path, its
// direction is turn + habit (1 - 2 s).
std::string reach(int number, double turn_deg, double habit_deg) {
  std::string rows;
  PlatePoint place{40.0, -20.0};
  double share = 0.0;
  for (int i = 0; i < 140; ++i) {
    const double s = minimum_jerk((0.01 * i - 0.3) / 0.8);
    place = point_ahead(place, turn_deg + habit_deg * (1.0 - s - share), 300.0 * (s - share));
    share = s;
    rows += std::to_string(number) + ',' + std::to_string(0.01 * i) + ',' + std::to_string(place.right_mm) + ',' +
            std::to_string(place.away_mm) + '\n';
  }
  return rows;
}
const std::string header = "reach,time_s,right_mm,away_mm\n";

TEST(StudyOwnRecordings, DirectionAndPaceOfRotatedReaches) {
  const auto reaches = parse_reaches("own.csv", header + reach(1, 30.0, 10.0) + reach(2, -70.0, 10.0));
  ASSERT_EQ(reaches.size(), 2U);
  for (const RecordedReach& each : reaches) {
    EXPECT_NEAR(each.direction_deg[5], 5.0, 0.5);
    EXPECT_NEAR(each.direction_deg[10], 0.0, 0.5);
    EXPECT_NEAR(each.direction_deg[15], -5.0, 0.5);
    EXPECT_NEAR(each.path_fraction[50], 0.5, 0.02);
    EXPECT_NEAR(each.path_fraction[25], 0.14, 0.02);  // minimum_jerk(0.28): parse_reaches() cuts off 6 % at either end
  }
  const OwnPath path = own_path_of(reaches);
  EXPECT_NEAR(path.mean_deg[0], 10.0, 0.5);
  EXPECT_NEAR(wander_sd_deg(path), 0.0, 0.1);
}

TEST(StudyOwnRecordings, WanderIsTheDifferenceBetweenReaches) {
  const OwnPath path = own_path_of(parse_reaches("own.csv", header + reach(1, 0.0, 6.0) + reach(2, 0.0, -6.0)));
  EXPECT_NEAR(path.mean_deg[0], 0.0, 0.1);
  EXPECT_NEAR(wander_sd_deg(path), 6.0 / std::sqrt(3.0), 0.4);
}

TEST(StudyOwnRecordings, ErrorsNameTheReachAndTheRemedy) {
  const auto refusal = [](const std::string& text) {
    try {
      parse_reaches("own.csv", text);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_TRUE(has(refusal(""), "own.csv: there is no header; it must name reach,time_s,right_mm,away_mm"));
  EXPECT_TRUE(has(refusal(header), "own.csv has no reach"));
  EXPECT_TRUE(has(refusal("reach,time_s,right_mm\n"), "line 1"));
  EXPECT_TRUE(has(refusal(header + "1,0,0,0\n1,0,1,1\n"), "time_s"));
  EXPECT_TRUE(has(refusal(header + "1,0,0,nan\n"), "away_mm"));
  EXPECT_TRUE(has(refusal(header + "7,0,0,0\n7,0.1,1,1\n"), "own.csv, reach 7 has 2 samples in motion"));
  std::string metres = header;
  for (int i = 0; i < 100; ++i) metres += "1," + std::to_string(0.01 * i) + ",0," + std::to_string(3e-3 * i) + "\n";
  EXPECT_TRUE(has(refusal(metres), "in millimetres")) << refusal(metres);
}

}  // namespace
}  // namespace hrt::study
