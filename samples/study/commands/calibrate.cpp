// hrt-study calibrate: who made these slides?
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "samples/study/cli/arguments.h"
#include "samples/study/cli/input.h"
#include "samples/study/cli/output.h"
#include "samples/study/commands/commands.h"
#include "samples/study/figures/calibration.h"
#include "samples/study/figures/retest.h"
#include "samples/study/figures/workshop.h"
#include "samples/study/people/participants.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

// A thousand slides of a minute at 90 Hz have half of this.
constexpr std::size_t max_bytes = std::size_t{1} << 29;

struct Options {
  std::string data;
  std::string retest;
  double goal_direction_deg = 0.0;
  std::string format = "text";
  std::string plot;
  std::string profile;
  MeasuredWith conditions;
  std::string out;
};

// Seconds since 1970 at the beginning of a day, "2026-03-01", or at a minute of it, "2026-03-01T14:30Z".
std::optional<std::int64_t> time_of(const std::string& text) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, taken = 0;
  if (text.size() == 10) {
    if (std::sscanf(text.c_str(), "%4d-%2d-%2d%n", &year, &month, &day, &taken) != 3) return std::nullopt;
  } else if (std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2dZ%n", &year, &month, &day, &hour, &minute,
                         &taken) != 5) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  const bool whole = static_cast<std::size_t>(taken) == text.size();
  if (!whole || !date.ok() || year < 1970 || hour < 0 || hour > 23 || minute < 0 || minute > 59)
    return std::nullopt;
  const std::chrono::seconds time = std::chrono::sys_days(date).time_since_epoch() +
                                    std::chrono::hours(hour) + std::chrono::minutes(minute);
  return time.count();
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() < 64 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// The picture, in the format that its name ends with.
std::string draw(const Figure& figure, const std::string& path) {
  const std::string ending = path.ends_with(".png") ? "png" : "svg";
  const fs::path parent = fs::absolute(path).parent_path();
  return Workshop("--plot", parent.string()).draw(figure, ending);
}

CalibrationReport calibrated(const std::string& data, double goal_direction_deg) {
  CalibrationReport report{.name = data, .goal_direction_deg = goal_direction_deg};
  const auto trials = parse_calibration_csv(data, read_input("FILE", data, max_bytes));
  report.trials = trials.size();
  const auto result = calibrate(trials, goal_direction_deg);
  if (const auto* refusal = std::get_if<CalibrationRefusal>(&result))
    throw std::runtime_error(data + ": no calibration: " + refusal->reason);
  report.calibration = std::get<Calibration>(result);
  return report;
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

void run(const Options& options) {
  if (!options.plot.empty() && !options.plot.ends_with(".svg") && !options.plot.ends_with(".png"))
    throw UsageError(not_allowed("--plot", options.plot, "a file whose name ends with .svg or .png"));
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
      options.plot.empty() ? ""
                           : draw(retest ? retest_figure(*retest) : calibration_figure(report), options.plot);
  if (!options.plot.empty()) plot.write(picture);
  if (!options.profile.empty()) profile.write(calibration_profile(report.calibration, options.conditions));
  out.write(page);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      add_command(app, "calibrate", "A participant's parameters from slides over a plate at rest.",
                  "FILE is CSV with a header that names " + std::string(calibration_header) +
                      R"(:
a row a tracked position of the fingertip (right of and away along the mid-line), the rows of a trial
together, its time increasing. Lines that start with # and other columns are ignored.

Let the person slide to one target, four or five times at each of the plate orientations -75 to 75 in
steps of 15 in random order; a slide of 30 mm or more, and half a second at rest before it. Needed are
ten such slides at three orientations that span 40 deg; with fewer than seven orientations the illusion
is taken for linear. Six slides more, within which the plate turns by 30 deg or more and back, show
rate and delay of the person's steering; their rows have the plate's orientation as it turns. If the data do not suffice, the reason is on standard error, and the exit code is
1. If the person is unlike the model, the page says so and what to do, and their values are not
determined. Published human data cover orientations of -60 to 60.

Examples:
  hrt-study calibrate me.csv --plot me.svg --profile me.json
  hrt-study calibrate me.csv --retest me-a-week-later.csv --plot retest.svg
  hrt-study participants --out me.csv && hrt-study calibrate me.csv --format json)",
                  [options] { run(*options); });
  require(add_path(command, "FILE", &options->data, "a file that can be read", "The data, CSV."));
  add_path(command, "--retest", &options->retest, "a file that can be read",
           "A second calibration's data: whether the two differ, and by how much. --plot then shows both;\n"
           "--profile is of FILE.");
  add_number(command, "--goal", &options->goal_direction_deg, {-45.0, 45.0}, "Direction of the goal, deg.");
  add_choice(command, "--format", &options->format, {"text", "json"}, "What to write.");
  add_path(command, "--plot", &options->plot, "a file whose name ends with .svg or .png",
           "Draw curve, directions and residuals there. Needs gnuplot.");
  add_path(command, "--profile", &options->profile, "a file in a folder that can be written",
           "Write a profile there that the plugin loads (hrt_profile_load).");
  MeasuredWith& conditions = options->conditions;
  add_value(command, "--measured", "a day or a minute of UTC, 2026-03-01 or 2026-03-01T14:30Z", "",
            "When the slides were made, for --profile.", [&conditions](const std::string& text) {
              const auto time_s = time_of(text);
              if (time_s) conditions.time_s = *time_s;
              return time_s.has_value();
            });
  for (const auto& [name, field] : {std::pair{"plate", &conditions.plate}, {"tracker", &conditions.tracker}})
    add_value(command, std::string("--") + name, "1 to 63 printable ASCII characters", "",
              std::string("With which ") + name + ", for --profile, as the host names it there.",
              [to = field](const std::string& text) {
                *to = text;
                return is_name(text);
              });
  add_out(command, &options->out);
}

}  // namespace hrt::study
