#include "core/mpc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hrt {
namespace {

constexpr std::array<double, max_horizon> steady_gains() {
  std::array<double, max_horizon> gains{};
  gains.fill(0.85);
  return gains;
}
constexpr auto gains = steady_gains();

double perceived_error(const Mpc::Command& command, const MpcProblem& problem) {
  return problem.gains[0] * (problem.tactile_weight * command.plate_offset_deg +
                             (1.0 - problem.tactile_weight) * problem.finger_offset_deg);
}

// Away from the bound e_k = g_N (p_k - p_R), g_N a ratio of Fibonacci numbers.
TEST(Mpc, UnconstrainedGains) {
  const MpcProblem problem{1.0, -0.5, 0.15, 0.0, gains.data()};
  const double expected[] = {0.0, 1.0 / 2.0, 3.0 / 5.0, 8.0 / 13.0, 21.0 / 34.0};
  for (int horizon = 1; horizon <= 5; ++horizon) {
    Mpc mpc({.horizon = horizon});
    const Mpc::Command command = mpc.solve(problem);
    EXPECT_EQ(command.active, ActiveBound::none);
    EXPECT_NEAR(perceived_error(command, problem), expected[horizon - 1] * 1.5, 1e-12) << horizon;
  }
}

// N = 2, p_k = 0, p_R = -12, w = 0.1, K = 0.85: e_0 = 12 / 2 = 6, so t_0 = 6 / (0.85 * 0.1) = 70.59.
//
// N = 3: the free optimum's second step would need t_1 = 93, so t_1 stands at the bound and
// e_1 = 0.85 (0.1 * 84.5 - 0.9 e_0) = 7.1825 - 0.765 e_0, x_1 = 12 - e_0, x_2 = 4.8175 - 0.235 e_0, e_2 = 0.
// d/de_0 of e_0^2 + e_1^2 + x_1^2 + x_2^2 vanishes at e_0 = (12 + 0.765 * 7.1825 + 0.235 * 4.8175) / 2.64045.
TEST(Mpc, SaturatedSecondStepByHand) {
  const MpcProblem problem{0.0, -12.0, 0.1, 0.0, gains.data()};
  EXPECT_NEAR(Mpc({.horizon = 2}).solve(problem).plate_offset_deg, 6.0 / 0.085, 1e-10);
  MpcDiagnostics diagnostics;
  const Mpc::Command command = Mpc({.horizon = 3}).solve(problem, &diagnostics);
  const double e_0 = (12.0 + 0.765 * 7.1825 + 0.235 * 4.8175) / 2.64045;
  EXPECT_NEAR(command.plate_offset_deg, e_0 / 0.085, 1e-10);
  EXPECT_EQ(diagnostics.active[0], ActiveBound::none);
  EXPECT_EQ(diagnostics.active[1], ActiveBound::upper);
  EXPECT_EQ(diagnostics.active[2], ActiveBound::none);
}

// The same with p_R = -14: (14 + 0.765 * 7.1825 + 0.235 * 6.8175) / 2.64045 = 7.99, but the bound only
// gives e_0 = 0.085 * 84.5 = 7.18.
TEST(Mpc, SaturatedFirstStepByHand) {
  const MpcProblem problem{0.0, -14.0, 0.1, 0.0, gains.data()};
  const Mpc::Command command = Mpc({.horizon = 3}).solve(problem);
  EXPECT_EQ(command.active, ActiveBound::upper);
  EXPECT_DOUBLE_EQ(command.plate_offset_deg, 84.5);
}

// The cost of the plate offsets `plate`, straight from the definition.
double window_cost(const MpcConfig& config, const MpcProblem& problem, const std::vector<double>& plate) {
  double p = problem.finger_offset_deg;
  double cost = 0.0;
  for (std::size_t i = 0; i < plate.size(); ++i) {
    const double e =
        problem.gains[i] * (problem.tactile_weight * plate[i] + (1.0 - problem.tactile_weight) * p);
    const double miss = p - problem.real_offset_deg;
    cost += config.perceived_weight * e * e + config.actual_weight * miss * miss;
    p -= e;
  }
  return cost;
}

TEST(Mpc, NoGridPointBeatsTheOptimum) {
  const MpcConfig config{.horizon = 3};
  for (const double w : {0.05, 0.1, 0.15, 0.3}) {
    for (const double finger : {-25.0, -9.4, -3.0, 0.0, 2.0, 12.0}) {
      for (const double real : {-12.0, -10.0, 0.0, 5.0}) {
        const MpcProblem problem{finger, real, w, 0.0, gains.data()};
        MpcDiagnostics diagnostics;
        Mpc(config).solve(problem, &diagnostics);
        const std::vector<double> optimum(diagnostics.plate_offset_deg.begin(),
                                          diagnostics.plate_offset_deg.begin() + 3);
        const double best = window_cost(config, problem, optimum);
        EXPECT_NEAR(best, diagnostics.cost, 1e-9 * (1.0 + best));
        for (int a = -20; a <= 20; ++a) {
          for (int b = -20; b <= 20; ++b) {
            for (int c = -20; c <= 20; ++c) {
              const double cost = window_cost(config, problem, {a * 4.225, b * 4.225, c * 4.225});
              ASSERT_GE(cost, best - 1e-9 * (1.0 + best)) << w << ' ' << finger << ' ' << real;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace hrt
