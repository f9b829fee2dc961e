// Recorded fingertip paths, from the plugin's recordings and from calibration data, under our controller, in an open
// loop: what it would have believed and commanded. The finger cannot answer: a path is as it was recorded, whatever the
// plate would have done.
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

/// How the plate's orientation under a path is known.
enum class PlateSource {
  measured,   ///< its device reported it
  commanded,  ///< from the recorded commands, and the servo that the recorded session declares
  resting,    ///< calibration data: at rest
};

/// One path, with where the plate stood in each sample's plate_orientation_deg.
struct RecordedPath {
  std::string file;
  int number = 0;  ///< in the file, from 1
  Reach reach{};
  std::vector<FingerSample> samples;
  PlateSource plate_source = PlateSource::commanded;
};

/// The paths of a file, and of reaches that have none the reason.
struct RecordedPaths {
  std::vector<RecordedPath> paths;
  std::vector<std::string> left_out;  ///< a sentence each
  PlateDynamics plate;                ///< as the recorded session declares it
  std::int64_t tracker_latency_ns = 0;
};

/// The gap that is assumed where a file has no real target, to the right of the goal straight ahead, and the
/// distance to both targets.
inline constexpr double assumed_gap_deg = 10.0;
inline constexpr double assumed_distance_mm = 100.0;

/// Reads a recording (format 3) or calibration data. `name` is the file's name in errors. Throws UsageError
/// naming file, line and the allowed values.
RecordedPaths parse_recorded_paths(const std::string& name, std::string_view text);

/// One path. Angles in degrees.
struct ReplayedPath {
  RecordedPath path;
  double bearing_error_deg;     ///< of the last position from the start, less the real target's: as recorded
  double peak_felt_error_deg;   ///< as estimated, under the plate that stood there
  Quantile command_change_deg;  ///< median size, modulo 180, of command less where the plate stood
  PlateCommand last;            ///< of the controller
  ReachSummary summary;
  PersonBelief person;  ///< carried to the next reach of the file
  bool learnt = false;  ///< the reach taught something, which the next one of the file began from
};

/// Each path of a file under our controller, one after another, as reaches of one person.
std::vector<ReplayedPath> replay(const RecordedPaths& recorded);

struct Replayed {
  std::vector<ReplayedPath> paths;
  std::vector<std::string> left_out;  ///< a sentence each
};

/// All .csv files of a folder, in the order of their names. Throws UsageError naming `argument` if the folder
/// has no such file, or one cannot be read.
Replayed replay_folder(const std::string& argument, const std::string& folder);

std::string replay_text(const Replayed& replayed);
Results replay_results(const Replayed& replayed);

}  // namespace hrt::study
