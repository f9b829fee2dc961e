// The controller against a reference solver and the optimality conditions (mpc_reference.h), on random problems.
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
  RandomRate rate;
  RandomGains gains = RandomGains::perceived;
};

class MpcExact : public testing::TestWithParam<Case> {};

TEST_P(MpcExact, MeetsTheOptimalityConditionsAndTheReference) {
  const Case& c = GetParam();
  Random random(static_cast<unsigned>(c.horizon));
  for (int i = 0; i < c.problems; ++i) {
    const RandomProblem drawn(random, c.horizon, c.rate, c.gains);
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

    // Gains below about 1e-6 are beyond the precision of the reference solver.
    if (c.gains == RandomGains::mostly_small) continue;
    const LongVector reference = dense_optimum(dense, feasible_start(drawn.config, drawn.problem));
    // Compared in degrees perceived at the finger, K w t: a plate angle has no exact value where its gain is 0.
    for (int k = 0; k < c.horizon; ++k)
      EXPECT_NEAR(static_cast<double>(reference[k] - plate[k]) * drawn.gains[k] * drawn.problem.tactile_weight, 0.0,
                  c.gains == RandomGains::two_thirds_zero ? 1e-10 : 1e-12)
          << i << " step " << k;
  }
}

std::string name_of_case(const testing::TestParamInfo<Case>& tested) {
  constexpr const char* rates[] = {"", "Rate", "SlowRate", "FractionOfBound"};
  constexpr const char* gains[] = {"", "TwoThirdsZero", "MostlySmall", "AnySize"};
  const auto& [horizon, problems, rate, gain] = tested.param;
  return "Horizon" + std::to_string(horizon) + rates[static_cast<int>(rate)] + gains[static_cast<int>(gain)];
}

INSTANTIATE_TEST_SUITE_P(Random, MpcExact,
                         testing::Values(Case{1, 500, RandomRate::none}, Case{1, 500, RandomRate::moderate},
                                         Case{2, 1000, RandomRate::none}, Case{2, 1000, RandomRate::moderate},
                                         Case{3, 2000, RandomRate::none}, Case{3, 2000, RandomRate::moderate},
                                         Case{5, 1000, RandomRate::none}, Case{5, 1000, RandomRate::moderate},
                                         Case{10, 300, RandomRate::none}, Case{10, 300, RandomRate::moderate},
                                         Case{20, 60, RandomRate::none}, Case{20, 60, RandomRate::moderate},
                                         Case{10, 300, RandomRate::slow}, Case{20, 60, RandomRate::slow},
                                         Case{3, 2000, RandomRate::fraction_of_bound},
                                         Case{20, 60, RandomRate::fraction_of_bound}),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(
    SmallGains, MpcExact,
    testing::Values(Case{1, 100, RandomRate::moderate, RandomGains::two_thirds_zero},
                    Case{3, 2000, RandomRate::none, RandomGains::two_thirds_zero},
                    Case{3, 2000, RandomRate::moderate, RandomGains::two_thirds_zero},
                    Case{10, 500, RandomRate::moderate, RandomGains::two_thirds_zero},
                    Case{20, 60, RandomRate::moderate, RandomGains::two_thirds_zero},
                    Case{3, 2000, RandomRate::slow, RandomGains::mostly_small},
                    Case{20, 60, RandomRate::slow, RandomGains::mostly_small},
                    Case{3, 2000, RandomRate::fraction_of_bound, RandomGains::ten_to_minus_six_to_one},
                    Case{20, 60, RandomRate::fraction_of_bound, RandomGains::ten_to_minus_six_to_one}),
    name_of_case);

}  // namespace
}  // namespace hrt
