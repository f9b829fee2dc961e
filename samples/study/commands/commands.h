// The subcommands, one file each. Each function adds a subcommand whose callback does the work.
#pragma once

namespace CLI {
class App;
}

namespace hrt::study {

void add_table1(CLI::App& app);
void add_trial(CLI::App& app);
void add_scene(CLI::App& app);
void add_report(CLI::App& app);
void add_participants(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_coverage(CLI::App& app);
void add_ridges(CLI::App& app);
void add_robustness(CLI::App& app);

}  // namespace hrt::study
