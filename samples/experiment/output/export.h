// What a study's journals say, as tables: a row a trial, a row a person.
#pragma once

#include <filesystem>
#include <string>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

struct Tables {
  std::string trials;      ///< CSV
  std::string people;      ///< CSV
  std::string dictionary;  ///< of both, Markdown
  unsigned sessions = 0;
};

/// Of all sessions in the study's folder. Conditions are letters unless `unblinds`. Throws Refusal.
Tables export_study(const Design& design, const std::filesystem::path& study, bool unblinds);

}  // namespace hrt::experiment
