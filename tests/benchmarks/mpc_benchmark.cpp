// Single solves of the controller's problem: those of a closed loop with the noisy participant, and random
// ones.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <limits>
#include <vector>

#include "core/paper/mpc.h"
#include "core/paper/participant.h"
#include "core/simulation/random.h"
#include "tests/benchmarks/peers.h"
#include "tests/core/paper/mpc_random_problem.h"

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
constexpr int horizons[] = {3, 10, 20};
constexpr std::size_t compared = 500;   // problems that peers solve too, of these
constexpr std::size_t referenced = 25;  // each so manieth by the reference

struct Case {
  MpcConfig config;
  MpcProblem problem;
};

// Reach after reach of a participant with a virtual target at 5 degrees and the real one at -5.
class ClosedLoop {
 public:
  ClosedLoop(const LoopConfig& loop, int horizon)
      : config_{.horizon = horizon, .plate_rate_bound_deg = loop.rate_bound_deg}, tactile_weight_(loop.tactile_weight) {
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
  MpcProblem problem() const { return {finger_deg_, -10.0, tactile_weight_, plate_deg_, windows_[step_].data()}; }

  void advance(double plate_deg) {
    finger_deg_ +=
        noise_deg_[noise_] - windows_[step_][0] * (tactile_weight_ * plate_deg + (1.0 - tactile_weight_) * finger_deg_);
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

// The problems that a controller meets in the loop, step by step. Each stays valid as long as `loop`.
std::vector<MpcProblem> problems_of(ClosedLoop& loop) {
  const Mpc mpc(loop.config());
  std::vector<MpcProblem> problems;
  for (int k = 0; k < reaches * reach_steps; ++k) {
    problems.push_back(loop.problem());
    loop.advance(mpc.solve(problems.back()).plate_offset_deg);
  }
  return problems;
}

// The times of single solves in microseconds, each the least of five.
std::vector<double> single_times_us(const MpcConfig& config, const std::vector<MpcProblem>& problems) {
  std::vector<double> min_us(problems.size(), std::numeric_limits<double>::infinity());
  for (int repetition = 0; repetition < 5; ++repetition) {
    const Mpc mpc(config);
    for (std::size_t k = 0; k < problems.size(); ++k) {
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(mpc.solve(problems[k]));
      const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
      min_us[k] = std::min(min_us[k], time.count());
    }
  }
  std::sort(min_us.begin(), min_us.end());
  return min_us;
}

void print_row(const char* name, int horizon, const std::vector<double>& sorted_us) {
  std::printf("%-24s  %7d  %9.2f  %6.2f  %8.2f\n", name, horizon, sorted_us[sorted_us.size() / 2],
              sorted_us[sorted_us.size() * 99 / 100], sorted_us.back());
}

// Ours and each peer in the same run: by how much longer it takes, and the largest error of a first
// plate offset against the long-double reference.
void print_peers(const std::vector<Case>& cases) {
  if (peers().empty()) return;
  const std::size_t count = std::min(cases.size(), compared);
  std::vector<DenseProblem> dense;
  std::vector<double> ours_us, ours_deg, exact_deg;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [of, problem] = cases[i];
    dense.push_back(dense_problem(of, problem));
    const Mpc mpc(of);
    ours_us.push_back(solve_us([](int) {}, [&](int) { benchmark::DoNotOptimize(mpc.solve(problem)); }));
    ours_deg.push_back(mpc.solve(problem).plate_offset_deg);
    if (i % referenced == 0)
      exact_deg.push_back(static_cast<double>(dense_optimum(dense[i], feasible_start(of, problem))[0]));
  }
  const auto print = [&](const char* name, std::vector<double> us, const std::vector<double>& deg) {
    double error_deg = 0.0;
    for (std::size_t i = 0; i < exact_deg.size(); ++i)
      error_deg = std::max(error_deg, std::abs(deg[referenced * i] - exact_deg[i]));
    std::sort(us.begin(), us.end());
    std::sort(ours_us.begin(), ours_us.end());
    std::printf("    %-11s %6.2f times the median, %6.2f the 99th percentile; error %.1e deg\n", name,
                us[count / 2] / ours_us[count / 2], us[count * 99 / 100] / ours_us[count * 99 / 100], error_deg);
  };
  print("ours", ours_us, ours_deg);
  for (const Peer& peer : peers()) {
    std::vector<double> us, deg(count);
    for (std::size_t i = 0; i < count; ++i) us.push_back(peer.solve(dense[i], deg[i]));
    print(peer.name, us, deg);
  }
}

// Random problems with a rate bound from a quarter of a percent of the plate bound to all of it: far harder
// than a loop's.
void print_random_times(int horizon, int problems) {
  Random random(static_cast<unsigned>(horizon));
  std::vector<double> times_us;
  std::deque<RandomProblem> kept;
  std::vector<Case> cases;
  int cut = 0;
  for (int i = 0; i < problems; ++i) {
    if (kept.size() > compared) kept.pop_back();
    const RandomProblem& drawn = kept.emplace_back(random, horizon, RandomRate::slow);
    times_us.push_back(single_times_us(drawn.config, {drawn.problem}).front());
    cut += !Mpc(drawn.config).solve(drawn.problem).optimal;
    if (cases.size() < compared) cases.push_back({drawn.config, drawn.problem});
  }
  std::sort(times_us.begin(), times_us.end());
  print_row("random", horizon, times_us);
  if (cut > 0) std::printf("of these, %d are not optimal\n", cut);
  print_peers(cases);
}

void print_single_times(int random_problems) {
  std::printf("single solves             horizon  median us  p99 us  worst us\n");
  for (const LoopConfig& loop_config : loops) {
    for (const int horizon : horizons) {
      ClosedLoop loop(loop_config, horizon);
      const std::vector<MpcProblem> problems = problems_of(loop);
      print_row(loop_config.name, horizon, single_times_us(loop.config(), problems));
      std::vector<Case> cases;
      for (const MpcProblem& problem : problems) cases.push_back({loop.config(), problem});
      print_peers(cases);
    }
  }
  for (const int horizon : horizons) print_random_times(horizon, random_problems);
}

}  // namespace
}  // namespace hrt

// hrt_mpc_benchmark [RANDOM_PROBLEMS]
int main(int argc, char** argv) { hrt::print_single_times(argc > 1 ? std::atoi(argv[1]) : 5000); }
