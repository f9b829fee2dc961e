// The simulated people of a script.
#include "samples/app/text/members.h"
#include "samples/mock_runtime/script/event.h"

namespace hrt::mock {

PersonSettings read_person(Members& members) {
  constexpr double second_per_ms = 1e-3;
  std::vector<Steering> steerings;
  members.one_of("steering", steerings,
                 {{"steps", Steering::steps},
                  {"continuous", Steering::continuous},
                  {"predictive", Steering::predictive},
                  {"place", Steering::place},
                  {"heavy_arm", Steering::heavy_arm},
                  {"crossings", Steering::crossings}});
  PersonSettings settings = steerings == std::vector{Steering::steps} ? paper_person() : PersonSettings{};
  if (!steerings.empty()) settings.steerings = steerings;
  members.one_of("illusion", settings.illusions,
                 {{"linear", IllusionFamily::linear},
                  {"saturating", IllusionFamily::saturating},
                  {"sine", IllusionFamily::sine},
                  {"tanh", IllusionFamily::tanh},
                  {"dead_band", IllusionFamily::dead_band},
                  {"unequal", IllusionFamily::unequal}});
  Range scale_deg{};
  if (members.range("illusion_scale_deg", scale_deg, 1.0, 90.0)) settings.illusion_scale_deg = scale_deg;
  members.range("tactile_weight", settings.tactile_weight, 0.001, 0.499);
  members.range("weight_drift", settings.weight_drift, -0.5, 0.5);
  members.range("gain_per_s", settings.gain_per_s, 0.1, 50.0);
  members.range("delay_ms", settings.delay_s, 0.0, 250.0, second_per_ms);
  members.range("noise_deg2_per_s", settings.noise_deg2_per_s, 0.0, 1e4);
  Range start_deg{};
  if (members.range("start_direction_deg", start_deg, -90.0, 90.0)) settings.start_direction_deg = start_deg;
  members.range("bias_deg", settings.bias_deg, -45.0, 45.0);
  members.range("own_bias_deg", settings.own_bias_deg, -45.0, 45.0);
  members.range("habit_deg", settings.habit_deg, -45.0, 45.0);
  members.one_of("pace", settings.paces,
                 {{"minimum_jerk", Pace::minimum_jerk},
                  {"even", Pace::even},
                  {"skewed", Pace::skewed},
                  {"stop_and_go", Pace::stop_and_go},
                  {"pause", Pace::pause},
                  {"two_parts", Pace::two_parts},
                  {"reversal", Pace::reversal}});
  members.range("duration_ms", settings.duration_s, 100.0, 60'000.0, second_per_ms);
  members.range("path_scale", settings.path_scale, 0.1, 3.0);
  members.range("reaction_ms", settings.reaction_s, 0.0, 10'000.0, second_per_ms);
  return settings;
}

}  // namespace hrt::mock
