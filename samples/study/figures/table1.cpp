// Table I as a figure.
#include "samples/study/figures/figures.h"
#include "samples/study/output.h"

namespace hrt::study {

Figure table1_figure(const Table1& table) {
  Figure figure{
      .name = "table1",
      .title = "Table I: paper and model",
      .caption =
          "Share of trials that end within 1.5 deg of the real direction, for the six pairs of each "
          "condition. Bars: 95 % interval of the paper's 50 trials. Model: " +
          std::to_string(table.options.trials) +
          " trials a cell. Dashed: limit of any controller, since the noise of the last step "
          "comes after the plate has acted.",
      .width_px = 1200,
      .height_px = 760};
  std::string plots;
  for (std::size_t i = 0; i < table.conditions.size(); ++i) {
    const CellGroup& group = table.conditions[i];
    const std::string block = "$condition" + std::to_string(i);
    figure.script += block + " << EOD\n";
    std::string tics;
    for (std::size_t j = 0; j < group.cells.size(); ++j) {
      const Cell& cell = group.cells[j];
      const PercentInterval interval = paper_interval(cell);
      figure.script += std::to_string(j) + ' ' + number(*cell.paper_percent) + ' ' + number(interval.low) +
                       ' ' + number(interval.high) + ' ' + number(cell.result.hit_percent()) + '\n';
      tics += (j == 0 ? "'" : ", '") + number(cell.condition.real_direction_deg) + " / " +
              number(cell.condition.virtual_direction_deg) + "' " + std::to_string(j);
    }
    figure.script += "EOD\n";
    plots += "set title '" + group.title + "'\nset xtics (" + tics + ")\nplot " +
             number(limit_percent(group.cells.front().condition)) +
             " with lines dt 2 lw 1.5 lc rgb '#555555' title 'limit', " + block +
             " using ($1-0.12):2:3:4 with yerrorbars pt 6 ps 1.3 lw 1.5 lc rgb '#08306b' title 'paper', " +
             block + " using ($1+0.12):5 with points pt 5 ps 1.2 lc rgb '#b35806' title 'model'\n";
  }
  figure.script += "set multiplot layout 2,2 title \"" + figure.title +
                   " (both simulation)\" font ',14'\nset key below width 2\nset bmargin 6\nset grid ytics "
                   "back lt 1 lw 0.6 lc rgb '#dddddd'\n"
                   "set xrange [-0.5:5.5]\nset yrange [50:100]\n"
                   "set xlabel 'real / virtual direction, deg'\nset ylabel 'trials within 1.5 deg, %'\n" +
                   plots + "unset multiplot\n";
  return figure;
}

}  // namespace hrt::study
