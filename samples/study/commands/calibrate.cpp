// hrt-study calibrate: who made these slides?
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/calibrate/retest.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/calibration.h"
#include "samples/study/people/participants.h"

namespace hrt::study {
namespace {

// A thousand slides of a minute at 90 Hz have half of this.
constexpr std::size_t max_slides_bytes = std::size_t{1} << 29;

struct CalibrateOptions {
  std::string data;
  std::string retest;
  double goal_direction_deg = 0.0;
  std::string format = "text";
  std::string plot;
  std::string profile;
  std::string out;
};

CalibrationReport calibrated(const std::string& data, double goal_direction_deg) {
  CalibrationReport report{.name = data, .goal_direction_deg = goal_direction_deg};
  const auto trials = parse_calibration_csv(data, read_input("FILE", data, max_slides_bytes));
  report.trials = trials.size();
  const auto result = calibrate(trials, goal_direction_deg);
  if (const auto* refusal = std::get_if<CalibrationRefusal>(&result))
    throw std::runtime_error(data + ": no calibration: " + refusal->reason);
  report.calibration = std::get<Calibration>(result);
  return report;
}

// Test and retest of a person: two calibrations compared.
struct ComparedValue {
  EstimatedTrait trait;  ///< of the first calibration
  RetestDifference difference;
};

struct RetestReport {
  CalibrationReport first;
  CalibrationReport second;
  std::vector<ComparedValue> values;
};

EstimatedTrait trait_of(const Calibration& calibration, std::string_view name) {
  const std::vector<EstimatedTrait> all = estimated_traits(calibration);
  return *std::find_if(all.begin(), all.end(), [&](const EstimatedTrait& each) { return each.name == name; });
}

std::string conclusion(const RetestReport& report) {
  std::string differing;
  std::size_t known = 0;
  for (const ComparedValue& value : report.values) {
    known += value.difference.difference.known ? 1 : 0;
    if (value.difference.differs) differing += (differing.empty() ? "" : "; ") + std::string(value.trait.words);
  }
  if (known == 0) return "No value is known from both calibrations: nothing can be compared";
  if (differing.empty())
    return "No difference is shown. That is no proof that nothing changed: the intervals say how much it may "
           "be";
  return "They differ: " + differing;
}

RetestReport compare_calibrations(CalibrationReport first, CalibrationReport second) {
  RetestReport report{std::move(first), std::move(second), {}};
  const Calibration& a = report.first.calibration;
  const Calibration& b = report.second.calibration;
  std::vector<RepeatedValue> values;
  for (const char* const name : {"tactile_weight", "max_gap_deg", "bias_deg", "habit_deg", "tracker_noise_mm"}) {
    const EstimatedTrait first_value = trait_of(a, name);
    report.values.push_back({first_value, {}});
    values.push_back({first_value.interval, trait_of(b, name).interval});
  }
  const std::vector<RetestDifference> differences = compare(values);
  for (std::size_t i = 0; i < values.size(); ++i) report.values[i].difference = differences[i];
  return report;
}

std::string retest_text(const RetestReport& report) {
  std::string text = "\nRetest " + report.second.name + " less test " + report.first.name + "\n  " + left("", 36) +
                     right("difference", 15) + "   95 % interval\n";
  for (const ComparedValue& value : report.values) {
    const Interval& difference = value.difference.difference;
    text += "  " + left(value.trait.words, 36);
    text += difference.known ? right(fixed(difference.value, value.trait.decimals), 15) + "   " +
                                   between(difference.lower, difference.upper, value.trait.decimals, " to ") +
                                   (value.difference.differs ? ", differs" : "") + '\n'
                             : right("not determined", 15) + '\n';
  }
  return text + conclusion(report) +
         ". With all values together, 5 % of pairs of an unchanged person would show a difference.\n";
}

nlohmann::ordered_json retest_json(const RetestReport& report) {
  nlohmann::ordered_json page{{"test", report.first.name}, {"retest", report.second.name}};
  bool differs = false;
  for (const ComparedValue& value : report.values) {
    const RetestDifference& difference = value.difference;
    differs = differs || difference.differs;
    page["values"][value.trait.name] = {{"difference", difference.difference.value},
                                        {"interval", {difference.difference.lower, difference.difference.upper}},
                                        {"known", difference.difference.known},
                                        {"p", difference.p},
                                        {"differs", difference.differs}};
  }
  page["differs"] = differs;
  return page;
}

std::string text_page(const CalibrationReport& report, const std::optional<RetestReport>& retest) {
  return retest ? calibration_text(report) + '\n' + calibration_text(retest->second) + retest_text(*retest)
                : calibration_text(report);
}

std::string json_page(const CalibrationReport& report, const std::optional<RetestReport>& retest) {
  nlohmann::ordered_json page = calibration_json(report);
  if (retest) {
    page["retest"] = retest_json(*retest);
    page["retest"]["calibration"] = calibration_json(retest->second);
  }
  return page.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

void run(const CalibrateOptions& options) {
  const Output out("--out", options.out);
  const Output plot("--plot", options.plot);
  const Output profile("--profile", options.profile);

  // Everything that can fail does so before anything is written.
  const CalibrationReport report = calibrated(options.data, options.goal_direction_deg);
  std::optional<RetestReport> retest;
  if (!options.retest.empty())
    retest = compare_calibrations(report, calibrated(options.retest, options.goal_direction_deg));
  const std::string page = options.format == "json" ? json_page(report, retest) : text_page(report, retest);
  const std::string picture =
      options.plot.empty() ? "" : draw_beside("--plot", options.plot, calibration_figure(report));
  if (!options.plot.empty()) plot.write(picture);
  if (!options.profile.empty()) profile.write(calibration_profile(report.calibration));
  out.write(page);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App& command = add_command(app, "calibrate", "A participant's parameters from slides over a plate at rest.",
                                  "FILE is CSV with a header that names " + std::string(calibration_header) +
                                      R"(:
a row a tracked position of the fingertip (right of and away along the mid-line), the rows of a trial
together, its time increasing. Lines that start with # and other columns are ignored.

Let the person slide to one target, twice at each of the plate orientations -75 to 75 in steps of 7.5 in
random order; a slide of 30 mm or more, and half a second at rest before it. Needed are ten such slides at
three orientations that span 40 deg; between orientations that are far apart the curve is not known.
Slides within which the plate turned are left out. If the data do not suffice, the reason is on standard error, and the exit code is 1. If the person is unlike the model, the page says so and what to do, and their values are not
determined. Published human data cover orientations of -60 to 60.

Examples:
  hrt-study calibrate me.csv --plot me.svg --profile me.json
  hrt-study calibrate me.csv --retest me-a-week-later.csv
  hrt-study participants --out me.csv && hrt-study calibrate me.csv --format json)",
                                  [options] { run(*options); });
  add_path(command, "FILE", options->data, "The data, CSV.")->required();
  add_path(command, "--retest", options->retest,
           "A second calibration's data: whether the two differ, and by how much. --plot and --profile are\n"
           "of FILE.");
  add_number(command, "--goal", options->goal_direction_deg, {-45.0, 45.0}, "Direction of the goal, deg.");
  add_choice(command, "--format", options->format, {"text", "json"}, "What to write.");
  add_plot(command, options->plot, "Draw curve, directions and residuals there. Needs python3-matplotlib.");
  add_path(command, "--profile", options->profile, "File of a profile that the plugin loads (hrt_profile_load).");
  add_out(command, options->out);
}

}  // namespace hrt::study
