// hrt-reach --register and --measure-tracker: a scripted hand touches marks of a plate that is not where the scene has
// it, or two dimples.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "samples/reach/measure_tracker.h"
#include "tests/samples/reach/hand_path.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

class ReachRegistration : public testing::Test {
 protected:
  static Outcome run(const Path& path, const std::vector<std::string>& more) {
    return run_scripted(path.script(), person_and(more));
  }
  std::string written(const std::string& text) const {
    std::ofstream(file) << text;
    return file;
  }

  const std::string file = scratch_folder() + "/plate.txt";
};

TEST_F(ReachRegistration, FindsAPlateThatIsElsewhere) {
  // Without registration no finger comes to the start.
  EXPECT_EQ(run(Path().reach(), {"--time-limit", "8"}).exit_code, 8);
  const std::string recording = scratch_folder() + "/contact.csv";
  const Outcome outcome = expect_exit(0, run(Path().touch(marks).reach(), {"--register", file, "--record", recording}));
  expect_said(outcome, {"touch mark 1 and hold still. Mark 1 is \"start\" (1 of 6).", "\"rim near left\"",
                        "registered [residual of the touches 0.0 mm", "displace the ends of reaches by 0."});
  // With a registered plate, a finger that reaches the cylinder is recorded as a contact.
  EXPECT_TRUE(has(read_file(recording), "\ntouched,0,"));
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].final_direction_deg, 0.0, 1.0);
  EXPECT_LE(rows_of(outcome)[0].miss_mm, 5.1);
  EXPECT_TRUE(rows_of(outcome)[0].reached);
  // The pose is in STAGE, whose origin is 1.2 m below that of LOCAL.
  const auto kept = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(kept["space"], "STAGE");
  EXPECT_NEAR(kept["position_m"][0], PlatePose{}.x_m, 1e-4);
  EXPECT_NEAR(kept["position_m"][1], PlatePose{}.y_m + 0.008 + 1.2, 1e-4);
  EXPECT_NEAR(kept["position_m"][2], PlatePose{}.z_m, 1e-4);
}

TEST_F(ReachRegistration, IsKeptForTheNextRunAndChecked) {
  ASSERT_EQ(run(Path().touch(marks).reach(), {"--register", file}).exit_code, 0);
  const Outcome next = expect_exit(0, run(Path().hold(marks[0]).reach(), {"--registered", file}));
  expect_said(next, {"to check the plate's position. Mark 1 is \"start\"",
                     "The plate has not moved: you touched 0 mm from the mark."});
  EXPECT_TRUE(rows_of(next)[0].reached);
  PlatePose moved;
  moved.x_m += 0.03;
  expect_said(expect_exit(12, run(Path(moved).hold(marks[0]).lift().touch({marks[0]}).reach(), {"--registered", file})),
              {"touched 30 mm from where it was registered", "register the plate again (hrt-reach: --register)"});
}

// The joint is 20 mm from the skin, and the hand leans differently in the reach than in the touches.
TEST_F(ReachRegistration, FindsTheSkinOfAHandThatLeans) {
  constexpr double skin_m = 0.02;
  const auto touched = [&] {
    Path path;
    for (const Attitude& attitude : {Attitude{}, {-35, 0, 0}, {0, 0, 30}, {0, 0, -30}, {10, 30, 0}, {10, -30, 0}})
      path.hold_hand(attitude, skin_m).touch({marks[0]});
    path.hold_hand({-10, 0, -20}, skin_m).touch(marks);
    return path.hold_hand({-10, 0, 25}, skin_m);
  };
  const Outcome outcome = expect_exit(0, run(touched().reach(), {"--register", file, "--fingertip"}));
  expect_said(outcome, {"touch mark 1 with the finger held tilted onto its left side",
                        "The skin of the fingertip is 20.0 mm from the tracked joint",
                        "registered [residual of the touches 0.0 mm", "displace the ends of reaches by 0."});
  ASSERT_EQ(rows_of(outcome).size(), 1U);
  EXPECT_NEAR(rows_of(outcome)[0].final_direction_deg, 0.0, 0.5);
  EXPECT_LE(rows_of(outcome)[0].miss_mm, 5.1);
  // The file keeps the skin offset for the next run.
  auto joint = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(joint["hand"], "right");
  const Path next = Path().hold_hand({-10, 0, 25}, skin_m).hold(marks[0]).reach();
  const Outcome kept = expect_exit(0, run(next, {"--registered", file}));
  expect_said(kept, "The plate has not moved: you touched 0 mm from the mark.");
  EXPECT_LE(rows_of(kept)[0].miss_mm, 5.1);
  expect_said(expect_exit(12, run(next, {"--registered", file, "--hand", "left"})), "valid for one hand only");
  // Without the skin offset, the lean of the hand (45 degrees over 20 mm) appears as a displacement.
  joint.erase("hand");
  const Outcome ignored = run(next, {"--registered", written(joint.dump())});
  EXPECT_NE(ignored.exit_code, 0) << ignored.out << ignored.err;
}

TEST_F(ReachRegistration, TouchesInOneAttitudeDoNotDetermineTheSkin) {
  Path path;
  for (int touch = 0; touch < 18; ++touch) path.touch({marks[0]});
  const Outcome outcome = expect_exit(12, run(path, {"--register", file, "--fingertip"}));
  expect_said(outcome, {"fingertip: The measurements are not sufficient.", "tilt the finger more"});
}

TEST_F(ReachRegistration, IsCheckedBeforeEachReach) {
  ASSERT_EQ(run(Path().touch(marks).reach(), {"--register", file}).exit_code, 0);
  const std::vector<std::string> twice = {"--registered", file, "--check-each", "--repeat", "2"};
  const Outcome same = expect_exit(0, run(Path().hold(marks[0]).reach().lift().touch({marks[0]}).reach(), twice));
  EXPECT_EQ(rows_of(same).size(), 2U);
  const std::string question = "to check the plate's position. Mark 1 is \"start\"";
  const std::size_t first = same.err.find(question);
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(same.err.find(question, first + 1), std::string::npos) << same.err;
  // Both touches before the second reach are 30 mm from the mark.
  const Place moved{marks[0].right_m + 0.03, marks[0].towards_user_m};
  const Outcome refused = expect_exit(12, run(Path().hold(marks[0]).reach().lift().touch({moved, moved}), twice));
  EXPECT_EQ(rows_of(refused).size(), 1U);
  expect_said(refused, "touched 30 mm from where it was registered");
}

TEST_F(ReachRegistration, AsksAgainIfTheTouchesDoNotFit) {
  std::vector<Place> confused = marks;
  std::swap(confused[2], confused[5]);
  std::swap(confused[3], confused[4]);
  const Outcome second = expect_exit(0, run(Path().touch(confused).touch(marks).reach(), {"--register", file}));
  expect_said(second, "marks were confused");
  expect_said(expect_exit(12, run(Path().touch(confused).touch(confused).touch(confused), {"--register", file + "2"})),
              "registration: The touches fit a plate that is upside down or mirrored.");
  EXPECT_EQ(read_file(file + "2"), "");
}

TEST_F(ReachRegistration, WaitForATouchHasATimeLimit) {
  const Outcome outcome = expect_exit(8, run(Path(), {"--register", file, "--time-limit", "4"}));
  expect_said(outcome, "no response within 4 s. ");
}

TEST_F(ReachRegistration, TakesMarksFromAFile) {
  const std::string own = scratch_folder() + "/marks.csv";
  std::ofstream(own) << "name,x_m,y_m,z_m,plate_orientation\nd\xe9"
                        "part,0,-0.001,0.05,0\nnear,0,-0.001,0.088,any\n"
                        "near right,0.0762102,-0.001,0.044,any\nfar right,0.0762102,-0.001,-0.044,any\n"
                        "far left,-0.0762102,-0.001,-0.044,any\n";
  const std::vector<Place> there = {
      {0.0, 0.05}, {0.0, 0.088}, {0.0762102, 0.044}, {0.0762102, -0.044}, {-0.0762102, -0.044}};
  const Outcome outcome = expect_exit(0, run(Path().touch(there).reach(), {"--register", file, "--marks", own}));
  expect_said(outcome, "Mark 5 is \"far left\" (5 of 5).");
  // Invalid bytes of a name that is not UTF-8 are replaced.
  EXPECT_EQ(nlohmann::json::parse(read_file(file))["check"], "d\xef\xbf\xbdpart");
}

TEST_F(ReachRegistration, BadFilesAreRefusedByLine) {
  const auto refused = [&](const std::string& text, const std::string& part, const std::string& option) {
    std::vector<std::string> arguments = {option, written(text)};
    if (option == "--marks") arguments.insert(arguments.end(), {"--register", file + ".out"});
    expect_said(expect_exit(12, run(Path(), arguments)), part);
  };
  const std::string header = "name,x_m,y_m,z_m\n";
  refused("a,b\n", "line 1: the first columns must be name,x_m,y_m,z_m", "--marks");
  refused(header + "a,0,0,0\nb,nan,0,0\n", "line 3: \"nan\" is not a number of metres from -1 to 1", "--marks");
  refused(header + "a,0,0\n", "line 2: \"\" is not a number", "--marks");
  refused(header + "a,0,0,2\n", "line 2: \"2\" is not a number of metres from -1 to 1", "--marks");
  refused(header + ",0,0,0\n", "line 2: the mark has no name", "--marks");
  refused(header + "a\x1b[2J,0,0,0\n", "line 2: the line has more than 200 bytes or a control character", "--marks");
  refused(header + "a,0,0,0\nb,0,0,0.1\n", "line 3: there are fewer than 3 marks", "--marks");

  ASSERT_EQ(run(Path().touch(marks).reach(), {"--register", file}).exit_code, 0);
  const std::string good = read_file(file);
  const auto with = [&](const std::string& part, const std::string& by) {
    std::string text = good;
    return text.replace(text.find(part), part.size(), by);
  };
  refused("", "parse error", "--registered");
  refused("{}", "key 'version' not found", "--registered");
  refused(good.substr(0, good.size() / 2), "parse error", "--registered");
  refused(with("\"version\":2", "\"version\":1"), "version must be 2); register the plate again", "--registered");
  refused(with("STAGE", "MOON"), "space must be STAGE or LOCAL", "--registered");
  refused(with("\"rotation\"", "\"rotating\""), "key 'rotation' not found", "--registered");
  refused(with("\"check_m\":[0.0", "\"check_m\":[\"0\""), "type must be number", "--registered");
  refused(with("\"check_m\":[0.0,", "\"check_m\":["), "check_m must have 3 numbers", "--registered");
  refused(with("}", ",\"hand\":\"third\"}"), "hand must be left or right", "--registered");
  expect_said(expect_exit(12, run(Path(), {"--registered", "/nowhere/plate.txt"})),
              "/nowhere/plate.txt cannot be read");
  // The plugin rejects numbers that are not a pose of a plate.
  expect_said(
      expect_exit(3, run(Path(), {"--registered", written(with("\"position_m\":[2", "\"position_m\":[20002"))})),
      "plate_position_m[0] is");
  expect_exit(10, run(Path().touch(marks), {"--register", "/nowhere/plate.txt"}));
}

// The second dimple is touched 2 mm to either side in turn: bearings of 1.146 degrees to either side of their mean.
TEST_F(ReachRegistration, MeasuresTheTrackersBearing) {
  Path path;
  for (int i = 0; i < 20; ++i) path.hold({0.0, 0.05}).hold({i % 2 == 0 ? 0.002 : -0.002, -0.05});
  const Outcome outcome = expect_exit(0, run(path, {"--measure-tracker"}));
  EXPECT_TRUE(
      has(outcome.out, {"Standard deviation of the bearing over 100 mm: 1.18 degrees, 95 % interval 0.89 to 1.72.",
                        "at most 80 % of reaches end within 1.5 degrees", "interval 62 to 91 %",
                        "bearing_sd_deg of --finger, to 1.18."}));
  expect_said(expect_exit(8, run(Path(), {"--measure-tracker", "--time-limit", "4"})),
              "No finger rested in the dimple");
  expect_said(expect_exit(2, run_program({desk, "--measure-tracker"})), "needs a person");
}

// Expected values are those of the table in plugin/SETUP.md.
TEST(ReachTracker, SharesAreThoseOfTheTable) {
  for (const auto& [sd_deg, share] :
       {std::pair{0.3, "100"}, {0.75, "95"}, {1.0, "87"}, {1.5, "68"}, {2.0, "55"}, {2.9, "40"}}) {
    std::vector<double> bearings_deg;
    for (int i = 0; i < 20; ++i) bearings_deg.push_back(180.0 + (i % 2 == 0 ? 1 : -1) * sd_deg * std::sqrt(0.95));
    EXPECT_TRUE(has(bearing_sd_text(bearings_deg, 0.1), std::string("at most ") + share + " %"));
  }
}

TEST_F(ReachRegistration, NeedsAPerson) {
  expect_said(expect_exit(2, run_program({desk, "--register", file})), "need a person, who touches the marks");
}

}  // namespace
}  // namespace hrt::reach
