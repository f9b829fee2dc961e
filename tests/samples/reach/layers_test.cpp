// LunarG's API layers, as Debian packages them, in front of the mock runtime.
#include <gtest/gtest.h>

#include "tests/samples/reach/hand_path.h"
#include "tests/samples/reach/program.h"

namespace hrt::reach {
namespace {

// With a layer that writes its text into the file `report`.
Outcome run_with(const std::string& layer, const std::string& variable, const std::string& report,
                 const std::string& script, std::vector<std::string> arguments) {
  auto environment = scripted_environment(script);
  environment["XR_ENABLE_API_LAYERS"] = "XR_APILAYER_LUNARG_" + layer;
  environment["XR_" + variable + "_EXPORT_TYPE"] = "text";
  environment["XR_" + variable + "_FILE_NAME"] = report;
  environment["ASAN_OPTIONS"] = "detect_leaks=0";  // Debian 13's layers leak
  arguments.insert(arguments.begin(), desk);
  return run_program(arguments, environment);
}

// It reports every mistake of an application and of a runtime that it finds, and changes nothing.
TEST(ReachLayers, CoreValidationHasNothingToSay) {
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
    const Outcome outcome = run_with("core_validation", "CORE_VALIDATION", report, script, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    EXPECT_TRUE(has(outcome.err, "Core Validation output type")) << "the layer is not there";
    EXPECT_EQ(validation_findings(report), "") << script;
    std::vector<std::string> without_layer = arguments;
    without_layer.insert(without_layer.begin(), desk);
    EXPECT_EQ(outcome.out, run_scripted(script, without_layer).out) << script;
  }
}

}  // namespace
}  // namespace hrt::reach
