#include "core/simulation/controllers.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

// SD of the wander of people without an own path, and lower limit for others: motor noise of 8 deg^2/s, filtered with
// the time constant of the wander (0.3 s).
constexpr double steady_wander_deg = 1.1;

}  // namespace

RetargeterConfig people_controller(const Tuning& tuning) {
  RetargeterConfig config;
  config.tuning = tuning;
  config.person = unknown_person(0.2, 0.05, 0.0, tuning);
  config.mode = ControlMode::reach;
  config.plate = {.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};
  return config;
}

RetargeterConfig people_controller(const PersonCondition& condition, const Tuning& tuning) {
  RetargeterConfig config = people_controller(tuning);
  config.tracker_latency_ns = std::llround(1e9 * condition.tracker.declared_latency_s);
  config.tracker_bearing_sd_deg = condition.tracker.declared_bearing_sd_deg;
  return config;
}

RetargeterConfig informed_controller(const PersonCondition& condition, std::span<const PersonState::Index> traits,
                                     const Tuning& tuning) {
  using T = PersonState;
  RetargeterConfig config = people_controller(tuning);
  config.plate = condition.plate;
  config.tracker_latency_ns = std::llround(1e9 * condition.tracker.latency_s);
  config.tracker_bearing_sd_deg = condition.tracker.declared_bearing_sd_deg;
  const Person& person = condition.person;
  const auto know_if = [&](T::Index trait, double mean, double sd) {
    if (std::find(traits.begin(), traits.end(), trait) != traits.end()) set_trait_prior(config.person, trait, mean, sd);
  };
  // The cubic that equals the person's illusion at 35 and at 70 degrees, on the side of the gap.
  const double side = condition.virtual_direction_deg > condition.real_direction_deg ? 1.0 : -1.0;
  const double near_slope = side * felt_shift_deg(person.illusion, side * 35.0) / 35.0;
  const double far_slope = side * felt_shift_deg(person.illusion, side * 70.0) / 70.0;
  const double curve = (near_slope - far_slope) / ((70.0 * 70.0 - 35.0 * 35.0) / (75.0 * 75.0));
  know_if(T::weight, near_slope + curve * (35.0 * 35.0) / (75.0 * 75.0), 0.01);
  know_if(T::curve, curve, 0.015);
  know_if(T::fading, person.steering == Steering::crossings ? 1.0 : 0.0, 0.02);
  know_if(T::gain, person.gain_per_s, 0.5);
  know_if(T::bias, person.bias_deg - person.own_bias_deg, 0.5);
  know_if(T::habit, person.habit_deg + mean_habit_deg(person.own_path), 0.5);
  know_if(T::scatter, std::max(person.scatter_deg, tuning.min_scatter_deg), 0.1);
  know_if(T::log_wander, logarithm(std::max(wander_sd_deg(person.own_path), steady_wander_deg)), 0.2);
  know_if(T::evenness, person.pace == Pace::even ? 1.0 : 0.0, 0.05);
  know_if(T::log_rate, -logarithm(person.duration_s), 0.05);
  return config;
}

RetargeterConfig paper_controller() {
  RetargeterConfig config;
  config.plate = {.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};
  return config;
}

}  // namespace hrt
