#include "samples/study/page.h"

#include "samples/study/output.h"

namespace hrt::study {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; color: #111; }
svg { width: 100%; height: auto; }
figure { margin: 2rem 0; border-top: 1px solid #ccc; padding-top: 1rem; }
figcaption { max-width: 60rem; }
table { border-collapse: collapse; margin: 1rem 0; }
th, td { padding: .15rem .8rem; text-align: right; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child, td.words { text-align: left; }
tr.mean td { border-bottom: 2px solid #888; font-weight: bold; }
.note { border: 2px solid #111; padding: .5rem 1rem; font-weight: bold; }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) {
    if (character == '&')
      result += "&amp;";
    else if (character == '<')
      result += "&lt;";
    else if (character == '>')
      result += "&gt;";
    else
      result += character;
  }
  return result;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// The <svg> element alone, its ids made unique in the page: gnuplot gives every file the same.
std::string inlined(const std::string& file, const Figure& figure) {
  std::string svg = file.substr(std::min(file.find("<svg"), file.size()));
  const std::string prefix = figure.name + '-';
  for (const char* quote : {"'", "\""}) {
    replace_all(svg, std::string(" id=") + quote, std::string(" id=") + quote + prefix);
    replace_all(svg, std::string("href=") + quote + '#', std::string("href=") + quote + '#' + prefix);
  }
  replace_all(svg, "url(#", "url(#" + prefix);
  replace_all(svg, "<title>Gnuplot</title>", "<title>" + escaped(figure.title) + "</title>");
  return svg;
}

std::string cells(std::initializer_list<std::string> values) {
  std::string row;
  for (const std::string& value : values) row += "<td>" + escaped(value) + "</td>";
  return row;
}

std::string interval_text(const PercentInterval& interval) {
  return fixed(interval.low, 1) + " – " + fixed(interval.high, 1);
}

std::string table_rows(const CellGroup& group) {
  std::string rows;
  for (const Cell& cell : group.cells)
    rows += "<tr>" +
            cells({group.title, number(cell.condition.real_direction_deg),
                   number(cell.condition.virtual_direction_deg), fixed(*cell.paper_percent, 0),
                   interval_text(paper_interval(cell)), fixed(cell.result.hit_percent(), 1),
                   agrees(cell) ? "yes" : "no"}) +
            "</tr>\n";
  return rows + "<tr class=\"mean\">" +
         cells({"mean; limit of any controller " + fixed(limit_percent(group.cells.front().condition), 1) +
                    " %",
                "", "", fixed(*group.paper_percent, 1), interval_text(*group.paper_interval()),
                fixed(group.mean_percent(), 1), group.reproduced ? "yes" : "no"}) +
         "</tr>\n";
}

std::string claim_row(const CellGroup& claim) {
  return "<tr>" +
         cells({claim.title, claim.paper_percent ? fixed(*claim.paper_percent, 1) : "",
                claim.paper_percent ? interval_text(*claim.paper_interval()) : "",
                fixed(claim.mean_percent(), 1)}) +
         "<td class=\"words\">" + escaped(claim.verdict) + "</td></tr>\n";
}

}  // namespace

std::string html_page(const Table1& table, const std::vector<Figure>& figures,
                      const std::vector<std::string>& drawings) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>Haptic retargeting by touch: the paper and the model</title>\n<style>" +
      std::string(style) +
      "</style>\n</head>\n<body>\n<h1>Haptic retargeting by touch: the paper and the model</h1>\n"
      "<p class=\"note\">Everything on this page is simulation, the paper's numbers too. There was no "
      "human trial.</p>\n"
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
  for (std::size_t i = 0; i < figures.size(); ++i)
    page += "<figure role=\"img\" aria-label=\"" + escaped(figures[i].title) + "\">\n" +
            inlined(drawings[i], figures[i]) + "<figcaption><b>" + escaped(figures[i].title) + ".</b> " +
            escaped(figures[i].caption) + " Simulation.</figcaption>\n</figure>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
