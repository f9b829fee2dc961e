// Table I as a figure.
#include "samples/study/cli/output.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {
namespace {

// "Condition 1: σ_u² = 0.5, w_T = 0.15", in gnuplot's markup.
std::string heading(const CellGroup& group) {
  const Participant& participant = group.cells.front().condition.participant;
  return "Condition " + group.name.substr(10) + ": σ_u² = " + number(participant.motor_variance_deg2) +
         " (°)², w_T = " + number(participant.tactile_weight);
}

}  // namespace

Figure table1_figure(const Table1& table) {
  Figure figure{.name = "table1",
                .title = "Table I: paper and model",
                .caption =
                    "Share of trials that end within 1.5° of the real direction, for the six pairs of each condition. "
                    "Bars: 95 % intervals (Wilson) of the paper's 50 trials and of the model's " +
                    std::to_string(table.options.trials) +
                    " a cell. Dashed: limit of any controller, since the noise of the last step comes after the plate "
                    "has acted.",
                .width_px = 560,
                .height_px = 1160};
  std::string plots;
  for (std::size_t i = 0; i < table.conditions.size(); ++i) {
    const CellGroup& group = table.conditions[i];
    const std::string block = "$condition" + std::to_string(i);
    figure.script += block + " << EOD\n";
    std::string tics;
    for (std::size_t j = 0; j < group.cells.size(); ++j) {
      const Cell& cell = group.cells[j];
      const PercentInterval interval = paper_interval(cell);
      const PercentInterval model = wilson_interval(cell.result.hit_percent(), static_cast<double>(cell.result.trials));
      figure.script += std::to_string(j) + ' ' + number(*cell.paper_percent) + ' ' + number(interval.low) + ' ' +
                       number(interval.high) + ' ' + number(cell.result.hit_percent()) + ' ' + number(model.low) + ' ' +
                       number(model.high) + '\n';
      tics += (j == 0 ? "'" : ", '") + number(cell.condition.real_direction_deg) + " / " +
              number(cell.condition.virtual_direction_deg) + "' " + std::to_string(j);
    }
    figure.script += "EOD\n";
    plots += "set title '" + heading(group) + "'\nset xtics (" + tics + ")\nplot " +
             number(limit_percent(group.cells.front().condition)) +
             " with lines dt 2 lw 1.5 lc rgb '#555555' title 'limit', " + block +
             " using ($1-0.12):2:3:4 with yerrorbars pt 6 ps 1.3 lw 1.5 lc rgb '#08306b' title 'paper', " + block +
             " using ($1+0.12):5:6:7 with yerrorbars pt 5 ps 0.9 lw 1.5 lc rgb '#b35806' title 'model'\n";
  }
  figure.script += "set multiplot layout 4,1 title \"" + figure.title +
                   " (both simulation)\" font ',14'\nset key below width 2\nset bmargin 6\nset grid ytics "
                   "back lt 1 lw 0.6 lc rgb '#dddddd'\n"
                   "set xrange [-0.5:5.5]\nset yrange [50:100]\n"
                   "set xlabel 'real / virtual direction, °'\nset ylabel 'trials within 1.5°, %'\n" +
                   plots + "unset multiplot\n";
  return figure;
}

}  // namespace hrt::study
