#include <memory>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/figures.h"
#include "samples/study/paper/table1.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  Table1Options table;
  std::string out;
};

void run(const ReportOptions& options) {
  StagingFolder staged("--out", options.out);
  const Table1 table = simulate_table1(options.table);
  std::vector<Figure> figures = path_figures(options.table.seed);
  figures.insert(figures.begin(), ridges_figure(options.table.seed));
  figures.push_back(
      {.name = "table1",
       .title = "Table I: paper and model",
       .caption =
           "Percentage of trials that end within 1.5° of the real direction, for six pairs in each condition. Bars: "
           "95 % intervals (Wilson) of the paper's 50 trials and of the model's " +
           fmt::to_string(table.options.trials) +
           " per cell. Dashed: limit of any controller, as the plate cannot correct the noise of the last step.",
       .data = page_of(table1_results(table))});
  staged.draw(figures);
  const std::string page = "report.html";
  staged.write(page, html_page(table1_text(table), figures));
  staged.publish();
  Output("--out", "")
      .write(
          fmt::format("Wrote {} pictures and the page {}\n", figures.size(), (fs::path(options.out) / page).string()));
}

}  // namespace

void add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& command = add_command(
      app, "report", "Draw Figs. 1c and 4 to 8 and Table I as SVG, with an HTML page.",
      R"(Writes fig1c, fig4 to fig8 and table1 (.svg) and report.html, which shows them. Existing files of these names
are replaced. Needs python3-matplotlib.

Examples:
  hrt-study report --out report
  hrt-study report --out quick --trials 1000)",
      [options] { run(*options); });
  add_path(command, "--out", options->out, "Folder for the files; created if missing.")->required();
  add_trials(command, options->table.trials, "Number of trials in each cell of Table I.");
  add_seed(command, options->table.seed);
  add_threads(command, options->table.threads);
}

}  // namespace hrt::study
