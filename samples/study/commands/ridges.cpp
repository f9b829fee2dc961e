// hrt-study ridges: the paper's Fig. 1c.
#include "samples/study/figures/ridges.h"

#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/commands/commands.h"

namespace hrt::study {
namespace {

struct RidgesOptions {
  RidgeOptions ridges;
  std::string plot;
  Writing writing;
};

Ridges simulated(const RidgesOptions& options) {
  const Output plot("--plot", options.plot);
  Ridges ridges = simulate_ridges(options.ridges);
  if (!options.plot.empty()) plot.write(draw_beside("--plot", options.plot, ridges_figure(ridges)));
  return ridges;
}

}  // namespace

void add_ridges(CLI::App& app) {
  const auto options = std::make_shared<RidgesOptions>();
  CLI::App& command = add_command(
      app, "ridges", "The paper's Fig. 1c: slides straight ahead over a plate that rests at five angles.",
      R"(At rest the participant feels straight ahead: w_T T + (1 - w_T) P = 0 for a plate at T.

Examples:
  hrt-study ridges --plot fig1c.svg
  hrt-study ridges --tactile-weight 0.3 --angles -60:60:9 --format csv)",
      [options] { options->writing.write([options] { return simulated(*options); }, ridges_results, ridges_text); });
  RidgeOptions& ridges = options->ridges;
  add_numbers(command, "--angles", ridges.plate_angles_deg, {-90.0, 90.0, false, false},
              "Angles of the ridges' normal, deg.");
  add_number(command, "--tactile-weight", ridges.tactile_weight, tactile_weight_range,
             "Share of touch in the felt direction (w_T).");
  add_number(command, "--motor-variance", ridges.motor_variance_deg2, variance_range,
             "Variance of the motor command (sigma_u^2), deg^2.");
  add_integer(command, "--trials", ridges.trials, 1, 10'000, "Slides at each angle.");
  add_seed(command, ridges.seed);
  add_plot(command, options->plot, "Draw the paths there. Needs python3-matplotlib.");
  options->writing.add_options(command);
}

}  // namespace hrt::study
