// Simulated steps per second on one thread: participant, controller and random number of a step together.
// Rows: one of a table (four trials side by side, two, one after the other), and one with the solver in the
// loop.
#include <benchmark/benchmark.h>

#include <cstdint>

#include "core/paper_simulation/batch.h"
#include "core/paper_simulation/trial_table.h"
#include "core/simulation/lanes.h"

namespace hrt {
namespace {

constexpr std::uint32_t table_trials = 4096;
constexpr std::uint32_t solver_trials = 64;

// Arguments: w_T in hundredths (at 10 the plate stands at its bound nearly always), horizon.
Condition condition_of(const benchmark::State& state) {
  Condition condition;
  condition.participant.tactile_weight = static_cast<double>(state.range(0)) / 100.0;
  condition.controller.participant = condition.participant;
  condition.controller.mpc.horizon = static_cast<int>(state.range(1));
  return condition;
}

void grid(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"w_percent", "horizon"})->ArgsProduct({{10, 15}, {3, 20, 50}});
}

template <class Lanes>
void steps_by_table(benchmark::State& state) {
  const TrialTable table = *TrialTable::tabulate(condition_of(state));
  std::uint32_t id = 0;
  std::uint64_t steps = 0;
  for (auto _ : state) steps += table.run<Lanes>(1, id++, 0, table_trials).steps;
  state.SetItemsProcessed(static_cast<std::int64_t>(steps));
}
#if defined(HRT_AVX2)  // on a processor that has it
BENCHMARK(steps_by_table<QuadLanes>)->Apply(grid);
#endif
BENCHMARK(steps_by_table<PairLanes>)->Apply(grid);
BENCHMARK(steps_by_table<ScalarLanes>)->Apply(grid);

void steps_by_solver(benchmark::State& state) {
  const Condition condition = condition_of(state);
  std::uint32_t id = 0;
  std::uint64_t steps = 0;
  for (auto _ : state) {
    for (std::uint32_t trial = 0; trial < solver_trials; ++trial)
      benchmark::DoNotOptimize(simulate_trial(condition, {.seed = 1, .condition = id, .trial = trial}));
    steps += solver_trials * static_cast<std::uint64_t>(condition.steps);
    ++id;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(steps));
}
BENCHMARK(steps_by_solver)->Apply(grid);

}  // namespace
}  // namespace hrt

BENCHMARK_MAIN();
