#include "samples/study/paper/grid.h"

#include <limits>

#include "core/paper/participant.h"
#include "samples/study/cli/output.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {

Grid::Grid() {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = {parameters[i].default_value};
}

std::uint64_t Grid::size() const {
  constexpr std::uint64_t max = std::numeric_limits<std::uint32_t>::max();
  // Lists are short enough that one product of them cannot overflow.
  std::uint64_t size = virtual_directions_deg.size() * gaps_deg.size();
  for (const auto& list : values) {
    if (size <= max) size *= list.size();
  }
  if (size > max)
    throw UsageError("--gap and the other lists: at most " + std::to_string(max) + " combinations are allowed");
  return size;
}

Condition Grid::at(std::uint64_t index) const {
  const auto take = [&index](const std::vector<double>& list) {
    const double value = list[index % list.size()];
    index /= list.size();
    return value;
  };
  ParameterValues point;
  for (std::size_t i = values.size(); i-- > 0;) point[i] = take(values[i]);
  const double gap_deg = take(gaps_deg);
  const double virtual_direction_deg = take(virtual_directions_deg);
  return make_condition(point, virtual_direction_deg - gap_deg, virtual_direction_deg);
}

std::string grid_header() {
  std::string row = "index,real_direction_deg,virtual_direction_deg,";
  for (const Parameter& parameter : parameters) row += std::string(parameter.column) + ',';
  return row +
         "seed,trials,hits,hit_percent,hit_percent_low,hit_percent_high,mean_miss_deg,rms_miss_deg,"
         "rms_perceived_error_deg,saturated_share,max_gap_deg,reachable\n";
}

std::string grid_row(std::uint64_t index, const Condition& condition, std::uint64_t seed, const BatchResult& result) {
  const PercentInterval interval = wilson_interval(result.hit_percent(), static_cast<double>(result.trials));
  const Authority authority =
      steering_authority(condition.real_direction_deg, condition.virtual_direction_deg,
                         condition.participant.tactile_weight, condition.controller.mpc.plate_bound_deg);
  std::string row = std::to_string(index) + ',' + number(condition.real_direction_deg) + ',' +
                    number(condition.virtual_direction_deg) + ',';
  for (const double value : values_of(condition)) row += number(value) + ',';
  row += std::to_string(seed) + ',' + std::to_string(result.trials) + ',' + std::to_string(result.hits);
  for (const double value :
       {result.hit_percent(), interval.low, interval.high, result.mean_miss_deg(), result.rms_miss_deg(),
        result.rms_felt_error_deg(), result.saturated_share(), authority.max_gap_deg})
    row += ',' + number(value);
  return row + (authority.reachable ? ",1\n" : ",0\n");
}

}  // namespace hrt::study
