// The map of gaps that can be held.
#include <cmath>

#include "core/paper/authority.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {
namespace {

// Gap held with the plate `offset_deg` from the virtual direction, over the tactile weight.
std::string curve(const std::string& name, double offset_deg) {
  std::string block = '$' + name + " << EOD\n";
  for (int i = 1; i <= 100; ++i) {
    const double tactile_weight = 0.00499 * i;
    block += number(tactile_weight) + ' ' + number(max_gap_deg(tactile_weight, offset_deg)) + '\n';
  }
  return block + "EOD\n";
}

}  // namespace

Figure authority_figure(const Table1& table) {
  constexpr double top_deg = 30.0;
  const double bound_deg = table.conditions.front().cells.front().condition.controller.mpc.plate_bound_deg;
  Figure figure{
      .name = "authority",
      .title = "Which gaps can be held",
      .caption = "Below the solid line the plate, within " + number(bound_deg) +
                 "° of the virtual direction, can hold the finger on the real direction while the "
                 "participant feels the virtual one. Thin lines: where the plate then stands. Points: the "
                 "paper's conditions, with the share of simulated trials that end within 1.5°, of " +
                 std::to_string(table.options.trials) +
                 " trials a pair; σ_u² is 0.5 (°)², at a gap of 12° 2 (°)². Human data on the illusion cover "
                 "plates within 60° of the motion.",
      .width_px = 560,
      .height_px = 500};
  std::string points = "$points << EOD\n";
  for (const auto* groups : {&table.conditions, &table.claims})
    for (const CellGroup& group : *groups) {
      const Condition& condition = group.cells.front().condition;
      const bool is_shown = group.name == "condition_1" || group.name == "condition_2" ||
                            group.name.starts_with("tactile_weight") || group.name == "gap_12";
      if (is_shown)
        points += number(condition.participant.tactile_weight) + ' ' +
                  number(std::abs(condition.virtual_direction_deg - condition.real_direction_deg)) + " \"" +
                  fixed(group.mean_percent(), 0) + " %\" " + (group.name == "gap_12" ? "1" : "-1") + '\n';
    }
  figure.script =
      curve("bound", bound_deg) + curve("right_angle", 90.0) + curve("sixty", 60.0) + curve("thirty", 30.0) +
      points + "EOD\nset title \"" + figure.title +
      " (from the model)\" font ',14'\nset key outside below maxcols 2\nset grid back lt 1 lw 0.6 lc rgb "
      "'#dddddd'\n"
      "set bmargin 7\nset style textbox opaque noborder margins 0.5,0.5\nset xrange [0:0.5]\nset yrange [0:" +
      number(top_deg) +
      "]\nset xlabel 'tactile weight w_T'\nset ylabel 'gap between real and virtual direction, °'\n"
      "plot $bound using 1:2 with filledcurves x1 fc rgb '#e8eef4' title 'can be held', "
      "$right_angle using 1:2 with lines dt 2 lw 1.5 lc rgb '#555555' title 'plate at 90°', "
      "$bound using 1:2 with lines lw 3 lc rgb '#08306b' title 'plate at " +
      number(bound_deg) +
      "°', $sixty using 1:2 with lines dt 4 lw 1.2 lc rgb '#08306b' title 'at 60°', "
      "$thirty using 1:2 with lines dt 3 lw 1.2 lc rgb '#08306b' title 'at 30°', "
      "$points using 1:2 with points pt 7 ps 1.3 lc rgb '#b35806' title 'simulated', "
      "$points using 1:($2+1.2*$4):3 with labels boxed notitle\n";
  return figure;
}

}  // namespace hrt::study
