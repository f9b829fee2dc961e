// hrt-study coverage: calibrates simulated people of many kinds, and counts the 95 % intervals that contain the true
// value.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/math/elementary.h"
#include "core/setup/setup.h"
#include "core/simulation/people.h"
#include "core/simulation/slide.h"
#include "samples/study/cli/arguments.h"
#include "samples/study/commands/commands.h"
#include "samples/study/numbers/parallel.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {
namespace {

// People of the family `family` of core/simulation/people.h, with an optional change of person or session.
struct CoverageKind {
  const char* name;
  const char* description;
  const char* family;
  double weight_trend = 0.0;    // change of w from the first slide to the last, with a random sign
  double outlying_share = 0.0;  // fraction of slides whose direction is 15 to 40 degrees off
  void (*change)(PersonCondition& condition, Draws& draws) = nullptr;  // applied before the session
};

struct CoverageOptions {
  int slides = 32;  // at the plate angles of a set-up (core/setup)
  double duration_s = 2.0;
  std::uint64_t seed = 1;
  std::uint64_t people = 50;
  std::uint64_t threads = 2;
  std::string kind = "all";
  Writing writing;
};

enum Quantity { weight, bias, habit, max_gap, quantities };
constexpr const char* quantity_name[quantities] = {"weight", "bias", "habit", "max_gap"};

struct CoveragePerson {
  bool refused = false;  // the calibration failed: no intervals
  std::array<double, quantities> truth{};
  std::array<Interval, quantities> found{};
  LackOfFit lack_of_fit;
};

struct Tally {
  Share known;
  Share covered;       // among determined values
  double error = 0.0;  // sum over determined values
  double width = 0.0;  // sum over determined values

  void add(const Interval& found, double truth) {
    known.count(found.known);
    if (!found.known) return;
    covered.count(found.lower <= truth && truth <= found.upper);
    error += found.value - truth;
    width += found.upper - found.lower;
  }
  // Mean over determined values; NaN without determined values.
  double mean_error() const { return error / static_cast<double>(known.hits); }
  double mean_width() const { return width / static_cast<double>(known.hits); }
  std::string text(int decimals) const {
    const PercentInterval range = covered.interval();
    return fmt::format("{:>7}{:>5} {:8}{:>8}{:>7}", cell(known.percent(), 0), cell(covered.percent(), 0),
                       covered.of > 0 ? "(" + between(range.low, range.high, 0) + ")" : "",
                       cell(mean_error(), decimals), cell(mean_width(), decimals));
  }
};

struct Coverage {
  const CoverageKind* kind;
  Share refused;
  Share angle, order, path;  // people with a significant lack of fit; see LackOfFit
  std::array<Tally, quantities> of;

  void add(const CoveragePerson& person) {
    refused.count(person.refused);
    angle.count(person.lack_of_fit.angle_p < min_fit_p);
    order.count(person.lack_of_fit.order_p < min_fit_p);
    path.count(person.lack_of_fit.path_p < min_fit_p);
    for (std::size_t i = 0; i < quantities; ++i) of[i].add(person.found[i], person.truth[i]);
  }
};

constexpr std::uint32_t session_stream = 18;
// Ratio of a minimum-jerk motion's mean speed over the path to its mean speed over time.
constexpr double speed_over_path = 10.0 / 7.0;

template <int min, int max>
void weighs(PersonCondition& condition, Draws& draws) {
  condition.person.illusion.tactile_weight = 0.01 * (min + (max - min) * draws.uniform());
}
void peaked(PersonCondition& condition, Draws&) {
  condition.person.illusion.family = IllusionFamily::peaked;
  condition.person.illusion.scale_deg = 50.0;
}
void biased(PersonCondition& condition, Draws& draws) {
  condition.person.bias_deg = draws.uniform() < 0.5 ? -3.0 : 3.0;
}

constexpr CoverageKind all_kinds[] = {
    {"linear", "linear illusion, continuous steering", "linear"},
    {"steps", "the paper's person", "steps"},
    {"predictive", "predict their own motion over the sensory delay", "predictive"},
    {"clip-60", "illusion saturates at 60°", "clip-60"},
    {"clip-45", "illusion saturates at 45°", "clip-45"},
    {"tanh-60", "w 60° tanh(t / 60°)", "tanh-60"},
    {"sine-45", "w 45° sin 2t", "sine-45"},
    {"dead-band", "no shift within 10°", "dead-band"},
    {"unequal", "half the illusion to the right", "unequal"},
    {"bias-3", "bias of ±3°", "bias-3"},
    {"habit-5", "habit of ±5°", "habit-5"},
    {"mixture", "clip-60, bias, habit, correlated noise", "mixture"},
    {"noise-100", "noise of 1.2 mm over 100 ms", "noise-100"},
    {"outliers", "3 % of positions with an error of 30 mm", "outliers"},
    {"slow-tracker", "tracker of 30 Hz with jitter", "slow-tracker"},
    {"slips", "5 % of slides in a direction 15 to 40° off", "linear", 0.0, 0.05},
    {"trend", "w changes by ±0.06 over the session", "linear", 0.06},
    {"strong", "linear, w_T of 0.3 to 0.45", "linear", 0.0, 0.0, weighs<30, 45>},
    {"strong-clip", "saturating at 60°, w_T of 0.3 to 0.45", "clip-60", 0.0, 0.0, weighs<30, 45>},
    {"weak", "linear, w_T of 0.05 to 0.12", "linear", 0.0, 0.0, weighs<5, 12>},
    {"peaked", "illusion linear up to t = 50°, falls to 0 at 90°", "linear", 0.0, 0.0, peaked},
    {"drift", "w changes by ±0.05 within each slide", "drift"},
    {"place-bias", "steer to the target's position, bias of ±3°", "place", 0.0, 0.0, biased},
    {"place", "steer to the target's position", "place"},
    {"heavy-arm", "arm of 1 kg, muscles with a time constant of 40 ms", "heavy-arm"},
    {"crossings", "ridges felt only when crossed", "crossings"},
};

// Simulates the slides of person `index` of a kind, in the order of the session, and writes the true values to `truth`.
std::vector<CalibrationTrial> coverage_slides(const CoverageKind& kind, const CoverageOptions& session,
                                              std::uint32_t index, std::array<double, quantities>* truth) {
  PersonCondition condition = draw_person(*people_family(kind.family), session.duration_s, session.seed, index);
  Draws draws(session.seed, session_stream, index, 0);
  if (kind.change) kind.change(condition, draws);
  Person person = condition.person;
  person.illusion.tactile_weight += 0.5 * person.weight_drift;  // value in the middle of the path
  const double speed_mm_s = speed_over_path * condition.distance_mm / session.duration_s;
  const auto shift = [&](double t) { return mean_felt_shift_deg(person, speed_mm_s, t); };
  const auto largest = [&](double sign) { return max_shift_deg(person, speed_mm_s, curve_bound_deg, sign); };
  double bias_deg = person.bias_deg - person.own_bias_deg;
  double habit_deg = person.habit_deg;
  if (person.steering == Steering::place) {
    // The goal of people who steer to the target's position is bias (1 + log(1 - s)) at the fraction s of the path. The
    // true bias is its value at s = 0.5, the true habit half of its decrease from s = 0 to s = 0.85.
    habit_deg = -0.5 * bias_deg * logarithm(0.15);
    bias_deg *= 1.0 + logarithm(0.5);
  }
  *truth = {(shift(60.0) - shift(-60.0)) / 120.0, bias_deg, habit_deg, std::min(largest(1.0), largest(-1.0))};

  const double trend = draws.uniform() < 0.5 ? -kind.weight_trend : kind.weight_trend;
  std::vector<CalibrationTrial> trials;
  for (int i = 0; i < session.slides; ++i) {
    PersonCondition now = condition;
    now.person.illusion.tactile_weight +=
        trend * (static_cast<double>(i) / static_cast<double>(session.slides - 1) - 0.5);
    CalibrationTrial trial =
        simulate_slide(now, curve_bound_deg * planned_share(i), session.seed, index, static_cast<std::uint32_t>(i));
    if (draws.uniform() < kind.outlying_share) {
      const double off_deg = (draws.uniform() < 0.5 ? -1.0 : 1.0) * (15.0 + 25.0 * draws.uniform());
      for (TimedPoint& sample : trial.samples) {
        const PlatePoint& p = sample.position;
        sample.position = {p.right_mm * cos_deg(off_deg) - p.away_mm * sin_deg(off_deg),
                           p.right_mm * sin_deg(off_deg) + p.away_mm * cos_deg(off_deg)};
      }
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

CoveragePerson coverage_person(const CoverageKind& kind, const CoverageOptions& session, std::uint32_t index) {
  CoveragePerson person;
  const auto trials = coverage_slides(kind, session, index, &person.truth);
  const auto result = calibrate(trials);
  const auto* found = std::get_if<Calibration>(&result);
  person.refused = found == nullptr;
  if (!found) {
    for (Interval& unknown : person.found) unknown.known = false;
    return person;
  }
  person.found = {found->tactile_weight, found->bias_deg, found->habit_deg, found->max_gap_deg};
  person.lack_of_fit = found->lack_of_fit;
  return person;
}

struct CoverageStudy {
  CoverageOptions options;
  std::vector<Coverage> rows;
};

Coverage simulate(const CoverageKind& kind, const CoverageOptions& options) {
  std::vector<CoveragePerson> people(options.people);
  for_each_part(people.size(), options.threads,
                [&](std::uint64_t i) { people[i] = coverage_person(kind, options, static_cast<std::uint32_t>(i)); });
  Coverage coverage{.kind = &kind};
  for (const CoveragePerson& person : people) coverage.add(person);
  return coverage;
}

std::string text(const CoverageStudy& study) {
  const CoverageOptions& options = study.options;
  std::string page = fmt::format(
      "Calibrations of simulated people; there was no human trial. {} people of each kind, {} slides at the angles of "
      "a set-up, {} s each.\n"
      "known: % of people for whom the calibration determines the value\n"
      "cover: % of the known 95 % intervals that contain the true value, and the 95 % interval of this percentage\n"
      "error: mean of estimate minus true value; width: mean width of the interval\n"
      "w: tactile weight; t: angle between the motion and the ridge normal\n\n"
      "{:14}  {:34}  {:34}  {:34}  {:34}\n{:14}",
      options.people, options.slides, options.duration_s, "", "w_T", "bias, deg", "habit, deg", "largest gap, deg", "");
  for (int i = 0; i < quantities; ++i) page += "  known cover           error  width ";
  for (const Coverage& row : study.rows) {
    page += fmt::format("\n{:14}", row.kind->name);
    for (std::size_t i = 0; i < quantities; ++i) page += row.of[i].text(i == weight ? 4 : 2);
  }
  page +=
      "\n\n% of people whose values are unknown because of a lack of fit over the plate's angle, the order of the "
      "slides or the\npath (first three columns), or because the calibration failed (fourth column)\n";
  for (const Coverage& of : study.rows)
    page += fmt::format("{:14}{:>6.0f}{:>6.0f}{:>6.0f}{:>6.0f}   {}\n", of.kind->name, of.angle.percent(),
                        of.order.percent(), of.path.percent(), of.refused.percent(), of.kind->description);
  return page;
}

Results results(const CoverageStudy& study) {
  Results found{.about = {{"simulation", true},
                          {"people", study.options.people},
                          {"seed", study.options.seed},
                          {"duration_s", study.options.duration_s},
                          {"slides", study.options.slides}},
                .rows = {}};
  for (const Coverage& of : study.rows) {
    Row row{{"kind", of.kind->name},      {"description", of.kind->description},
            {"refused", of.refused.hits}, {"angle", of.angle.hits},
            {"order", of.order.hits},     {"path", of.path.hits}};
    for (std::size_t i = 0; i < quantities; ++i) {
      const std::string name = quantity_name[i];
      row[name + "_known"] = of.of[i].known.hits;
      row[name + "_covered"] = of.of[i].covered.hits;
      row[name + "_mean_error"] = of.of[i].mean_error();
      row[name + "_mean_width"] = of.of[i].mean_width();
    }
    found.rows.push_back(row);
  }
  return found;
}

CoverageStudy simulate(const CoverageOptions& options) {
  CoverageStudy study{.options = options, .rows = {}};
  Progress progress;
  for (std::size_t i = 0; i < std::size(all_kinds); ++i) {
    if (options.kind != "all" && options.kind != all_kinds[i].name) continue;
    study.rows.push_back(simulate(all_kinds[i], options));
    progress.update(i + 1, std::size(all_kinds));
  }
  return study;
}

}  // namespace

void add_coverage(CLI::App& app) {
  const auto options = std::make_shared<CoverageOptions>();
  CLI::App& command = add_command(
      app, "coverage", "Coverage of the calibration's 95 % intervals, for simulated people.",
      R"(Simulates families of 'robustness', and people with strong, weak or peaked illusions, with outlying slides, or
with a weight that changes over the session. 50 people of each kind take about three minutes.

Examples:
  hrt-study coverage --kind habit-5
  hrt-study coverage --slides 16 --people 200)",
      [options] { options->writing.write([options] { return simulate(*options); }, results, text); });
  std::vector<std::string> kinds{"all"};
  for (const CoverageKind& kind : all_kinds) kinds.emplace_back(kind.name);
  add_choice(command, "--kind", options->kind, kinds, "Kind of simulated people.");
  add_integer(command, "--people", options->people, 1, 100'000, "Number of simulated people of each kind.");
  add_integer(command, "--slides", options->slides, 16, 200, "Number of slides of each person.");
  add_number(command, "--duration", options->duration_s, {0.3, 20.0}, "Duration of a slide, s.");
  add_threads(command, options->threads);
  add_seed(command, options->seed);
  options->writing.add_options(command);
}

}  // namespace hrt::study
