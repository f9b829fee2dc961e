#include "core/curve_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/exponential.h"

namespace hrt {
namespace {

constexpr int most_passes = 25;
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
// A residual grows by this factor at most when its slide is left out.
constexpr double most_growth = 5.0;
constexpr double least_log_gain = 0.5;
constexpr double most_log_gain = 3.6;

enum Parameter { bias, habit, start, log_gain, delay, goal_delay, start_share, first, second };

struct Limits {
  double least;
  double most;
};

Limits limits(CurveFamily family, int parameter) {
  switch (parameter) {
    case log_gain:
      return {least_log_gain, most_log_gain};
    case delay:
      return {0.0, 0.2};
    case goal_delay:
      return {-0.15, 0.15};
    case start_share:
      return {-0.5, 1.5};
    case first:
      return {-0.2, 0.8};
    case second: {
      const CurveRange range = second_range(family);
      return {range.least, range.most};
    }
    default:
      return {-60.0, 60.0};
  }
}

FitVector clamped(CurveFamily family, FitVector parameters) {
  for (int i = 0; i < parameters.size(); ++i) {
    const Limits range = limits(family, i);
    parameters(i) = std::clamp(parameters(i), range.least, range.most);
  }
  return parameters;
}

Prior prior(CurveFamily family, int parameter) {
  constexpr std::array<Prior, second> priors{
      {{0.0, 100.0}, {0.0, 20.0}, {0.0, 10.0}, {2.2, 1.0}, {0.06, 0.2}, {0.0, 0.05}, {0.0, 0.3}, {0.2, 1.0}}};
  if (parameter < second) return priors[static_cast<std::size_t>(parameter)];
  const CurveRange range = second_range(family);
  return {0.5 * (range.least + range.most), range.most - range.least};
}

double prior_penalty(CurveFamily family, const FitVector& parameters) {
  double sum = 0.0;
  for (int i = 0; i < parameters.size(); ++i) {
    const Prior expected = prior(family, i);
    const double off = (parameters(i) - expected.mean) / expected.deviation;
    sum += off * off;
  }
  return sum;
}

FitMatrix prior_information(CurveFamily family, int count) {
  FitMatrix information = FitMatrix::Zero(count, count);
  for (int i = 0; i < count; ++i) {
    const Prior expected = prior(family, i);
    information(i, i) = 1.0 / (expected.deviation * expected.deviation);
  }
  return information;
}

double misfit_of(std::span<const SlideTrack> slides, const SlidingPersonModel& person,
                 const PartsMatrix& weight, std::vector<SlideDirections>* residuals) {
  double sum = 0.0;
  residuals->clear();
  for (const SlideTrack& slide : slides) {
    residuals->push_back(slide.direction_deg - predicted_directions(slide, person));
    sum += residuals->back().dot(weight * residuals->back());
  }
  return sum;
}

// Of a step on the way, where one-sided differences will do: `predicted_deg` is what the person's are.
SlideJacobian rough_jacobian(const SlideTrack& track, const SlidingPersonModel& person,
                             const SlideDirections& predicted_deg) {
  const CurveFamily family = person.curve.family;
  const FitVector middle = fit_vector(person);
  SlideJacobian jacobian(slide_parts, middle.size());
  for (int i = 0; i < middle.size(); ++i) {
    const double step = fit_derivative_step(family, i);
    FitVector above = middle;
    above(i) += step;
    jacobian.col(i) = (predicted_directions(track, fitted_person(family, above)) - predicted_deg) / step;
  }
  return jacobian;
}

// Levenberg and Marquardt's steps from `parameters`.
CurveFit descend(CurveFamily family, FitVector parameters, std::span<const SlideTrack> slides,
                 const PartsMatrix& weight) {
  CurveFit fit;
  const auto count = static_cast<int>(parameters.size());
  fit.person = fitted_person(family, parameters);
  fit.misfit = misfit_of(slides, fit.person, weight, &fit.residuals);
  double damping = 1e-3;
  std::vector<SlideDirections> tried;
  for (int pass = 0; pass < most_passes; ++pass) {
    FitMatrix information = FitMatrix::Zero(count, count);
    FitVector gradient = FitVector::Zero(count);
    for (std::size_t i = 0; i < slides.size(); ++i) {
      const SlideJacobian jacobian =
          rough_jacobian(slides[i], fit.person, slides[i].direction_deg - fit.residuals[i]);
      information += jacobian.transpose() * weight * jacobian;
      gradient += jacobian.transpose() * weight * fit.residuals[i];
    }
    information += prior_information(family, count);
    for (int i = 0; i < count; ++i) {
      const Prior expected = prior(family, i);
      gradient(i) -= (parameters(i) - expected.mean) / (expected.deviation * expected.deviation);
    }
    const double before = fit.misfit + prior_penalty(family, parameters);
    bool better = false;
    double gained = 0.0;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      FitMatrix damped = information;
      for (int i = 0; i < count; ++i) damped(i, i) *= 1.0 + damping;
      const FitVector next = clamped(family, parameters + damped.ldlt().solve(gradient));
      const SlidingPersonModel person = fitted_person(family, next);
      const double misfit = misfit_of(slides, person, weight, &tried);
      gained = before - misfit - prior_penalty(family, next);
      better = gained > 0.0;
      if (better) {
        parameters = next;
        fit.person = person;
        fit.misfit = misfit;
        fit.residuals = tried;
        damping = std::max(0.1 * damping, 1e-9);
      } else {
        damping *= 10.0;
      }
    }
    if (!better || gained < 1e-5) break;
  }
  return fit;
}

// The derivatives where the descent has come to.
void linearise(std::span<const SlideTrack> slides, const PartsMatrix& weight, CurveFit* fit) {
  fit->information =
      prior_information(fit->person.curve.family, static_cast<int>(fit_vector(fit->person).size()));
  for (const SlideTrack& slide : slides) {
    fit->jacobians.push_back(slide_jacobian(slide, fit->person));
    const SlideJacobian& jacobian = fit->jacobians.back();
    fit->information += jacobian.transpose() * weight * jacobian;
  }
}

// What the parameters may be off by: slides left out one at a time, to first order; the width of the priors;
// and what the steering law gets wrong in all slides alike.
FitMatrix covariance_of(const CurveFit& fit, std::span<const SlideTrack> slides, const PartsMatrix& weight) {
  const auto count = static_cast<int>(fit.information.rows());
  const FitMatrix inverse = fit.information.inverse();
  FitMatrix left_out = FitMatrix::Zero(count, count);
  FitMatrix common = FitMatrix::Zero(count, count);
  SlideJacobian tilted = SlideJacobian::Zero(slide_parts, count);
  for (std::size_t i = 0; i < slides.size(); ++i) {
    const SlideJacobian& jacobian = fit.jacobians[i];
    const PartsMatrix kept = PartsMatrix::Identity() - jacobian * inverse * jacobian.transpose() * weight;
    SlideDirections predicted_residual = kept.partialPivLu().solve(fit.residuals[i]);
    // A slide that alone shows a parameter leaves nothing to predict it from.
    const double growth = predicted_residual.norm() / (most_growth * fit.residuals[i].norm());
    if (growth > 1.0) predicted_residual /= growth;
    const FitVector change = inverse * (jacobian.transpose() * (weight * predicted_residual));
    left_out += change * change.transpose();
    tilted += (slides[i].plate_deg / common_angle_deg) * (weight * jacobian);
  }
  for (int part = 0; part < slide_parts; ++part) {
    const FitVector by_angle = inverse * tilted.row(part).transpose() * common_deviation_deg(part);
    common += by_angle * by_angle.transpose();
  }
  common(bias, bias) += habit_as_bias * habit_as_bias * fit.person.habit_deg * fit.person.habit_deg;
  const FitMatrix precision = prior_information(fit.person.curve.family, count);
  const auto n = static_cast<double>(slides.size());
  return left_out * ((n - 1.0) / n) + inverse * precision * inverse + common;
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

double common_deviation_deg(int part) {
  return common_share * law_deviation_deg[static_cast<std::size_t>(part)];
}

PartsMatrix fit_weight(const PartsMatrix& parts_covariance) {
  PartsMatrix covariance = parts_covariance;
  for (int part = 0; part < slide_parts; ++part)
    covariance(part, part) += law_deviation_deg[part] * law_deviation_deg[part];
  return covariance.inverse();
}

double fit_derivative_step(CurveFamily family, int parameter) {
  const bool angle = parameter == second && (family == CurveFamily::saturating ||
                                             family == CurveFamily::tanh || family == CurveFamily::dead_band);
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
  const CurveFamily family = person.curve.family;
  const FitVector middle = fit_vector(person);
  SlideJacobian jacobian(slide_parts, middle.size());
  for (int i = 0; i < middle.size(); ++i) {
    const double step = fit_derivative_step(family, i);
    FitVector above = middle;
    FitVector below = middle;
    above(i) += step;
    below(i) -= step;
    jacobian.col(i) = (predicted_directions(track, fitted_person(family, above)) -
                       predicted_directions(track, fitted_person(family, below))) /
                      (2.0 * step);
  }
  return jacobian;
}

CurveFit fit_curve(CurveFamily family, std::span<const SlideTrack> slides,
                   const PartsMatrix& parts_covariance) {
  const PartsMatrix weight = fit_weight(parts_covariance);
  CurveFit best;
  best.misfit = std::numeric_limits<double>::infinity();
  for (const double guess : first_guesses(family)) {
    const SlidingPersonModel person{.curve = {family, 0.18, guess}};
    CurveFit fit = descend(family, fit_vector(person), slides, weight);
    if (fit.misfit < best.misfit) best = std::move(fit);
  }
  linearise(slides, weight, &best);
  best.bic = best.misfit + static_cast<double>(first + curve_parameters(family)) *
                               logarithm(static_cast<double>(slides.size()));
  best.covariance = covariance_of(best, slides, weight);
  return best;
}

}  // namespace hrt
