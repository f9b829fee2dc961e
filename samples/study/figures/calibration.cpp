#include "samples/study/figures/calibration.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "core/learning.h"
#include "samples/study/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

struct Quantity {
  const char* name;  // in JSON
  const char* words;
  Interval interval;
  int decimals;
};

std::array<Quantity, 5> quantities(const Calibration& calibration) {
  Interval noise_mm = calibration.tracker_noise_m;
  for (double* value : {&noise_mm.value, &noise_mm.lower, &noise_mm.upper}) *value *= 1e3;
  return {
      {{"tactile_weight", "tactile weight w_T", calibration.tactile_weight, 3},
       {"bias_deg", "bias, deg, left positive", calibration.bias_deg, 2},
       {"motor_variance_deg2", "motor variance sigma_u^2, deg^2", calibration.motor_variance_deg2, 3},
       {"sensory_variance_deg2", "sensory variance sigma_h^2, deg^2", calibration.sensory_variance_deg2, 3},
       {"tracker_noise_mm", "tracker noise, mm", noise_mm, 3}}};
}

std::string interval_text(const Quantity& quantity) {
  return fixed(quantity.interval.lower, quantity.decimals) + " to " +
         fixed(quantity.interval.upper, quantity.decimals);
}

std::string row(const std::string& name, const std::string& value, const std::string& rest) {
  return "  " + left(name, 34) + right(value, 15) + "   " + rest + '\n';
}

}  // namespace

std::string calibration_text(const CalibrationReport& report) {
  std::string text = "Calibration of " + report.name + ": " +
                     std::to_string(report.calibration.chords.size()) + " of " +
                     std::to_string(report.trials) + " trials have a slide that can be used\n\n";
  text += row("", "estimate", "95 % interval");
  for (const Quantity& quantity : quantities(report.calibration)) {
    text += quantity.interval.known ? row(quantity.words, fixed(quantity.interval.value, quantity.decimals),
                                          interval_text(quantity))
                                    : row(quantity.words, "not determined",
                                          interval_text(quantity) + " is equally plausible, best fit " +
                                              fixed(quantity.interval.value, quantity.decimals));
  }
  return text + "\nThe method has been tried on simulated people only; there was no human trial.\n";
}

std::string calibration_json(const CalibrationReport& report) {
  nlohmann::ordered_json page{
      {"data", report.name},
      {"tried_on", "simulated people only"},
      {"trials", report.trials},
      {"trials_used", report.calibration.chords.size()},
      {"goal_direction_deg", report.config.goal_direction_deg},
      {"step_period_s", 1e-9 * static_cast<double>(report.config.step_period_ns)},
  };
  for (const Quantity& quantity : quantities(report.calibration))
    page[quantity.name] = {{"value", quantity.interval.value},
                           {"interval", {quantity.interval.lower, quantity.interval.upper}},
                           {"known", quantity.interval.known}};
  for (const Chord& chord : report.calibration.chords)
    page["chords"].push_back({{"plate_orientation_deg", chord.plate_orientation_deg},
                              {"direction_deg", chord.direction_deg},
                              {"fitted_deg", chord.fitted_deg}});
  return page.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string calibration_profile(const Calibration& calibration) {
  const auto sd = [](const Interval& interval, double least) {
    return std::max(deviation_of_interval(interval.lower, interval.upper), least);
  };
  const Interval& weight = calibration.tactile_weight;
  nlohmann::ordered_json profile{
      {"format", "haptic retargeting profile"}, {"version", 1},
      {"tactile_weight", weight.value},         {"tactile_weight_sd", sd(weight, least_carried_weight_sd)},
      {"bias_deg", calibration.bias_deg.value}, {"tracker_noise_m", calibration.tracker_noise_m.value}};
  const Interval& motor = calibration.motor_variance_deg2;
  const Interval& sensory = calibration.sensory_variance_deg2;
  if (motor.known) {
    profile["motor_variance_deg2"] = motor.value;
    profile["motor_variance_sd_deg2"] = sd(motor, least_carried_motor_variance_sd_deg2);
  }
  if (sensory.known) profile["sensory_variance_deg2"] = sensory.value;
  return profile.dump(2) + '\n';
}

Figure calibration_figure(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  std::vector<Chord> chords = calibration.chords;
  std::sort(chords.begin(), chords.end(),
            [](const Chord& a, const Chord& b) { return a.plate_orientation_deg < b.plate_orientation_deg; });
  Figure figure{.name = "calibration",
                .title = "Directions over plates at rest",
                .caption = "",
                .width_px = 800,
                .height_px = 760};
  figure.script = "$chords << EOD\n";
  for (const Chord& chord : chords)
    figure.script += number(chord.plate_orientation_deg) + ' ' + number(chord.direction_deg) + ' ' +
                     number(chord.fitted_deg) + '\n';
  const auto [weight, bias] = std::pair(quantities(calibration)[0], quantities(calibration)[1]);
  const std::string common =
      "set grid back lt 1 lw 0.6 lc rgb '#dddddd'\nset offsets graph 0.05, graph 0.05, "
      "graph 0.05, graph 0.05\nset lmargin 10\nset rmargin 3\n";
  figure.script +=
      "EOD\n" + common + "set multiplot\nset origin 0,0.4\nset size 1,0.6\nset title \"Chords of " +
      std::to_string(chords.size()) +
      " slides against the plate's orientation\\nw_T = " + fixed(weight.interval.value, 3) + " (" +
      interval_text(weight) + "), bias " + fixed(bias.interval.value, 2) + " deg (" + interval_text(bias) +
      ")\" font ',13'\nset key top right\nset ylabel 'direction of the second half, deg'\n"
      "plot $chords using 1:3 with lines lw 2 lc rgb '#08306b' title 'fit: (G - w_T T) / (1 - w_T)', "
      "$chords using 1:2 with points pt 6 ps 1.1 lw 1.3 lc rgb '#b35806' title 'a slide'\n"
      "set origin 0,0\nset size 1,0.4\nset title 'Residuals'\n"
      "set xlabel 'plate orientation (normal of the ridges), deg'\nset ylabel 'slide less fit, deg'\n"
      "plot 0 with lines lw 2 lc rgb '#08306b' notitle, "
      "$chords using 1:($2-$3) with points pt 6 ps 1.1 lw 1.3 lc rgb '#b35806' notitle\nunset multiplot\n";
  return figure;
}

}  // namespace hrt::study
