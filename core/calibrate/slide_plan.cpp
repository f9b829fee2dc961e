#include "core/calibrate/slide_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/calibrate/person_fit.h"
#include "core/math/exponential.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

// The first slides, as shares of half the range about its middle.
constexpr std::array<double, 9> opening{-0.4, 0.8, 0.0, -0.8, 0.4, -0.6, 0.2, 0.6, -0.2};
constexpr double candidate_step_deg = 5.0;
// The motion stays this far from along the ridges, as far as the fit shows.
constexpr double max_planned_offset_deg = 74.0;
// Families that are less likely are left out of the plan's variance within families.
constexpr double min_probability = 0.01;
// The largest gap counts half as much as the weight.
constexpr double gap_share = 0.5;

// Numbers of a person that the plan is to narrow, in the weight's units.
Eigen::Vector2d wanted(const SlidingPersonModel& person) {
  return {curve_weight(person.curve), weaker_peak(person.curve).shift_deg / curve_bound_deg};
}

// One family as the plan sees it.
struct Prospect {
  double probability;
  FitMatrix information;
  Eigen::Matrix<double, Eigen::Dynamic, 2> gradients;
  Eigen::Vector2d values;
};

Prospect prospect(const FamilyFit& family) {
  const CurveFit& fit = family.fit;
  const FitVector middle = fit_vector(fit.person);
  Prospect seen{family.probability, fit.information, {}, wanted(fit.person)};
  seen.gradients.resize(middle.size(), 2);
  for (int i = 0; i < middle.size(); ++i)
    seen.gradients.row(i) = fit_derivative(fit.person.curve.family, middle, i, wanted).transpose();
  return seen;
}

// The variance that is expected to be left after a slide over `track`'s plate: within the families, and
// between them as far as the slide leaves two of them alike (Bhattacharyya's coefficient).
double expected_variance(const std::vector<Prospect>& prospects, const std::vector<FamilyFit>& families,
                         const SlideTrack& track, const PartsMatrix& weight) {
  double sum = 0.0;
  std::vector<SlideDirections> predicted;
  for (std::size_t m = 0; m < prospects.size(); ++m) {
    const Prospect& own = prospects[m];
    predicted.push_back(predicted_directions(track, families[m].fit.person));
    if (own.probability < min_probability) continue;
    const SlideJacobian jacobian = slide_jacobian(track, families[m].fit.person);
    const FitMatrix information = own.information + congruence(jacobian, weight);
    const auto variance = [&](const FitVector& gradient) {
      return gradient.dot(solve_symmetric(information, gradient));
    };
    sum += own.probability * (variance(own.gradients.col(0)) + gap_share * variance(own.gradients.col(1)));
  }
  for (std::size_t m = 0; m < prospects.size(); ++m) {
    for (std::size_t n = 0; n < m; ++n) {
      const double both = prospects[m].probability * prospects[n].probability;
      const SlideDirections apart = predicted[m] - predicted[n];
      const double weight_apart = prospects[m].values(0) - prospects[n].values(0);
      const double gap_apart = prospects[m].values(1) - prospects[n].values(1);
      sum += both * (weight_apart * weight_apart + gap_share * gap_apart * gap_apart) *
             exponential(-0.125 * apart.dot(weight * apart));
    }
  }
  return sum;
}

// The middle is on neither side.
double side_of(double plate_deg) { return plate_deg > 1.0 ? 1.0 : plate_deg < -1.0 ? -1.0 : 0.0; }

// How far the nearest of the slides' angles is.
double nearest_deg(const std::vector<SlideTrack>& slides, double plate_deg) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SlideTrack& slide : slides) nearest = std::min(nearest, std::abs(slide.plate_deg - plate_deg));
  return nearest;
}

// The angle on the other side than `last_side` that is expected to leave the least variance. A curve needs
// more angles first: the one farthest from all so far.
double best_angle_deg(const PersonFit& person, const std::vector<SlideTrack>& fitted, bool curved, double last_side,
                      const SlidePlan& plan) {
  std::vector<Prospect> prospects;
  for (const FamilyFit& family : person.families) prospects.push_back(prospect(family));
  const PartsMatrix weight = fit_weight(person.scatter.covariance);
  const double range_deg = plan.upper_plate_deg - plan.lower_plate_deg;
  const double middle_deg = 0.5 * (plan.lower_plate_deg + plan.upper_plate_deg);
  SlideTrack candidate = fitted.back();
  double best_deg = middle_deg;
  double min = std::numeric_limits<double>::infinity();
  const auto count = std::max(1, static_cast<int>(std::ceil(range_deg / candidate_step_deg)));
  for (int i = 0; i <= count; ++i) {
    candidate.plate_deg = plan.lower_plate_deg + range_deg * i / count;
    if (last_side != 0.0 && side_of(candidate.plate_deg - middle_deg) == last_side) continue;
    const double settled_deg = settled_model_deg(person.best().person, candidate.plate_deg);
    if (std::abs(candidate.plate_deg - settled_deg) > max_planned_offset_deg) continue;
    const double left = curved ? expected_variance(prospects, person.families, candidate, weight)
                               : -nearest_deg(fitted, candidate.plate_deg);
    if (left >= min) continue;
    min = left;
    best_deg = candidate.plate_deg;
  }
  return best_deg;
}

}  // namespace

NextSlide next_slide(std::span<const SlideTrack> slides, std::span<const double> order, const SlidePlan& plan) {
  const double middle_deg = 0.5 * (plan.lower_plate_deg + plan.upper_plate_deg);
  const double half_deg = 0.5 * (plan.upper_plate_deg - plan.lower_plate_deg);
  if (slides.size() < opening.size()) return {middle_deg + half_deg * opening[slides.size()], false};
  const std::vector<SlideVerdict> verdicts = slide_verdicts(slides);
  const auto counting = std::count(verdicts.begin(), verdicts.end(), SlideVerdict::used);
  if (counting < min_fitted_slides) {
    // The person comes to move along the ridges nearly everywhere: nearer to the goal.
    return {middle_deg + 0.5 * half_deg * opening[slides.size() % opening.size()], false};
  }

  const PersonFit person = fit_person(slides, order);
  std::vector<SlideTrack> fitted;
  for (const std::size_t i : person.used) fitted.push_back(slides[i]);
  const bool curved = different_angles(fitted) >= min_curve_angles;
  const double last_side = side_of(slides.back().plate_deg - middle_deg);
  const double best_deg = best_angle_deg(person, fitted, curved, last_side, plan);

  const Interval w = person.value([](const SlidingPersonModel& p) { return curve_weight(p.curve); });
  const LackOfFit& lack = person.lack_of_fit;
  const bool enough = person.used.size() >= static_cast<std::size_t>(min_trials) && curved &&
                      w.upper - w.lower <= plan.enough_weight_width &&
                      std::min({lack.angle_p, lack.order_p, lack.path_p}) >= min_fit_p;
  return {best_deg, enough};
}

NextSlide next_slide(const std::vector<CalibrationTrial>& trials, double goal_direction_deg, const SlidePlan& plan) {
  const CalibrationSlides slides = slides_of(trials, goal_direction_deg);
  return next_slide(slides.resting, slides.order, plan);
}

}  // namespace hrt
