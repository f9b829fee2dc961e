// hrt-study robustness: the controllers on people, trackers and plates that are not as assumed.
#include <memory>
#include <sstream>

#include <nlohmann/json.hpp>

#include "samples/study/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/gnuplot.h"
#include "samples/study/figures/robustness_page.h"
#include "samples/study/figures/workshop.h"
#include "samples/study/output.h"
#include "samples/study/robustness.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

struct Options {
  RobustnessOptions robustness;
  std::string format = "text";
  std::string out;
};

using Rows = std::vector<RobustnessRow>;

// Words in lines of at most `width`, each after `indent`.
std::string wrapped(const std::string& words, const std::string& indent = "", std::size_t width = 105) {
  std::string page;
  std::string line = indent;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (line.size() + word.size() > width) {
      page += line + '\n';
      line = indent;
    }
    line += (line.size() > indent.size() ? " " : "") + word;
  }
  return page + line + '\n';
}

std::string row_text(const RobustnessRow& row) {
  std::string line = "  " + left(row.label(), 10);
  for (const RobustnessCell& cell : row.cells)
    line += right(fixed(cell.miss_median_mm, 2), 9) + right(fixed(cell.miss_95_mm, 2), 7) +
            right(fixed(cell.bearing_percent, 1), 7);
  return line + '\n';
}

std::string text(const Options& options, const Rows& rows) {
  std::string page = wrapped("Simulated reaches of " + std::to_string(options.robustness.trials) +
                             " people a line, the same for all controllers; there was no human trial. " +
                             middle_case_words() + " Each block below varies one thing.") +
                     "\nmiss: across the line to the real target, mm, median and 95 %; near: % within 1.5 "
                     "deg of its bearing\n\n" +
                     left("", 12);
  for (const Controller controller : controllers) page += right(controller_title(controller), 23);
  page += '\n' + left("", 12);
  for (std::size_t i = 0; i < controllers.size(); ++i)
    page += right("miss", 9) + right("95 %", 7) + right("near", 7);
  page += '\n';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].factor != rows[i - 1].factor)
      page += std::string("\n") + rows[i].factor->title + '\n';
    page += row_text(rows[i]);
    if (const std::string why = limit_words(rows[i]); !why.empty()) page += wrapped(why, "    ");
  }
  return page;
}

std::string csv(const Options& options, const Rows& rows) {
  std::string page =
      "factor,value,label,controller,trials,seed,direction_percent,bearing_percent,miss_median_mm,miss_95_mm,"
      "felt_error_mean_abs_deg,said_unreachable_percent,beyond_authority_percent,least_miss_median_mm\n";
  for (const RobustnessRow& row : rows)
    for (std::size_t i = 0; i < controllers.size(); ++i) {
      const RobustnessCell& cell = row.cells[i];
      page += std::string(row.factor->name) + ',' + number(row.value) + ',' + row.label() + ',' +
              controller_name(controllers[i]) + ',' + std::to_string(options.robustness.trials) + ',' +
              std::to_string(options.robustness.seed);
      for (const double value : {cell.direction_percent, cell.bearing_percent, cell.miss_median_mm,
                                 cell.miss_95_mm, cell.felt_error_deg, cell.unreachable_percent,
                                 row.beyond_authority_percent, row.least_miss_median_mm})
        page += ',' + number(value);
      page += '\n';
    }
  return page;
}

std::string json(const Options& options, const Rows& rows) {
  nlohmann::ordered_json page{{"simulation", true},
                              {"trials", options.robustness.trials},
                              {"seed", options.robustness.seed},
                              {"middle_case", middle_case_words()}};
  for (const RobustnessRow& row : rows) {
    nlohmann::ordered_json entry{{"factor", row.factor->name},
                                 {"value", row.value},
                                 {"label", row.label()},
                                 {"beyond_authority_percent", row.beyond_authority_percent},
                                 {"least_miss_median_mm", row.least_miss_median_mm}};
    for (std::size_t i = 0; i < controllers.size(); ++i) {
      const RobustnessCell& cell = row.cells[i];
      entry["controllers"][controller_name(controllers[i])] = {
          {"direction_percent", cell.direction_percent},
          {"bearing_percent", cell.bearing_percent},
          {"miss_median_mm", cell.miss_median_mm},
          {"miss_95_mm", cell.miss_95_mm},
          {"felt_error_mean_abs_deg", cell.felt_error_deg},
          {"said_unreachable_percent", cell.unreachable_percent}};
    }
    page["rows"].push_back(entry);
  }
  return page.dump(2) + '\n';
}

std::string formatted(const Options& options, const Rows& rows) {
  return options.format == "csv"    ? csv(options, rows)
         : options.format == "json" ? json(options, rows)
                                    : text(options, rows);
}

Rows simulate(const Options& options) {
  Progress progress;
  return simulate_robustness(robustness_factors(), options.robustness,
                             [&](std::uint64_t done, std::uint64_t total) { progress.update(done, total); });
}

// Pictures, page and numbers, all or none.
void make_folder(const Options& options) {
  const Workshop workshop("--out", options.out);
  run_gnuplot("", workshop.folder());  // missing: said before the work, not after it
  const Rows rows = simulate(options);
  const std::vector<Figure> figures = robustness_figures(rows);
  std::string script;
  for (const Figure& figure : figures) script += drawing(figure, "svg") + drawing(figure, "png");
  run_gnuplot(script, workshop.folder());
  std::vector<std::string> drawings;
  for (const Figure& figure : figures) drawings.push_back(workshop.read(figure.name + ".svg"));

  const std::string page = "robustness.html";
  replace_file(workshop.folder() / "robustness.csv", csv(options, rows));
  replace_file(workshop.folder() / "robustness.json", json(options, rows));
  replace_file(workshop.folder() / page, robustness_page(options.robustness, rows, figures, drawings));
  for (const Figure& figure : figures)
    for (const char* ending : {".svg", ".png"}) workshop.publish(figure.name + ending);
  for (const char* name : {"robustness.csv", "robustness.json", "robustness.html"}) workshop.publish(name);
  Output("--out", "")
      .write(formatted(options, rows) +
             (options.format == "text" ? "\nWrote " + std::to_string(2 * figures.size()) +
                                             " pictures, robustness.csv, robustness.json and the page " +
                                             (fs::path(options.out) / page).string() + "\n"
                                       : ""));
}

void run(const Options& options) {
  if (!options.out.empty()) return make_folder(options);
  const Output output("--out", "");
  output.write(formatted(options, simulate(options)));
}

}  // namespace

void add_robustness(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = add_command(
      app, "robustness", "Four controllers on people, trackers and plates that are not as they assume.",
      "The controllers: the paper's, which assumes w_T = 0.15 and a plate that follows at once; one that\n"
      "learns w_T within the reach; that one aimed along the line of sight to the real target; and an\n"
      "informed one, which knows w_T, bias, variances, step period and tracker noise. All see noisy\n"
      "positions. Trial i has the same person and the same random numbers on every line and with every\n"
      "controller.\n"
      "\n"
      "With --out there is a folder of robustness.csv, robustness.json, a picture for each thing that is\n"
      "varied (.svg and .png) and robustness.html, one file with everything in it. Needs gnuplot.\n"
      "\n"
      "Examples:\n"
      "  hrt-study robustness\n"
      "  hrt-study robustness --trials 5000 --format csv > robustness.csv\n"
      "  hrt-study robustness --out robustness",
      [options] { run(*options); });
  add_integer(command, "--trials", &options->robustness.trials, 1, 1'000'000, "Trials of each line.");
  add_seed(command, &options->robustness.seed);
  add_threads(command, &options->robustness.threads);
  add_choice(command, "--format", &options->format, {"text", "csv", "json"},
             "What to write to standard output.");
  add_path(command, "--out", &options->out, "a folder that can be written",
           "Folder for numbers, pictures and page; made if missing.");
}

}  // namespace hrt::study
