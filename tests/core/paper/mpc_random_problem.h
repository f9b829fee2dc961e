// Random problems for the controller: quantities vary over most of their ranges, and values sometimes coincide exactly.
// The random numbers are the same on every host.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/paper/mpc.h"
#include "core/paper/participant.h"

namespace hrt {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

enum class RandomGains { perceived, two_thirds_zero, mostly_small };
enum class RandomRate { none, moderate, slow, fraction_of_bound };

struct RandomProblem {
  MpcConfig config;
  std::array<double, max_horizon> gains{};
  MpcProblem problem;

  RandomProblem(Random& random, int horizon, RandomRate rate, RandomGains gain_kind = RandomGains::perceived) {
    config.horizon = horizon;
    config.perceived_weight = std::exp(uniform(random, -3.0, 3.0));
    config.actual_weight = random() % 8 == 0 ? 0.0 : std::exp(uniform(random, -3.0, 3.0));
    config.plate_bound_deg = random() % 2 ? 90.0 : std::ceil(uniform(random, 0.0, 90.0));
    if (rate == RandomRate::moderate)
      config.plate_rate_bound_deg = random() % 2 ? 0.5 * config.plate_bound_deg : uniform(random, 0.5, 60.0);
    if (rate == RandomRate::slow)
      config.plate_rate_bound_deg = config.plate_bound_deg * std::exp(uniform(random, -6.0, 0.0));
    if (rate == RandomRate::fraction_of_bound)  // steps at full rate end exactly at the plate bound
      config.plate_rate_bound_deg = config.plate_bound_deg / static_cast<double>(1 + random() % 8);
    if (random() % 2) {
      std::generate_n(gains.begin(), horizon, [&] { return uniform(random, 0.01, 1.0); });
    } else {
      const Participant participant{.motor_variance_deg2 = std::exp(uniform(random, -3.0, 2.0)),
                                    .sensory_variance_deg2 = std::exp(uniform(random, -3.0, 2.0)),
                                    .initial_variance_deg2 = uniform(random, 0.0, 2.0)};
      std::copy_n(GainWindow(participant, horizon).data(), horizon, gains.begin());
    }
    if (gain_kind == RandomGains::two_thirds_zero)
      for (int i = 0; i < horizon; ++i)
        if (random() % 3 != 0) gains[i] = 0.0;
    if (gain_kind == RandomGains::mostly_small)
      std::generate_n(gains.begin(), horizon, [&] { return std::pow(uniform(random, 0.0, 1.0), 4); });
    const double w = uniform(random, 0.02, 0.49);
    const double max_gap = config.plate_bound_deg * w / (1.0 - w);
    problem.finger_offset_deg = random() % 4 == 0 ? 0.0 : uniform(random, -3.0, 3.0) * max_gap;
    problem.real_offset_deg = random() % 4 == 0 ? max_gap : uniform(random, -1.5, 1.5) * max_gap;
    problem.tactile_weight = w;
    problem.plate_offset_deg = random() % 4 == 0 ? 0.0 : uniform(random, -1.0, 1.0) * config.plate_bound_deg;
    if (rate == RandomRate::fraction_of_bound)
      problem.plate_offset_deg =
          config.plate_rate_bound_deg * std::round(problem.plate_offset_deg / config.plate_rate_bound_deg);
    problem.gains = gains.data();
  }
  RandomProblem(const RandomProblem&) = delete;  // `problem` points to `gains`
  RandomProblem& operator=(const RandomProblem&) = delete;
  ~RandomProblem() = default;
};

}  // namespace hrt
