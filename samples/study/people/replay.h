// Recorded fingertip paths under our controller, in an open loop: what it would have believed and commanded.
// The finger cannot answer: a path is as it was recorded, whatever the plate would have done.
#pragma once

#include <string>
#include <vector>

#include "samples/study/numbers/results.h"
#include "samples/study/people/recorded_paths.h"

namespace hrt::study {

/// One path. Angles in degrees.
struct ReplayedPath {
  RecordedPath path;
  double bearing_error_deg;     ///< of the last position from the start, less the real target's: as recorded
  double peak_felt_error_deg;   ///< as estimated, under the plate that stood there
  Quantile command_change_deg;  ///< median size, modulo 180, of command less where the plate stood
  PlateCommand last;            ///< of the controller
  ReachSummary summary;
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
