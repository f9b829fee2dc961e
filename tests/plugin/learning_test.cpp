// Estimates of the paper's controller from reach to reach, with its simulated participant.
#include "core/paper_simulation/participant.h"
#include "core/simulation/random.h"
#include "fixture.h"

namespace hrt::test {
namespace {

constexpr std::uint32_t steps = 30;
constexpr double real_deg = -5.0;
constexpr double virtual_deg = 5.0;

class LearningTest : public SessionTest {
 protected:
  void set(const hrt_session_config& config) {
    create(config);
    real_ = add(HRT_TARGET_REAL, real_deg);
    virtual_ = add(HRT_TARGET_VIRTUAL, virtual_deg);
  }

  hrt_session_config config() const { return config_of(session); }

  /// Runs one reach of a person with w_T = 0.2, whose directions are tracked exactly.
  hrt_reach_summary reach_of(double motor_variance_deg2, std::uint32_t reach) {
    EXPECT_OK(begin(real_, virtual_));
    SimulatedParticipant participant({.tactile_weight = 0.2, .motor_variance_deg2 = motor_variance_deg2}, virtual_deg);
    for (std::uint32_t step = 0; step < steps; ++step) {
      const hrt_command command = update(direction_sample(step * step_ns, participant.finger_direction_deg()));
      participant.step(command.plate_orientation_deg,
                       standard_normal({.seed = 11, .condition = 0, .trial = reach, .step = step}));
    }
    return end();
  }

 private:
  hrt_target real_{}, virtual_{};
};

hrt_session_config adapting(std::uint32_t adaptation) {
  hrt_session_config config = paper_config();
  config.adaptation = adaptation;
  return config;
}

// The estimate starts at the configured value, 0.5.
TEST_F(LearningTest, MotorVarianceConvergesToThePersons) {
  for (const double truth : {0.3, 1.0, 2.0}) {
    set(adapting(HRT_ADAPTATION_CARRIED));
    double mean = 0.0;
    for (std::uint32_t reach = 0; reach < 60; ++reach) {
      reach_of(truth, reach);
      if (reach >= 20) mean += config().paper.motor_variance_deg2 / 40.0;
    }
    EXPECT_NEAR(mean, truth, 0.15 * truth);
  }
}

TEST_F(LearningTest, SummaryHasTheSdOfTheMotorVariance) {
  set(adapting(HRT_ADAPTATION_REACH));
  hrt_reach_summary summary = reach_of(1.0, 0);
  EXPECT_GT(summary.paper.motor_variance_deg2, 0.6);
  EXPECT_LT(summary.paper.motor_variance_sd_deg2, 0.2);
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.5) << "the estimate must not be written to the configuration";

  set(adapting(HRT_ADAPTATION_OFF));
  summary = reach_of(1.0, 0);
  EXPECT_EQ(summary.paper.motor_variance_deg2, 0.5);
  EXPECT_EQ(summary.paper.motor_variance_sd_deg2, 0.0);
}

TEST_F(LearningTest, OneReachChangesTheMotorVarianceByAFactorOfTwoAtMost) {
  hrt_session_config assumed = adapting(HRT_ADAPTATION_CARRIED);
  assumed.paper.motor_variance_deg2 = 0.1;
  set(assumed);
  EXPECT_GT(reach_of(4.0, 0).paper.motor_variance_deg2, 0.2);
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.2);
  EXPECT_EQ(config().paper.motor_variance_sd_deg2, 0.5);

  // Carried estimates of the motor variance are between 0.05 and 5 deg^2, for any configured value.
  assumed.paper.motor_variance_deg2 = 1e-9;
  set(assumed);
  reach_of(4.0, 0);
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.05);
  assumed.paper.motor_variance_deg2 = 1e4;
  set(assumed);
  reach_of(4.0, 0);
  EXPECT_EQ(config().paper.motor_variance_deg2, 5.0);

  // A reach without observations changes no estimate.
  assumed.paper.motor_variance_deg2 = 0.7;
  set(assumed);
  begin_reach();
  update(hrt_sample_init());
  end();
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.7);
  EXPECT_EQ(config().paper.motor_variance_sd_deg2, 0.5);
}

// With one observed direction, the SD of w_T grows beyond its range; the carried SD is limited to the range.
TEST_F(LearningTest, CarriedEstimatesAreWithinTheirRanges) {
  hrt_session_config assumed = adapting(HRT_ADAPTATION_CARRIED);
  assumed.person.tactile_weight_sd = 0.49;
  set(assumed);
  begin_reach();
  update(direction_sample(0, 0.0));
  hrt_sample dropout = direction_sample(20 * step_ns, 0.0);
  dropout.flags = 0;
  update(dropout);
  end();
  EXPECT_EQ(config().person.tactile_weight_sd, 0.49);
  set(config());
}

// With a bias of 2 degrees and a target at 5 degrees, the results are those for a target at 7 degrees without a bias.
TEST_F(LearningTest, BiasActsLikeAShiftedTarget) {
  const auto reach = [&](double target_deg, double bias_deg) {
    create(paper_config(), [&](auto& c) { c.person.bias_deg = bias_deg; });
    const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, target_deg);
    EXPECT_EQ(gap_of(real, cup).gap_deg, 12.0);
    EXPECT_OK(begin(real, cup));
    for (std::uint32_t step = 0; step < steps; ++step) update(direction_sample(step * step_ns, 3.0 - step / 3.0));
    return end();
  };
  const hrt_reach_summary one = reach(5.0, 2.0), other = reach(7.0, 0.0);
  EXPECT_EQ(one.paper.miss_deg, other.paper.miss_deg);
  EXPECT_EQ(one.paper.perceived_direction_deg, other.paper.perceived_direction_deg);
  EXPECT_EQ(one.paper.perceived_error_deg, other.paper.perceived_error_deg);

  create(paper_config(), [](auto& c) { c.person.bias_deg = 45.0; });
  expect_error(begin(add(HRT_TARGET_REAL, -50.0), add(HRT_TARGET_VIRTUAL, 5.0)), HRT_ERROR_OUT_OF_RANGE,
               "at 50 with the user's bias");
}

}  // namespace
}  // namespace hrt::test
