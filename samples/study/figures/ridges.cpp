#include "samples/study/figures/ridges.h"

#include <cmath>

#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"
#include "samples/study/paper/paper.h"

namespace hrt::study {
namespace {

// One after another, and apart in grey.
constexpr const char* colors[] = {"#b35806", "#f1a340", "#555555", "#67a9cf", "#08306b"};

RidgeAngle simulate(const RidgeOptions& options, double plate_deg, std::uint32_t number) {
  const double weight = options.tactile_weight;
  RidgeAngle angle{.plate_deg = plate_deg,
                   .rest_deg = -weight * plate_deg / (1.0 - weight),
                   .mean_deg = 0.0,
                   .sd_deg = 0.0,
                   .paths = {}};
  Condition condition = make_condition(options.motor_variance_deg2, weight, 0.0, 0.0);
  condition.controller.mode = ControlMode::fixed_plate;
  condition.controller.fixed_plate_orientation_deg = condition.plate_orientation_deg = plate_deg;
  double squares = 0.0;
  for (std::uint32_t trial = 0; trial < options.trials; ++trial) {
    std::vector<TrialStep> steps;
    const TrialOutcome outcome =
        simulate_trial(condition, {.seed = options.seed, .condition = number, .trial = trial}, &steps);
    angle.paths.push_back(path_of(steps, &TrialStep::finger_direction_deg));
    angle.mean_deg += outcome.final_direction_deg;
    squares += outcome.final_direction_deg * outcome.final_direction_deg;
  }
  const auto n = static_cast<double>(options.trials);
  angle.mean_deg /= n;
  angle.sd_deg = std::sqrt(std::max(squares / n - angle.mean_deg * angle.mean_deg, 0.0));
  return angle;
}

}  // namespace

Ridges simulate_ridges(const RidgeOptions& options) {
  Ridges ridges{.options = options, .angles = {}};
  for (const double plate_deg : options.plate_angles_deg)
    ridges.angles.push_back(simulate(options, plate_deg, static_cast<std::uint32_t>(ridges.angles.size())));
  return ridges;
}

std::string ridges_text(const Ridges& ridges) {
  std::string page =
      wrapped("The paper's Fig. 1c: " + std::to_string(ridges.options.trials) +
              " simulated slides straight ahead over a plate that rests at each angle, weight of touch " +
              number(ridges.options.tactile_weight) + ", motor variance " + number(ridges.options.motor_variance_deg2) +
              " deg^2. Ridges that lead to the left by touch (positive) bend the path to the right. There was "
              "no human trial here.") +
      "\nplate, deg  final direction, deg: mean      SD  at rest\n";
  for (const RidgeAngle& angle : ridges.angles)
    page += right(number(angle.plate_deg), 10) + right(fixed(angle.mean_deg, 1), 29) +
            right(fixed(angle.sd_deg, 1), 8) + right(fixed(angle.rest_deg, 1), 9) + '\n';
  return page;
}

Results ridges_results(const Ridges& ridges) {
  Results found{.about = {{"simulation", true},
                          {"trials", ridges.options.trials},
                          {"seed", ridges.options.seed},
                          {"tactile_weight", ridges.options.tactile_weight},
                          {"motor_variance_deg2", ridges.options.motor_variance_deg2}},
                .rows = {}};
  for (const RidgeAngle& angle : ridges.angles)
    found.rows.push_back({{"plate_deg", angle.plate_deg},
                          {"mean_deg", angle.mean_deg},
                          {"sd_deg", angle.sd_deg},
                          {"rest_deg", angle.rest_deg}});
  return found;
}

Figure ridges_figure(const Ridges& ridges) {
  Figure figure{.name = "fig1c",
                .title = "Fig. 1c: straight ahead over a plate at rest",
                .caption =
                    "Simulated paths of a participant who goes straight ahead, and their median, over a "
                    "plate that rests. The color is that of the plate's angle.",
                .width_px = 640,
                .height_px = 560,
                .script = ""};
  std::string plots;
  for (std::size_t i = 0; i < ridges.angles.size(); ++i) {
    const RidgeAngle& angle = ridges.angles[i];
    const std::string name = "plate" + std::to_string(i);
    const std::string color = std::string("lc rgb '") + colors[i % std::size(colors)] + "'";
    figure.script += path_block(name, angle.paths) + path_block(name + "_median", {median_path(angle.paths)});
    plots += (i == 0 ? "plot $" : ", $") + name + " using 1:2 with lines lw 0.4 " + color + " notitle, $" + name +
             "_median using 1:2 with lines lw 3 " + color + " title 'plate at " +
             with_minus_signs(number(angle.plate_deg)) + "°'";
  }
  figure.script += "set title \"" + figure.title +
                   " (simulation)\" font ',13'\nset key outside right\nset grid back lt 1 lw 0.6 lc rgb "
                   "'#dddddd'\nset size ratio -1\nset xrange [-35:35]\nset yrange [0:105]\n"
                   "set xlabel 'to the right of the mid-line, mm'\nset ylabel 'away from the participant, mm'\n" +
                   plots + '\n';
  return figure;
}

}  // namespace hrt::study
