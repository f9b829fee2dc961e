#include "samples/study/people/trace.h"

#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "samples/study/cli/output.h"

namespace hrt::study {

Trace trace_reach(const PersonCondition& condition, int reach, std::uint64_t seed, std::uint32_t index) {
  Trace trace{.condition = condition, .samples = {}};
  const RetargeterConfig controller = people_controller(condition);
  simulate_person(condition, &controller, reach, seed, index, [&](int number, const PersonMoment& moment) {
    if (number + 1 != reach) return;
    trace.samples.push_back({.time_s = moment.time_s,
                             .finger = moment.finger,
                             .felt = moment.felt,
                             .plate_deg = moment.plate_deg,
                             .commanded_deg = moment.command.plate_orientation_deg,
                             .felt_error_deg = moment.command.felt_error_deg,
                             .mean = {},
                             .deviation = {}});
    for (const StateVariable& variable : person_state) {
      trace.samples.back().mean[variable.index] = moment.filter->mean(variable.index);
      trace.samples.back().deviation[variable.index] = moment.filter->sd(variable.index);
    }
  });
  return trace;
}

std::string state_name(const StateVariable& variable) {
  return *variable.unit ? std::string(variable.name) + '_' + variable.unit : variable.name;
}

std::string trace_csv(const Trace& trace) {
  std::string page =
      "time_s,finger_right_mm,finger_away_mm,felt_right_mm,felt_away_mm,plate_deg,commanded_deg,felt_error_"
      "deg";
  for (const StateVariable& variable : person_state)
    page += ',' + state_name(variable) + ',' + state_name(variable) + "_sd";
  page += '\n';
  for (const TracedSample& sample : trace.samples) {
    page += number(sample.time_s);
    for (const double value : {sample.finger.right_mm, sample.finger.away_mm, sample.felt.right_mm, sample.felt.away_mm,
                               sample.plate_deg, sample.commanded_deg, sample.felt_error_deg})
      page += ',' + number(value);
    for (std::size_t i = 0; i < sample.mean.size(); ++i)
      page += ',' + number(sample.mean[i]) + ',' + number(sample.deviation[i]);
    page += '\n';
  }
  return page;
}

}  // namespace hrt::study
