// A session: from consent to its end, through as many processes as it takes.
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
  std::string plate;         ///< its file's content; empty: it has none
  std::string registration;  ///< the same, of a plate that another program registered
};

std::filesystem::path folder_of(const SessionPlace& place);

/// Freezes the design in the study's folder at the first participant. Throws Refusal if another one is frozen
/// there.
void freeze(const Design& design, const std::filesystem::path& study, const Disk& disk);

/// Runs the session, or resumes it; one that has ended stays as it is. Returns how it ended: "done",
/// "stopped", or "left", to be resumed. Throws Refusal.
std::string run_session(const Design& design, const SessionPlace& place, Subject& subject, const Disk& disk);

}  // namespace hrt::experiment
