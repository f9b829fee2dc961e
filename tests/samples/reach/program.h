// Runs hrt-reach as its users do: as a program, with Khronos' loader and the mock runtime.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/samples/process.h"

namespace hrt::reach {

inline const std::string desk = HRT_SCENES "/desk.gltf";

/// Environment of a run: the mock runtime's manifest and no other variable of OpenXR.
std::map<std::string, std::string> mock_environment();

/// mock_environment() with this script for the mock runtime (samples/mock_runtime/SCRIPTS.md).
std::map<std::string, std::string> scripted_environment(const std::string& script);

/// Part of a script: a participant with so little noise that only faults matter. A reach takes 2.7 s, about 270 frames
/// with the rest at its end.
inline const std::string calm = R"("participants": [{"illusion": "linear", "tactile_weight": 0.2,
    "steering": "continuous", "delay_ms": 50, "gain_per_s": 9, "noise_deg2_per_s": 0.5, "start_direction_deg": 0,
    "habit_deg": 0, "pace": "minimum_jerk", "duration_ms": 2400, "reaction_ms": 300}])";

class Program : public Process {
 public:
  explicit Program(const std::vector<std::string>& arguments,
                   const std::map<std::string, std::string>& environment = mock_environment(), int err = -1,
                   int in = -1);
};

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::map<std::string, std::string>& environment = mock_environment());

Outcome run_scripted(const std::string& script, const std::vector<std::string>& arguments);

/// Arguments for a person's reach to the bottle on a simulated plate, followed by `more`.
std::vector<std::string> person_and(const std::vector<std::string>& more = {});

inline void expect_said(const Outcome& outcome, const std::string& text) { EXPECT_TRUE(has(outcome.err, text)); }
inline void expect_said(const Outcome& outcome, std::initializer_list<const char*> texts) {
  EXPECT_TRUE(has(outcome.err, texts));
}

struct Row {
  std::string virtual_name;
  double final_direction_deg;
  double peak_felt_deg;
  double miss_deg;
  double miss_mm;
  std::string touch;  ///< "-" if unknown
  double assumed;
  int frames;
  int lost;
  int bound_percent;
  bool reached;
};
std::vector<Row> rows_of(const Outcome& outcome);

/// Creates an empty folder, which is removed at the end of the process.
std::string scratch_folder();

/// A new folder, and arguments of a reach to the bottle that is recorded there.
struct Files {
  std::string folder = scratch_folder();

  std::vector<std::string> arguments(const std::string& limit_s) const {
    return {desk, "--target", "bottle", "--runtime-limit", limit_s, "--record", folder + "/r.csv"};
  }
};

}  // namespace hrt::reach
