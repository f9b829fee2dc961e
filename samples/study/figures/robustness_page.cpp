#include "samples/study/figures/robustness_page.h"

#include <algorithm>
#include <cmath>

#include "samples/study/figures/html.h"
#include "samples/study/output.h"

namespace hrt::study {
namespace {

using Rows = std::span<const RobustnessRow>;

// Lines that stay apart in grey: each has its own dash, point and lightness.
constexpr const char* styles[] = {"lw 2 dt 2 pt 4 lc rgb '#999999'", "lw 2 dt 4 pt 8 lc rgb '#e08214'",
                                  "lw 3 dt 1 pt 7 lc rgb '#08306b'", "lw 2 dt 3 pt 6 lc rgb '#35978f'"};

// The rows of one factor after the other.
std::vector<Rows> by_factor(Rows rows) {
  std::vector<Rows> groups;
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin;
    while (end < rows.size() && rows[end].factor == rows[begin].factor) ++end;
    groups.push_back(rows.subspan(begin, end - begin));
    begin = end;
  }
  return groups;
}

std::string plot(std::size_t column, bool titled) {
  std::string lines;
  for (std::size_t i = 0; i < controllers.size(); ++i)
    lines += (i == 0 ? "plot" : ",") + std::string(" $rows using 1:") + std::to_string(column + 3 * i) +
             " with linespoints ps 1.1 " + styles[i] +
             (titled ? std::string(" title '") +
                           (controllers[i] == Controller::paper ? "the paper''s"
                                                                : controller_title(controllers[i])) +
                           "'"
                     : " notitle");
  return lines;
}

Figure factor_figure(Rows rows) {
  const Factor& factor = *rows.front().factor;
  Figure figure{.name = std::string("robustness_") + factor.name,
                .title = factor.title,
                .caption = "",
                .width_px = 1200,
                .height_px = 420};
  std::string why;
  for (const RobustnessRow& row : rows)
    if (const std::string words = limit_words(row); !words.empty())
      why += " At " + row.label() + ": " + words + '.';
  figure.caption =
      "Left: the miss across the line to the target, median. Middle: the miss that 95 % of reaches do not "
      "pass. Right: share of reaches that end within 1.5 deg of the target's bearing. All else is as in the "
      "middle case." +
      why;
  std::string& script = figure.script;
  script = "$rows << EOD\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    script += factor.labels.empty() ? number(rows[i].value) : std::to_string(i);
    for (const RobustnessCell& cell : rows[i].cells)
      script += ' ' + number(cell.miss_median_mm) + ' ' + number(cell.miss_95_mm) + ' ' +
                number(cell.bearing_percent);
    script += '\n';
  }
  script += "EOD\n";
  if (!factor.labels.empty()) {
    script += "set xtics (";
    for (std::size_t i = 0; i < rows.size(); ++i)
      script += (i == 0 ? "'" : ", '") + rows[i].label() + "' " + std::to_string(i);
    script += ")\n";
  }
  const std::string title = std::string(factor.title) + " (simulation)";
  script +=
      "set grid back lt 1 lw 0.6 lc rgb '#dddddd'\nset offsets graph 0.05, graph 0.05, 0, 0\n"
      "set tmargin 4\nset bmargin 5\nset lmargin 8\nset rmargin 3\n"
      "set multiplot layout 1,3 title \"" +
      title + "\" font ',14'\nset xlabel \"" + factor.title +
      "\"\n"
      "set logscale y\nset yrange [0.1:200]\nset title 'median miss, mm'\nset key top left Left reverse "
      "samplen 3\n" +
      plot(2, true) + "\nset title '95 % miss, mm'\n" + plot(3, false) +
      "\nunset logscale y\nset yrange [-3:103]\nset ytics 20\nset title 'within 1.5 deg of bearing, %'\n" +
      plot(4, false) + "\nunset multiplot\n";
  return figure;
}

std::string table_rows(Rows rows) {
  std::string html;
  for (const RobustnessRow& row : rows)
    for (std::size_t i = 0; i < controllers.size(); ++i) {
      const RobustnessCell& cell = row.cells[i];
      html += i + 1 == controllers.size() ? "<tr class=\"last\">" : "<tr>";
      html += table_cells({i == 0 ? row.label() : ""}) + "<td class=\"words\">" +
              escaped(controller_title(controllers[i])) + "</td>";
      html += table_cells({fixed(cell.miss_median_mm, 2), fixed(cell.miss_95_mm, 2),
                           fixed(cell.bearing_percent, 1), fixed(cell.direction_percent, 1),
                           fixed(cell.felt_error_deg, 2), fixed(cell.unreachable_percent, 1)}) +
              "</tr>\n";
    }
  return html;
}

}  // namespace

std::string middle_case_words() {
  return "The middle case: 100 mm in 3 s at constant speed, a gap of 10 deg, 1.2 mm of tracker noise at 90 "
         "Hz, "
         "a servo of 400 deg/s after 30 ms; w_T drawn from 0.12 to 0.25 and sigma_u^2 from 0.5 to 1, both "
         "known to the informed controller only.";
}

std::string limit_words(const RobustnessRow& row) {
  if (row.beyond_authority_percent == 0.0) return "";
  return "for " + fixed(row.beyond_authority_percent, 0) +
         " % of these people no plate orientation holds the gap: their w_T is too low for it, and at rest no "
         "controller brings them nearer than " +
         fixed(row.least_miss_median_mm, 1) + " mm (median)";
}

std::vector<Figure> robustness_figures(const std::vector<RobustnessRow>& rows) {
  std::vector<Figure> figures;
  for (const Rows group : by_factor(rows))
    if (group.size() > 1) figures.push_back(factor_figure(group));
  return figures;
}

std::string robustness_page(const RobustnessOptions& options, const std::vector<RobustnessRow>& rows,
                            const std::vector<Figure>& figures, const std::vector<std::string>& drawings) {
  const std::string header =
      "<table>\n<tr><th></th><th class=\"words\">controller</th><th>median miss, mm</th><th>95 %, mm</th>"
      "<th>within 1.5 deg of bearing, %</th><th>of direction, %</th><th>felt error, deg</th>"
      "<th>says unreachable, %</th></tr>\n";
  std::string page = page_start("Haptic retargeting by touch: robustness");
  page +=
      "<p>Four controllers lead the same simulated people, " + std::to_string(options.trials) +
      " a line (seed " + std::to_string(options.seed) +
      "), by noisy tracked positions: the paper's, which assumes w_T = 0.15 and a plate that follows at "
      "once; one that learns w_T within the reach; that one aimed along the line of sight to the real "
      "target, as the plugin does; and an informed one, which knows w_T, bias, variances, step period and "
      "tracker "
      "noise. " +
      escaped(middle_case_words()) +
      " Each section varies one thing. Felt error is the mean absolute difference of the direction that is "
      "felt from the virtual one in the last step.</p>\n";
  std::size_t figure = 0;
  for (const Rows group : by_factor(rows)) {
    page += "<h2>" + escaped(group.front().factor->title) + "</h2>\n";
    if (group.size() > 1) {
      page += figure_element(figures[figure], drawings[figure]);
      ++figure;
      page +=
          "<details><summary>The numbers</summary>\n" + header + table_rows(group) + "</table></details>\n";
    } else {
      page += header + table_rows(group) + "</table>\n";
    }
  }
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
