#include "samples/study/pages/power_page.h"

#include "samples/study/cli/output.h"
#include "samples/study/pages/html.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

// Curves that stay apart in grey: each has its own shape and lightness.
constexpr const char* styles[] = {"pt 7 lc rgb '#08306b'", "pt 4 lc rgb '#b35806'", "pt 9 lc rgb '#35978f'",
                                  "pt 6 lc rgb '#762a83'", "pt 2 lc rgb '#777777'"};

std::string reaches_words(std::uint64_t reaches) {
  return std::to_string(reaches) + (reaches == 1 ? " reach" : " reaches") + " under each condition";
}

Figure figure_of(const PowerStudy& study, std::uint64_t reaches) {
  Figure figure{.name = "power_" + std::to_string(reaches),
                .title = "Power, " + reaches_words(reaches),
                .caption =
                    "Share of simulated trials that find the effect, with 95 % intervals (Wilson). "
                    "Dotted: 80 %.",
                .width_px = 560,
                .height_px = 430,
                .script = ""};
  std::string plots;
  int curve = 0;
  for (const PowerRow& row : study.rows) {
    if (row.reaches != reaches) continue;
    const std::string block = "$effect" + std::to_string(curve);
    figure.script += block + " << EOD\n";
    for (const PowerPoint& point : row.points) {
      const PercentInterval interval = point.found.interval();
      figure.script += std::to_string(point.people) + ' ' + number(point.found.percent()) + ' ' +
                       number(interval.low) + ' ' + number(interval.high) + '\n';
    }
    figure.script += "EOD\n";
    const std::string style = styles[static_cast<std::size_t>(curve) % std::size(styles)];
    plots += ", " + block + " using 1:2:3:4 with yerrorlines ps 0.8 lw 1.3 " + style + " title '" +
             number(row.effect_deg) + "°'";
    ++curve;
  }
  std::string ticks;
  for (const double people : study.options.people) ticks += (ticks.empty() ? "" : ", ") + number(people);
  figure.script +=
      "set title \"" + figure.title +
      " (simulation)\" font ',12'\nset key outside below maxcols 5 samplen 2 title 'effect on "
      "the bearing error'\nset grid y back lt 1 lw 0.6 lc rgb '#dddddd'\nset logscale x\nset xtics (" +
      ticks + ")\nset bmargin 8\nset xrange [" + number(0.85 * study.options.people.front()) + ':' +
      number(1.18 * study.options.people.back()) +
      "]\nset xlabel 'people'\nset yrange [-2:102]\nset ytics 20\nset ylabel 'trials that find the effect, "
      "%'\nplot 80 with lines dt 3 lw 1.5 lc rgb '#555555' notitle" +
      plots + "\n";
  return figure;
}

std::string table(const PowerStudy& study) {
  std::string html =
      "<table>\n<tr><th>effect, °</th><th>reaches</th><th>people for 80 %</th>"
      "<th>people for 90 %</th></tr>\n";
  for (const PowerRow& row : study.rows)
    html += "<tr>" +
            table_cells({number(row.effect_deg), std::to_string(row.reaches), people_text(row.for_80, "–"),
                         people_text(row.for_90, "–")}) +
            "</tr>\n";
  return html + "</table>\n";
}

}  // namespace

std::vector<Figure> power_figures(const PowerStudy& study) {
  std::vector<Figure> figures;
  for (const PoolSpread& pool : study.pool) figures.push_back(figure_of(study, pool.reaches));
  return figures;
}

std::string power_page(const PowerStudy& study, const std::vector<Figure>& figures) {
  std::string page = page_start("Haptic retargeting by touch: people for a first trial") +
                     "<p>What these numbers take for granted:</p>\n<ul>\n";
  for (const std::string& assumption : power_assumptions(study.options))
    page += "<li>" + escaped(with_symbols(assumption)) + "</li>\n";
  page +=
      "</ul>\n<h2>People for a given effect</h2>\n<p>In brackets: 95 % interval over the simulated "
      "people.</p>\n" +
      table(study);
  for (const Figure& figure : figures) page += figure_element(figure);
  page +=
      "<h2>The simulated people</h2>\n<p>A person's mean error, and by how much the controller lessens "
      "it.</p>\n<div class=\"wide\"><table class=\"small\">\n<tr><th>reaches</th><th>with, median, °</th>"
      "<th>without, median, °</th><th>difference, mean, °</th><th>difference, SD, °</th></tr>\n";
  const auto words = [](const Quantile& quantile) {
    return fixed(quantile.value, 2) + " (" + between(quantile.low, quantile.high, 2, "–") + ")";
  };
  for (const PoolSpread& pool : study.pool)
    page += "<tr>" +
            table_cells({std::to_string(pool.reaches), words(pool.with_deg), words(pool.without_deg),
                         words(pool.difference_deg.mean), words(pool.difference_deg.sd)}) +
            "</tr>\n";
  return page + "</table></div>\n</body>\n</html>\n";
}

}  // namespace hrt::study
