// The simulated people of a script.
#include "samples/mock_runtime/script/event.h"

namespace hrt::mock {

PersonSettings read_person(const Json& object, const std::string& where) {
  constexpr double second_per_ms = 1e-3;
  static const Names<Steering> steerings{{"steps", Steering::steps},           {"continuous", Steering::continuous},
                                         {"predictive", Steering::predictive}, {"place", Steering::place},
                                         {"heavy_arm", Steering::heavy_arm},   {"crossings", Steering::crossings}};
  static const Names<IllusionFamily> illusions{
      {"linear", IllusionFamily::linear},       {"saturating", IllusionFamily::saturating},
      {"sine", IllusionFamily::sine},           {"tanh", IllusionFamily::tanh},
      {"dead_band", IllusionFamily::dead_band}, {"unequal", IllusionFamily::unequal}};
  static const Names<Pace> paces{
      {"minimum_jerk", Pace::minimum_jerk}, {"even", Pace::even},   {"skewed", Pace::skewed},
      {"stop_and_go", Pace::stop_and_go},   {"pause", Pace::pause}, {"two_parts", Pace::two_parts},
      {"reversal", Pace::reversal}};
  PersonSettings settings;
  if (object.contains("steering")) {
    const std::vector<Steering> given = meanings(object["steering"], steerings);
    if (given == std::vector{Steering::steps}) settings = paper_person();
    settings.steerings = given;
  }
  if (object.contains("illusion")) settings.illusions = meanings(object["illusion"], illusions);
  if (object.contains("pace")) settings.paces = meanings(object["pace"], paces);
  // Reads a number, or the two bounds of a draw; `scale` converts to the unit of `range`.
  const auto read = [&](const char* key, auto& range, double scale = 1.0) {
    if (!object.contains(key)) return;
    const Json& given = object[key];
    const double low = given.is_array() ? given[0] : given, high = given.is_array() ? given[1] : given;
    if (low > high) refuse(where + "." + key, "must have the smaller number first");
    range = {low * scale, high * scale};
  };
  read("illusion_scale_deg", settings.illusion_scale_deg);
  read("tactile_weight", settings.tactile_weight);
  read("weight_drift", settings.weight_drift);
  read("gain_per_s", settings.gain_per_s);
  read("delay_ms", settings.delay_s, second_per_ms);
  read("noise_deg2_per_s", settings.noise_deg2_per_s);
  read("start_direction_deg", settings.start_direction_deg);
  read("bias_deg", settings.bias_deg);
  read("own_bias_deg", settings.own_bias_deg);
  read("habit_deg", settings.habit_deg);
  read("duration_ms", settings.duration_s, second_per_ms);
  read("path_scale", settings.path_scale);
  read("reaction_ms", settings.reaction_s, second_per_ms);
  return settings;
}

}  // namespace hrt::mock
