#include "samples/study/paper/table1.h"

#include <algorithm>

#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

std::string paper_columns(std::optional<double> paper_percent, std::optional<PercentInterval> interval,
                          double percent) {
  return fmt::format("{:>9}{:>15}{:>9.1f}", paper_percent ? cell(*paper_percent, 1) : "",
                     interval ? between(interval->low, interval->high, 1, " - ") : "", percent);
}

std::string yes_or_no(bool yes) { return yes ? "     yes\n" : "      NO\n"; }

// Ends of the 95 % interval of the SD of a sample of six from a normal distribution, divided by the true SD.
constexpr double low_sd_of_six = 0.408;
constexpr double high_sd_of_six = 1.602;

std::string condition_text(const CellGroup& group) {
  std::string page = group.title + "\n   real  virtual    paper  95 % interval    model  agrees\n";
  for (const Cell& cell : group.cells)
    page += fmt::format("{:>7}{:>9}", cell.condition.real_direction_deg, cell.condition.virtual_direction_deg) +
            paper_columns(cell.paper_percent, paper_interval(cell), cell.result.hit_percent()) +
            yes_or_no(agrees(cell));
  const double sd = group.sd_percent();
  const PercentInterval six{low_sd_of_six * sd, high_sd_of_six * sd};
  return page + "    mean        " + paper_columns(group.paper_percent, group.paper_interval(), group.mean_percent()) +
         yes_or_no(group.reproduced) + "    SD          " + paper_columns(group.paper_sd, six, sd) +
         yes_or_no(six.contains(*group.paper_sd)) +
         fmt::format("    limit of any controller: {:.1f} %: the plate cannot correct the noise of the last step\n\n",
                     limit_percent(group.cells.front().condition));
}

std::string fit_text(const Table1& table) {
  int outside = 0;
  for (const CellGroup& group : table.conditions)
    for (const Cell& cell : group.cells) outside += agrees(cell) ? 0 : 1;
  std::string page = fmt::format(
      "chi-squared {:.1f} over {} cells, p = {:.2f}: {} with the noise of the paper's 50 trials per cell.\n"
      "log-likelihood of the paper's trials {:.1f}\n"
      "{} of the {} cells lie outside their 95 % interval; one in twenty does by chance.\n{}\n"
      "SD: standard deviation of the six pairs. That of the model is for cells of 50 trials, and its interval\n"
      "contains 95 % of the SDs of six such cells.\n",
      table.chi_squared, table.degrees_of_freedom, table.p_value,
      table.p_value >= 0.05 ? "consistent" : "NOT consistent", table.log_likelihood, outside, table.degrees_of_freedom,
      wrapped(in_sample_words, 110));
  for (const CellGroup& group : table.conditions)
    if (!group.reproduced)
      page += fmt::format("The mean of condition {} lies outside its interval by {:.2f} percentage points.\n",
                          group.name.substr(10),
                          std::max(group.paper_interval()->low - group.mean_percent(),
                                   group.mean_percent() - group.paper_interval()->high));
  return page + "The paper prints 79 % for one cell, which would be 39.5 of 50 trials; the comparison uses 79 %.\n\n";
}

std::string claims_text(const Table1& table) {
  std::string page = "Other claims of the paper             paper  95 % interval    model  lowest and highest\n";
  for (const CellGroup& claim : table.claims) {
    page += fmt::format("{:34}", claim.title) +
            paper_columns(claim.paper_percent, claim.paper_interval(), claim.mean_percent());
    if (claim.cells.size() > 1) {
      const auto less = [](const Cell& a, const Cell& b) { return a.result.hits < b.result.hits; };
      const auto [lowest, highest] = std::minmax_element(claim.cells.begin(), claim.cells.end(), less);
      page += fmt::format("{:>8.1f} - {:.1f} of the six pairs", lowest->result.hit_percent(),
                          highest->result.hit_percent());
    }
    page += "\n    ";
    for (const char c : wrapped(claim.verdict, 96)) page += c == '\n' ? "\n    " : std::string(1, c);
    page += '\n';
  }
  return page;
}

std::string best_words(const BestAmplitude& best) {
  if (best.gap_deg == amplitudes_deg[paper_amplitude]) return "best at 10 deg";
  return fmt::format("best at {} deg, by {:.1f} points{}", best.gap_deg, best.percent - best.paper_amplitude_percent,
                     best.by_chance ? ", not significant" : "");
}

std::string amplitudes_text(const Table1& table) {
  std::string page = "\nThe six pairs with other gaps, deg; the paper calls 10 deg the best\n            ";
  for (const double gap_deg : amplitudes_deg) page += fmt::format("{:>7}", gap_deg);
  for (std::size_t i = 0; i < table.conditions.size(); ++i) {
    page += fmt::format("\ncondition {} ", i + 1);
    for (std::size_t k = 0; k < std::size(amplitudes_deg); ++k)
      page += fmt::format("{:>7.1f}", table.amplitudes[i * std::size(amplitudes_deg) + k].mean_percent());
    page += "  " + best_words(best_amplitude(table, i));
  }
  return page + '\n';
}

Row row_of(const CellGroup& group, const Cell& cell) {
  const Condition& condition = cell.condition;
  Row row{{"group", group.name},
          {"motor_variance_deg2", condition.participant.motor_variance_deg2},
          {"tactile_weight", condition.participant.tactile_weight},
          {"real_direction_deg", condition.real_direction_deg},
          {"virtual_direction_deg", condition.virtual_direction_deg},
          {"horizon", condition.controller.mpc.horizon},
          {"tolerance_deg", condition.tolerance_deg},
          {"controller", condition.controller.mode == ControlMode::mpc ? "mpc" : "none"},
          {"trials", cell.result.trials},
          {"hits", cell.result.hits},
          {"percent", cell.result.hit_percent()},
          {"mean_miss_deg", cell.result.mean_miss_deg()},
          {"rms_miss_deg", cell.result.rms_miss_deg()},
          {"rms_felt_error_deg", cell.result.rms_felt_error_deg()},
          {"paper_percent", nullptr},
          {"paper_low_percent", nullptr},
          {"paper_high_percent", nullptr},
          {"agrees", nullptr}};
  if (cell.paper_percent) {
    row["paper_percent"] = *cell.paper_percent;
    row["paper_low_percent"] = paper_interval(cell).low;
    row["paper_high_percent"] = paper_interval(cell).high;
    row["agrees"] = agrees(cell);
  }
  return row;
}

Row group_row(const CellGroup& group) {
  Row row{{"name", group.name}, {"title", group.title}, {"mean_percent", group.mean_percent()}};
  if (group.paper_percent) {
    row["paper_mean_percent"] = *group.paper_percent;
    row["paper_interval_percent"] = {group.paper_interval()->low, group.paper_interval()->high};
  }
  row["reproduced"] = group.reproduced;
  row["verdict"] = group.verdict;
  return row;
}

}  // namespace

std::string table1_text(const Table1& table) {
  const Table1Options& options = table.options;
  std::string page = fmt::format(
      "Percentage of trials that end within 1.5 deg of the real target: paper (50 trials per cell) and model\n"
      "({} trials per cell, seed {}, horizon {}, plate bound {} deg,\nsensory variance {} deg^2, {} steps). Both are "
      "simulated; there was no human trial. Directions in deg.\n\n",
      options.trials, options.seed, options.horizon, options.plate_bound_deg, options.sensory_variance_deg2,
      options.steps);
  for (const CellGroup& group : table.conditions) page += condition_text(group);
  return page + fit_text(table) + claims_text(table) + amplitudes_text(table);
}

Results table1_results(const Table1& table) {
  Results found{.about = {{"simulation", true},
                          {"note", "Paper and model are both simulated; there was no human trial."},
                          {"trials_per_cell", table.options.trials},
                          {"seed", table.options.seed},
                          {"horizon", table.options.horizon},
                          {"plate_bound_deg", table.options.plate_bound_deg},
                          {"sensory_variance_deg2", table.options.sensory_variance_deg2},
                          {"steps", table.options.steps},
                          {"log_likelihood", table.log_likelihood},
                          {"chi_squared", table.chi_squared},
                          {"degrees_of_freedom", table.degrees_of_freedom},
                          {"p_value", table.p_value}},
                .rows = {}};
  for (std::size_t i = 0; i < table.conditions.size(); ++i) {
    const CellGroup& group = table.conditions[i];
    Row condition = group_row(group);
    condition["sd_percent"] = group.sd_percent();
    condition["paper_sd_percent"] = *group.paper_sd;
    condition["limit_percent"] = limit_percent(group.cells.front().condition);
    condition["best_amplitude_deg"] = best_amplitude(table, i).gap_deg;
    found.about["conditions"].push_back(condition);
  }
  for (const CellGroup& group : table.claims) found.about["claims"].push_back(group_row(group));
  for (const auto* groups : {&table.conditions, &table.claims, &table.amplitudes})
    for (const CellGroup& group : *groups)
      for (const Cell& cell : group.cells) found.rows.push_back(row_of(group, cell));
  return found;
}

}  // namespace hrt::study
