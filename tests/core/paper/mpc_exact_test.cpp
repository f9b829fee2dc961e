// Plans for random problems meet the optimality conditions (mpc_reference.h).
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

TEST_P(MpcExact, RandomProblems_MeetTheOptimalityConditions) {
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
  }
}

std::string name_of_case(const testing::TestParamInfo<Case>& tested) {
  constexpr const char* rates[] = {"", "Rate", "SlowRate", "FractionOfBound"};
  constexpr const char* gains[] = {"", "TwoThirdsZero", "MostlySmall"};
  const auto& [horizon, problems, rate, gain] = tested.param;
  return "Horizon" + std::to_string(horizon) + rates[static_cast<int>(rate)] + gains[static_cast<int>(gain)];
}

INSTANTIATE_TEST_SUITE_P(Random, MpcExact,
                         testing::Values(Case{1, 500, RandomRate::moderate}, Case{3, 2000, RandomRate::none},
                                         Case{3, 2000, RandomRate::moderate}, Case{20, 60, RandomRate::none},
                                         Case{20, 60, RandomRate::slow}, Case{20, 60, RandomRate::fraction_of_bound},
                                         Case{3, 2000, RandomRate::moderate, RandomGains::two_thirds_zero},
                                         Case{20, 60, RandomRate::moderate, RandomGains::two_thirds_zero},
                                         Case{20, 60, RandomRate::slow, RandomGains::mostly_small}),
                         name_of_case);

}  // namespace
}  // namespace hrt
