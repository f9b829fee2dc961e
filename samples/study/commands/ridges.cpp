#include <cmath>
#include <memory>

#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/figures.h"
#include "samples/study/paper/paper.h"

namespace hrt::study {
namespace {

struct RidgeOptions {
  std::vector<double> plate_angles_deg{-60.0, -30.0, 0.0, 30.0, 60.0};  // as in reference [2] of the paper
  double tactile_weight = 0.15;
  double motor_variance_deg2 = 0.5;
  std::uint64_t trials = 50;
  std::uint64_t seed = 1;
  std::string plot;
  Writing writing;
};

struct RidgeAngle {
  double plate_deg;
  double rest_deg;                                  // perceived as straight ahead: -w T / (1 - w) for a plate at T
  double mean_deg = 0.0, sd_deg = 0.0;              // of the final directions
  std::vector<std::vector<double>> directions_deg;  // direction of the finger by trial, then step
};

RidgeAngle simulate(const RidgeOptions& options, double plate_deg, std::uint32_t number) {
  const double weight = options.tactile_weight;
  RidgeAngle angle{.plate_deg = plate_deg, .rest_deg = -weight * plate_deg / (1.0 - weight)};
  Condition condition = make_condition(options.motor_variance_deg2, weight, 0.0, 0.0);
  condition.controller.mode = ControlMode::fixed_plate;
  condition.controller.fixed_plate_orientation_deg = condition.plate_orientation_deg = plate_deg;
  double squares = 0.0;
  for (std::uint32_t trial = 0; trial < options.trials; ++trial) {
    std::vector<TrialStep> steps;
    const TrialOutcome outcome =
        simulate_trial(condition, {.seed = options.seed, .condition = number, .trial = trial}, &steps);
    std::vector<double>& directions_deg = angle.directions_deg.emplace_back();
    for (const TrialStep& step : steps) directions_deg.push_back(step.finger_direction_deg);
    angle.mean_deg += outcome.final_direction_deg;
    squares += outcome.final_direction_deg * outcome.final_direction_deg;
  }
  const auto n = static_cast<double>(options.trials);
  angle.mean_deg /= n;
  angle.sd_deg = std::sqrt(std::max(squares / n - angle.mean_deg * angle.mean_deg, 0.0));
  return angle;
}

using Ridges = std::vector<RidgeAngle>;

Ridges simulate_ridges(const RidgeOptions& options) {
  Ridges angles;
  for (const double plate_deg : options.plate_angles_deg)
    angles.push_back(simulate(options, plate_deg, static_cast<std::uint32_t>(angles.size())));
  return angles;
}

std::string ridges_text(const RidgeOptions& options, const Ridges& angles) {
  std::string page =
      wrapped(
          fmt::format(
              "As in the paper's Fig. 1c: {} simulated slides straight ahead over a plate that rests at each angle, "
              "tactile weight {}, motor variance {} deg^2. Ridges that shift the perceived direction to the left "
              "(positive angles) bend the path to the right. Fixed point: direction that is perceived as straight "
              "ahead. There was no human trial.",
              options.trials, options.tactile_weight, options.motor_variance_deg2),
          110) +
      "\n\nplate, deg  final direction, deg: mean      SD  fixed point\n";
  for (const RidgeAngle& angle : angles)
    page += fmt::format("{:>10}{:>29.1f}{:>8.1f}{:>13.1f}\n", angle.plate_deg, angle.mean_deg, angle.sd_deg,
                        angle.rest_deg);
  return page;
}

Results ridges_results(const RidgeOptions& options, const Ridges& angles) {
  Results found{.about = {{"simulation", true},
                          {"trials", options.trials},
                          {"seed", options.seed},
                          {"tactile_weight", options.tactile_weight},
                          {"motor_variance_deg2", options.motor_variance_deg2}},
                .rows = {}};
  for (const RidgeAngle& angle : angles)
    found.rows.push_back({{"plate_deg", angle.plate_deg},
                          {"mean_deg", angle.mean_deg},
                          {"sd_deg", angle.sd_deg},
                          {"rest_deg", angle.rest_deg}});
  return found;
}

Figure figure_of(const Ridges& angles) {
  Row data;
  for (const RidgeAngle& angle : angles)
    data["angles"].push_back({{"plate_deg", angle.plate_deg}, {"directions_deg", angle.directions_deg}});
  return {.name = "fig1c",
          .title = "Fig. 1c: straight ahead over a plate at rest",
          .caption =
              "Simulated paths of a participant who slides straight ahead over a plate at rest, and their median. Each "
              "colour is an angle of the plate.",
          .data = data};
}

Ridges simulated(const RidgeOptions& options) {
  const Output plot("--plot", options.plot);
  Ridges angles = simulate_ridges(options);
  if (!options.plot.empty()) plot.write(draw_beside("--plot", options.plot, figure_of(angles)));
  return angles;
}

}  // namespace

Figure ridges_figure(std::uint64_t seed) { return figure_of(simulate_ridges({.seed = seed})); }

void add_ridges(CLI::App& app) {
  const auto options = std::make_shared<RidgeOptions>();
  CLI::App& command = add_command(
      app, "ridges", "The paper's Fig. 1c: slides straight ahead over a fixed plate at several angles.",
      R"(Paths approach the direction P that is perceived as straight ahead: w_T T + (1 - w_T) P = 0, where T is the
plate orientation.

Examples:
  hrt-study ridges --plot fig1c.svg
  hrt-study ridges --tactile-weight 0.3 --angles -60:60:9 --format csv)",
      [options] {
        options->writing.write([&] { return simulated(*options); },
                               [&](const Ridges& angles) { return ridges_results(*options, angles); },
                               [&](const Ridges& angles) { return ridges_text(*options, angles); });
      });
  add_numbers(command, "--angles", options->plate_angles_deg, {-90.0, 90.0, false, false},
              "Plate orientations (normal of the ridges), deg.");
  add_number(command, "--tactile-weight", options->tactile_weight, tactile_weight_range,
             "Tactile weight w_T: fraction of touch in the perceived direction.");
  add_number(command, "--motor-variance", options->motor_variance_deg2, variance_range,
             "Variance of the motor command (sigma_u^2), deg^2.");
  add_integer(command, "--trials", options->trials, 1, 10'000, "Slides at each angle.");
  add_seed(command, options->seed);
  add_plot(command, options->plot, "SVG file for a figure of the paths. Needs python3-matplotlib.");
  options->writing.add_options(command);
}

}  // namespace hrt::study
