#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/paper_simulation/control_law.h"
#include "tests/core/paper/steady_gains.h"

namespace hrt {
namespace {

TEST(PiecewiseLinear, ByHand) {
  const PiecewiseLinear tent({{-1.0, 0.0}, {0.0, 2.0}, {4.0, 0.0}});
  EXPECT_EQ(tent(-1.0), 0.0);
  EXPECT_EQ(tent(-0.5), 1.0);
  EXPECT_EQ(tent(0.0), 2.0);
  EXPECT_EQ(tent(3.0), 0.5);
  EXPECT_EQ(tent(-2.0), -2.0);
  EXPECT_EQ(tent(6.0), -1.0);
  EXPECT_EQ(tent.slope(0), 2.0);
  EXPECT_EQ(tent.slope(1), -0.5);
}

// One step: the best e is 0, so t = -(1 - w_T) p / w_T = -9 p until the bound of 84.5 holds at p = 9.39.
TEST(ControlLaw, HorizonOneByHand) {
  const auto law = control_law({.horizon = 1}, {0.0, -10.0, 0.1, 0.0, gains.data()});
  ASSERT_TRUE(law);
  ASSERT_EQ(law->plate_offset_deg.nodes().size(), 4u);
  EXPECT_NEAR(law->saturated_below_deg, -84.5 / 9.0, 1e-11);
  EXPECT_NEAR(law->saturated_above_deg, 84.5 / 9.0, 1e-11);
  for (const double p : {-9.0, 0.0, 1.0, 9.3}) EXPECT_NEAR(law->plate_offset_deg(p), -9.0 * p, 1e-10);
  EXPECT_EQ(law->plate_offset_deg(-10.0), 84.5);
  EXPECT_EQ(law->plate_offset_deg(500.0), -84.5);
}

// Two steps, away from the bound: e = (p - p_R) / 2, K (w_T t + (1 - w_T) p) = e.
TEST(ControlLaw, HorizonTwoByHand) {
  const auto law = control_law({.horizon = 2}, {0.0, -2.0, 0.2, 0.0, gains.data()});
  ASSERT_TRUE(law);
  for (const double p : {-4.0, -2.0, 0.0, 1.0})
    EXPECT_NEAR(law->plate_offset_deg(p), ((p + 2.0) / 2.0 / 0.85 - 0.8 * p) / 0.2, 1e-10) << p;
}

TEST(ControlLaw, NoneWithARateBoundOrWithoutGain) {
  const MpcProblem problem{0.0, -2.0, 0.2, 0.0, gains.data()};
  MpcConfig config;
  EXPECT_TRUE(control_law(config, problem));
  config.plate_rate_bound_deg = 40.0;
  EXPECT_FALSE(control_law(config, problem));
  const std::array<double, 3> no_gain{0.5, 0.0, 0.0};
  EXPECT_FALSE(control_law({}, {0.0, -2.0, 0.2, 0.0, no_gain.data()}));
}

// The law against the solver, everywhere, for controllers and participants of all kinds.
TEST(ControlLaw, AgreesWithTheSolver) {
  std::mt19937_64 generator(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(generator() >> 11) * 0x1p-53);
  };
  const auto log_uniform = [&](double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); };
  int without_law = 0;
  for (int i = 0; i < 1500; ++i) {
    const MpcConfig config{
        .horizon = static_cast<int>(uniform(1.0, 50.99)),
        .perceived_weight = log_uniform(0.01, 100.0),
        .actual_weight = i % 10 == 0 ? 0.0 : log_uniform(0.01, 100.0),
        .plate_bound_deg = uniform(5.0, 90.0),
    };
    const Participant participant{
        .tactile_weight = uniform(0.02, 0.49),
        .motor_variance_deg2 = log_uniform(0.01, 10.0),
        .sensory_variance_deg2 = log_uniform(0.01, 10.0),
    };
    GainWindow window(participant, config.horizon);
    for (int k = static_cast<int>(uniform(0.0, 30.0)); k > 0; --k) window.advance();
    MpcProblem problem{0.0, uniform(-25.0, 25.0), participant.tactile_weight, 0.0, window.data()};
    const auto law = control_law(config, problem);
    if (!law) {
      ++without_law;
      continue;
    }
    Mpc mpc(config);
    for (int j = 0; j < 60; ++j) {
      problem.finger_offset_deg = j % 2 ? uniform(-40.0, 40.0) : problem.real_offset_deg + uniform(-3.0, 3.0);
      const Mpc::Command optimum = mpc.solve(problem);
      const double tabulated = law->plate_offset_deg(problem.finger_offset_deg);
      // What counts is what the finger does of it.
      const double weight = window.data()[0] * problem.tactile_weight;
      ASSERT_NEAR(weight * tabulated, weight * optimum.plate_offset_deg, 1e-9)
          << i << " N " << config.horizon << " q " << config.perceived_weight << ' ' << config.actual_weight << " L "
          << config.plate_bound_deg << " w " << problem.tactile_weight << " p_R " << problem.real_offset_deg << " p "
          << problem.finger_offset_deg << " K " << window.data()[0];
      const bool saturated = problem.finger_offset_deg <= law->saturated_below_deg ||
                             problem.finger_offset_deg >= law->saturated_above_deg;
      ASSERT_EQ(saturated, optimum.active != ActiveBound::none) << i;
    }
  }
  EXPECT_LT(without_law, 15);
}

}  // namespace
}  // namespace hrt
