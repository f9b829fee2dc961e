// Simulates successive reaches of one person.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/person/person_filter.h"
#include "core/retargeter_config.h"
#include "core/simulation/people.h"

namespace hrt {

/// Result of a reach: ground truth, and the summary of the controller.
struct PersonOutcome {
  double bearing_error_deg;    ///< bearing of the end minus that of the real target
  double miss_mm;              ///< distance of the end from the line to the real target, signed as bearing_error_deg
  PlatePoint finger;           ///< final position
  double peak_felt_error_deg;  ///< largest size of SlidingPerson::felt_error_deg() at more than 10 mm/s
  ReachSummary summary;        ///< summary of the controller; without a controller, the defaults
  std::optional<PersonBelief> learnt;  ///< prior of the next reach, before a contact; nullopt if not changed
};

/// A sample of a reach, with the ground truth.
struct PersonMoment {
  double time_s;  ///< time since the reach began; the finger rests for the first 0.4 to 0.8 s
  PlatePoint finger;
  PlatePoint felt;   ///< perceived position of the finger
  double plate_deg;  ///< plate orientation, without PersonCondition::plate_offset_deg
  PlateCommand command;
  const PersonFilter* filter;  ///< filter of the controller; null under the paper's controller
};
using PersonWatch = std::function<void(int, const PersonMoment&)>;

/// Simulates `reaches` successive reaches of one person. A controller for people begins each reach with the estimates
/// from the reaches before it; the paper's controller begins each with `controller`. If `controller` is null, the plate
/// stays at 0. `watch` is called for each processed sample, with the number of the reach, which begins at 0. Any
/// thread.
std::vector<PersonOutcome> simulate_person(const PersonCondition& condition, const RetargeterConfig* controller,
                                           int reaches, std::uint64_t seed, std::uint32_t index,
                                           const PersonWatch& watch = {});

}  // namespace hrt
