#include "core/calibrate/curve_fit.h"

#include <algorithm>
#include <array>

#include "core/math/elementary.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

struct Prior {
  double mean;
  double deviation;
};

// SD of the error of the steering law in each part: large at the start, where people differ, and small at the end,
// where the direction has settled.
constexpr std::array<double, slide_parts> law_deviation_deg{2.0, 0.7, 0.25, 0.1};
// Fraction of that SD that is common to all slides of a person, at a plate angle of common_angle_deg.
constexpr double common_fraction = 0.45;
constexpr double common_angle_deg = 60.0;
// Limits: k from 1.6 to 37 /s, D up to 0.2 s, L within 0.15 s (slide_model.h).
constexpr double min_log_gain = 0.5;
constexpr double max_log_gain = 3.6;
constexpr double max_delay_s = 0.2;
constexpr double max_goal_delay_s = 0.15;
// Limits of the slope of the curve, of its change at a knot times the spacing of the knots (illusion_curve.h), and of
// eta and lambda (slide_model.h): wider than the ranges in people.
constexpr double min_slope = -0.2;
constexpr double max_slope = 0.8;
constexpr double max_bend_deg = 20.0;
constexpr double max_drift = 0.6;
constexpr double min_start_share = -0.5;
constexpr double max_start_share = 1.5;
// Slope of the straight curve with which the first descent begins. Times the spacing, this is the prior SD of the
// changes of slope in the first descent.
constexpr double first_slope = 0.18;
// In the second descent, the prior SD of the change of slope at a knot is the slope or the weight of the first curve,
// whichever is larger, and at least this.
constexpr double min_steepness = 0.02;

// Step of the one-sided differences, relative to fit_step().
constexpr double rough_step_fraction = 1e-4;

// One Jacobian takes 0.2 ms on a core of 3 GHz.
constexpr std::size_t jacobians_per_step = 2;

enum Parameter { bias, habit, start, log_gain, delay, goal_delay, start_share, drift, slope, bends };
static_assert(bends + curve_bends == fit_parameters);

FitVector clamped(FitVector parameters) {
  for (const int i : {bias, habit, start})
    parameters(i) = std::clamp(parameters(i), -max_direction_deg, max_direction_deg);
  parameters(log_gain) = std::clamp(parameters(log_gain), min_log_gain, max_log_gain);
  parameters(delay) = std::clamp(parameters(delay), 0.0, max_delay_s);
  parameters(goal_delay) = std::clamp(parameters(goal_delay), -max_goal_delay_s, max_goal_delay_s);
  parameters(start_share) = std::clamp(parameters(start_share), min_start_share, max_start_share);
  parameters(drift) = std::clamp(parameters(drift), -max_drift, max_drift);
  parameters(slope) = std::clamp(parameters(slope), min_slope, max_slope);
  for (int i = bends; i < fit_parameters; ++i) parameters(i) = std::clamp(parameters(i), -max_bend_deg, max_bend_deg);
  return parameters;
}

// The priors bound parameters that the slides hardly determine.
void set_prior(LeastSquares* problem) {
  // In the order of Parameter.
  constexpr std::array<Prior, bends> priors{{{0.0, 100.0},
                                             {0.0, 20.0},
                                             {0.0, 10.0},
                                             {2.2, 1.0},
                                             {0.06, 0.2},
                                             {0.0, 0.05},
                                             {0.0, 0.3},
                                             {0.0, 0.1},
                                             {0.2, 1.0}}};
  problem->prior_mean.resize(fit_parameters);
  problem->prior_deviation.resize(fit_parameters);
  for (int i = 0; i < fit_parameters; ++i) {
    const Prior expected =
        i < bends ? priors[static_cast<std::size_t>(i)] : Prior{0.0, first_slope * IllusionCurve::spacing_deg};
    problem->prior_mean(i) = expected.mean;
    problem->prior_deviation(i) = expected.deviation;
  }
}

SlideJacobian rough_jacobian(const SlideTrack& track, const SlidingPersonModel& person) {
  const FitVector middle = fit_vector(person);
  const SlideDirections here_deg = predicted_directions(track, person);
  SlideJacobian jacobian(slide_parts, middle.size());
  for (int i = 0; i < middle.size(); ++i) {
    FitVector above = middle;
    const double step = rough_step_fraction * fit_step(i);
    above(i) += step;
    jacobian.col(i) = (predicted_directions(track, fitted_person(above)) - here_deg) / step;
  }
  return jacobian;
}

// Residuals and derivatives are multiplied by `root`; root^T root is the weight matrix.
LeastSquares problem_of(std::span<const SlideTrack> slides, const Eigen::MatrixXd& root) {
  LeastSquares problem;
  set_prior(&problem);
  problem.clamped = clamped;
  problem.groups = slides.size();
  problem.residuals = [=](std::size_t i, const FitVector& parameters) -> Eigen::VectorXd {
    return product(root, slides[i].direction_deg - predicted_directions(slides[i], fitted_person(parameters)));
  };
  problem.derivatives = [=](std::size_t i, const FitVector& parameters) {
    return product(root, rough_jacobian(slides[i], fitted_person(parameters)));
  };
  return problem;
}

// Inverse of the sum of a slide's covariance and the variances of the steering law's error.
PartsMatrix fit_weight(const PartsMatrix& parts_covariance) {
  PartsMatrix covariance = parts_covariance;
  for (int part = 0; part < slide_parts; ++part)
    covariance(part, part) += law_deviation_deg[part] * law_deviation_deg[part];
  return inverse(covariance);
}

SlideJacobian slide_jacobian(const SlideTrack& track, const SlidingPersonModel& person) {
  const FitVector middle = fit_vector(person);
  SlideJacobian jacobian(slide_parts, middle.size());
  for (int i = 0; i < middle.size(); ++i)
    jacobian.col(i) =
        fit_derivative(middle, i, [&](const SlidingPersonModel& other) { return predicted_directions(track, other); });
  return jacobian;
}

// Covariance of the parameters due to errors of the steering law that are common to all slides.
FitMatrix common_covariance(const CurveFit& fit, std::span<const SlideTrack> slides, const PartsMatrix& weight) {
  const FitMatrix inverted = inverse(fit.information);
  SlideJacobian tilted = SlideJacobian::Zero(slide_parts, inverted.cols());
  for (std::size_t i = 0; i < slides.size(); ++i)
    tilted += (slides[i].plate_deg / common_angle_deg) * product(weight, fit.jacobians[i]);
  for (int part = 0; part < slide_parts; ++part) tilted.row(part) *= common_deviation_deg(part);
  FitMatrix common = congruence(product(tilted, inverted), PartsMatrix::Identity());
  return common;
}

}  // namespace

double common_deviation_deg(int part) { return common_fraction * law_deviation_deg[static_cast<std::size_t>(part)]; }

double fit_step(int parameter) {
  constexpr std::array<double, bends> steps{0.05, 0.05, 0.05, 0.02, 0.003, 0.003, 0.01, 0.01, 0.002};
  return parameter < bends ? steps[static_cast<std::size_t>(parameter)] : 0.03;
}

FitVector fit_vector(const SlidingPersonModel& person) {
  FitVector parameters(fit_parameters);
  parameters(bias) = person.bias_deg;
  parameters(habit) = person.habit_deg;
  parameters(start) = person.start_deg;
  parameters(log_gain) = person.log_gain;
  parameters(delay) = person.delay_s;
  parameters(goal_delay) = person.goal_delay_s;
  parameters(start_share) = person.start_share;
  parameters(drift) = person.curve_drift;
  parameters(slope) = curve_slope(person.curve);
  const CurveBends bend_deg = bends_of(person.curve);
  for (int i = 0; i < curve_bends; ++i) parameters(bends + i) = bend_deg[static_cast<std::size_t>(i)];
  return parameters;
}

SlidingPersonModel fitted_person(const FitVector& parameters) {
  CurveBends bend_deg{};
  for (int i = 0; i < curve_bends; ++i) bend_deg[static_cast<std::size_t>(i)] = parameters(bends + i);
  return {.curve = bent_curve(parameters(slope), bend_deg),
          .bias_deg = parameters(bias),
          .habit_deg = parameters(habit),
          .curve_drift = parameters(drift),
          .start_deg = parameters(start),
          .start_share = parameters(start_share),
          .log_gain = parameters(log_gain),
          .delay_s = parameters(delay),
          .goal_delay_s = parameters(goal_delay)};
}

CurveFitting::CurveFitting(std::span<const SlideTrack> slides, const PartsMatrix& parts_covariance)
    : slides_(slides),
      weight_(fit_weight(parts_covariance)),
      root_(cholesky_factor(weight_).transpose()),
      problem_(problem_of(slides, root_)) {
  descent_.emplace(problem_, fit_vector({.curve = bent_curve(first_slope)}));
}

bool CurveFitting::step() {
  switch (stage_) {
    case Stage::wide_prior:
      if (descent_->step()) narrow_prior();
      return false;
    case Stage::narrow_prior:
      if (descent_->step()) take_parameters();
      return false;
    case Stage::derivatives:
      if (fit_.jacobians.size() < slides_.size()) {
        add_derivatives();
        return false;
      }
      find_covariance();
  }
  return true;
}

void CurveFitting::narrow_prior() {
  const FitVector found = descent_->fit().parameters;
  const IllusionCurve curve = fitted_person(found).curve;
  const double steepness = std::max({curve_slope(curve), curve_weight(curve), min_steepness});
  problem_.prior_deviation.tail(curve_bends).setConstant(steepness * IllusionCurve::spacing_deg);
  descent_.emplace(problem_, found);
  stage_ = Stage::narrow_prior;
}

void CurveFitting::take_parameters() {
  const FitVector& found = descent_->fit().parameters;
  fit_.person = fitted_person(found);
  fit_.prior_deviation = problem_.prior_deviation;
  fit_.prior_off = (problem_.prior_mean - found).cwiseQuotient(problem_.prior_deviation);
  stage_ = Stage::derivatives;
}

void CurveFitting::add_derivatives() {
  for (std::size_t i = 0; i < jacobians_per_step && fit_.jacobians.size() < slides_.size(); ++i) {
    const SlideTrack& slide = slides_[fit_.jacobians.size()];
    fit_.residuals.emplace_back(slide.direction_deg - predicted_directions(slide, fit_.person));
    fit_.jacobians.push_back(slide_jacobian(slide, fit_.person));
  }
}

void CurveFitting::find_covariance() {
  std::vector<Eigen::VectorXd> residuals;
  std::vector<Eigen::MatrixXd> derivatives;
  for (std::size_t i = 0; i < slides_.size(); ++i) {
    residuals.emplace_back(product(root_, fit_.residuals[i]));
    derivatives.push_back(product(root_, fit_.jacobians[i]));
  }
  fit_.information = information_of(derivatives, problem_.prior_deviation);
  fit_.effective = static_cast<double>(fit_parameters) -
                   inverse(fit_.information).diagonal().cwiseQuotient(problem_.prior_deviation.cwiseAbs2()).sum();
  fit_.covariance = jackknife_covariance(residuals, derivatives, problem_.prior_deviation) +
                    common_covariance(fit_, slides_, weight_);
}

}  // namespace hrt
