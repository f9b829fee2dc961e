// hrt-study table1: the paper's Table I and its other claims beside the model, as text, CSV or JSON.
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/paper/paper.h"
#include "samples/study/paper/table1.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

using Json = nlohmann::ordered_json;

// "     93.0    89.5 - 95.4     92.8"
std::string columns(std::optional<double> paper_percent, std::optional<PercentInterval> interval,
                    double percent) {
  return right(paper_percent ? fixed(*paper_percent, 1) : "", 9) +
         right(interval ? between(interval->low, interval->high, 1, " - ") : "", 15) +
         right(fixed(percent, 1), 9);
}

std::string yes_or_no(bool yes) {
  return yes ? "     yes" : "      NO";
}

std::string table_text(const Table1& table) {
  std::string page;
  for (const CellGroup& group : table.conditions) {
    page += group.title + "\n   real  virtual    paper  95 % interval    model  agrees\n";
    for (const Cell& cell : group.cells)
      page += right(number(cell.condition.real_direction_deg), 7) +
              right(number(cell.condition.virtual_direction_deg), 9) +
              columns(cell.paper_percent, paper_interval(cell), cell.result.hit_percent()) +
              yes_or_no(agrees(cell)) + '\n';
    page += left("    mean", 16) +
            columns(group.paper_percent, group.paper_interval(), group.mean_percent()) +
            yes_or_no(group.reproduced) + "\n    no controller does better than " +
            fixed(limit_percent(group.cells.front().condition), 1) +
            ": the noise of the last step comes after the plate has acted\n\n";
  }
  return page;
}

std::string fit_text(const Table1& table) {
  int outside = 0;
  for (const CellGroup& group : table.conditions)
    for (const Cell& cell : group.cells) outside += agrees(cell) ? 0 : 1;
  std::string page = "chi-squared " + fixed(table.chi_squared, 1) + " over " +
                     std::to_string(table.degrees_of_freedom) + " cells, p = " + fixed(table.p_value, 2) +
                     ": " + (table.p_value >= 0.05 ? "consistent" : "NOT consistent") +
                     " with the sampling noise of the paper's 50 trials a cell.\n" + std::to_string(outside) +
                     " of the " + std::to_string(table.degrees_of_freedom) +
                     " cells lie outside their 95 % interval; one in twenty does by chance.\n" +
                     wrapped(in_sample_words);
  for (const CellGroup& group : table.conditions)
    if (!group.reproduced)
      page += "The mean of " + group.name.substr(0, 9) + ' ' + group.name.substr(10) +
              " lies outside its interval by " +
              fixed(std::max(group.paper_interval()->low - group.mean_percent(),
                             group.mean_percent() - group.paper_interval()->high),
                    2) +
              " percentage points.\n";
  return page + "79 % of 50 trials is no whole number; it is taken as the paper prints it.\n\n";
}

std::string claims_text(const Table1& table) {
  std::string page =
      left("What else the paper says", 34) + "    paper  95 % interval    model  lowest and highest\n";
  for (const CellGroup& claim : table.claims) {
    page +=
        left(claim.title, 34) + columns(claim.paper_percent, claim.paper_interval(), claim.mean_percent());
    if (claim.cells.size() > 1) {
      const auto less = [](const Cell& a, const Cell& b) { return a.result.hits < b.result.hits; };
      const auto [lowest, highest] = std::minmax_element(claim.cells.begin(), claim.cells.end(), less);
      page += right(fixed(lowest->result.hit_percent(), 1), 8) + " - " +
              fixed(highest->result.hit_percent(), 1) + " of the six pairs";
    }
    page += '\n' + wrapped(claim.verdict, 100, "    ", "    ");
  }
  return page;
}

std::string page_text(const Table1& table) {
  return "Trials that end within 1.5 deg of the real target, in percent: paper (50 trials a cell) and "
         "model\n(" +
         std::to_string(table.options.trials) + " trials a cell, seed " + std::to_string(table.options.seed) +
         ", horizon " + std::to_string(table.options.horizon) +
         "). Both are simulation; there was no human trial. Directions in deg.\n\n" + table_text(table) +
         fit_text(table) + claims_text(table);
}

std::string csv(const Table1& table) {
  std::string page =
      "group,motor_variance_deg2,tactile_weight,real_direction_deg,virtual_direction_deg,horizon,tolerance_"
      "deg,"
      "controller,trials,hits,percent,rms_miss_deg,rms_felt_error_deg,paper_percent,paper_low_percent,paper_"
      "high_percent,agrees\n";
  for (const auto* groups : {&table.conditions, &table.claims})
    for (const CellGroup& group : *groups)
      for (const Cell& cell : group.cells) {
        const Condition& condition = cell.condition;
        page += group.name + ',' + number(condition.participant.motor_variance_deg2) + ',' +
                number(condition.participant.tactile_weight) + ',' + number(condition.real_direction_deg) +
                ',' + number(condition.virtual_direction_deg) + ',' +
                std::to_string(condition.controller.mpc.horizon) + ',' + number(condition.tolerance_deg) +
                ',' + (condition.controller.mode == ControlMode::mpc ? "mpc" : "none") + ',' +
                std::to_string(cell.result.trials) + ',' + std::to_string(cell.result.hits) + ',' +
                number(cell.result.hit_percent()) + ',' + number(cell.result.rms_miss_deg()) + ',' +
                number(cell.result.rms_felt_error_deg());
        page += cell.paper_percent
                    ? ',' + number(*cell.paper_percent) + ',' + number(paper_interval(cell).low) + ',' +
                          number(paper_interval(cell).high) + (agrees(cell) ? ",1\n" : ",0\n")
                    : std::string(",,,,\n");
      }
  return page;
}

Json json(const Cell& cell) {
  const Condition& condition = cell.condition;
  Json object{{"motor_variance_deg2", condition.participant.motor_variance_deg2},
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
              {"rms_felt_error_deg", cell.result.rms_felt_error_deg()}};
  if (cell.paper_percent) {
    const PercentInterval interval = paper_interval(cell);
    object["paper_percent"] = *cell.paper_percent;
    object["paper_interval_percent"] = {interval.low, interval.high};
    object["agrees"] = agrees(cell);
  }
  return object;
}

Json json(const CellGroup& group) {
  Json object{{"name", group.name}, {"title", group.title}, {"mean_percent", group.mean_percent()}};
  if (group.paper_percent) {
    object["paper_mean_percent"] = *group.paper_percent;
    object["paper_interval_percent"] = {group.paper_interval()->low, group.paper_interval()->high};
  }
  object["reproduced"] = group.reproduced;
  object["verdict"] = group.verdict;
  return object;
}

std::string json_page(const Table1& table) {
  Json page{{"simulation", true},
            {"note", "Paper and model are both simulation; there was no human trial."},
            {"trials_per_cell", table.options.trials},
            {"seed", table.options.seed},
            {"horizon", table.options.horizon},
            {"cells", Json::array()},
            {"conditions", Json::array()},
            {"chi_squared", table.chi_squared},
            {"degrees_of_freedom", table.degrees_of_freedom},
            {"p_value", table.p_value},
            {"claims", Json::array()}};
  for (const CellGroup& group : table.conditions) {
    Json condition = json(group);
    condition["limit_percent"] = limit_percent(group.cells.front().condition);
    page["conditions"].push_back(condition);
    for (const Cell& cell : group.cells) page["cells"].push_back(json(cell));
  }
  for (const CellGroup& group : table.claims) {
    Json claim = json(group);
    for (const Cell& cell : group.cells) claim["cells"].push_back(json(cell));
    page["claims"].push_back(claim);
  }
  return page.dump(2) + '\n';
}

}  // namespace

void add_table1(CLI::App& app) {
  struct CommandOptions {
    Table1Options table;
    std::string format = "text";
    std::string out;
  };
  const auto options = std::make_shared<CommandOptions>();
  CLI::App& command = add_command(
      app, "table1", "The paper's Table I and its other claims beside what the model gives.",
      R"(A cell agrees if the model's percentage lies in the 95 % interval (Wilson's) of the paper's
50 trials. Chi-squared compares all 24 cells at once; its mean by chance is 24.

Examples:
  hrt-study table1
  hrt-study table1 --trials 50 --seed 7
  hrt-study table1 --trials 1000000 --format json --out table1.json)",
      [options] {
        const Output output("--out", options->out);
        const Table1 table = simulate_table1(options->table);
        output.write(options->format == "csv"    ? csv(table)
                     : options->format == "json" ? json_page(table)
                                                 : page_text(table));
      });
  add_trials(command, &options->table.trials, "Trials of each cell.");
  add_seed(command, &options->table.seed);
  add_integer(command, "--horizon", &options->table.horizon, 1, max_horizon,
              "Steps that the controller looks ahead.");
  add_threads(command, &options->table.threads);
  add_choice(command, "--format", &options->format, {"text", "csv", "json"}, "What to write.");
  add_out(command, &options->out);
}

}  // namespace hrt::study
