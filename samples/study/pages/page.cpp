#include "samples/study/pages/page.h"

#include "samples/study/cli/output.h"
#include "samples/study/pages/html.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

// A row a pair, a column a condition: the paper's percentage with its interval, and the model's.
std::string table_rows(const Table1& table) {
  const auto cell = [](double paper, const PercentInterval& interval, double model, bool agrees) {
    return "<td>" + fixed(paper, 0) + " <small>" + between(interval.low, interval.high, 0, "–") +
           "</small> <b>" + fixed(model, 1) + "</b>" + (agrees ? "" : " ✗") + "</td>";
  };
  std::string rows;
  const std::size_t pairs = table.conditions.front().cells.size();
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const Condition& condition = table.conditions.front().cells[pair].condition;
    rows += "<tr><td>" + number(condition.real_direction_deg) + " / " +
            number(condition.virtual_direction_deg) + "</td>";
    for (const CellGroup& group : table.conditions) {
      const Cell& at = group.cells[pair];
      rows += cell(*at.paper_percent, paper_interval(at), at.result.hit_percent(), agrees(at));
    }
    rows += "</tr>\n";
  }
  rows += "<tr class=\"mean\"><td>mean</td>";
  for (const CellGroup& group : table.conditions)
    rows += cell(*group.paper_percent, *group.paper_interval(), group.mean_percent(), group.reproduced);
  rows += "</tr>\n<tr><td>limit of any controller</td>";
  for (const CellGroup& group : table.conditions)
    rows += "<td>" + fixed(limit_percent(group.cells.front().condition), 1) + "</td>";
  return rows + "</tr>\n";
}

std::string table_head(const Table1& table) {
  std::string head = "<tr><th>real / virtual, °</th>";
  for (const CellGroup& group : table.conditions) {
    const Participant& participant = group.cells.front().condition.participant;
    head += "<th>σ<sub>u</sub>² " + number(participant.motor_variance_deg2) + ", w<sub>T</sub> " +
            number(participant.tactile_weight) + "</th>";
  }
  return head + "</tr>\n";
}

// The verdict in a row of its own: pages are read on phones too.
std::string claim_rows(const CellGroup& claim) {
  const std::optional<PercentInterval> interval = claim.paper_interval();
  return "<tr class=\"head\">" +
         table_cells({with_symbols(claim.title), claim.paper_percent ? fixed(*claim.paper_percent, 1) : "",
                      interval ? between(interval->low, interval->high, 1, " – ") : "",
                      fixed(claim.mean_percent(), 1)}) +
         "</tr>\n<tr><td colspan=\"4\" class=\"words\">" + escaped(with_symbols(claim.verdict)) +
         "</td></tr>\n";
}

}  // namespace

std::string html_page(const Table1& table, const std::vector<Figure>& figures) {
  std::string page = page_start("Haptic retargeting by touch: the paper and the model");
  page +=
      "<p>A ridged plate turns under the fingertip. Touch reports motion perpendicular to the ridges, "
      "so turning the plate leads the hand to a real target while the participant feels that they go "
      "to a virtual one. Directions are in degrees from the plate's mid-line, counter-clockwise "
      "positive seen from above.</p>\n";
  page +=
      "<h2>Table I</h2>\n<p>Trials that end within 1.5° of the real direction, in percent: the paper's 50 "
      "trials a cell, their 95 % interval, and in bold " +
      std::to_string(table.options.trials) + " trials of the model (seed " +
      std::to_string(table.options.seed) + "). ✗: outside the interval.</p>\n<p>Chi-squared is " +
      fixed(table.chi_squared, 1) + " over " + std::to_string(table.degrees_of_freedom) +
      " cells, p = " + fixed(table.p_value, 2) + ". " + with_symbols(in_sample_words) +
      "</p>\n<div class=\"wide\"><table class=\"small\">\n" + table_head(table) + table_rows(table) +
      "</table></div>\n<h2>What else the paper says</h2>\n<table class=\"small\">\n<tr><th>claim</th>"
      "<th>paper, %</th><th>interval</th><th>model, %</th></tr>\n";
  for (const CellGroup& claim : table.claims) page += claim_rows(claim);
  page += "</table>\n<h2>Figures</h2>\n";
  for (const Figure& figure : figures) page += figure_element(figure);
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
