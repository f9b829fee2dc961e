// All components together: hrt-reach, Khronos' loader, the mock runtime, the plugin, the scene.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/samples/reach/hand_path.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

TEST(ReachEndToEnd, ReachesEveryTargetOfTheDesk) {
  const Outcome outcome = expect_exit(0, run_program({desk}));
  EXPECT_EQ(outcome.err, "");
  const std::vector<Row> rows = rows_of(outcome);
  ASSERT_EQ(rows.size(), 3U) << outcome.out;
  EXPECT_EQ(rows[0].virtual_name, "bottle");
  EXPECT_EQ(rows[1].virtual_name, "goblet");
  EXPECT_EQ(rows[2].virtual_name, "pawn");
  for (const Row& row : rows) {
    EXPECT_TRUE(row.reached) << row.virtual_name;
    EXPECT_LT(std::abs(row.miss_deg), 2.5) << row.virtual_name;
    EXPECT_LT(row.miss_mm, 5.0);
    // A reaction of 0.3 to 0.7 s, a motion of 1 to 2 s and a rest of 0.3 s at 90 Hz.
    EXPECT_GE(row.frames, 144);
    EXPECT_LE(row.frames, 273);
    EXPECT_EQ(row.lost, 0);
  }
}

// By default, the paper's controller assumes a tactile weight of 0.15.
TEST(ReachEndToEnd, ThePapersControllerMissesIfTheUsersWeightDiffers) {
  const std::string strong = R"({"participants": [{"illusion": "linear", "tactile_weight": 0.3}]})";
  EXPECT_EQ(run_scripted(strong, {desk, "--controller", "paper"}).exit_code, 1);
  EXPECT_EQ(run_scripted(strong, {desk}).exit_code, 0);
}

TEST(ReachEndToEnd, ReachesForChosenTargetsInTheGivenOrder) {
  const std::vector<Row> rows = rows_of(run_program({desk, "--target", "pawn", "--target", "bottle"}));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].virtual_name, "pawn");
  EXPECT_EQ(rows[1].virtual_name, "bottle");
}

// With a tactile weight of 0.10, gaps up to 7.5 degrees are feasible with the plate within 75 degrees of the motion,
// and up to 9.4 with the paper's bound. The pawn's gap is 12.
TEST(ReachEndToEnd, DoesNotCountInfeasibleTargets) {
  const std::string light = R"({"participants": [{"illusion": "linear", "tactile_weight": 0.1}]})";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{desk, "--target", "pawn", "--controller", "paper", "--tactile-weight", "0.1"},
        std::vector<std::string>{desk, "--target", "pawn", "--tactile-weight", "0.1"}}) {
    const Outcome outcome = expect_exit(0, run_scripted(light, arguments));
    EXPECT_TRUE(has(outcome.out, {"(flag: gap infeasible)", "0 of 0 reaches with a feasible gap ended at the target",
                                  "; 1 more had an infeasible gap"}));
  }
}

using Environment = std::map<std::string, std::string>;

struct Refused {
  std::vector<std::string> arguments;
  int exit_code;
  std::string named;
  Environment environment = mock_environment();
};

TEST(ReachRefusal, IsOneSentenceAndAnExitCode) {
  const std::string folder = scratch_folder();
  std::ofstream(folder + "/runtime.json")
      << R"({"file_format_version": "1.0.0", "runtime": {"library_path": "./none.so"}})";
  std::ofstream(folder + "/empty.json") << "{}";
  const Refused all[] = {
      {{desk}, 5, "XR_RUNTIME_JSON", Environment{}},
      {{desk}, 5, "XR_RUNTIME_JSON", {{"XR_RUNTIME_JSON", folder + "/runtime.json"}}},
      {{desk, "--plugin", "/nonexistent.so"}, 3, "/nonexistent.so"},
      {{desk, "--plugin", HRT_MOCK_LIBRARY}, 3, "hrt_result_string"},  // a library that is not the plugin
      {{desk, "--profile", folder + "/empty.json"}, 3, "empty.json"},
      {{"nonexistent.gltf"}, 4, "nonexistent.gltf"},
      {{desk, "--target", "moon"}, 4, "\"moon\""},
      {{}, 2, "scene"},
      {{desk, "--tactile-weight", "0.5"}, 2, "--tactile-weight"},
      {{desk, "--repeat", "0"}, 2, "--repeat"},
      {{desk, "--hand", "third"}, 2, "--hand"},
      {{desk, "--time-limit", "inf"}, 2, "--time-limit"},
      {{desk, "--bogus"}, 2, "--bogus"},
      {{desk, "--calibrate", "profile.json", "--target", "bottle"}, 2, ""},
      {{desk, "--register", "plate.txt", "--registered", "plate.txt"}, 2, ""},
      {{desk, "--marks", "plate.txt"}, 2, ""},
      {{desk, "--fingertip"}, 2, ""},
      {{desk, "--register", "plate.txt", "--fingertip", "--hand", "either"}, 2, "--fingertip"},
      {{desk, "--speak-with", "no-such-voice --fast"}, 2, "no-such-voice"},
      {{desk, "--speak", "--speak-with", "cat"}, 2, ""},
      {{desk, "--check-each"}, 2, "--register"},
      {{desk, "--max-slides", "20"}, 2, "--max-slides"},
      {{desk, "--calibrate", "/nonexistent/profile.json"}, 10, "/nonexistent/profile.json"},
      {{desk, "--calibrate", "/dev/null"}, 10, "/dev/null"},
      {person_and({"--eye-height", "tall"}), 2, ""},
      {{desk, "--record", "/nonexistent/reach.csv"}, 10, "/nonexistent/reach.csv"},
      {{desk, "--record", "/dev/full"}, 10, "/dev/full"}};
  for (const auto& [arguments, exit_code, named, environment] : all) {
    const Outcome outcome = expect_exit(exit_code, run_program(arguments, environment));
    EXPECT_EQ(outcome.out, "") << outcome.err;
    EXPECT_EQ(outcome.err.rfind("hrt-reach: ", 0), 0U) << outcome.err;
    EXPECT_EQ(occurrences(outcome.err, "\n"), 1U) << outcome.err;
    EXPECT_TRUE(has(outcome.err, named));
  }
}

TEST(ReachCommandLine, ExplainsItself) {
  const Outcome help = expect_exit(0, run_program({"--help"}));
  EXPECT_TRUE(has(help.out, {"scene", "--plugin", "--target", "--seed", "--hand", "Exit codes", "XR_RUNTIME_JSON"}));
}

// LunarG's layer, as Debian packages it, reports every mistake of an application and of a runtime that it finds, and
// changes nothing.
TEST(ReachLayers, CoreValidationReportsNothing) {
  const std::string recentred = R"("events": [{"frame": 90, "do": "recenter", "space": "STAGE",
      "position_m": [0.1, 0, 0.2], "yaw_deg": 15}], )";
  struct Case {
    std::string script;
    std::vector<std::string> arguments;
  };
  for (const auto& [script, arguments] :
       {Case{"{}", {}},
        Case{"{" + calm + R"(, "events": [{"session": 1, "frame": 60, "do": "lose_session"}]})",
             {"--target", "bottle"}},
        Case{R"({"events": [{"frame": 400, "do": "session_state", "state": "LOSS_PENDING"}]})", {}},
        Case{Path(plate_of_desk).reach().rest(2000).script(recentred),
             {"--target", "bottle", "--person", "--plate", "servo"}}}) {
    const std::string report = scratch_folder() + "/report.txt";
    auto environment = scripted_environment(script);
    environment["XR_ENABLE_API_LAYERS"] = "XR_APILAYER_LUNARG_core_validation";
    environment["XR_CORE_VALIDATION_EXPORT_TYPE"] = "text";
    environment["XR_CORE_VALIDATION_FILE_NAME"] = report;
    environment["ASAN_OPTIONS"] = "detect_leaks=0";  // Debian 13's layers leak
    std::vector<std::string> whole = arguments;
    whole.insert(whole.begin(), desk);
    const Outcome outcome = expect_exit(0, run_program(whole, environment));
    EXPECT_TRUE(has(outcome.err, "Core Validation output type")) << "the layer is not installed";
    EXPECT_EQ(validation_findings(report), "") << script;
    EXPECT_EQ(outcome.out, run_scripted(script, whole).out) << script;
  }
}

}  // namespace
}  // namespace hrt::reach
