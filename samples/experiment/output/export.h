// Tables of the data in the journals of a study.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

struct Tables {
  std::map<std::string, std::string> files;  ///< contents by file name: CSV, and the data dictionary
  unsigned sessions = 0;
};

/// Returns the tables of all sessions of a study. Conditions are letters unless `unblinds`. Throws Refusal if there is
/// no session, or if a journal is damaged or of another design.
Tables export_study(const Design& design, const std::filesystem::path& study, bool unblinds);

}  // namespace hrt::experiment
