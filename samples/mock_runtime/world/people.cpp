#include "samples/mock_runtime/world/people.h"

#include <cmath>

namespace hrt::mock {
namespace {

// Identifiers of the independent random sequences, one per purpose.
enum Stream : std::uint32_t { people, reaches };

Range usual_scale_deg(IllusionFamily family) {
  if (family == IllusionFamily::saturating) return {45.0, 60.0};
  if (family == IllusionFamily::tanh) return {60.0, 60.0};
  if (family == IllusionFamily::dead_band) return {10.0, 10.0};
  return {45.0, 45.0};
}

double draw_in(const Range& range, Draws& draws) { return range.min + draws.uniform() * (range.max - range.min); }

template <typename Value>
Value one_of(const std::vector<Value>& values, Draws& draws) {
  return values[static_cast<std::size_t>(draws.uniform() * static_cast<double>(values.size()))];
}

}  // namespace

PersonSettings paper_person() {
  PersonSettings settings;
  settings.illusions = {IllusionFamily::linear};
  settings.steerings = {Steering::steps};
  settings.start_direction_deg = {0.0, 0.0};
  settings.habit_deg = {0.0, 0.0};
  settings.paces = {Pace::even};
  settings.duration_s = {3.0, 3.0};
  settings.reaction_s = {0.0, 0.0};
  return settings;
}

DrawnPerson draw(const PersonSettings& settings, std::uint64_t seed, std::uint32_t number) {
  Draws draws(seed, people, number, 0);
  DrawnPerson drawn;
  Person& person = drawn.person;
  person.illusion.tactile_weight = draw_in(settings.tactile_weight, draws);
  person.illusion.family = one_of(settings.illusions, draws);
  person.illusion.scale_deg =
      draw_in(settings.illusion_scale_deg.value_or(usual_scale_deg(person.illusion.family)), draws);
  person.weight_drift = draw_in(settings.weight_drift, draws);
  person.steering = one_of(settings.steerings, draws);
  person.gain_per_s = draw_in(settings.gain_per_s, draws);
  person.delay_s = draw_in(settings.delay_s, draws);
  person.noise_deg2_per_s = draw_in(settings.noise_deg2_per_s, draws);
  person.bias_deg = draw_in(settings.bias_deg, draws);
  person.own_bias_deg = draw_in(settings.own_bias_deg, draws);
  person.habit_deg = draw_in(settings.habit_deg, draws);
  person.pace = one_of(settings.paces, draws);
  person.duration_s = draw_in(settings.duration_s, draws);
  person.path_scale = draw_in(settings.path_scale, draws);
  drawn.reaction_ns = std::llround(1e9 * draw_in(settings.reaction_s, draws));
  drawn.start_fraction = draw_in({0.0, 1.0}, draws);
  if (settings.start_direction_deg) {
    drawn.start_fraction = 0.0;
    person.start_direction_deg = draw_in(*settings.start_direction_deg, draws);
  } else {
    person.start_direction_deg = draws.normal();
  }
  return drawn;
}

Person DrawnPerson::towards(double virtual_direction_deg) const {
  Person reaching = person;
  reaching.start_direction_deg += start_fraction * virtual_direction_deg;
  return reaching;
}

Draws noise_of_reach(std::uint64_t seed, std::uint32_t number) { return {seed, reaches, number, 0}; }

}  // namespace hrt::mock
