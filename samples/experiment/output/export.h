// Tables of the contents of a study's journals.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

struct Tables {
  std::map<std::string, std::string> files;  ///< by name: CSV, and their dictionary in Markdown
  unsigned sessions = 0;
};

/// Tables of all sessions in the study's folder. Conditions are letters unless `unblinds`. Throws Refusal.
Tables export_study(const Design& design, const std::filesystem::path& study, bool unblinds);

}  // namespace hrt::experiment
