// hrt-study sweep: every combination of lists of values, as CSV, in parts.
#include <algorithm>
#include <cmath>
#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/cli/part.h"
#include "samples/study/commands/commands.h"
#include "samples/study/paper/grid.h"

namespace hrt::study {
namespace {

struct SweepOptions {
  Grid grid;
  Part part;
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
  const std::uint64_t first = options.part.begin(points);
  const std::uint64_t last = options.part.end(points);
  // Blocks of about this many trials, so that all threads have work.
  constexpr std::uint64_t block_trials = 50'000;
  const std::uint64_t block = std::max<std::uint64_t>(1, block_trials / options.trials);
  std::string text = options.part.has_header() ? grid_header() : "";
  Progress progress;
  for (std::uint64_t begin = first; begin < last; begin += block)
    text += rows(options, begin, std::min(begin + block, last), [&](std::uint64_t done) {
      progress.update((begin - first) * options.trials + done, (last - first) * options.trials);
    });
  output.write(text);
}

}  // namespace

void add_sweep(CLI::App& app) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command =
      add_command(app, "sweep", "Every combination of lists of values, as CSV; in parts.",
                  R"(The grid has every combination of the listed values. A row of the CSV is one point: its parameters,
then the results of its trials. Point i takes the random numbers of condition i, so the rows do not
depend on threads or parts.
)" + part_words("points") +
                      R"(
Examples:
  hrt-study sweep --gap 2:20:10 --tactile-weight 0.05:0.45:9 --out gaps.csv
  hrt-study sweep --perceived-weight 0.01,0.1,1,10 --trials 100000
  hrt-study sweep --horizon 1:50:50 --part $SLURM_ARRAY_TASK_ID/8 --out part$SLURM_ARRAY_TASK_ID.csv
  cat part1.csv part2.csv part3.csv > whole.csv)",
                  [options] { run(*options); });
  add_numbers(command, "--gap", &options->grid.gaps_deg, gap_range, "Gap: virtual minus real direction, deg.");
  add_numbers(command, "--virtual", &options->grid.virtual_directions_deg, direction_range,
              "Direction of the virtual target, deg.");
  for (std::size_t i = 0; i < parameters.size(); ++i) add_parameter(command, parameters[i], &options->grid.values[i]);
  add_trials(command, &options->trials, "Trials of each point.");
  add_seed(command, &options->seed);
  add_threads(command, &options->threads);
  add_part(command, &options->part);
  add_out(command, &options->out);
}

}  // namespace hrt::study
