#include "core/authority.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

// 84.5 * 0.1 / 0.9 = 9.3889: a gap of 8 is held at 8 * 9 = 72, one of 10 is not.
TEST(StudyAuthority, MapByHand) {
  const StudyRun run =
      run_study({"authority", "--tactile-weight", "0.1", "--gap", "8,10", "--format", "csv"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto rows = lines(run.out);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0],
            "tactile_weight,plate_bound_deg,largest_gap_deg,gap_deg,reachable,margin_deg,plate_offset_deg,"
            "settling_offset_deg");
  const auto held = fields(rows[1]);
  EXPECT_NEAR(std::stod(held[2]), 9.3889, 1e-4);
  EXPECT_EQ(held[4], "1");
  EXPECT_NEAR(std::stod(held[6]), 72.0, 1e-12);
  EXPECT_NEAR(std::stod(held[7]), -8.0, 1e-12);
  const auto out_of_reach = fields(rows[2]);
  EXPECT_EQ(out_of_reach[4], "0");
  EXPECT_EQ(out_of_reach[6], "84.5");
  EXPECT_NEAR(std::stod(out_of_reach[7]), -84.5 / 9.0, 1e-12);
}

TEST(StudyAuthority, JsonIsTheLibrarysMap) {
  const StudyRun run =
      run_study({"authority", "--tactile-weight", "0.05:0.45:9", "--gap", "-20:20:5", "--format", "json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto page = nlohmann::json::parse(run.out);
  EXPECT_EQ(page["simulation"], true);
  ASSERT_EQ(page["map"].size(), 45U);
  EXPECT_EQ(page["map"].front()["tactile_weight"], 0.05);
  EXPECT_EQ(page["map"].back()["tactile_weight"], 0.45);
  for (const auto& entry : page["map"]) {
    const double gap_deg = entry["gap_deg"];
    const Authority authority = steering_authority(-gap_deg, 0.0, entry["tactile_weight"], 84.5);
    EXPECT_EQ(entry["reachable"], authority.reachable);
    EXPECT_EQ(entry["plate_offset_deg"], authority.plate_orientation_deg);
    EXPECT_EQ(entry["settling_offset_deg"], authority.settling_direction_deg);
  }
}

TEST(StudyAuthority, TextMarksWhatCannotBeHeld) {
  const StudyRun run = run_study({"authority", "--tactile-weight", "0.05,0.15", "--gap", "4,10"});
  const auto rows = lines(run.out);
  EXPECT_EQ(rows[rows.size() - 2], "   0.05      4.45    76.0      -");
  EXPECT_EQ(rows[rows.size() - 1], "   0.15     14.91    22.7   56.7");
  EXPECT_NE(run.out.find("no human trial"), std::string::npos);
}

}  // namespace
}  // namespace hrt::study
