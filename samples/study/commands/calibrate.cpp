// hrt-study calibrate: estimates a person's parameters from slides over a fixed plate.
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/calibrate/calibration.h"
#include "core/calibrate/retest.h"
#include "core/learning.h"
#include "core/person/person_belief.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/figures.h"
#include "samples/study/people/participants.h"

namespace hrt::study {
namespace {

struct CalibrationReport {
  std::string name;  // file name of the data
  std::size_t trials = 0;
  double goal_direction_deg = 0.0;
  Calibration calibration;
};

// A value of a calibration, with its label and number of decimals.
struct EstimatedTrait {
  const char* name;   // name in JSON
  const char* words;  // label with its unit
  Interval interval;
  int decimals;
};

constexpr const char* verdict_name[] = {"used", "outlying", "along_ridges"};

std::string interval_text(const EstimatedTrait& trait) {
  return between(trait.interval.lower, trait.interval.upper, trait.decimals, " to ");
}

std::string row(const std::string& name, const std::string& value, const std::string& rest) {
  return "  " + left(name, 36) + right(value, 15) + "   " + rest + '\n';
}

std::string fit_text(const Calibration& calibration) {
  const LackOfFit& lack = calibration.lack_of_fit;
  const auto line = [](const char* over, double p) {
    return row(std::string("  ") + over, fixed(p, 3), p < min_fit_p ? "a pattern" : "none");
  };
  std::string text = "\nPatterns in the residuals of the fit, with p of the test\n" +
                     line("over the plate's angle", lack.angle_p) + line("over the order of the slides", lack.order_p) +
                     line("along the paths", lack.path_p);
  for (const CalibratedSlide& slide : calibration.slides) {
    if (slide.verdict != SlideVerdict::outlying) continue;
    Eigen::Index part = 0;
    (slide.parts_deg - slide.fitted_deg).cwiseAbs().maxCoeff(&part);
    text += "  excluded: trial " + std::to_string(slide.trial + 1) + ", an outlier: part " + std::to_string(part + 1) +
            " of its path has a direction of " + fixed(slide.parts_deg(part), 1) + " deg, the fit " +
            fixed(slide.fitted_deg(part), 1) + '\n';
  }
  if (const std::size_t along = calibration.count(SlideVerdict::along_ridges); along > 0)
    text +=
        "  excluded: " + std::to_string(along) + " slides nearly along the ridges, where the illusion changes sign\n";
  if (calibration.max_plate_deg > 60.0)
    text += "  the slides have plate angles up to " + fixed(calibration.max_plate_deg, 0) +
            " deg; published human data cover 60 deg\n";
  for (const std::string& advice : calibration.advice()) text += "Next: " + advice + ".\n";
  return text;
}

std::vector<EstimatedTrait> estimated_traits(const Calibration& calibration) {
  return {{"tactile_weight", "tactile weight w_T at 60°", calibration.tactile_weight, 3},
          {"bias_deg", "bias, °, left positive", calibration.bias_deg, 2},
          {"habit_deg", "habit of curving, °", calibration.habit_deg, 2},
          {"max_gap_deg", "largest feasible gap, °", calibration.max_gap_deg, 1},
          {"person_weight", "slope w of the illusion curve", calibration.slope, 3},
          {"person_curve", "curvature b of the illusion curve", calibration.curve, 3},
          {"tracker_noise_mm", "tracker noise, white, mm", calibration.noise.white_mm, 3},
          {"correlated_noise_mm", "tracker noise, correlated, mm", calibration.noise.correlated_mm, 3},
          {"noise_correlation_s", "correlation time of the noise, s", calibration.noise.correlation_s, 3}};
}

std::string calibration_text(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  std::string text = "Calibration of " + report.name + ": " + std::to_string(calibration.count(SlideVerdict::used)) +
                     " of " + std::to_string(report.trials) + " trials were used\n\n";
  text += row("", "estimate", "95 % interval");
  for (const EstimatedTrait& trait : estimated_traits(calibration)) {
    const std::string value = fixed(trait.interval.value, trait.decimals);
    text += trait.interval.known ? row(trait.words, value, interval_text(trait))
                                 : row(trait.words, "not determined", "best fit " + value);
  }
  text +=
      row("its angle between plate and motion, °", fixed(calibration.peak_offset_deg, 0), "") + fit_text(calibration);
  return text + "\nThe method has been tested with simulated people only; there was no human trial.\n";
}

nlohmann::ordered_json calibration_json(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  nlohmann::ordered_json page{
      {"data", report.name},
      {"tried_on", "simulated people only"},
      {"trials", report.trials},
      {"trials_used", calibration.count(SlideVerdict::used)},
      {"goal_direction_deg", report.goal_direction_deg},
  };
  for (const EstimatedTrait& trait : estimated_traits(calibration))
    page[trait.name] = {{"value", trait.interval.value},
                        {"interval", {trait.interval.lower, trait.interval.upper}},
                        {"known", trait.interval.known}};
  page["slides_turned"] = calibration.slides_turned;
  page["fits"] = calibration.fits();
  page["lack_of_fit"] = {{"angle_p", calibration.lack_of_fit.angle_p},
                         {"order_p", calibration.lack_of_fit.order_p},
                         {"path_p", calibration.lack_of_fit.path_p}};
  page["min_fit_p"] = min_fit_p;
  page["peak_offset_deg"] = calibration.peak_offset_deg;
  for (const CurvePoint& point : calibration.band)
    page["curve"].push_back({{"offset_deg", point.offset_deg},
                             {"shift_deg", point.shift_deg.value},
                             {"interval", {point.shift_deg.lower, point.shift_deg.upper}}});
  for (const CalibratedSlide& slide : calibration.slides) {
    const auto residuals_deg = (slide.parts_deg - slide.fitted_deg).eval();
    page["slides"].push_back({{"trial", slide.trial + 1},
                              {"verdict", verdict_name[static_cast<int>(slide.verdict)]},
                              {"plate_deg", slide.plate_deg},
                              {"direction_deg", settled_direction_deg(slide.parts_deg)},
                              {"fitted_deg", settled_direction_deg(slide.fitted_deg)},
                              {"residuals_deg", std::vector<double>(residuals_deg.begin(), residuals_deg.end())}});
  }
  page["advice"] = calibration.advice();
  return page;
}

// JSON for hrt_profile_load(), without fields that the data cannot determine.
std::string calibration_profile(const Calibration& calibration) {
  nlohmann::ordered_json profile{{"format", "haptic retargeting profile"}, {"version", 1}};
  const Interval& weight = calibration.tactile_weight;
  if (weight.known) {
    profile["tactile_weight"] = weight.value;
    profile["tactile_weight_sd"] =
        std::max(deviation_of_interval(weight.lower, weight.upper), Tuning{}.min_carried_weight_sd);
  }
  if (calibration.bias_deg.known) profile["bias_deg"] = calibration.bias_deg.value;
  if (const auto noise = known_noise(calibration.noise)) {
    profile["tracker_noise_m"] = noise->white_mm / mm_per_m;
    if (noise->correlated_mm > 0.0) {
      profile["tracker_correlated_noise_m"] = noise->correlated_mm / mm_per_m;
      profile["tracker_correlation_s"] = noise->correlation_s;
    }
  }
  if (calibration.slope.known && calibration.curve.known && calibration.bias_deg.known && calibration.habit_deg.known) {
    const PersonBelief belief = calibrated_person({.weight = calibration.slope,
                                                   .curve = calibration.curve,
                                                   .weight_curve_correlation = calibration.slope_curve_correlation,
                                                   .bias_deg = calibration.bias_deg,
                                                   .habit_deg = calibration.habit_deg});
    for (int i = 0; i < PersonState::traits; ++i) {
      profile["person_mean"].push_back(belief.mean(i));
      for (int j = 0; j <= i; ++j) profile["person_covariance"].push_back(belief.covariance(i, j));
    }
  }
  return profile.dump(2) + '\n';
}

// Figure of the illusion curve, of the directions and of the residuals.
Figure calibration_figure(const CalibrationReport& report) {
  return {.name = "calibration",
          .title = "Directions over plates at rest",
          .caption = "",
          .data = calibration_json(report)};
}

// Twice the size of a file with a thousand slides of one minute at 90 Hz.
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

// Test-retest comparison of two calibrations of a person.
struct ComparedValue {
  EstimatedTrait trait;  // of the first calibration
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
    return "No significant difference. The intervals show how large an undetected difference may be";
  return "Significantly different: " + differing;
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
  std::string text = "\nRetest " + report.second.name + " minus test " + report.first.name + "\n  " + left("", 36) +
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
         ". Of pairs of calibrations of an unchanged person, 5 % have a significant difference in any value.\n";
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

  // All inputs and destinations are checked before anything is written.
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
  CLI::App& command =
      add_command(app, "calibrate", "Estimate a participant's parameters from slides over a fixed plate.",
                  "FILE is CSV with a header that names " + std::string(calibration_header) +
                      R"(:
one row per tracked position of the fingertip (to the right of the mid-line, and away along it). The rows of
a trial are contiguous, with increasing times. Lines that start with # and other columns are ignored.

Protocol: the person slides to one target, twice at each plate orientation from -75 to 75 in steps of 7.5, in
random order. A slide is at least 30 mm long, after half a second at rest. The minimum is ten such slides at
three orientations that span 40 deg; between orientations that are far apart the illusion curve is unknown.
Slides during which the plate turned are excluded. If the data are not sufficient, the exit code is 1 and the
reason is on standard error. If the model does not fit the person, the values are not determined, and the
output says what to do. Published human data cover orientations from -60 to 60.

Examples:
  hrt-study calibrate me.csv --plot me.svg --profile me.json
  hrt-study calibrate me.csv --retest me-a-week-later.csv
  hrt-study participants --out me.csv && hrt-study calibrate me.csv --format json)",
                  [options] { run(*options); });
  add_path(command, "FILE", options->data, "The data, CSV.")->required();
  add_path(command, "--retest", options->retest,
           "Data of a second calibration, with which FILE is compared: differences, intervals and significance.\n"
           "--plot and --profile use FILE.");
  add_number(command, "--goal", options->goal_direction_deg, {-45.0, 45.0}, "Direction of the goal, deg.");
  add_choice(command, "--format", options->format, {"text", "json"}, "Format of the output.");
  add_plot(command, options->plot,
           "SVG file for a figure of curve, directions and residuals. Needs python3-matplotlib.");
  add_path(command, "--profile", options->profile, "File for a profile that the plugin loads (hrt_profile_load).");
  add_out(command, options->out);
}

}  // namespace hrt::study
