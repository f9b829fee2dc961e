// The controller against judges that share nothing with it (mpc_reference.h), on random problems.
#include <gtest/gtest.h>

#include <string>

#include "core/paper/mpc.h"
#include "tests/core/paper/mpc_random_problem.h"
#include "tests/core/paper/mpc_reference.h"

namespace hrt {
namespace {

struct Case {
  int horizon;
  int problems;
  bool has_rate_bound;
  RandomGains gains = RandomGains::felt;
};

class MpcExact : public testing::TestWithParam<Case> {};

TEST_P(MpcExact, MeetsTheOptimalityConditionsAndTheReference) {
  const Case& c = GetParam();
  Random random(static_cast<unsigned>(c.horizon));
  for (int i = 0; i < c.problems; ++i) {
    const RandomProblem drawn(random, c.horizon, c.has_rate_bound, c.gains);
    MpcPlan plan;
    const Mpc::Command command = Mpc(drawn.config).solve(drawn.problem, &plan);
    EXPECT_TRUE(command.optimal) << i;
    LongVector plate(c.horizon);
    for (int k = 0; k < c.horizon; ++k) plate[k] = plan.plate_offset_deg[k];
    EXPECT_EQ(command.plate_offset_deg, plan.plate_offset_deg[0]);

    const DenseProblem dense = dense_problem(drawn.config, drawn.problem);
    const KktResidual residual = kkt_residual(dense, plate);
    EXPECT_LT(residual.stationarity, 1e-9L) << i;
    EXPECT_LT(residual.violation_deg, 1e-12L) << i;

    const LongVector reference = dense_optimum(dense, feasible_start(drawn.config, drawn.problem));
    // Compared in degrees felt at the finger, K w t: what is left of a plate angle whose gain is small.
    for (int k = 0; k < c.horizon; ++k)
      EXPECT_NEAR(static_cast<double>(reference[k] - plate[k]) * drawn.gains[k] * drawn.problem.tactile_weight, 0.0,
                  c.gains == RandomGains::felt ? 1e-12 : 1e-10)
          << i << " step " << k;
  }
}

std::string name_of_case(const testing::TestParamInfo<Case>& tested) {
  return "Horizon" + std::to_string(tested.param.horizon) + (tested.param.has_rate_bound ? "Rate" : "Box") +
         (tested.param.gains == RandomGains::felt ? "" : "TwoThirdsZero");
}

INSTANTIATE_TEST_SUITE_P(Random, MpcExact,
                         testing::Values(Case{1, 500, false}, Case{1, 500, true}, Case{2, 1000, false},
                                         Case{2, 1000, true}, Case{3, 2000, false}, Case{3, 2000, true},
                                         Case{5, 1000, false}, Case{5, 1000, true}, Case{10, 300, false},
                                         Case{10, 300, true}, Case{20, 60, false}, Case{20, 60, true},
                                         Case{50, 20, false}, Case{50, 20, true}),
                         name_of_case);

INSTANTIATE_TEST_SUITE_P(ZeroGains, MpcExact,
                         testing::Values(Case{1, 100, true, RandomGains::two_thirds_zero},
                                         Case{3, 2000, false, RandomGains::two_thirds_zero},
                                         Case{3, 2000, true, RandomGains::two_thirds_zero},
                                         Case{10, 500, true, RandomGains::two_thirds_zero},
                                         Case{20, 60, true, RandomGains::two_thirds_zero},
                                         Case{50, 20, true, RandomGains::two_thirds_zero}),
                         name_of_case);

}  // namespace
}  // namespace hrt
