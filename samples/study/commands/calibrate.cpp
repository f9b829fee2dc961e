#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/calibrate/calibration.h"
#include "core/calibrate/retest.h"
#include "core/learning.h"
#include "core/person/person_belief.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/figures.h"
#include "samples/study/people/participants.h"

namespace hrt::study {
namespace {

struct CalibrationReport {
  std::string name;  // file with the data
  std::size_t trials = 0;
  double goal_direction_deg = 0.0;
  Calibration calibration;
};

struct EstimatedTrait {
  const char* name;   // name in JSON
  const char* words;  // label with its unit
  Interval interval;
  int decimals;
};

constexpr const char* verdict_name[] = {"used", "outlying", "along_ridges"};

std::string row(const std::string& name, const std::string& value, const std::string& rest) {
  return fmt::format("  {:36}{:>15}   {}\n", name, value, rest);
}

std::string value_row(const char* words, const Interval& interval, int decimals) {
  return row(words, cell(interval.value, decimals), between(interval.lower, interval.upper, decimals, " to "));
}

std::string fit_text(const Calibration& calibration) {
  const LackOfFit& lack = calibration.lack_of_fit;
  std::string text = "\nPatterns in the residuals of the fit, with p of the test\n";
  for (const auto& [over, p] : {std::pair("over the plate's angle", lack.angle_p),
                                {"over the order of the slides", lack.order_p},
                                {"along the paths", lack.path_p}})
    text += row(std::string("  ") + over, cell(p, 3), p < min_fit_p ? "a pattern" : "none");
  for (const CalibratedSlide& slide : calibration.slides) {
    if (slide.verdict != SlideVerdict::outlying) continue;
    Eigen::Index part = 0;
    (slide.parts_deg - slide.fitted_deg).cwiseAbs().maxCoeff(&part);
    text += fmt::format(
        "  excluded: trial {}, an outlier: part {} of its path has a direction of {:.1f} deg, the fit has {:.1f} deg\n",
        slide.trial + 1, part + 1, slide.parts_deg(part), slide.fitted_deg(part));
  }
  if (const std::size_t along = calibration.count(SlideVerdict::along_ridges); along > 0)
    text += fmt::format("  excluded: {} slides nearly along the ridges, where the illusion changes sign\n", along);
  if (calibration.max_plate_deg > 60.0)
    text +=
        fmt::format("  the slides have plate angles up to {:.0f} deg; published human data cover angles up to 60 deg\n",
                    calibration.max_plate_deg);
  for (const std::string& advice : calibration.advice()) text += "Next: " + advice + ".\n";
  return text;
}

std::vector<EstimatedTrait> estimated_traits(const Calibration& calibration) {
  return {{"tactile_weight", "w_T, ridge normal at 60° to motion", calibration.tactile_weight, 3},
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
  std::string text = fmt::format("Calibration of {}: {} of {} trials were used\n\n", report.name,
                                 calibration.count(SlideVerdict::used), report.trials) +
                     row("", "estimate", "95 % interval");
  for (const EstimatedTrait& trait : estimated_traits(calibration))
    text += trait.interval.known
                ? value_row(trait.words, trait.interval, trait.decimals)
                : row(trait.words, "not determined", "best fit " + cell(trait.interval.value, trait.decimals));
  return text + row("plate minus motion at largest gap, °", cell(calibration.peak_offset_deg, 0), "") +
         fit_text(calibration) + "\nThe method has been tested with simulated people only; there was no human trial.\n";
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

// Returns JSON for hrt_profile_load(), without fields that the data cannot determine.
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

// A file with a thousand slides of one minute at 90 Hz is smaller.
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

// A value of the first of two calibrations, and the value of the second minus it.
struct ComparedValue {
  EstimatedTrait trait;
  RetestDifference difference;
};

std::vector<ComparedValue> compare_calibrations(const Calibration& first, const Calibration& second) {
  std::vector<RepeatedValue> values;
  std::vector<ComparedValue> compared;
  const auto all = estimated_traits(first), again = estimated_traits(second);
  for (const std::string_view name : {"tactile_weight", "max_gap_deg", "bias_deg", "habit_deg", "tracker_noise_mm"}) {
    const auto at = std::ranges::find(all, name, &EstimatedTrait::name) - all.begin();
    compared.push_back({all[static_cast<std::size_t>(at)], {}});
    values.push_back({compared.back().trait.interval, again[static_cast<std::size_t>(at)].interval});
  }
  const std::vector<RetestDifference> differences = compare(values);
  for (std::size_t i = 0; i < values.size(); ++i) compared[i].difference = differences[i];
  return compared;
}

std::string conclusion(const std::vector<ComparedValue>& values) {
  std::vector<std::string> differing;
  for (const ComparedValue& value : values)
    if (value.difference.differs) differing.emplace_back(value.trait.words);
  if (std::ranges::none_of(values, [](const ComparedValue& value) { return value.difference.difference.known; }))
    return "No value is known from both calibrations: nothing can be compared";
  if (differing.empty())
    return "No significant difference. The intervals show how large an undetected difference may be";
  return fmt::format("Significantly different: {}", fmt::join(differing, "; "));
}

std::string retest_text(const std::string& names, const std::vector<ComparedValue>& values) {
  std::string text = "\nRetest " + names + "\n" + row("", "difference", "95 % interval");
  for (const auto& [trait, difference] : values) {
    if (!difference.difference.known) {
      text += fmt::format("  {:36}{:>15}\n", trait.words, "not determined");
      continue;
    }
    text += value_row(trait.words, difference.difference, trait.decimals);
    if (difference.differs) text.insert(text.size() - 1, ", differs");
  }
  return text + conclusion(values) +
         ". Of pairs of calibrations of an unchanged person, 5 % differ significantly in at least one value.\n";
}

nlohmann::ordered_json retest_json(const std::vector<ComparedValue>& values) {
  nlohmann::ordered_json page;
  for (const auto& [trait, difference] : values)
    page["values"][trait.name] = {{"difference", difference.difference.value},
                                  {"interval", {difference.difference.lower, difference.difference.upper}},
                                  {"known", difference.difference.known},
                                  {"p", difference.p},
                                  {"differs", difference.differs}};
  page["differs"] = std::ranges::any_of(values, [](const ComparedValue& value) { return value.difference.differs; });
  return page;
}

void run(const CalibrateOptions& options) {
  const Output out("--out", options.out);
  const Output plot("--plot", options.plot);
  const Output profile("--profile", options.profile);

  // All inputs and destinations are checked before any result is written.
  const CalibrationReport report = calibrated(options.data, options.goal_direction_deg);
  nlohmann::ordered_json page = calibration_json(report);
  const std::string picture =
      options.plot.empty()
          ? ""
          : draw_beside("--plot", options.plot, {"calibration", "Directions over plates at rest", "", page});
  std::string text = calibration_text(report);
  if (!options.retest.empty()) {
    const CalibrationReport second = calibrated(options.retest, options.goal_direction_deg);
    const auto values = compare_calibrations(report.calibration, second.calibration);
    text += '\n' + calibration_text(second) + retest_text(second.name + " minus test " + report.name, values);
    page["retest"] = {{"test", report.name}, {"retest", second.name}};
    page["retest"].update(retest_json(values));
    page["retest"]["calibration"] = calibration_json(second);
  }
  if (options.format == "json") text = page.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  if (!options.plot.empty()) plot.write(picture);
  if (!options.profile.empty()) profile.write(calibration_profile(report.calibration));
  out.write(text);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App& command =
      add_command(app, "calibrate", "Estimate a participant's parameters from slides over a fixed plate.",
                  "FILE is CSV with a header that names " + std::string(calibration_header) +
                      R"(:
one row per tracked position of the fingertip: right_m to the right of the plate's mid-line, away_m along it,
away from the person. The rows of a trial are contiguous, with increasing times. Lines that start with # and
other columns are ignored.

Protocol: the person slides to one target, twice at each plate orientation from -75 to 75 in steps of 7.5, in
random order. A slide is at least 30 mm long, after half a second at rest. The minimum is ten such slides at
three orientations that span 40 deg; between orientations that are far apart the illusion curve is unknown.
Slides during which the plate turned by more than 5 deg are excluded. If the data are not sufficient, the exit
code is 1 and the reason is on standard error. If the model does not fit the person, the values are not
determined, and the output says what to do. Published human data cover orientations from -60 to 60.

Examples:
  hrt-study calibrate me.csv --plot me.svg --profile me.json
  hrt-study calibrate me.csv --retest me-a-week-later.csv
  hrt-study participants --out me.csv && hrt-study calibrate me.csv --format json)",
                  [options] { run(*options); });
  add_path(command, "FILE", options->data, "The data, CSV.")->required();
  add_path(command, "--retest", options->retest,
           "Data of a second calibration, with which FILE is compared: differences, intervals and significance.\n"
           "--plot and --profile use FILE.");
  add_number(command, "--goal", options->goal_direction_deg, {-45.0, 45.0},
             "Direction of the target of the slides, deg, left positive.");
  add_choice(command, "--format", options->format, {"text", "json"}, "Format of the output.");
  add_plot(command, options->plot,
           "SVG file for a figure of curve, directions and residuals. Needs python3-matplotlib.");
  add_path(command, "--profile", options->profile, "File for a profile that the plugin loads (hrt_profile_load).");
  add_out(command, options->out);
}

}  // namespace hrt::study
