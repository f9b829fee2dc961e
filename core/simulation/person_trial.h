// Reaches of a simulated person, one after another. Results are of simulation.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/person/person_filter.h"
#include "core/retargeter_config.h"
#include "core/simulation/people.h"

namespace hrt {

/// End of a reach: ground truth, not an estimate.
struct PersonOutcome {
  double bearing_error_deg;    ///< bearing of the end from the start, minus that of the real target
  double miss_mm;              ///< across the real direction, signed as bearing_error_deg
  PlatePoint finger;           ///< final position
  double peak_felt_error_deg;  ///< largest perceived minus virtual direction while the finger moves
  ReachSummary summary;        ///< the controller's own account; zero without a controller
  std::optional<PersonBelief>
      learnt;  ///< estimate with which the next reach begins; none if this reach changes nothing
};

/// A sample of a reach, with the ground truth.
struct PersonMoment {
  double time_s;      ///< since the reach began; the finger moves later
  PlatePoint finger;  ///< position of the finger
  PlatePoint felt;    ///< perceived position of the finger
  double plate_deg;   ///< direction of the ridge normal
  PlateCommand command;
  const PersonFilter* filter;  ///< the controller's; null: it is not the one for people
};
/// Called with the number of the reach, from 0 on.
using PersonWatch = std::function<void(int, const PersonMoment&)>;

/// `reaches` of one person, one after another, each led by `controller` with what it has learnt; as
/// ControlMode::reach carries it. Without a controller (null) the plate stays at 0. `watch` gets each sample
/// that a controller has taken. Any thread.
std::vector<PersonOutcome> simulate_person(const PersonCondition& condition, const RetargeterConfig* controller,
                                           int reaches, std::uint64_t seed, std::uint32_t index,
                                           const PersonWatch& watch = {});

}  // namespace hrt
