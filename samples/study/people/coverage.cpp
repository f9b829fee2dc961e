#include "samples/study/people/coverage.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"
#include "core/setup/setup.h"
#include "core/simulation/slide.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

constexpr std::uint32_t session_stream = 18;
// A minimum-jerk motion's mean speed over the path, over that in the mean over time.
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
    {"predictive", "predict their own motion", "predictive"},
    {"clip-60", "illusion saturates at 60°", "clip-60"},
    {"clip-45", "illusion saturates at 45°", "clip-45"},
    {"tanh-60", "60° tanh(t / 60°)", "tanh-60"},
    {"sine-45", "45° sin 2t", "sine-45"},
    {"dead-band", "nothing felt within 10°", "dead-band"},
    {"unequal", "half to the right", "unequal"},
    {"bias-3", "bias of ±3°", "bias-3"},
    {"habit-5", "habit of ±5°", "habit-5"},
    {"mixture", "clip-60, bias, habit, correlated noise", "mixture"},
    {"noise-100", "noise of 1.2 mm over 100 ms", "noise-100"},
    {"outliers", "3 % of positions off by 30 mm", "outliers"},
    {"slow-tracker", "30 Hz, uneven", "slow-tracker"},
    {"slips", "5 % of slides go 15 to 40° off", "linear", 0.0, 0.05},
    {"trend", "w changes by ±0.06 over the session", "linear", 0.06},
    {"strong", "linear, w_T of 0.3 to 0.45", "linear", 0.0, 0.0, weighs<30, 45>},
    {"strong-clip", "saturating at 60°, w_T of 0.3 to 0.45", "clip-60", 0.0, 0.0, weighs<30, 45>},
    {"weak", "linear, w_T of 0.05 to 0.12", "linear", 0.0, 0.0, weighs<5, 12>},
    {"peaked", "illusion rises to 50° and falls to 0 at 90°", "linear", 0.0, 0.0, peaked},
    {"drift", "w changes by ±0.05 within each slide", "drift"},
    {"place-bias", "seek the target's place, bias of ±3°", "place", 0.0, 0.0, biased},
    {"place", "seek the target's place", "place"},
    {"heavy-arm", "1 kg, muscles of 40 ms", "heavy-arm"},
    {"crossings", "ridges felt as they are crossed", "crossings"},
};

}  // namespace

std::span<const CoverageKind> coverage_kinds() { return all_kinds; }

std::vector<CalibrationTrial> coverage_slides(const CoverageKind& kind, const CoverageSession& session,
                                              std::uint32_t index, std::array<double, quantities>* truth) {
  PersonCondition condition = draw_person(*people_family(kind.family), session.duration_s, session.seed, index);
  Draws draws(session.seed, session_stream, index, 0);
  if (kind.change) kind.change(condition, draws);
  Person person = condition.person;
  person.illusion.tactile_weight += 0.5 * person.weight_drift;  // in the middle of the path
  const double speed_mm_s = speed_over_path * condition.distance_mm / session.duration_s;
  const auto shift = [&](double t) { return mean_felt_shift_deg(person, speed_mm_s, t); };
  const auto largest = [&](double sign) { return max_shift_deg(person, speed_mm_s, curve_bound_deg, sign); };
  double bias_deg = person.bias_deg - person.own_bias_deg;
  double habit_deg = person.habit_deg;
  if (person.steering == Steering::place) {
    // They aim beside the place until they are near: the goal is bias (1 + log(1 - s)) at the share s of the path.
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

CoveragePerson coverage_person(const CoverageKind& kind, const CoverageSession& session, std::uint32_t index) {
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

void Tally::add(const Interval& found, double truth, double error_of_value) {
  known.count(found.known);
  if (!found.known) return;
  covered.count(found.lower <= truth && truth <= found.upper);
  error += error_of_value;
  width += found.upper - found.lower;
}

std::string Tally::covered_text(std::size_t columns) const {
  const PercentInterval range = covered.interval();
  return cell(covered.percent(), 0, columns) +
         left(covered.of > 0 ? " (" + between(range.low, range.high, 0) + ")" : "", 9);
}

void Coverage::add(const CoveragePerson& person) {
  refused.count(person.refused);
  angle.count(person.lack_of_fit.angle_p < min_fit_p);
  order.count(person.lack_of_fit.order_p < min_fit_p);
  path.count(person.lack_of_fit.path_p < min_fit_p);
  for (std::size_t i = 0; i < quantities; ++i)
    of[i].add(person.found[i], person.truth[i], person.found[i].value - person.truth[i]);
}

}  // namespace hrt::study
