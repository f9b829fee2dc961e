// The robustness study as text, CSV and JSON.
#pragma once

#include <string>
#include <vector>

#include "samples/study/people/robustness.h"

namespace hrt::study {

struct RobustnessStudy {
  RobustnessOptions options;
  std::vector<SimulatedPeople> people;
  std::vector<RobustnessRow> rows;  ///< simulate_robustness() of both
};

/// The name of the people, with the mark of their sort: * kept apart, + misplaced.
std::string label(const SimulatedPeople& people);

/// The condition common to all reaches.
std::string condition_words(const RobustnessStudy& study);

std::string robustness_text(const RobustnessStudy& study);
std::string robustness_csv(const RobustnessStudy& study);
std::string robustness_json(const RobustnessStudy& study);

}  // namespace hrt::study
