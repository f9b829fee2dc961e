// Learning from reach to reach: simulated people with unknown parameters, seen through the C ABI alone.
#include "core/math/trigonometry.h"
#include "core/paper_simulation/participant.h"
#include "core/simulation/random.h"
#include "fixture.h"

namespace hrt::test {
namespace {

constexpr int steps = 30;
constexpr double whole_m = 0.1;
constexpr double real_deg = -5.0;
constexpr double virtual_deg = 5.0;

/// Who reaches, and how they are tracked.
struct Person {
  Participant participant;
  double bias_deg = 0.0;
  double tracker_noise_m = 0.0;
};

class LearningTest : public SessionTest {
 protected:
  void set(const hrt_session_config& config) {
    create(config);
    real_ = add(HRT_TARGET_REAL, real_deg);
    virtual_ = add(HRT_TARGET_VIRTUAL, virtual_deg);
  }

  hrt_session_config config() const { return config_of(session); }

  /// One reach of which the directions are seen, and known exactly. The miss is in degrees, of the last step.
  hrt_reach_summary reach_by_direction(const Person& person, std::uint32_t reach, double* miss) {
    begin_again();
    SimulatedParticipant participant(person.participant, virtual_deg + person.bias_deg);
    double direction_deg = 0.0;
    for (int step = 0; step < steps; ++step) {
      direction_deg = participant.finger_direction_deg();
      const hrt_command command = update(direction_sample(step * step_ns, direction_deg));
      participant.step(command.plate_orientation_deg, normal(reach, static_cast<std::uint32_t>(step)));
    }
    *miss = direction_deg - real_deg;
    return end();
  }

  /// One reach of which a tracker sees positions at 90 Hz, after 0.2 s at rest. The miss is in millimetres,
  /// across the real direction.
  hrt_reach_summary reach_by_position(const Person& person, std::uint32_t reach, double* miss) {
    begin_again();
    SimulatedParticipant participant(person.participant, virtual_deg + person.bias_deg);
    double right_m = 0.0, forward_m = -0.05, plate_deg = 0.0;
    std::int64_t moved_to_ns = 0;
    const auto move_to = [&](std::int64_t time_ns) {
      const double travel_m = whole_m * static_cast<double>(time_ns - moved_to_ns) / (steps * step_ns);
      right_m -= travel_m * sin_deg(participant.finger_direction_deg());
      forward_m += travel_m * cos_deg(participant.finger_direction_deg());
      moved_to_ns = time_ns;
    };
    int step = 0;
    for (std::uint32_t sample = 0; step < steps; ++sample) {
      const std::int64_t time_ns = -200'000'000 + sample * 11'111'111ll;
      for (; step < steps && (step + 1) * step_ns <= time_ns; ++step) {
        move_to((step + 1) * step_ns);
        participant.step(plate_deg, normal(reach, static_cast<std::uint32_t>(step)));
      }
      if (step == steps) break;
      if (time_ns > 0) move_to(time_ns);
      const std::uint32_t draw = 1000 + 2 * sample;
      plate_deg = update(position_sample(time_ns, right_m + person.tracker_noise_m * normal(reach, draw),
                                         forward_m + person.tracker_noise_m * normal(reach, draw + 1)))
                      .plate_orientation_deg;
    }
    const double away_m = forward_m + 0.05;
    *miss = -1000.0 * (right_m * cos_deg(real_deg) + away_m * sin_deg(real_deg));
    return end();
  }

 private:
  static double normal(std::uint32_t reach, std::uint32_t draw) {
    return standard_normal({.seed = 11, .condition = 0, .trial = reach, .step = draw});
  }

  void begin_again() { ASSERT_OK(begin(real_, virtual_)); }

  hrt_target real_{}, virtual_{};
};

hrt_session_config adapting(std::uint32_t adaptation, std::uint32_t guidance = HRT_GUIDANCE_FIXED_DIRECTION) {
  hrt_session_config config = paper_config();
  config.adaptation = adaptation;
  config.guidance = guidance;
  return config;
}

Person with_motor_variance(double motor_variance_deg2, double tracker_noise_m = 0.0) {
  return {.participant = {.tactile_weight = 0.2, .motor_variance_deg2 = motor_variance_deg2},
          .tracker_noise_m = tracker_noise_m};
}

// From 0.5, which is assumed, to what the person has.
TEST_F(LearningTest, MotorVarianceComesToBeThePersons) {
  for (const double truth : {0.3, 1.0, 2.0}) {
    set(adapting(HRT_ADAPTATION_CARRIED));
    double mean = 0.0, miss = 0.0;
    for (std::uint32_t reach = 0; reach < 60; ++reach) {
      reach_by_direction(with_motor_variance(truth), reach, &miss);
      if (reach >= 20) mean += config().paper.motor_variance_deg2 / 40.0;
    }
    EXPECT_NEAR(mean, truth, 0.15 * truth);

    // A tracker with 0.4 mm of noise takes longer.
    set(adapting(HRT_ADAPTATION_CARRIED));
    mean = 0.0;
    for (std::uint32_t reach = 0; reach < 160; ++reach) {
      reach_by_position(with_motor_variance(truth, 0.0004), reach, &miss);
      if (reach >= 80) mean += config().paper.motor_variance_deg2 / 80.0;
    }
    EXPECT_NEAR(mean, truth, 0.2 * truth);
  }
}

TEST_F(LearningTest, SummarySaysHowWellTheMotorVarianceIsKnown) {
  double miss = 0.0;
  set(adapting(HRT_ADAPTATION_REACH));
  hrt_reach_summary summary = reach_by_direction(with_motor_variance(1.0), 0, &miss);
  EXPECT_GT(summary.paper.motor_variance_deg2, 0.6);
  EXPECT_LT(summary.paper.motor_variance_sd_deg2, 0.2);
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.5) << "carried, and should not be";

  // 1.2 mm of noise shows hardly anything of it.
  summary = reach_by_position(with_motor_variance(1.0, 0.0012), 0, &miss);
  EXPECT_GT(summary.paper.motor_variance_sd_deg2, 0.95 * 0.5);
  EXPECT_NEAR(summary.paper.motor_variance_deg2, 0.5, 0.2);

  set(adapting(HRT_ADAPTATION_OFF));
  summary = reach_by_direction(with_motor_variance(1.0), 0, &miss);
  EXPECT_EQ(summary.paper.motor_variance_deg2, 0.5);
  EXPECT_EQ(summary.paper.motor_variance_sd_deg2, 0.0);
}

TEST_F(LearningTest, OneReachCarriesLittle) {
  double miss = 0.0;
  hrt_session_config assumed = adapting(HRT_ADAPTATION_CARRIED);
  assumed.paper.motor_variance_deg2 = 0.1;
  set(assumed);
  EXPECT_GT(reach_by_direction(with_motor_variance(4.0), 0, &miss).paper.motor_variance_deg2, 0.2);
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.2);
  EXPECT_EQ(config().paper.motor_variance_sd_deg2, 0.5);

  // The bounds of what is carried, whatever was configured.
  assumed.paper.motor_variance_deg2 = 1e-9;
  set(assumed);
  reach_by_direction(with_motor_variance(4.0), 0, &miss);
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.05);
  assumed.paper.motor_variance_deg2 = 1e4;
  set(assumed);
  reach_by_direction(with_motor_variance(4.0), 0, &miss);
  EXPECT_EQ(config().paper.motor_variance_deg2, 5.0);

  // A reach in which nothing was seen carries nothing.
  assumed.paper.motor_variance_deg2 = 0.7;
  set(assumed);
  begin_reach();
  update(hrt_sample_init());
  end();
  EXPECT_EQ(config().paper.motor_variance_deg2, 0.7);
  EXPECT_EQ(config().paper.motor_variance_sd_deg2, 0.5);
}

// With nothing seen but a first direction, w_T becomes less sure; not less than can be configured.
TEST_F(LearningTest, WhatIsCarriedCanBeConfigured) {
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

// The person goes for 5 + 2 = 7 degrees: the same commands as for a target at 7 without a bias.
TEST_F(LearningTest, BiasMovesWhereTheUserGoes) {
  const auto reach = [&](double target_deg, double bias_deg) {
    hrt_session_config config = paper_config();
    config.person.bias_deg = bias_deg;
    create(config);
    const hrt_target real = add(HRT_TARGET_REAL, -5.0), cup = add(HRT_TARGET_VIRTUAL, target_deg);
    EXPECT_EQ(gap_of(real, cup).gap_deg, 12.0);
    EXPECT_OK(begin(real, cup));
    for (int step = 0; step < steps; ++step) update(direction_sample(step * step_ns, 3.0 - step / 3.0));
    return end();
  };
  hrt_reach_summary one = reach(5.0, 2.0);
  const hrt_reach_summary other = reach(7.0, 0.0);
  EXPECT_EQ(one.paper.miss_deg, other.paper.miss_deg);
  EXPECT_EQ(one.paper.perceived_direction_deg, other.paper.perceived_direction_deg);
  EXPECT_EQ(one.paper.perceived_error_deg, other.paper.perceived_error_deg);

  hrt_session_config config = paper_config();
  config.person.bias_deg = 45.0;
  create(config);
  expect_error(begin(add(HRT_TARGET_REAL, -50.0), add(HRT_TARGET_VIRTUAL, 5.0)), HRT_ERROR_OUT_OF_RANGE,
               "the virtual at 50 with the user's bias; allowed");
}

}  // namespace
}  // namespace hrt::test
