#include "core/simulation/controllers.h"
#include "core/simulation/person_trial.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {

Results trace_reach(const PersonCondition& condition, int reach, std::uint64_t seed, std::uint32_t index) {
  Results trace{.about = {{"real_deg", condition.real_direction_deg},
                          {"virtual_deg", condition.virtual_direction_deg},
                          {"distance_mm", condition.distance_mm}},
                .rows = {}};
  std::vector<std::string> names;
  for (const StateVariable& variable : person_state)
    names.push_back(fmt::format("{}{}{}", variable.name, *variable.unit ? "_" : "", variable.unit));
  trace.about["states"] = names;
  const RetargeterConfig controller = people_controller(condition);
  simulate_person(condition, &controller, reach, seed, index, [&](int number, const PersonMoment& moment) {
    if (number + 1 != reach) return;
    Row& row = trace.rows.emplace_back(Row{{"time_s", moment.time_s},
                                           {"finger_right_mm", moment.finger.right_mm},
                                           {"finger_away_mm", moment.finger.away_mm},
                                           {"felt_right_mm", moment.felt.right_mm},
                                           {"felt_away_mm", moment.felt.away_mm},
                                           {"plate_deg", moment.plate_deg},
                                           {"commanded_deg", moment.command.plate_orientation_deg},
                                           {"felt_error_deg", moment.command.felt_error_deg}});
    for (std::size_t i = 0; i < names.size(); ++i) {
      row[names[i]] = moment.filter->mean(person_state[i].index);
      row[names[i] + "_sd"] = moment.filter->sd(person_state[i].index);
    }
  });
  return trace;
}

}  // namespace hrt::study
