// Position of an unregistered plate, and of every plate after the runtime moves its spaces.
#include <gtest/gtest.h>

#include "tests/samples/reach/hand_path.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

void expect_reached(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  ASSERT_EQ(rows_of(outcome).size(), 1U) << outcome.out << outcome.err;
  EXPECT_TRUE(rows_of(outcome)[0].reached);
}

const std::string no_stage = R"("stage": false, )";
const std::string no_floor = no_stage + R"("withhold_extensions": ["XR_EXT_local_floor"], )";

// The finger is 0.75 m above the mock runtime's floor, which is 1.2 m below the origin of LOCAL.
TEST(ReachPlace, IsAboveTheFloorOfEverySpace) {
  const Path path = Path(plate_of_desk).reach();
  struct Case {
    std::string script;
    std::vector<std::string> arguments;
    std::string said;
  };
  for (const auto& [script, arguments, said] :
       {Case{"", person_and(), "(STAGE space)"}, Case{no_stage, person_and(), "(LOCAL_FLOOR space)"},
        Case{no_floor, person_and({"--eye-height", "1.2"}), "(LOCAL space)"}}) {
    const Outcome outcome = run_scripted(path.script(script), arguments);
    expect_reached(outcome);
    expect_said(outcome, said);
    expect_said(outcome, {"0.75 m above the floor, 0.12 m to the right and 0.32 m ahead", "--register FILE"});
  }
  // With another eye height the plate is 0.2 m lower, out of reach of the scripted finger.
  EXPECT_EQ(run_scripted(path.script(no_floor), person_and({"--eye-height", "1.4", "--time-limit", "4"})).exit_code, 8);
}

TEST(ReachPlace, NeedsTheHeightOfTheEyesWithoutAFloor) {
  const Outcome outcome = expect_exit(2, run_scripted(Path(plate_of_desk).reach().script(no_floor), person_and()));
  expect_said(outcome, "--eye-height METRES");
}

std::string recentre(const std::string& more) {
  return R"("events": [{"frame": 380, "do": "recenter", )" + more + "}], ";
}

// Frame 380 is within the reach. The hand's path is fixed in the room.
TEST(ReachRecentring, APersonsPlateStaysInTheRoom) {
  const Path path = Path(plate_of_desk).reach();
  const std::string far = R"("position_m": [0.6, 0.1, -0.4], "yaw_deg": 50)";
  for (const std::string delay : {"0", "200"}) {
    const Outcome outcome =
        run_scripted(path.script(no_stage + recentre(far + R"(, "delay_ms": )" + delay)), person_and());
    expect_reached(outcome);
    EXPECT_NEAR(rows_of(outcome)[0].final_direction_deg, 0.0, 1.0);
    EXPECT_EQ(rows_of(outcome)[0].lost, 0);
    expect_said(outcome, "The position of the plate in the room is unchanged.");
  }
  const Outcome stage = run_scripted(path.script(recentre(R"("space": "STAGE", )" + far)), person_and());
  expect_reached(stage);
  expect_said(stage, "The position of the plate in the room is unchanged.");
  // Recentring of a space that does not hold the plate has no effect.
  const Outcome other = run_scripted(path.script(recentre(far)), person_and());
  expect_reached(other);
  EXPECT_FALSE(has(other.err, "in the room is unchanged"));
}

TEST(ReachRecentring, ASimulatedUserNoticesNothing) {
  const std::string calm_person = "{" + calm;
  const std::vector<Row> usual = rows_of(run_scripted(calm_person + "}", {desk}));
  const std::string moves =
      R"(, "events": [{"frame": 100, "do": "recenter", "space": "STAGE", "position_m": [0.3, 0, 0.2], "yaw_deg": -30},
         {"frame": 150, "do": "recenter", "space": "STAGE", "position_m": [-0.3, 0.1, 0], "yaw_deg": 170},
         {"frame": 400, "do": "recenter", "space": "STAGE", "position_m": [1, 0, 1], "yaw_deg": 90}])";
  const Outcome outcome = expect_exit(0, run_scripted(calm_person + moves + "}", {desk}));
  const std::vector<Row> rows = rows_of(outcome);
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(rows[i].final_direction_deg, usual[i].final_direction_deg, 0.05);
    EXPECT_NEAR(rows[i].miss_mm, usual[i].miss_mm, 0.1);
  }
}

TEST(ReachRecentring, ByAnUnknownAmountEndsTheRun) {
  const std::string folder = scratch_folder();
  const Outcome outcome = expect_exit(
      12, run_scripted(Path(plate_of_desk)
                           .reach()
                           .script(recentre(R"("space": "STAGE", "position_m": [1, 0, 0], "pose_valid": false)")),
                       person_and({"--record", folder + "/r.csv"})));
  expect_said(outcome, {"moved its STAGE space", "register the plate (hrt-reach: --register FILE)"});
  EXPECT_TRUE(has(read_file(folder + "/r.csv"), "\n# end "));
}

// Recentring occurs during the touches, which are fixed in the room; the file has the pose in the new space.
TEST(ReachRecentring, WhileRegistering) {
  const std::string file = scratch_folder() + "/plate.txt";
  const Outcome outcome =
      run_scripted(Path().touch(marks).reach().script(
                       R"("events": [{"frame": 300, "do": "recenter", "space": "STAGE", "position_m": [1, 0, 1]}], )"),
                   person_and({"--register", file}));
  expect_reached(outcome);
  EXPECT_NEAR(value_of(read_file(file), "\"position_m\":["), PlatePose{}.x_m - 1.0, 1e-3) << read_file(file);
}

}  // namespace
}  // namespace hrt::reach
