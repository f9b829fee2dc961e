// Figs. 4 to 8 of the paper.
#include <algorithm>
#include <cmath>

#include "core/paper/participant.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures/figures.h"
#include "samples/study/figures/path.h"
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
  const char* paper;  ///< its result in the paper
};

constexpr PaperFigure paper_figures[] = {
    {4, 0, 10, 0.5, 0.15, false, "90 %"},
    {5, 10, 0, 0.5, 0.10, false, "88 %"},
    {6, -5, 5, 1.0, 0.10, false, "76 %"},
    {7, 0, 12, 2.0, 0.15, false, "60 %"},
    {8, 5, -5, 0.1, 0.15, true, "no correction towards the real target"},
};

// The direction after each step of each trial, and the median over the trials.
std::string directions_block(const std::vector<std::vector<double>>& directions_deg) {
  std::string trials = "$directions << EOD\n";
  std::string medians = "$directions_median << EOD\n";
  for (const auto& trial : directions_deg) {
    for (std::size_t k = 0; k < trial.size(); ++k) trials += std::to_string(k) + ' ' + number(trial[k]) + '\n';
    trials += '\n';
  }
  for (std::size_t k = 0; k < directions_deg.front().size(); ++k) {
    std::vector<double> at_step_deg;
    for (const auto& trial : directions_deg) at_step_deg.push_back(trial[k]);
    medians += std::to_string(k) + ' ' + number(median(at_step_deg)) + '\n';
  }
  return trials + "EOD\n" + medians + "EOD\n";
}

// Multiples of five that leave room about every point.
struct LateralRange {
  double first_mm = 0.0;
  double last_mm = 0.0;
};

LateralRange lateral_range(const std::vector<Path>& paths) {
  LateralRange range;
  for (const Path& path : paths)
    for (const PathPoint& point : path) {
      range.first_mm = std::min(range.first_mm, point.right_mm);
      range.last_mm = std::max(range.last_mm, point.right_mm);
    }
  return {5.0 * std::floor(range.first_mm / 5.0 - 0.3), 5.0 * std::ceil(range.last_mm / 5.0 + 0.3)};
}

// The four panels of a figure, one below the other.
constexpr int width_px = 560;
constexpr int height_px = 1600;
constexpr double left_px = 75.0;
constexpr double panel_width_px = 460.0;
constexpr double panel_height_px = 225.0;
constexpr double key_below_px = 55.0;
constexpr double first_top_px = 70.0;
constexpr double panel_pitch_px = 383.0;
constexpr double forward_range_mm = 110.0;

std::string panel_place(int panel) {
  const double top = 1.0 - (first_top_px + panel_pitch_px * panel) / height_px;
  const auto margin = [](const char* name, double at) {
    return std::string("set ") + name + " at screen " + number(at) + '\n';
  };
  return margin("lmargin", left_px / width_px) + margin("rmargin", (left_px + panel_width_px) / width_px) +
         margin("tmargin", top) + margin("bmargin", top - panel_height_px / height_px) +
         "set key at screen 0.53, screen " + number(top - (panel_height_px + key_below_px) / height_px) +
         " center top maxrows 2 spacing 1.2\n";
}

// How much longer a millimetre to the side is drawn than one ahead.
double enlargement(const LateralRange& range) {
  return panel_width_px / (range.last_mm - range.first_mm) / (panel_height_px / forward_range_mm);
}

// The trials that a figure shows.
struct PaperTrials {
  std::vector<Path> true_paths;
  std::vector<Path> perceived_paths;
  std::vector<std::vector<double>> directions_deg;  // of each trial, after each step
  std::string plate;                                // of the first one
  int hits = 0;
};

PaperTrials simulate(const PaperFigure& paper, const Condition& condition, std::uint64_t seed) {
  PaperTrials trials;
  trials.plate = "$plate << EOD\n0 " + number(condition.plate_orientation_deg) + '\n';
  for (std::uint32_t trial = 0; trial < static_cast<std::uint32_t>(paper_trials); ++trial) {
    std::vector<TrialStep> steps;
    const TrialOutcome outcome = simulate_trial(
        condition, {.seed = seed, .condition = static_cast<std::uint32_t>(paper.number), .trial = trial}, &steps);
    trials.hits += outcome.hit ? 1 : 0;
    trials.true_paths.push_back(path_of(steps, &TrialStep::finger_direction_deg));
    trials.perceived_paths.push_back(path_of(steps, &TrialStep::perceived_direction_deg));
    std::vector<double>& directions_deg = trials.directions_deg.emplace_back();
    for (const TrialStep& step : steps) directions_deg.push_back(step.finger_direction_deg);
    directions_deg.push_back(outcome.final_direction_deg);
    if (trial > 0) continue;
    for (const TrialStep& step : steps)
      trials.plate += std::to_string(step.step + 1) + ' ' + number(step.plate_orientation_deg) + '\n';
  }
  trials.plate += "EOD\n";
  return trials;
}

std::string paths_panel(int panel, const std::string& title, const std::string& paths, const std::string& thin,
                        const std::string& thick) {
  return panel_place(panel) + "set title '" + title + "'\nplot $" + paths + " using 1:2 with lines lw 0.7 lc rgb '" +
         thin + "' title 'one trial', $" + paths + "_median using 1:2 with lines " + thick +
         " title 'median', $real using 1:2 with points pt 7 ps 1.2 lc rgb '#1b7837' title 'real target', "
         "$virtual using 1:2 with points pt 12 ps 1.4 lw 2 lc rgb '#b35806' title 'virtual target'\n";
}

std::string level(double value_deg, const std::string& look) {
  return number(value_deg) + " with lines lc rgb '#555555' " + look + ", ";
}

std::string plate_panel(const PaperFigure& paper, double bound_deg) {
  std::string script = panel_place(2) +
                       "set title 'c: plate orientation in one trial'\nset xrange [0:31]\nset yrange [-110:110]\n"
                       "set ytics 30\nset xlabel 'model step (0.1 s)'\nset ylabel 'plate orientation, °'\nplot ";
  const Authority authority =
      steering_authority(paper.real_direction_deg, paper.virtual_direction_deg, paper.tactile_weight, bound_deg);
  if (!paper.is_plate_fixed)
    script += level(paper.virtual_direction_deg - bound_deg, "dt 3 lw 1.5 title 'bound'") +
              level(paper.virtual_direction_deg + bound_deg, "dt 3 lw 1.5 notitle");
  if (!paper.is_plate_fixed && authority.reachable)
    script += number(authority.plate_orientation_deg) +
              " with lines dt 2 lw 1.5 lc rgb '#b35806' title 'holds the real direction', ";
  return script + "$plate using 1:2 with linespoints pt 6 ps 0.6 lw 1.5 lc rgb '#08306b' title 'plate'\n";
}

std::string directions_panel(const PaperFigure& paper, double tolerance_deg) {
  return panel_place(3) +
         "set title 'd: true direction of motion'\nset yrange [-15:15]\nset ytics 5\n"
         "set ylabel 'direction, ° (left positive)'\nplot $directions using 1:2 with lines lw 0.7 lc rgb "
         "'#9ecae1' title 'one trial', $directions_median using 1:2 with lines lw 3 lc rgb '#a50f15' title "
         "'median', " +
         level(paper.real_direction_deg - tolerance_deg, "lw 1.5 title 'real ± 1.5°'") +
         level(paper.real_direction_deg + tolerance_deg, "lw 1.5 notitle") + number(paper.virtual_direction_deg) +
         " with lines dt 2 lw 1.5 lc rgb '#b35806' title 'virtual'\nunset multiplot\n";
}

// Without its script.
Figure described(const PaperFigure& paper, int hits) {
  const std::string number_text = std::to_string(paper.number);
  return {.name = "fig" + number_text,
          .title = "Fig. " + number_text + ": real target at " + number(paper.real_direction_deg) + "°, virtual at " +
                   number(paper.virtual_direction_deg) + "°" + (paper.is_plate_fixed ? ", no controller" : ""),
          .caption = "a: " + number(paper_trials) +
                     " simulated paths and their median. b: the paths that the "
                     "participant perceives. c: the plate in the first of these trials. d: the direction of motion, "
                     "which the last step judges. Motor variance " +
                     number(paper.motor_variance_deg2) + " (°)², tactile weight " + number(paper.tactile_weight) +
                     ". " + number(100.0 * hits / paper_trials) +
                     " % of these trials end within 1.5° of the real direction; the paper: " + paper.paper + ".",
          .width_px = width_px,
          .height_px = height_px};
}

Figure path_figure(const PaperFigure& paper, std::uint64_t seed) {
  Condition condition = make_condition(paper.motor_variance_deg2, paper.tactile_weight, paper.real_direction_deg,
                                       paper.virtual_direction_deg);
  if (paper.is_plate_fixed) condition.controller.mode = ControlMode::fixed_plate;
  const PaperTrials trials = simulate(paper, condition, seed);

  const PathPoint real = ahead({0.0, 0.0}, paper.real_direction_deg, path_length_mm);
  const PathPoint seen = ahead({0.0, 0.0}, paper.virtual_direction_deg, path_length_mm);
  std::vector<Path> all_paths{{real, seen}};
  all_paths.insert(all_paths.end(), trials.true_paths.begin(), trials.true_paths.end());
  all_paths.insert(all_paths.end(), trials.perceived_paths.begin(), trials.perceived_paths.end());
  const LateralRange sides = lateral_range(all_paths);
  const std::string enlarged = " (sideways enlarged " + fixed(enlargement(sides), 1) + " times)";

  Figure figure = described(paper, trials.hits);
  figure.script =
      path_block("true", trials.true_paths) + path_block("true_median", {median_path(trials.true_paths)}) +
      path_block("perceived", trials.perceived_paths) +
      path_block("perceived_median", {median_path(trials.perceived_paths)}) + path_block("real", {{real}}) +
      path_block("virtual", {{seen}}) + trials.plate + directions_block(trials.directions_deg) +
      "set multiplot layout 4,1 title \"" + figure.title +
      " (simulation)\" font ',12'\n"
      "set grid back lt 1 lw 0.6 lc rgb '#dddddd'\nset xrange [" +
      number(sides.first_mm) + ':' + number(sides.last_mm) +
      "]\nset yrange [0:110]\nset xlabel 'to the right of the mid-line, mm'\n"
      "set ylabel 'away from the participant, mm'\n" +
      paths_panel(0, "a: true paths" + enlarged, "true", "#9ecae1", "lw 3 lc rgb '#a50f15'") +
      paths_panel(1, "b: perceived paths" + enlarged, "perceived", "#bdbdbd", "dt 2 lw 3 lc rgb '#00441b'") +
      plate_panel(paper, condition.controller.mpc.plate_bound_deg) + directions_panel(paper, condition.tolerance_deg);
  return figure;
}

}  // namespace

std::vector<Figure> path_figures(std::uint64_t seed) {
  std::vector<Figure> figures;
  for (const PaperFigure& paper : paper_figures) figures.push_back(path_figure(paper, seed));
  return figures;
}

}  // namespace hrt::study
