// The controller against judges that share nothing with it (mpc_reference.h), on random problems.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/mpc.h"
#include "tests/core/mpc_reference.h"

namespace hrt {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

struct RandomProblem {
  MpcConfig config;
  std::array<double, max_horizon> gains;
  MpcProblem problem;
};

enum class Gains { any, of_filter };

// Every quantity over its whole range, with values that meet each other exactly now and then.
void draw(Random& random, int horizon, bool has_rate_bound, Gains gains, RandomProblem& drawn) {
  drawn.config = {
      .horizon = horizon,
      .perceived_weight = std::exp(uniform(random, -3.0, 3.0)),
      .actual_weight = random() % 8 == 0 ? 0.0 : std::exp(uniform(random, -3.0, 3.0)),
      .plate_bound_deg = random() % 2 ? 90.0 : std::ceil(uniform(random, 0.0, 90.0)),
  };
  if (has_rate_bound)
    drawn.config.plate_rate_bound_deg =
        random() % 2 ? 0.5 * drawn.config.plate_bound_deg : uniform(random, 0.5, 60.0);
  for (double& gain : drawn.gains) gain = gains == Gains::any ? uniform(random, 0.01, 1.0) : 0.0;
  if (gains == Gains::of_filter) {
    const Participant participant{.motor_variance_deg2 = std::exp(uniform(random, -3.0, 2.0)),
                                  .sensory_variance_deg2 = std::exp(uniform(random, -3.0, 2.0)),
                                  .initial_variance_deg2 = uniform(random, 0.0, 2.0)};
    const GainWindow window(participant, horizon);
    std::copy_n(window.data(), horizon, drawn.gains.begin());
  }
  const double w = uniform(random, 0.02, 0.49);
  const double largest_gap = drawn.config.plate_bound_deg * w / (1.0 - w);
  drawn.problem = {
      .finger_offset_deg = random() % 4 == 0 ? 0.0 : uniform(random, -3.0, 3.0) * largest_gap,
      .real_offset_deg = random() % 4 == 0 ? largest_gap : uniform(random, -1.5, 1.5) * largest_gap,
      .tactile_weight = w,
      .plate_offset_deg = random() % 4 == 0 ? 0.0 : uniform(random, -1.0, 1.0) * drawn.config.plate_bound_deg,
      .gains = drawn.gains.data(),
  };
}

struct Case {
  int horizon;
  int problems;
  bool has_rate_bound;
};

class MpcExact : public testing::TestWithParam<Case> {};

TEST_P(MpcExact, MeetsTheOptimalityConditionsAndTheReference) {
  const Case& c = GetParam();
  Random random(static_cast<unsigned>(c.horizon));
  for (int i = 0; i < c.problems; ++i) {
    RandomProblem drawn;
    draw(random, c.horizon, c.has_rate_bound, i % 2 ? Gains::any : Gains::of_filter, drawn);
    MpcDiagnostics diagnostics;
    const Mpc::Command command = Mpc(drawn.config).solve(drawn.problem, &diagnostics);
    LongVector plate(c.horizon);
    for (int k = 0; k < c.horizon; ++k) plate[k] = diagnostics.plate_offset_deg[k];
    EXPECT_EQ(command.plate_offset_deg, diagnostics.plate_offset_deg[0]);

    const DenseProblem dense = dense_problem(drawn.config, drawn.problem);
    const KktResidual residual = kkt_residual(dense, plate);
    EXPECT_LT(residual.stationarity, 1e-9L) << i;
    EXPECT_LT(residual.violation_deg, 1e-12L) << i;

    const LongVector reference = dense_optimum(dense, feasible_start(drawn.config, drawn.problem));
    // Compared in degrees felt at the finger, K w t: what is left of a plate angle whose gain is small.
    for (int k = 0; k < c.horizon; ++k)
      EXPECT_NEAR(
          static_cast<double>(reference[k] - plate[k]) * drawn.gains[k] * drawn.problem.tactile_weight, 0.0,
          1e-12)
          << i << " step " << k;
  }
}

std::string name_of_case(const testing::TestParamInfo<Case>& tested) {
  return "Horizon" + std::to_string(tested.param.horizon) + (tested.param.has_rate_bound ? "Rate" : "Box");
}

INSTANTIATE_TEST_SUITE_P(Random, MpcExact,
                         testing::Values(Case{1, 500, false}, Case{1, 500, true}, Case{2, 1000, false},
                                         Case{2, 1000, true}, Case{3, 1000, false}, Case{3, 1000, true},
                                         Case{5, 500, false}, Case{5, 500, true}, Case{10, 200, false},
                                         Case{10, 200, true}, Case{20, 60, false}, Case{20, 60, true},
                                         Case{50, 20, false}, Case{50, 20, true}),
                         name_of_case);

}  // namespace
}  // namespace hrt
