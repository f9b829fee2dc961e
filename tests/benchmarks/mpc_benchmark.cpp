// One step of the controller on the problems of a closed loop with the noisy participant, beside the same
// step by a general solver: ALGLIB's dense quadratic programming, the best that Debian 12 packages for C++.
// Every loop is first run against the dense reference of the tests; a wrong result fails the program.
#include <benchmark/benchmark.h>
#include <optimization.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/paper/mpc.h"
#include "core/paper/perception.h"
#include "core/simulation/random.h"
#include "tests/core/paper/mpc_random_problem.h"
#include "tests/core/paper/mpc_reference.h"

namespace hrt {
namespace {

constexpr int reach_steps = 30;
constexpr int reaches = 100;
constexpr int noises = 4096;

struct LoopConfig {
  const char* name;
  double tactile_weight;
  double rate_bound_deg;
};
constexpr double no_rate_bound = std::numeric_limits<double>::infinity();
// A gap of 10 degrees: within authority at w_T = 0.15, out of it at 0.1.
constexpr LoopConfig loops[] = {
    {"free", 0.15, no_rate_bound},
    {"saturated", 0.10, no_rate_bound},
    {"free, 40 deg/step", 0.15, 40.0},
    {"saturated, 40 deg/step", 0.10, 40.0},
};
constexpr int horizons[] = {3, 10, 20, 50};

// Reach after reach of a participant with a virtual target at 5 degrees and the real one at -5.
class ClosedLoop {
 public:
  ClosedLoop(const LoopConfig& loop, int horizon)
      : config_{.horizon = horizon, .plate_rate_bound_deg = loop.rate_bound_deg},
        tactile_weight_(loop.tactile_weight) {
    const Participant participant{.tactile_weight = loop.tactile_weight};
    GainWindow window(participant, horizon);
    for (auto& gains : windows_) {
      std::copy_n(window.data(), horizon, gains.begin());
      window.advance();
    }
    double variance_deg2 = participant.initial_variance_deg2;
    for (std::uint32_t i = 0; i < noises; ++i) {
      noise_deg_[i] = std::sqrt(participant.motor_variance_deg2 + variance_deg2) *
                      standard_normal({.seed = 1, .condition = 0, .trial = 0, .step = i});
      variance_deg2 = next_gain(participant, variance_deg2).variance_deg2;
    }
  }

  const MpcConfig& config() const { return config_; }
  int step_of_reach() const { return step_; }
  MpcProblem problem() const {
    return {finger_deg_, -10.0, tactile_weight_, plate_deg_, windows_[step_].data()};
  }

  void advance(double plate_deg) {
    finger_deg_ += noise_deg_[noise_] -
                   windows_[step_][0] * (tactile_weight_ * plate_deg + (1.0 - tactile_weight_) * finger_deg_);
    noise_ = (noise_ + 1) % noises;
    plate_deg_ = plate_deg;
    if (++step_ < reach_steps) return;
    step_ = 0;
    finger_deg_ = plate_deg_ = -5.0;
  }

 private:
  MpcConfig config_;
  double tactile_weight_;
  std::array<std::array<double, max_horizon>, reach_steps> windows_{};
  std::array<double, noises> noise_deg_{};
  int step_ = 0;
  int noise_ = 0;
  double finger_deg_ = -5.0;
  double plate_deg_ = -5.0;
};

// ALGLIB's solver, warm from its last solution. The matrices are those of dense_problem(), made ahead; a
// step only sets the linear term, which is affine in where the finger is, and the bound on the first turn.
class GeneralSolver {
 public:
  explicit GeneralSolver(const ClosedLoop& fresh_loop) : loop_(fresh_loop) {
    ClosedLoop loop = fresh_loop;
    const int n = loop.config().horizon;
    const bool has_rate_bound = std::isfinite(loop.config().plate_rate_bound_deg);
    linear_.setlength(n);
    solution_.setlength(n);
    std::fill_n(solution_.getcontent(), n, 0.0);
    for (int step = 0; step < reach_steps; ++step) {
      MpcProblem problem = loop.problem();
      problem.finger_offset_deg = 0.0;
      const DenseProblem at_0 = dense_problem(loop.config(), problem);
      problem.finger_offset_deg = 1.0;
      const DenseProblem at_1 = dense_problem(loop.config(), problem);
      alglib::real_2d_array hessian;
      hessian.setlength(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) hessian[i][j] = static_cast<double>(at_0.hessian(i, j));
      gradient_.emplace_back(at_0.gradient.cast<double>());
      gradient_by_finger_.emplace_back((at_1.gradient - at_0.gradient).cast<double>());
      states_.emplace_back();
      alglib::minqpstate& state = states_.back();
      alglib::minqpcreate(n, state);
      alglib::minqpsetquadraticterm(state, hessian, true);
      if (has_rate_bound)
        alglib::minqpsetalgobleic(state, 0.0, 0.0, 1e-8, 0);
      else
        alglib::minqpsetalgoquickqp(state, 0.0, 0.0, 1e-8, 0, true);
      alglib::minqpsetbcall(state, -loop.config().plate_bound_deg, loop.config().plate_bound_deg);
      if (has_rate_bound) {
        differences_.setlength(n, n);
        low_.setlength(n);
        high_.setlength(n);
        for (int i = 0; i < n; ++i) {
          for (int j = 0; j < n; ++j) differences_[i][j] = i == j ? 1.0 : i == j + 1 ? -1.0 : 0.0;
          low_[i] = -loop.config().plate_rate_bound_deg;
          high_[i] = loop.config().plate_rate_bound_deg;
        }
      }
      loop.advance(0.0);
    }
  }

  double solve(const MpcProblem& problem, int step) {
    alglib::minqpstate& state = states_[step];
    const int n = loop_.config().horizon;
    for (int i = 0; i < n; ++i)
      linear_[i] = gradient_[step][i] + problem.finger_offset_deg * gradient_by_finger_[step][i];
    alglib::minqpsetlinearterm(state, linear_);
    if (const double rate_deg = loop_.config().plate_rate_bound_deg; std::isfinite(rate_deg)) {
      low_[0] = problem.plate_offset_deg - rate_deg;
      high_[0] = problem.plate_offset_deg + rate_deg;
      alglib::minqpsetlc2dense(state, differences_, low_, high_);
    }
    alglib::minqpsetstartingpoint(state, solution_);
    alglib::minqpoptimize(state);
    alglib::minqpresultsbuf(state, solution_, report_);
    return solution_[0];
  }

 private:
  const ClosedLoop& loop_;
  std::vector<alglib::minqpstate> states_;
  std::vector<Eigen::VectorXd> gradient_;
  std::vector<Eigen::VectorXd> gradient_by_finger_;
  alglib::real_2d_array differences_;
  alglib::real_1d_array low_, high_, linear_, solution_;
  alglib::minqpreport report_;
};

std::string name_of(const char* solver, const LoopConfig& loop, int horizon) {
  return std::string(solver) + "/" + loop.name + "/" + std::to_string(horizon);
}

// Stops the program unless `solve` agrees with the reference on `steps` steps of the loop. Compared in
// degrees felt at the finger, which is what the cost is made of.
template <class Solve>
void check(const std::string& name, ClosedLoop loop, int steps, double tolerance_deg, const Solve& solve) {
  static std::set<std::string> checked;  // a benchmark is run many times over
  if (!checked.insert(name).second) return;
  for (int k = 0; k < steps; ++k) {
    const MpcProblem problem = loop.problem();
    const double plate_deg = solve(problem, loop.step_of_reach());
    const LongVector reference =
        dense_optimum(dense_problem(loop.config(), problem), feasible_start(loop.config(), problem));
    const double felt = problem.gains[0] * problem.tactile_weight;
    const double difference_deg = felt * (static_cast<double>(reference[0]) - plate_deg);
    if (!(std::abs(difference_deg) <= tolerance_deg)) {
      std::fprintf(stderr, "horizon %d, step %d: off the reference by %g degrees\n", loop.config().horizon, k,
                   difference_deg);
      std::exit(1);
    }
    loop.advance(plate_deg);
  }
}

int checked_steps(int horizon) {
  return horizon > 20 ? 2 * reach_steps : 10 * reach_steps;
}

// The problems that a controller meets in the loop, step by step. Each stays valid as long as `loop`.
std::vector<MpcProblem> problems_of(ClosedLoop& loop) {
  Mpc mpc(loop.config());
  std::vector<MpcProblem> problems;
  for (int k = 0; k < reaches * reach_steps; ++k) {
    problems.push_back(loop.problem());
    loop.advance(mpc.solve(problems.back()).plate_offset_deg);
  }
  return problems;
}

// Solves the problems of the loop in their order. Each waits for the answer to the one before, as in the
// loop, where the participant's step stands between them.
template <class Solve>
void time_steps(benchmark::State& state, const std::vector<MpcProblem>& problems, const Solve& solve) {
  int k = 0;
  double answer_deg = 0.0;
  for (auto _ : state) {
    MpcProblem problem = problems[k];
    problem.finger_offset_deg += 0.0 * answer_deg;
    answer_deg = solve(problem, k % reach_steps);
    if (++k == static_cast<int>(problems.size())) k = 0;
  }
  // Not in the loop: with a use of the answer there, gcc 12 copies it in each turn.
  if (!std::isfinite(answer_deg)) state.SkipWithError("an answer is no number");
}

void run_controller(benchmark::State& state, const LoopConfig& loop_config, int horizon) {
  ClosedLoop loop(loop_config, horizon);
  Mpc mpc(loop.config());
  const auto solve = [&](const MpcProblem& problem, int) { return mpc.solve(problem).plate_offset_deg; };
  check(name_of("controller", loop_config, horizon), loop, checked_steps(horizon), 1e-12, solve);
  time_steps(state, problems_of(loop), solve);
}

void run_general(benchmark::State& state, const LoopConfig& loop_config, int horizon) {
  ClosedLoop loop(loop_config, horizon);
  GeneralSolver solver(loop);
  const auto solve = [&](const MpcProblem& problem, int step) { return solver.solve(problem, step); };
  check(name_of("ALGLIB", loop_config, horizon), loop, checked_steps(horizon), 1e-6, solve);
  time_steps(state, problems_of(loop), solve);
}

// The times of single solves in microseconds, each the least of five: `cold` with a new controller for each
// problem, else in the order of the loop.
std::vector<double> single_times_us(const MpcConfig& config, const std::vector<MpcProblem>& problems,
                                    bool cold) {
  std::vector<double> min_us(problems.size(), std::numeric_limits<double>::infinity());
  for (int repetition = 0; repetition < 5; ++repetition) {
    Mpc mpc(config);
    for (std::size_t k = 0; k < problems.size(); ++k) {
      if (cold) mpc = Mpc(config);
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(mpc.solve(problems[k]));
      const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
      min_us[k] = std::min(min_us[k], time.count());
    }
  }
  std::sort(min_us.begin(), min_us.end());
  return min_us;
}

void print_single_times(const char* name, int horizon, const char* start,
                        const std::vector<double>& sorted_us) {
  std::printf("%-24s  %7d  %5s  %9.2f  %6.2f  %8.2f\n", name, horizon, start, sorted_us[sorted_us.size() / 2],
              sorted_us[sorted_us.size() * 99 / 100], sorted_us.back());
}

// Random problems with a rate bound from a quarter of a percent of the plate bound to all of it: far harder
// than a loop's, and some take all the work that is allowed.
std::vector<double> random_times_us(int horizon) {
  Random random(static_cast<unsigned>(horizon));
  std::vector<double> times_us;
  for (int i = 0; i < 5000; ++i) {
    RandomProblem drawn(random, horizon, true);
    drawn.config.plate_rate_bound_deg = drawn.config.plate_bound_deg * std::exp(uniform(random, -6.0, 0.0));
    times_us.push_back(single_times_us(drawn.config, {drawn.problem}, true).front());
  }
  std::sort(times_us.begin(), times_us.end());
  return times_us;
}

void print_worst_cases() {
  std::printf("\nsingle solves             horizon  start  median us  p99 us  worst us\n");
  for (const LoopConfig& loop_config : loops) {
    for (const int horizon : horizons) {
      ClosedLoop loop(loop_config, horizon);
      const std::vector<MpcProblem> problems = problems_of(loop);
      for (const bool cold : {true, false})
        print_single_times(loop_config.name, horizon, cold ? "cold" : "warm",
                           single_times_us(loop.config(), problems, cold));
    }
  }
  for (const int horizon : horizons) print_single_times("random", horizon, "cold", random_times_us(horizon));
}

void run_filter(benchmark::State& state) {
  const Participant participant;
  FilterGain step{0.0, participant.initial_variance_deg2};
  double plate_deg = 0.0;
  for (auto _ : state) {
    step = next_gain(participant, step.variance_deg2);
    plate_deg = participant_step({.tactile_weight = participant.tactile_weight,
                                  .gain = step.gain,
                                  .goal_direction_deg = 5.0,
                                  .plate_orientation_deg = plate_deg,
                                  .finger_direction_deg = 1.0})
                    .perceived_direction_deg;
    benchmark::DoNotOptimize(plate_deg);
  }
}

// Prints as usual and keeps the least time of every benchmark.
class Reporter : public benchmark::ConsoleReporter {
 public:
  Reporter() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const double time_ns = run.GetAdjustedCPUTime();
      const auto [entry, added] = min_ns_.emplace(run.run_name.function_name, time_ns);
      if (!added) entry->second = std::min(entry->second, time_ns);
    }
  }

  // Those that a filter left out are shown as "nan".
  void print_ratios() const {
    std::printf("\nleast of all repetitions  horizon  controller ns  ALGLIB ns  ratio\n");
    for (const LoopConfig& loop : loops) {
      for (const int horizon : horizons) {
        const double ours_ns = min_ns(name_of("controller", loop, horizon));
        const double general_ns = min_ns(name_of("ALGLIB", loop, horizon));
        std::printf("%-24s  %7d  %13.1f  %9.0f  %5.0f\n", loop.name, horizon, ours_ns, general_ns,
                    general_ns / ours_ns);
      }
    }
  }

 private:
  double min_ns(const std::string& name) const {
    const auto entry = min_ns_.find(name);
    return entry == min_ns_.end() ? std::numeric_limits<double>::quiet_NaN() : entry->second;
  }

  std::map<std::string, double> min_ns_;
};

}  // namespace
}  // namespace hrt

int main(int argc, char** argv) {
  using namespace hrt;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RegisterBenchmark("filter", run_filter);
  for (const LoopConfig& loop : loops) {
    for (const int horizon : horizons) {
      benchmark::RegisterBenchmark(
          name_of("controller", loop, horizon).c_str(),  // NOLINT(readability-redundant-string-cstr)
          [&loop, horizon](benchmark::State& state) { run_controller(state, loop, horizon); });
      benchmark::RegisterBenchmark(
          name_of("ALGLIB", loop, horizon).c_str(),  // NOLINT(readability-redundant-string-cstr)
          [&loop, horizon](benchmark::State& state) { run_general(state, loop, horizon); });
    }
  }
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratios();
  print_worst_cases();
}
