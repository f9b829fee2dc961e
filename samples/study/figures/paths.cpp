#include "core/paper/participant.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures/figures.h"
#include "samples/study/paper/paper.h"

namespace hrt::study {
namespace {

struct PaperFigure {
  int number;
  double real_direction_deg;
  double virtual_direction_deg;
  double motor_variance_deg2;
  double tactile_weight;
  bool is_plate_fixed;
  const char* paper;  ///< result in the paper
};

constexpr PaperFigure paper_figures[] = {
    {4, 0, 10, 0.5, 0.15, false, "90 %"},
    {5, 10, 0, 0.5, 0.10, false, "88 %"},
    {6, -5, 5, 1.0, 0.10, false, "76 %"},
    {7, 0, 12, 2.0, 0.15, false, "60 %"},
    {8, 5, -5, 0.1, 0.15, true, "no correction towards the real target"},
};

Figure path_figure(const PaperFigure& paper, std::uint64_t seed) {
  Condition condition = make_condition(paper.motor_variance_deg2, paper.tactile_weight, paper.real_direction_deg,
                                       paper.virtual_direction_deg);
  if (paper.is_plate_fixed) condition.controller.mode = ControlMode::fixed_plate;
  const double bound_deg = condition.controller.mpc.plate_bound_deg;
  const GapFeasibility feasibility =
      paper_gap_feasibility(paper.real_direction_deg, paper.virtual_direction_deg, paper.tactile_weight, bound_deg);
  Row data{{"real_deg", paper.real_direction_deg},
           {"virtual_deg", paper.virtual_direction_deg},
           {"tolerance_deg", condition.tolerance_deg},
           {"bound_deg", paper.is_plate_fixed ? Row() : Row(bound_deg)},
           {"sustaining_deg",
            paper.is_plate_fixed || !feasibility.reachable ? Row() : Row(feasibility.plate_orientation_deg)},
           {"plate_deg", {condition.plate_orientation_deg}}};  // plate orientations in the first trial
  int hits = 0;
  for (std::uint32_t trial = 0; trial < static_cast<std::uint32_t>(paper_trials); ++trial) {
    std::vector<TrialStep> steps;
    const TrialOutcome outcome = simulate_trial(
        condition, {.seed = seed, .condition = static_cast<std::uint32_t>(paper.number), .trial = trial}, &steps);
    hits += outcome.hit ? 1 : 0;
    std::vector<double> true_deg, perceived_deg;
    for (const TrialStep& step : steps) {
      true_deg.push_back(step.finger_direction_deg);
      perceived_deg.push_back(step.perceived_direction_deg);
      if (trial == 0) data["plate_deg"].push_back(step.plate_orientation_deg);
    }
    data["true_deg"].push_back(true_deg);
    data["perceived_deg"].push_back(perceived_deg);
    true_deg.push_back(outcome.final_direction_deg);
    data["direction_deg"].push_back(true_deg);
  }
  return {.name = fmt::format("fig{}", paper.number),
          .title = fmt::format("Fig. {}: real target at {}°, virtual at {}°{}", paper.number, paper.real_direction_deg,
                               paper.virtual_direction_deg, paper.is_plate_fixed ? ", no controller" : ""),
          .caption = fmt::format(
              "a: {} simulated paths and their median. b: the perceived paths. c: the plate in the first of these "
              "trials. d: the direction of motion, whose last value decides whether the trial is a hit. Motor variance "
              "{} (°)², tactile weight {}. {} % of these trials end within 1.5° of the real direction; the paper: {}.",
              paper_trials, paper.motor_variance_deg2, paper.tactile_weight, 100.0 * hits / paper_trials, paper.paper),
          .data = data};
}

}  // namespace

std::vector<Figure> path_figures(std::uint64_t seed) {
  std::vector<Figure> figures;
  for (const PaperFigure& paper : paper_figures) figures.push_back(path_figure(paper, seed));
  return figures;
}

}  // namespace hrt::study
