// Perceived against actual error as the weights of the cost vary.
//
// Away from the plate's bound the controller chooses e freely, and x = p - p_R becomes x - e + noise, with
// noise of variance s^2 = sigma_u^2 + var. The controllers with the least E e^2 for a given E x^2 are linear,
// e = g x with 0 < g <= 1, and in the steady state
//     E x^2 = s^2 / (g (2 - g)),   E e^2 = g s^2 / (2 - g).
// That curve is the limit: a bound on the plate cannot improve on it.
#include <cmath>

#include "core/calibrate/calibration.h"
#include "core/paper/perception.h"
#include "samples/study/cli/output.h"
#include "samples/study/cli/parameters.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {
namespace {

// Enough for the steady state.
constexpr int steps_to_rest = 100;

constexpr double motor_variances_deg2[] = {0.5, 1.0};
constexpr double tactile_weights[] = {0.15, 0.10};
constexpr double actual_weights[] = {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 20.0};

Condition condition(double motor_variance_deg2, double tactile_weight, double actual_weight) {
  Condition condition = make_condition(motor_variance_deg2, tactile_weight, -5.0, 5.0);
  condition.controller.mpc.actual_weight = actual_weight;
  condition.steps = steps_to_rest;
  return condition;
}

std::string limit_curve(const std::string& name, double noise_variance_deg2) {
  std::string block = '$' + name + " << EOD\n";
  for (int i = 4; i <= 100; ++i) {
    const double gain = 0.01 * i;
    block += number(std::sqrt(noise_variance_deg2 * gain / (2.0 - gain))) + ' ' +
             number(std::sqrt(noise_variance_deg2 / (gain * (2.0 - gain)))) + '\n';
  }
  return block + "EOD\n";
}

std::vector<BatchResult> simulate_points(const FigureOptions& options) {
  std::vector<BatchJob> jobs;
  for (const double motor_variance_deg2 : motor_variances_deg2)
    for (const double tactile_weight : tactile_weights)
      for (const double actual_weight : actual_weights)
        jobs.push_back({.condition = condition(motor_variance_deg2, tactile_weight, actual_weight),
                        .condition_id = static_cast<std::uint32_t>(jobs.size()),
                        .first_trial = 0,
                        .last_trial = static_cast<std::uint32_t>(options.trials)});
  return run_with_progress(jobs, options.seed, options.threads);
}

// Of one curve, a point for each actual weight.
std::string points_block(const std::string& name, const BatchResult* results) {
  std::string block = '$' + name + " << EOD\n";
  for (const double actual_weight : actual_weights) {
    const BatchResult& result = *results++;
    // Of a normal error, the standard deviation of a root mean square is 1 / sqrt(2 n) of it.
    const double relative = normal_975 / std::sqrt(2.0 * static_cast<double>(result.trials));
    block += number(result.rms_felt_error_deg()) + ' ' + number(result.rms_miss_deg()) + ' ' +
             number(relative * result.rms_felt_error_deg()) + ' ' + number(relative * result.rms_miss_deg()) +
             ' ' + number(actual_weight) + '\n';
  }
  return block + "EOD\n";
}

}  // namespace

Figure frontier_figure(const FigureOptions& options) {
  const std::vector<BatchResult> results = simulate_points(options);
  Figure figure{
      .name = "frontier",
      .title = "Perceived against actual error as the weights vary",
      .caption =
          "Each point is a ratio of the two weights in the controller's cost, actual to perceived, from 0.05 "
          "(upper left) to 20 (lower right); labelled where w_T = 0.15. Gap 10°, horizon 3, at rest (" +
          std::to_string(steps_to_rest) + " steps), " + std::to_string(options.trials) +
          " trials a point, with 95 % intervals. Lines: the theoretical limit of any controller. With "
          "w_T = 0.10 a gap of 10° is just out of reach, so the points lie above.",
      .width_px = 560,
      .height_px = 560};
  std::string plots;
  std::size_t job = 0;
  int style = 0;
  for (const double motor_variance_deg2 : motor_variances_deg2) {
    const Condition any = condition(motor_variance_deg2, 0.15, 1.0);
    const std::string limit = "limit" + std::to_string(style);
    figure.script += limit_curve(limit, motor_variance_deg2 + steady_gain(any.participant).variance_deg2);
    const std::string colour = style == 0 ? "#08306b" : "#b35806";
    plots += (style == 0 ? "plot $" : ", $") + limit + " using 1:2 with lines lw 2 dt " +
             (style == 0 ? "1" : "2") + " lc rgb '" + colour +
             "' title 'limit, σ_u² = " + number(motor_variance_deg2) + "'";
    for (const double tactile_weight : tactile_weights) {
      const std::string block = "points" + std::to_string(job);
      figure.script += points_block(block, &results[job]);
      job += std::size(actual_weights);
      const bool is_held = tactile_weight > 0.12;
      const int point = (is_held ? 6 : 8) + style;
      plots += ", $" + block + " using 1:2:3:4 with xyerrorbars ps 1 lw 1.5 pt " + std::to_string(point) +
               " lc rgb '" + colour + "' title 'w_T = " + fixed(tactile_weight, 2) +
               ", σ_u² = " + number(motor_variance_deg2) + "'";
      if (is_held && style == 0) plots += ", $" + block + " using 1:2:5 with labels offset -2,-0.7 notitle";
    }
    ++style;
  }
  figure.script +=
      "set title \"" + figure.title +
      " (simulation)\" font ',11'\nset key outside below maxcols 2\nset bmargin 9\nset grid back lt 1 lw "
      "0.6 lc rgb '#dddddd'\n"
      "set xrange [0:1.2]\nset yrange [0.5:3.5]\n"
      "set xlabel 'perceived error: RMS of perceived less virtual direction, °'\n"
      "set ylabel 'actual error: RMS of true less real direction, °'\n" +
      plots + "\n";
  return figure;
}

}  // namespace hrt::study
