#include "core/calibrate/curve_fit.h"

#include <algorithm>
#include <array>

#include "core/math/exponential.h"
#include "core/math/least_squares.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

// What is taken for possible before any slide: wide, so that a parameter that slides hardly show keeps the
// fit from running away.
struct Prior {
  double mean;
  double deviation;
};

// How far the steering law may be wrong about each part: people set out and settle in ways of their own, and
// what the curve is shows at the end.
constexpr std::array<double, slide_parts> law_deviation_deg{2.0, 0.7, 0.25, 0.1};
// The same of all slides of a person, in proportion to the plate's angle, as a share of that.
constexpr double common_share = 0.45;
constexpr double common_angle_deg = 60.0;
// The mean turn of a habit may be wrong by this share of it, and is then taken for a bias.
constexpr double habit_as_bias = 0.04;
// People who steer to a place, not in a direction, turn back what they have felt: as by a curve that is
// larger by twice this share. Half of it is allowed for, since most people need none.
constexpr double place_as_curve = 0.005;
// The rate k of correction is 1.6 to 37 /s, D up to 0.2 s as in slide_model.h, L within 0.15 s.
constexpr double min_log_gain = 0.5;
constexpr double max_log_gain = 3.6;
constexpr double max_delay_s = 0.2;
constexpr double max_goal_delay_s = 0.15;
// Directions are within max_direction_deg; a curve's first number within these, with room about those of
// people.
constexpr double min_first = -0.2;
constexpr double max_first = 0.8;
constexpr double min_start_share = -0.5;
constexpr double max_start_share = 1.5;
// The weight from which a fit sets out.
constexpr double first_weight = 0.18;

enum Parameter { bias, habit, start, log_gain, delay, goal_delay, start_share, first, second };

struct Limits {
  double min;
  double max;
};

Limits limits(CurveFamily family, int parameter) {
  switch (parameter) {
    case log_gain:
      return {min_log_gain, max_log_gain};
    case delay:
      return {0.0, max_delay_s};
    case goal_delay:
      return {-max_goal_delay_s, max_goal_delay_s};
    case start_share:
      return {min_start_share, max_start_share};
    case first:
      return {min_first, max_first};
    case second: {
      const CurveRange range = second_range(family);
      return {range.min, range.max};
    }
    default:
      return {-max_direction_deg, max_direction_deg};
  }
}

FitVector clamped(CurveFamily family, FitVector parameters) {
  for (int i = 0; i < parameters.size(); ++i) {
    const Limits range = limits(family, i);
    parameters(i) = std::clamp(parameters(i), range.min, range.max);
  }
  return parameters;
}

Prior prior(CurveFamily family, int parameter) {
  constexpr std::array<Prior, second> priors{
      {{0.0, 100.0}, {0.0, 20.0}, {0.0, 10.0}, {2.2, 1.0}, {0.06, 0.2}, {0.0, 0.05}, {0.0, 0.3}, {0.2, 1.0}}};
  if (parameter < second) return priors[static_cast<std::size_t>(parameter)];
  const CurveRange range = second_range(family);
  return {0.5 * (range.min + range.max), range.max - range.min};
}

// By family, in the parameters' order.
void set_prior(CurveFamily family, LeastSquares* problem) {
  const auto count = static_cast<Eigen::Index>(first + curve_parameters(family));
  problem->prior_mean.resize(count);
  problem->prior_deviation.resize(count);
  for (int i = 0; i < count; ++i) {
    const Prior expected = prior(family, i);
    problem->prior_mean(i) = expected.mean;
    problem->prior_deviation(i) = expected.deviation;
  }
}

SlideJacobian rough_jacobian(const SlideTrack& track, const SlidingPersonModel& person) {
  const CurveFamily family = person.curve.family;
  const FitVector middle = fit_vector(person);
  const SlideDirections here_deg = predicted_directions(track, person);
  SlideJacobian jacobian(slide_parts, middle.size());
  for (int i = 0; i < middle.size(); ++i) {
    const double step = fit_derivative_step(family, i);
    FitVector above = middle;
    above(i) += step;
    jacobian.col(i) = (predicted_directions(track, fitted_person(family, above)) - here_deg) / step;
  }
  return jacobian;
}

// Residuals and derivatives are multiplied by `root`: root' root is the weight.
LeastSquares problem_of(CurveFamily family, std::span<const SlideTrack> slides, const Eigen::MatrixXd& root) {
  LeastSquares problem;
  set_prior(family, &problem);
  problem.clamped = [family](const FitVector& parameters) { return clamped(family, parameters); };
  problem.residuals = [=](const FitVector& parameters) {
    const SlidingPersonModel person = fitted_person(family, parameters);
    std::vector<Eigen::VectorXd> residuals;
    for (const SlideTrack& slide : slides)
      residuals.emplace_back(product(root, slide.direction_deg - predicted_directions(slide, person)));
    return residuals;
  };
  problem.derivatives = [=](const FitVector& parameters) {
    const SlidingPersonModel person = fitted_person(family, parameters);
    std::vector<Eigen::MatrixXd> derivatives;
    for (const SlideTrack& slide : slides) derivatives.push_back(product(root, rough_jacobian(slide, person)));
    return derivatives;
  };
  return problem;
}

// What the steering law gets wrong in all slides alike, in parameters.
FitMatrix common_covariance(const CurveFit& fit, std::span<const SlideTrack> slides, const PartsMatrix& weight) {
  const FitMatrix inverted = inverse(fit.information);
  SlideJacobian tilted = SlideJacobian::Zero(slide_parts, inverted.cols());
  for (std::size_t i = 0; i < slides.size(); ++i)
    tilted += (slides[i].plate_deg / common_angle_deg) * product(weight, fit.jacobians[i]);
  for (int part = 0; part < slide_parts; ++part) tilted.row(part) *= common_deviation_deg(part);
  FitMatrix common = congruence(product(tilted, inverted), PartsMatrix::Identity());
  common(bias, bias) += habit_as_bias * habit_as_bias * fit.person.habit_deg * fit.person.habit_deg;
  const IllusionCurve& curve = fit.person.curve;
  FitVector larger = FitVector::Zero(common.rows());
  larger(first) = place_as_curve * curve.first;
  if (curve.family == CurveFamily::unequal || curve.family == CurveFamily::cubic)
    larger(second) = place_as_curve * curve.second;
  common += product(larger, larger.transpose());
  return common;
}

std::vector<double> first_guesses(CurveFamily family) {
  switch (family) {
    case CurveFamily::saturating:
      return {62.0, 45.0};
    case CurveFamily::tanh:
      return {70.0};
    case CurveFamily::dead_band:
      return {8.0};
    case CurveFamily::unequal:
      return {0.15};
    default:
      return {0.0};
  }
}

}  // namespace

double common_deviation_deg(int part) { return common_share * law_deviation_deg[static_cast<std::size_t>(part)]; }

PartsMatrix fit_weight(const PartsMatrix& parts_covariance) {
  PartsMatrix covariance = parts_covariance;
  for (int part = 0; part < slide_parts; ++part)
    covariance(part, part) += law_deviation_deg[part] * law_deviation_deg[part];
  return inverse(covariance);
}

double fit_derivative_step(CurveFamily family, int parameter) {
  const bool angle = parameter == second && (family == CurveFamily::saturating || family == CurveFamily::tanh ||
                                             family == CurveFamily::dead_band);
  return angle ? 0.5 : fit_step[parameter];
}

FitVector fit_vector(const SlidingPersonModel& person) {
  FitVector parameters(first + curve_parameters(person.curve.family));
  parameters(bias) = person.bias_deg;
  parameters(habit) = person.habit_deg;
  parameters(start) = person.start_deg;
  parameters(log_gain) = person.log_gain;
  parameters(delay) = person.delay_s;
  parameters(goal_delay) = person.goal_delay_s;
  parameters(start_share) = person.start_share;
  parameters(first) = person.curve.first;
  if (parameters.size() > second) parameters(second) = person.curve.second;
  return parameters;
}

SlidingPersonModel fitted_person(CurveFamily family, const FitVector& parameters) {
  return {.curve = {family, parameters(first), parameters.size() > second ? parameters(second) : 0.0},
          .bias_deg = parameters(bias),
          .habit_deg = parameters(habit),
          .start_deg = parameters(start),
          .start_share = parameters(start_share),
          .log_gain = parameters(log_gain),
          .delay_s = parameters(delay),
          .goal_delay_s = parameters(goal_delay)};
}

SlideJacobian slide_jacobian(const SlideTrack& track, const SlidingPersonModel& person) {
  const FitVector middle = fit_vector(person);
  SlideJacobian jacobian(slide_parts, middle.size());
  for (int i = 0; i < middle.size(); ++i)
    jacobian.col(i) = fit_derivative(person.curve.family, middle, i, [&](const SlidingPersonModel& other) {
      return predicted_directions(track, other);
    });
  return jacobian;
}

CurveFit fit_curve(CurveFamily family, std::span<const SlideTrack> slides, const PartsMatrix& parts_covariance) {
  const PartsMatrix weight = fit_weight(parts_covariance);
  const Eigen::MatrixXd root = cholesky_factor(weight).transpose();
  const LeastSquares problem = problem_of(family, slides, root);
  LeastSquaresFit found;
  for (const double guess : first_guesses(family)) {
    const LeastSquaresFit tried = descend(problem, fit_vector({.curve = {family, first_weight, guess}}));
    if (found.parameters.size() == 0 || tried.misfit < found.misfit) found = tried;
  }

  CurveFit best;
  best.person = fitted_person(family, found.parameters);
  best.misfit = found.misfit;
  best.bic = best.misfit + static_cast<double>(found.parameters.size()) * logarithm(static_cast<double>(slides.size()));
  std::vector<Eigen::VectorXd> residuals;
  std::vector<Eigen::MatrixXd> derivatives;
  for (const SlideTrack& slide : slides) {
    best.residuals.emplace_back(slide.direction_deg - predicted_directions(slide, best.person));
    best.jacobians.push_back(slide_jacobian(slide, best.person));
    residuals.emplace_back(product(root, best.residuals.back()));
    derivatives.push_back(product(root, best.jacobians.back()));
  }
  best.information = information_of(derivatives, problem.prior_deviation);
  best.covariance =
      jackknife_covariance(residuals, derivatives, problem.prior_deviation) + common_covariance(best, slides, weight);
  return best;
}

}  // namespace hrt
