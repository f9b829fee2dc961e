#include "samples/study/paper/table1.h"

#include <algorithm>

#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

// "     93.0    89.5 - 95.4     92.8"
std::string paper_columns(std::optional<double> paper_percent, std::optional<PercentInterval> interval,
                          double percent) {
  return right(paper_percent ? fixed(*paper_percent, 1) : "", 9) +
         right(interval ? between(interval->low, interval->high, 1, " - ") : "", 15) + right(fixed(percent, 1), 9);
}

std::string yes_or_no(bool yes) { return yes ? "     yes" : "      NO"; }

// Ends of the 95 % interval of the SD of a sample of six from a normal distribution, divided by the true SD.
constexpr double low_sd_of_six = 0.408;
constexpr double high_sd_of_six = 1.602;

std::string condition_text(const CellGroup& group) {
  std::string page = group.title + "\n   real  virtual    paper  95 % interval    model  agrees\n";
  for (const Cell& cell : group.cells)
    page += right(number(cell.condition.real_direction_deg), 7) +
            right(number(cell.condition.virtual_direction_deg), 9) +
            paper_columns(cell.paper_percent, paper_interval(cell), cell.result.hit_percent()) +
            yes_or_no(agrees(cell)) + '\n';
  const double sd = group.sd_percent();
  const PercentInterval six{low_sd_of_six * sd, high_sd_of_six * sd};
  return page + left("    mean", 16) +
         paper_columns(group.paper_percent, group.paper_interval(), group.mean_percent()) +
         yes_or_no(group.reproduced) + '\n' + left("    SD", 16) + paper_columns(group.paper_sd, six, sd) +
         yes_or_no(six.contains(*group.paper_sd)) +
         "\n    limit of any controller: " + fixed(limit_percent(group.cells.front().condition), 1) +
         ", as the plate cannot correct the noise of the last step\n\n";
}

std::string fit_text(const Table1& table) {
  int outside = 0;
  for (const CellGroup& group : table.conditions)
    for (const Cell& cell : group.cells) outside += agrees(cell) ? 0 : 1;
  std::string page =
      "chi-squared " + fixed(table.chi_squared, 1) + " over " + std::to_string(table.degrees_of_freedom) +
      " cells, p = " + fixed(table.p_value, 2) + ": " + (table.p_value >= 0.05 ? "consistent" : "NOT consistent") +
      " with the noise of the paper's 50 trials per cell.\nlog-likelihood of the paper's trials " +
      fixed(table.log_likelihood, 1) + "\n" + std::to_string(outside) + " of the " +
      std::to_string(table.degrees_of_freedom) +
      " cells lie outside their 95 % interval; one in twenty does by chance.\n" + wrapped(in_sample_words, 110) +
      "\nSD: over the six pairs. The model's SD is that of cells of 50 trials; its interval contains 95 % of the\n"
      "SDs of six cells.\n";
  for (const CellGroup& group : table.conditions)
    if (!group.reproduced)
      page += "The mean of " + group.name.substr(0, 9) + ' ' + group.name.substr(10) +
              " lies outside its interval by " +
              fixed(std::max(group.paper_interval()->low - group.mean_percent(),
                             group.mean_percent() - group.paper_interval()->high),
                    2) +
              " percentage points.\n";
  return page + "79 % of 50 trials is not a whole number of trials; it is used as the paper prints it.\n\n";
}

std::string claims_text(const Table1& table) {
  std::string page = left("Other claims of the paper", 34) + "    paper  95 % interval    model  lowest and highest\n";
  for (const CellGroup& claim : table.claims) {
    page += left(claim.title, 34) + paper_columns(claim.paper_percent, claim.paper_interval(), claim.mean_percent());
    if (claim.cells.size() > 1) {
      const auto less = [](const Cell& a, const Cell& b) { return a.result.hits < b.result.hits; };
      const auto [lowest, highest] = std::minmax_element(claim.cells.begin(), claim.cells.end(), less);
      page += right(fixed(lowest->result.hit_percent(), 1), 8) + " - " + fixed(highest->result.hit_percent(), 1) +
              " of the six pairs";
    }
    page += "\n    ";
    for (const char c : wrapped(claim.verdict, 96)) page += c == '\n' ? "\n    " : std::string(1, c);
    page += '\n';
  }
  return page;
}

std::string best_words(const BestAmplitude& best) {
  if (best.gap_deg == amplitudes_deg[paper_amplitude]) return "best at 10 deg";
  return "best at " + number(best.gap_deg) + " deg, by " + fixed(best.percent - best.paper_amplitude_percent, 1) +
         " points" + (best.by_chance ? ", not significant" : "");
}

std::string amplitudes_text(const Table1& table) {
  std::string page = "\nThe six pairs with other gaps, deg; the paper calls 10 deg the best\n" + left("", 12);
  for (const double gap_deg : amplitudes_deg) page += right(number(gap_deg), 7);
  page += '\n';
  for (std::size_t i = 0; i < table.conditions.size(); ++i) {
    page += "condition " + std::to_string(i + 1) + ' ';
    for (std::size_t k = 0; k < std::size(amplitudes_deg); ++k)
      page += right(fixed(table.amplitudes[i * std::size(amplitudes_deg) + k].mean_percent(), 1), 7);
    page += "  " + best_words(best_amplitude(table, i)) + '\n';
  }
  return page;
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
  std::string page =
      "Percentage of trials that end within 1.5 deg of the real target: paper (50 trials per cell) and model\n(" +
      std::to_string(table.options.trials) + " trials per cell, seed " + std::to_string(table.options.seed) +
      ", horizon " + std::to_string(table.options.horizon) + ", plate bound " + number(table.options.plate_bound_deg) +
      " deg,\nsensory variance " + number(table.options.sensory_variance_deg2) + " deg^2, " +
      std::to_string(table.options.steps) +
      " steps). Both are simulation; there was no human trial. Directions in deg.\n\n";
  for (const CellGroup& group : table.conditions) page += condition_text(group);
  return page + fit_text(table) + claims_text(table) + amplitudes_text(table);
}

Results table1_results(const Table1& table) {
  Results found{.about = {{"simulation", true},
                          {"note", "Paper and model are both simulation; there was no human trial."},
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
