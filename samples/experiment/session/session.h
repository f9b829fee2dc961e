// A session of a study: one visit of a participant, from consent to the end. After an interruption, another process
// resumes the session from the journal.
#pragma once

#include <filesystem>
#include <string>

#include "samples/experiment/data/disk.h"
#include "samples/experiment/session/state.h"
#include "samples/experiment/session/subject.h"

namespace hrt::experiment {

struct SessionPlace {
  std::filesystem::path study;  ///< folder of all data of the study
  unsigned participant;
  unsigned session = 1;
  std::string plate;         ///< content of the plate's file; empty: no file
  std::string registration;  ///< content of the registration file; empty: no file
};

std::filesystem::path folder_of(const SessionPlace& place);

/// Copies the design to a study's folder that has none. Throws Refusal if the folder has another design.
void freeze(const Design& design, const std::filesystem::path& study, const Disk& disk);

/// Runs or resumes the session; a session that has ended is not changed. Returns "done", "stopped", or "left" (the
/// experimenter quit; the session can be resumed). Throws an exception with the reason of a failure.
std::string run_session(const Design& design, const SessionPlace& place, Subject& subject, const Disk& disk);

}  // namespace hrt::experiment
