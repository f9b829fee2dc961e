#include "core/paper/authority.h"
#include "core/person/person_authority.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

// Within 75 of the motion 75 * 0.15 = 11.25 can be held: a gap of 8 with the plate 8 / 0.15 from the motion
// at -8, one of 10 with it 66.7 from the motion, beyond the 60 of human data. The paper's bound, 84.5 about
// the virtual direction, has 84.5 * 0.15 / 0.85 = 14.91.
TEST(StudyAuthority, MapByHand) {
  const StudyRun run =
      run_study({"authority", "--tactile-weight", "0.15", "--gap", "8,10,12", "--format", "csv"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto rows = lines(run.out);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0],
            "tactile_weight,gap_deg,motion_bound_deg,max_gap_deg,reachable,margin_deg,plate_offset_deg,"
            "settling_offset_deg,beyond_human_data,paper_plate_bound_deg,paper_max_gap_deg,paper_reachable,"
            "paper_margin_deg,paper_plate_offset_deg,paper_settling_offset_deg");
  const auto held = fields(rows[1]);
  EXPECT_EQ(held[2], "75");
  EXPECT_NEAR(std::stod(held[3]), 11.25, 1e-12);
  EXPECT_EQ(held[4], "1");
  EXPECT_NEAR(std::stod(held[5]), 3.25, 1e-12);
  EXPECT_NEAR(std::stod(held[6]), 8.0 / 0.15 - 8.0, 1e-9);
  EXPECT_NEAR(std::stod(held[7]), -8.0, 1e-12);
  EXPECT_EQ(held[8], "0");
  EXPECT_EQ(held[9], "84.5");
  EXPECT_NEAR(std::stod(held[10]), 14.9118, 1e-4);
  EXPECT_NEAR(std::stod(held[13]), 8.0 / 0.15 - 8.0, 1e-9);
  const auto beyond_data = fields(rows[2]);
  EXPECT_EQ(beyond_data[4], "1");
  EXPECT_EQ(beyond_data[8], "1");
  const auto out_of_reach = fields(rows[3]);
  EXPECT_EQ(out_of_reach[4], "0");
  EXPECT_NEAR(std::stod(out_of_reach[7]), -11.25, 1e-12);
  EXPECT_NEAR(std::stod(out_of_reach[6]), 75.0 - 11.25, 1e-12);
  EXPECT_EQ(out_of_reach[11], "1");  // the paper's
}

TEST(StudyAuthority, JsonIsTheLibrarysMap) {
  const StudyRun run =
      run_study({"authority", "--tactile-weight", "0.05:0.45:9", "--gap", "-20:20:5", "--format", "json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto page = nlohmann::json::parse(run.out);
  EXPECT_EQ(page["simulation"], true);
  EXPECT_EQ(page["human_data_deg"], 60.0);
  ASSERT_EQ(page["map"].size(), 45U);
  EXPECT_EQ(page["map"].front()["tactile_weight"], 0.05);
  EXPECT_EQ(page["map"].back()["tactile_weight"], 0.45);
  for (const auto& entry : page["map"]) {
    const double gap_deg = entry["gap_deg"];
    const double weight = entry["tactile_weight"];
    const Authority motion = authority_about_motion(-gap_deg, 0.0, {.weight = weight, .curve = 0.0}, 75.0);
    EXPECT_EQ(entry["reachable"], motion.reachable);
    EXPECT_EQ(entry["plate_offset_deg"], motion.plate_orientation_deg);
    EXPECT_EQ(entry["settling_offset_deg"], motion.settling_direction_deg);
    const Authority paper = steering_authority(-gap_deg, 0.0, weight, 84.5);
    EXPECT_EQ(entry["paper_reachable"], paper.reachable);
    EXPECT_EQ(entry["paper_plate_offset_deg"], paper.plate_orientation_deg);
    EXPECT_EQ(entry["paper_settling_offset_deg"], paper.settling_direction_deg);
  }
}

TEST(StudyAuthority, TextMarksWhatCannotBeHeldAndWhatNobodyHasMeasured) {
  const StudyRun run = run_study({"authority", "--tactile-weight", "0.05,0.15", "--gap", "4,10,12"});
  const auto rows = lines(run.out);
  EXPECT_EQ(rows[rows.size() - 2], "   0.05   3.75     4.45      -      -      -");
  EXPECT_EQ(rows[rows.size() - 1], "   0.15  11.25    14.91   22.7  *56.7      -");
  EXPECT_TRUE(has(run.out, "no human trial"));
}

}  // namespace
}  // namespace hrt::study
