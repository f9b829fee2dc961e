// One reach of a simulated person, sample by sample: the truth, the command, and every state of the
// controller's filter with its deviation. A simulation.
#pragma once

#include <array>
#include <iterator>
#include <string>
#include <vector>

#include "core/person/person_filter.h"
#include "core/simulation/people.h"

namespace hrt::study {

struct TracedSample {
  double time_s;
  PlatePoint finger, felt;
  double plate_deg;
  double commanded_deg;
  double felt_error_deg;                                   ///< as the controller has it
  std::array<double, PersonState::count> mean, deviation;  ///< in the order of PersonState
};

struct Trace {
  PersonCondition condition;
  std::vector<TracedSample> samples;
};

/// Reach `reach`, from 1 on, of a person led by our controller, which has learnt from those before.
Trace trace_reach(const PersonCondition& condition, int reach, std::uint64_t seed, std::uint32_t index);

/// A state of the filter with its unit, as "bias_deg".
std::string state_name(const StateVariable& variable);

/// A row a sample; a column a state, beside it its deviation.
std::string trace_csv(const Trace& trace);

}  // namespace hrt::study
