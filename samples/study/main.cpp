// hrt-study: simulates the paper's study and variations of it. See README.md in this folder.
#include <cctype>
#include <iostream>
#include <string>

#include "samples/study/cli/arguments.h"
#include "samples/study/commands/commands.h"

namespace {

// One line, without control characters.
void complain(std::string message) {
  for (char& character : message)
    if (std::iscntrl(static_cast<unsigned char>(character))) character = '?';
  std::cerr << "hrt-study: " << message << '\n';
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): the parser is set up, which throws without memory only
int main(int argc, char** argv) {
  using namespace hrt::study;
  constexpr int usage_error = 2;

  CLI::App app(
      "Simulates haptic retargeting by touch: a plate that turns under the fingertip leads the hand to\n"
      "a real target while the participant feels that they go to a virtual one.\n"
      "Every result is of simulation; there was no human trial.",
      "hrt-study");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.footer(
      R"(Start with:
  hrt-study table1                 the paper's Table I next to the model's
  hrt-study trial                  one reach, step by step
  hrt-study report --out report    figures and a page that shows them all

'hrt-study SUBCOMMAND --help' lists what each takes. Directions are in degrees from the plate's
mid-line (straight away from the participant), counter-clockwise positive seen from above.
Exit codes: 0 done, 1 failed, 2 an argument is wrong.)");
  app.set_version_flag("--version", HRT_STUDY_VERSION, "Print the version and exit.");
  app.set_help_flag("-h,--help", "Print this and exit.");
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
    complain(std::string(error.what()) + " (see --help)");
    return usage_error;
  } catch (const UsageError& error) {
    complain(error.what());
    return usage_error;
  } catch (const std::exception& error) {
    complain(error.what());
    return 1;
  }
  return 0;
}
