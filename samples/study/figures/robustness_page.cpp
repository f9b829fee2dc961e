#include "samples/study/figures/robustness_page.h"

#include <cmath>

#include "samples/study/figures/html.h"
#include "samples/study/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

using Rows = std::span<const RobustnessRow>;

// Points that stay apart in grey: each has its own shape and lightness.
constexpr const char* styles[] = {"pt 2 lc rgb '#999999'", "pt 8 lc rgb '#b35806'", "pt 6 lc rgb '#4393c3'",
                                  "pt 7 lc rgb '#08306b'", "pt 4 lc rgb '#35978f'"};

std::string label(const PeopleFamily& family) {
  return std::string(family.name) + (family.tuned ? "" : " *");
}

Figure duration_figure(double duration_s, Rows rows) {
  const std::string seconds = number(duration_s) + " s";
  Figure figure{.name = "robustness_" + std::to_string(std::llround(1e3 * duration_s)) + "_ms",
                .title = "People who reach in " + seconds,
                .caption =
                    "Reaches that end within 1.5 deg of the real target's bearing, of people who can "
                    "hold the gap, with 95 % intervals (Wilson). *: family kept apart from the search "
                    "for our controller's numbers.",
                .width_px = 560,
                .height_px = 150 + 27 * static_cast<int>(rows.size())};
  // Families from above to below; within a family the five points from above to below.
  std::string ticks;
  std::string script = "$rows << EOD\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ticks += (i == 0 ? "\"" : ", \"") + label(*rows[i].family) + "\" " + std::to_string(i);
    for (const Leading leading : leadings) {
      const Share& near = rows[i].cell(leading).near;
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

std::string percent_text(const Share& share) {
  return share.of == 0 ? "" : fixed(share.percent(), 1);
}

std::string value_text(double value) {
  return std::isnan(value) ? "" : fixed(value, 1);
}

std::string table(Rows rows) {
  std::string html =
      "<table>\n<tr><th>family</th><th class=\"words\">people</th><th>can hold</th>"
      "<th class=\"words\">controller</th><th>within 1.5 deg, %</th><th>interval</th><th>median miss, mm</th>"
      "<th>95 %, mm</th><th>peak felt error, deg</th><th>unreachable: found, %</th><th>false, %</th>"
      "<th>does not fit, %</th><th>off target, %</th><th>silent miss, %</th></tr>\n";
  for (const RobustnessRow& row : rows)
    for (const Leading leading : leadings) {
      const RobustnessCell& cell = row.cell(leading);
      const bool first = leading == leadings.front();
      const bool flags = leading != Leading::none;
      const auto flag = [&](const Share& share) { return flags ? percent_text(share) : ""; };
      const PercentInterval near = cell.near.interval();
      html += leading == leadings.back() ? "<tr class=\"last\">" : "<tr>";
      html += table_cells({first ? label(*row.family) : ""}) + "<td class=\"words\">" +
              (first ? escaped(row.family->says) : "") + "</td>" +
              table_cells({first ? std::to_string(cell.near.of) : ""}) + "<td class=\"words\">" +
              escaped(leading_title(leading)) + "</td>" +
              table_cells({percent_text(cell.near),
                           cell.near.of == 0 ? "" : fixed(near.low, 1) + " – " + fixed(near.high, 1),
                           value_text(cell.miss_median_mm), value_text(cell.miss_95_mm),
                           value_text(cell.peak_felt_error_median_deg), flag(cell.unreachable_found),
                           flag(cell.unreachable_false), flag(cell.misfit), flag(cell.off_target),
                           flag(cell.silent)}) +
              "</tr>\n";
    }
  return html + "</table>\n";
}

}  // namespace

std::string condition_words(const RobustnessOptions& options) {
  return std::to_string(options.people) + " people of each family at each duration (seed " +
         std::to_string(options.seed) +
         "): 100 mm, a gap of 10 deg, w_T 0.12 to 0.30, 1.2 mm of tracker noise at 90 Hz, a servo of 400 "
         "deg/s after 30 ms; our controller does not know the duration.";
}

std::vector<Figure> robustness_figures(const RobustnessOptions& options, Rows rows) {
  std::vector<Figure> figures;
  for (const double duration_s : options.durations_s)
    figures.push_back(duration_figure(duration_s, at_duration(rows, duration_s)));
  return figures;
}

std::string robustness_page(const RobustnessOptions& options, Rows rows, const std::vector<Figure>& figures,
                            const std::vector<std::string>& drawings) {
  std::string page = page_start("Haptic retargeting by touch: people as they are");
  page += "<p>" + escaped(condition_words(options)) +
          " Each family differs in one thing. Each person reaches without a controller, the plate at 0; with "
          "the paper's controller, which assumes w_T = 0.15; five times with ours, which does not know the "
          "person at first and carries what it learns; and once with ours informed of the person's "
          "traits.</p>\n<p>Share, miss and felt error are over people who can hold the gap, whatever the "
          "controller. Unreachable: found of those who cannot, false of those who can. A silent miss ends "
          "off target without a flag, of those who can.</p>\n";
  for (std::size_t i = 0; i < figures.size(); ++i)
    page += "<h2>" + escaped(figures[i].title) + "</h2>\n" + figure_element(figures[i], drawings[i]) +
            "<details><summary>The numbers</summary>\n" + table(at_duration(rows, options.durations_s[i])) +
            "</details>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
