#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {
namespace {

// Name of a filter state with its unit, such as "bias_deg".
std::string state_name(const StateVariable& variable) {
  return *variable.unit ? std::string(variable.name) + '_' + variable.unit : variable.name;
}

}  // namespace

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

std::vector<Figure> trace_figures(const Trace& trace) {
  Row reach{{"real_deg", trace.condition.real_direction_deg},
            {"virtual_deg", trace.condition.virtual_direction_deg},
            {"distance_mm", trace.condition.distance_mm}};
  for (const TracedSample& sample : trace.samples) {
    reach["time_s"].push_back(sample.time_s);
    reach["plate_deg"].push_back(sample.plate_deg);
    reach["finger_mm"].push_back({sample.finger.right_mm, sample.finger.away_mm});
    reach["felt_mm"].push_back({sample.felt.right_mm, sample.felt.away_mm});
  }
  Row filter;
  filter["time_s"] = reach["time_s"];
  for (const StateVariable& variable : person_state) {
    Row state{{"name", state_name(variable)}};
    for (const TracedSample& sample : trace.samples) {
      state["mean"].push_back(sample.mean[variable.index]);
      state["sd"].push_back(sample.deviation[variable.index]);
    }
    filter["states"].push_back(state);
  }
  return {
      {.name = "reach", .title = "", .caption = "", .data = reach},
      {.name = "trace", .title = "States of the filter over time in s, with +-2 SDs", .caption = "", .data = filter}};
}

}  // namespace hrt::study
