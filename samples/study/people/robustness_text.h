// The robustness study as text, and as rows of numbers.
#pragma once

#include <string>
#include <vector>

#include "samples/study/numbers/results.h"
#include "samples/study/people/robustness.h"

namespace hrt::study {

struct RobustnessStudy {
  RobustnessOptions options;
  std::vector<SimulatedPeople> people;
  std::vector<RobustnessRow> rows;  ///< simulate_robustness() of both
};

/// The name of the people, with the mark of their sort: * kept apart, + misplaced.
std::string label(const SimulatedPeople& people);

std::string robustness_text(const RobustnessStudy& study);
/// A row a family, duration and controller.
Results robustness_results(const RobustnessStudy& study);

}  // namespace hrt::study
