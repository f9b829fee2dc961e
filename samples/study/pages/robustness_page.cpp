#include "samples/study/pages/robustness_page.h"

#include <cmath>

#include "samples/study/cli/output.h"
#include "samples/study/pages/html.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

using Rows = std::span<const RobustnessRow>;

// Points that stay apart in grey: each has its own shape and lightness.
constexpr const char* styles[] = {"pt 2 lc rgb '#999999'", "pt 8 lc rgb '#b35806'", "pt 6 lc rgb '#4393c3'",
                                  "pt 7 lc rgb '#08306b'", "pt 4 lc rgb '#35978f'"};

Figure duration_figure(double duration_s, Rows rows) {
  const std::string seconds = number(duration_s) + " s";
  Figure figure{.name = "robustness_" + std::to_string(std::llround(1e3 * duration_s)) + "_ms",
                .title = "People who reach in " + seconds,
                .caption =
                    "Reaches that end within 1.5° of the real target's bearing, of people who can hold the "
                    "gap, with 95 % intervals (Wilson). *: family kept apart from the search for our "
                    "controller's numbers. +: tracker or plate is off, which no controller sees.",
                .width_px = 560,
                .height_px = 150 + 27 * static_cast<int>(rows.size())};
  // Families from above to below; within a family the five points from above to below.
  std::string ticks;
  std::string script = "$rows << EOD\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ticks += (i == 0 ? "\"" : ", \"") + label(rows[i].people) + "\" " + std::to_string(i);
    for (const Leading leading : leadings) {
      const Share& near = rows[i].cell(leading).can_hold.near;
      if (near.of == 0) continue;
      const PercentInterval interval = near.interval();
      const int column = static_cast<int>(leading);
      script += std::to_string(column) + ' ' + number(near.percent()) + ' ' +
                number(static_cast<double>(i) + 0.16 * (column - 2)) + ' ' + number(interval.low) + ' ' +
                number(interval.high) + '\n';
    }
  }
  script += "EOD\n$none << EOD\n-1 -1 -1 -1 -1\nEOD\n";  // gnuplot refuses to plot no points at all
  script +=
      "set title \"Within 1.5° of bearing, " + seconds +
      " (simulation)\" font ',13'\nset key outside below maxcols 2 samplen 1\nset grid x back lt 1 lw 0.6 "
      "lc rgb '#dddddd'\nset xrange [-2:102]\nset xtics 20\nset xlabel 'reaches, %'\nset yrange [" +
      number(static_cast<double>(rows.size()) - 0.5) + ":-0.5]\nset ytics (" + ticks +
      ") scale 0\nset bmargin 8\nset rmargin 3\n";
  for (std::size_t i = 1; i < rows.size(); ++i)
    script += "set arrow from graph 0, first " + number(static_cast<double>(i) - 0.5) +
              " to graph 1, first " + number(static_cast<double>(i) - 0.5) +
              " nohead back lw 0.6 lc rgb '#dddddd'\n";
  for (std::size_t i = 0; i < leadings.size(); ++i)
    script += std::string(i == 0 ? "plot " : ", ") + "$rows using ($1==" + std::to_string(i) +
              "?$2:NaN):3:4:5 with xerrorbars ps 0.8 lw 1.2 " + styles[i] + " title \"" +
              leading_title(leadings[i]) + '"';
  figure.script = script + ", $none using 2:3 with points notitle\n";
  return figure;
}

// "98.5 (97.1–99.2)"; what too few values bound is "?".
std::string with_interval(double value, double low, double high) {
  if (std::isnan(value)) return "";
  return "<b>" + fixed(value, 1) + "</b> <small>" + between(low, high, 1, "–") + "</small>";
}

std::string cell(const std::string& html) {
  return "<td>" + html + "</td>";
}

std::string cell(const Share& share) {
  const PercentInterval interval = share.interval();
  return cell(with_interval(share.percent(), interval.low, interval.high));
}

std::string cell(const Quantile& quantile) {
  return cell(with_interval(quantile.value, quantile.low, quantile.high));
}

constexpr int columns = 8;

// A sort of people, whether they can hold the gap or not, under each controller.
std::string group_rows(const RobustnessRow& row, bool can_hold) {
  const std::uint64_t people = row.cell(Leading::none).group(can_hold).near.of;
  if (people == 0) return "";
  std::string html = "<tr class=\"head\"><td colspan=\"" + std::to_string(columns) + "\"><b>" +
                     escaped(label(row.people)) + "</b>: " + escaped(row.people.says) + "; " +
                     std::to_string(people) + (can_hold ? " can hold the gap" : " cannot hold the gap") +
                     "</td></tr>\n";
  for (const Leading leading : leadings) {
    const ReachGroup& group = row.cell(leading).group(can_hold);
    const bool flags = leading != Leading::none;
    html += leading == leadings.back() ? "<tr class=\"last\">" : "<tr>";
    html += "<td>" + escaped(leading_title(leading)) + "</td>" + cell(group.near) +
            cell(group.miss_median_mm) + cell(group.miss_95_mm) + cell(group.peak_felt_error_median_deg) +
            (flags ? cell(can_hold ? group.unreachable : group.found) + cell(group.silent) +
                         cell(group.false_alarm)
                   : "<td></td><td></td><td></td>") +
            "</tr>\n";
  }
  return html;
}

std::string table(Rows rows) {
  std::string html =
      "<div class=\"wide\"><table class=\"small\">\n<thead><tr><th>controller</th><th>within 1.5°, %</th>"
      "<th>miss, median, mm</th><th>miss, 95 %, mm</th><th>peak felt error, median, °</th>"
      "<th>unreachable, %</th><th>silent miss, %</th><th>false alarm, %</th></tr></thead>\n";
  for (const RobustnessRow& row : rows) html += group_rows(row, true) + group_rows(row, false);
  return html + "</table></div>\n";
}

// For a page, where w_T has its subscript.
std::string prose(const std::string& text) {
  std::string html = escaped(text);
  replace_all(html, "w_T", "w<sub>T</sub>");
  return html;
}

}  // namespace

std::vector<Figure> robustness_figures(const RobustnessStudy& study) {
  std::vector<Figure> figures;
  for (const double duration_s : study.options.durations_s)
    figures.push_back(duration_figure(duration_s, at_duration(study.rows, duration_s)));
  return figures;
}

std::string robustness_page(const RobustnessStudy& study, const std::vector<Figure>& figures) {
  std::string page = page_start("Haptic retargeting by touch: people as they are");
  page +=
      "<p>" + prose(condition_words(study)) +
      " Each family differs in one thing. Each person reaches without a controller, the plate at 0; with the "
      "paper's controller, which assumes w<sub>T</sub> = 0.15; five times with ours, which does not know the "
      "person at first and carries what it learns; and once with ours informed of the person's "
      "traits.</p>\n<p>Whether a person can hold the gap does not depend on the controller: their largest "
      "felt shift, with the plate within 75° of the motion, exceeds it. Human data cover ridges within 60° "
      "of the motion. The felt error is the largest difference between the direction that the person feels "
      "and the virtual target's; 4.5° is noticed in vision, no threshold is published for "
      "touch.</p>\n<p>Unreachable: reported so by then. A silent miss ends off target without a flag; a "
      "false alarm ends on target and is flagged unreachable or off target. In brackets: 95 % intervals, "
      "Wilson's for shares, between two of the reaches for quantiles; ?: too few reaches bound it.</p>\n";
  for (std::size_t i = 0; i < figures.size(); ++i)
    page += "<h2>" + escaped(figures[i].title) + "</h2>\n" + figure_element(figures[i]) +
            folded("The numbers (open them to print them; all are in robustness.csv)",
                   table(at_duration(study.rows, study.options.durations_s[i])));
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
