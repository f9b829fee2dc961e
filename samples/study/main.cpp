// hrt-study: simulates the paper's study and variations of it. See README.md in this folder.
#include <cctype>
#include <iostream>
#include <string>

#include "samples/study/cli/arguments.h"
#include "samples/study/commands/commands.h"

namespace {

// Prints the message in one line, without control characters.
void print_error(std::string message) {
  for (char& character : message)
    if (std::iscntrl(static_cast<unsigned char>(character))) character = '?';
  std::cerr << "hrt-study: " << message << '\n';
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): setting up the parser throws only if memory is exhausted
int main(int argc, char** argv) {
  using namespace hrt::study;
  constexpr int usage_error = 2;

  CLI::App app(
      "Simulates haptic retargeting by touch: a plate that turns under the fingertip steers the hand to a\n"
      "real target while the participant feels a motion to a virtual one.\n"
      "All results are simulated; there was no human trial.",
      "hrt-study");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer(
      R"(Start with:
  hrt-study table1                 the paper's Table I next to the model's
  hrt-study trial                  one reach, step by step
  hrt-study report --out report    figures, and a page that shows them

'hrt-study SUBCOMMAND --help' lists the options of a subcommand. Directions are in degrees from the plate's
mid-line (straight away from the participant), counter-clockwise positive seen from above.
Exit codes: 0 success, 1 failure, 2 invalid argument.)");
  app.set_version_flag("--version", HRT_STUDY_VERSION, "Print the version and exit.");
  app.set_help_flag("-h,--help", "Print this help and exit.");
  app.require_subcommand(1);
  add_table1(app);
  add_ridges(app);
  add_trial(app);
  add_report(app);
  add_participants(app);
  add_calibrate(app);
  add_coverage(app);
  add_robustness(app);
  add_scene(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    print_error(std::string(error.what()) + " (see --help)");
    return usage_error;
  } catch (const UsageError& error) {
    print_error(error.what());
    return usage_error;
  } catch (const std::exception& error) {
    print_error(error.what());
    return 1;
  }
  return 0;
}
