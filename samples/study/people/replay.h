// Open-loop replay of recorded fingertip paths (the plugin's recordings, calibration data) through our controller: its
// state estimates and commands. The path is fixed, so the finger does not react to the commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/person/person_belief.h"
#include "core/plate/plate_model.h"
#include "core/reach/finger_sample.h"
#include "core/reach/reach.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {

/// Source of the plate orientation under a path.
enum class PlateSource {
  measured,   ///< reported by the plate
  commanded,  ///< computed from the recorded commands and the recorded servo model
  resting,    ///< calibration data: constant
};

/// One path; each sample has the plate orientation.
struct RecordedPath {
  std::string file;
  int number = 0;  ///< number in the file, from 1
  Reach reach{};
  std::vector<FingerSample> samples;
  PlateSource plate_source = PlateSource::commanded;
};

/// The paths of a file, and the reasons for skipped reaches.
struct RecordedPaths {
  std::vector<RecordedPath> paths;
  std::vector<std::string> left_out;  ///< a sentence each
  PlateDynamics plate;                ///< from the configuration of the recorded session
  std::int64_t tracker_latency_ns = 0;
};

/// Assumed for files without targets: gap to the right of the goal straight ahead, and distance to both targets.
inline constexpr double assumed_gap_deg = 10.0;
inline constexpr double assumed_distance_mm = 100.0;

/// Parses a recording (format 4) or calibration data. `name`: file name for errors. Throws UsageError naming file, line
/// and the allowed values.
RecordedPaths parse_recorded_paths(const std::string& name, std::string_view text);

/// Result of one path. Angles in degrees.
struct ReplayedPath {
  RecordedPath path;
  double bearing_error_deg;     ///< recorded bearing of the end minus that of the real target
  double peak_felt_error_deg;   ///< largest estimated perceived-direction error, with the recorded plate
  Quantile command_change_deg;  ///< median |command - recorded orientation|, modulo 180
  PlateCommand last;            ///< last command of the controller
  ReachSummary summary;
  PersonBelief person;  ///< carried to the next reach of the file
  bool learnt = false;  ///< the reach updated the estimates with which the next one of the file begins
};

/// Replays the paths of a file in order, as reaches of one person.
std::vector<ReplayedPath> replay(const RecordedPaths& recorded);

struct Replayed {
  std::vector<ReplayedPath> paths;
  std::vector<std::string> left_out;  ///< a sentence each
};

/// Replays all .csv files of a folder, sorted by name. Throws UsageError naming `argument` if the folder has none, or
/// one cannot be read.
Replayed replay_folder(const std::string& argument, const std::string& folder);

std::string replay_text(const Replayed& replayed);
Results replay_results(const Replayed& replayed);

}  // namespace hrt::study
