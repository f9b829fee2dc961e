#include "samples/study/figures/page.h"

#include "samples/study/figures/html.h"
#include "samples/study/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

std::string interval_text(const PercentInterval& interval) {
  return fixed(interval.low, 1) + " – " + fixed(interval.high, 1);
}

std::string table_rows(const CellGroup& group) {
  std::string rows;
  for (const Cell& cell : group.cells)
    rows += "<tr>" +
            table_cells({group.title, number(cell.condition.real_direction_deg),
                         number(cell.condition.virtual_direction_deg), fixed(*cell.paper_percent, 0),
                         interval_text(paper_interval(cell)), fixed(cell.result.hit_percent(), 1),
                         agrees(cell) ? "yes" : "no"}) +
            "</tr>\n";
  return rows + "<tr class=\"mean\">" +
         table_cells({"mean; limit of any controller " +
                          fixed(limit_percent(group.cells.front().condition), 1) + " %",
                      "", "", fixed(*group.paper_percent, 1), interval_text(*group.paper_interval()),
                      fixed(group.mean_percent(), 1), group.reproduced ? "yes" : "no"}) +
         "</tr>\n";
}

std::string claim_row(const CellGroup& claim) {
  return "<tr>" +
         table_cells({claim.title, claim.paper_percent ? fixed(*claim.paper_percent, 1) : "",
                      claim.paper_percent ? interval_text(*claim.paper_interval()) : "",
                      fixed(claim.mean_percent(), 1)}) +
         "<td class=\"words\">" + escaped(claim.verdict) + "</td></tr>\n";
}

}  // namespace

std::string html_page(const Table1& table, const std::vector<Figure>& figures,
                      const std::vector<std::string>& drawings) {
  std::string page = page_start("Haptic retargeting by touch: the paper and the model");
  page +=
      "<p>A ridged plate turns under the fingertip. Touch reports motion perpendicular to the ridges, "
      "so turning the plate leads the hand to a real target while the participant feels that they go "
      "to a virtual one. Directions are in degrees from the plate's mid-line, counter-clockwise "
      "positive seen from above.</p>\n";
  page +=
      "<h2>Table I</h2>\n<p>Trials that end within 1.5 deg of the real direction, in percent: the paper's 50 "
      "trials a cell with their 95 % interval, and " +
      std::to_string(table.options.trials) + " trials of the model (seed " +
      std::to_string(table.options.seed) + "). Chi-squared " + fixed(table.chi_squared, 1) + " over " +
      std::to_string(table.degrees_of_freedom) + " cells, p = " + fixed(table.p_value, 2) +
      ".</p>\n<table>\n<tr><th>condition</th><th>real, deg</th><th>virtual, deg</th><th>paper, %</th>"
      "<th>interval</th><th>model, %</th><th>agrees</th></tr>\n";
  for (const CellGroup& group : table.conditions) page += table_rows(group);
  page +=
      "</table>\n<h2>What else the paper says</h2>\n<table>\n<tr><th>claim</th><th>paper, %</th>"
      "<th>interval</th><th>model, %</th><th class=\"words\">verdict</th></tr>\n";
  for (const CellGroup& claim : table.claims) page += claim_row(claim);
  page += "</table>\n<h2>Figures</h2>\n";
  for (std::size_t i = 0; i < figures.size(); ++i) page += figure_element(figures[i], drawings[i]);
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
