// hrt-study sweep: every combination of lists of values, as CSV.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/paper/participant.h"
#include "core/paper_simulation/batch.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/cli/parameters.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {
namespace {

// The points of a sweep: every combination of the lists given, numbered.
class Grid {
 public:
  std::vector<double> virtual_directions_deg{5.0};
  std::vector<double> gaps_deg{10.0};
  std::array<std::vector<double>, std::tuple_size_v<ParameterValues>> values;  ///< in the order of `parameters`

  Grid() {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {parameters[i].default_value};
  }

  /// The number of points. Throws UsageError if there are more than 2^32 - 1.
  std::uint64_t size() const {
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

  /// Point `index` < size(); the last list varies fastest.
  Condition at(std::uint64_t index) const {
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
};

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

struct SweepOptions {
  Grid grid;
  std::uint64_t trials = 1'000;
  std::uint64_t seed = 1;
  std::uint64_t threads = 1;
  std::string out;
};

// Simulates points [first, last) together; one row each.
std::string rows(const SweepOptions& options, std::uint64_t first, std::uint64_t last,
                 const std::function<void(std::uint64_t)>& progress) {
  std::vector<BatchJob> jobs;
  for (std::uint64_t index = first; index < last; ++index)
    jobs.push_back({.condition = options.grid.at(index),
                    .condition_id = static_cast<std::uint32_t>(index),
                    .first_trial = 0,
                    .last_trial = static_cast<std::uint32_t>(options.trials)});
  const std::vector<BatchResult> results =
      run_batch(jobs, options.seed,
                {.threads = static_cast<int>(options.threads),
                 .progress = [&](std::uint64_t done, std::uint64_t) { progress(done); }});
  std::string text;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    text += grid_row(first + i, jobs[i].condition, options.seed, results[i]);
  return text;
}

void check_gaps(const Grid& grid) {
  const auto [smallest, max] = std::minmax_element(grid.gaps_deg.begin(), grid.gaps_deg.end());
  for (const double virtual_deg : grid.virtual_directions_deg)
    for (const double gap_deg : {*smallest, *max})
      // The real direction is rounded, so that a gap of nearly 90 may become one of 90.
      if (std::abs(virtual_deg - (virtual_deg - gap_deg)) >= gap_range.high)
        throw UsageError(not_allowed("--gap", number(gap_deg), gap_range.text()));
}

void run(const SweepOptions& options) {
  check_gaps(options.grid);
  const Output output("--out", options.out);
  const std::uint64_t points = options.grid.size();
  // Blocks of about this many trials, so that all threads have work.
  constexpr std::uint64_t block_trials = 50'000;
  const std::uint64_t block = std::max<std::uint64_t>(1, block_trials / options.trials);
  std::string text = grid_header();
  Progress progress;
  for (std::uint64_t begin = 0; begin < points; begin += block)
    text += rows(options, begin, std::min(begin + block, points),
                 [&](std::uint64_t done) { progress.update(begin * options.trials + done, points * options.trials); });
  output.write(text);
}

}  // namespace

void add_sweep(CLI::App& app) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command =
      add_command(app, "sweep", "Every combination of lists of values, as CSV.",
                  R"(The grid has every combination of the listed values. A row of the CSV is one point: its parameters,
then the results of its trials. Point i takes the random numbers of condition i, so the rows do not
depend on threads.

Examples:
  hrt-study sweep --gap 2:20:10 --tactile-weight 0.05:0.45:9 --out gaps.csv
  hrt-study sweep --perceived-weight 0.01,0.1,1,10 --trials 100000)",
                  [options] { run(*options); });
  add_numbers(command, "--gap", &options->grid.gaps_deg, gap_range, "Gap: virtual minus real direction, deg.");
  add_numbers(command, "--virtual", &options->grid.virtual_directions_deg, direction_range,
              "Direction of the virtual target, deg.");
  for (std::size_t i = 0; i < parameters.size(); ++i) add_parameter(command, parameters[i], &options->grid.values[i]);
  add_trials(command, &options->trials, "Trials of each point.");
  add_seed(command, &options->seed);
  add_threads(command, &options->threads);
  add_out(command, &options->out);
}

}  // namespace hrt::study
