#include "core/calibrate/lack_of_fit.h"

#include <algorithm>

#include "core/math/distributions.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

constexpr double rank_threshold = 1e-5;

}  // namespace

LackOfFitTests::LackOfFitTests(const CurveFit& fit, std::span<const SlideTrack> slides, std::span<const double> order,
                               const PartsMatrix& parts_covariance, int degree) {
  const auto count = static_cast<Eigen::Index>(slides.size());
  const PartsMatrix whitening = whitening_of(parts_covariance);
  const Eigen::Index rows = count * slide_parts + fit_parameters;
  residuals_.resize(rows);
  residuals_.tail(fit_parameters) = fit.prior_off;
  derivatives_ = Eigen::MatrixXd::Zero(rows, fit_parameters);
  derivatives_.bottomRows(fit_parameters).diagonal() = fit.prior_deviation.cwiseInverse();
  residual_freedom_ = static_cast<double>(count * slide_parts) - fit.effective;
  Eigen::MatrixXd angle = Eigen::MatrixXd::Zero(rows, degree - 1);
  Eigen::MatrixXd trend = Eigen::MatrixXd::Zero(rows, 2);
  Eigen::MatrixXd path = Eigen::MatrixXd::Zero(rows, Eigen::Index{2} * slide_parts);
  const double last = *std::max_element(order.begin(), order.end());
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Index row = i * slide_parts;
    residuals_.segment<slide_parts>(row) = whitening * fit.residuals[k];
    derivatives_.middleRows<slide_parts>(row) = product(whitening, fit.jacobians[k]);
    const Eigen::VectorXd powers = plate_powers(slides[k].plate_deg, degree);
    // The later parts have settled on the curve; the first one counts half.
    const SlideDirections settled = whitening * SlideDirections(0.5, 1.0, 1.0, 1.0);
    for (int power = 2; power <= degree; ++power) angle.block<slide_parts, 1>(row, power - 2) = settled * powers(power);
    const double when = 2.0 * order[k] / std::max(last, 1.0) - 1.0;
    trend.block<slide_parts, 1>(row, 0) = settled * when;
    trend.block<slide_parts, 1>(row, 1) = settled * (when * powers(1));
    path.block<slide_parts, slide_parts>(row, 0) = whitening;
    path.block<slide_parts, slide_parts>(row, slide_parts) = whitening * powers(1);
  }
  const double settled_deg = common_deviation_deg(slide_parts - 1);
  Eigen::VectorXd path_deg(2 * slide_parts);
  for (int part = 0; part < slide_parts; ++part)
    path_deg(part) = path_deg(slide_parts + part) = common_deviation_deg(part);
  patterns_[0] = {angle, Eigen::VectorXd::Constant(degree - 1, settled_deg)};
  patterns_[1] = {trend, Eigen::VectorXd::Zero(2)};
  patterns_[2] = {path, path_deg};
}

bool LackOfFitTests::step() {
  Pattern& pattern = patterns_[pattern_];
  if (next_column_ < pattern.columns.cols()) {
    const double left = linear_fit(derivatives_, pattern.columns.col(next_column_), rank_threshold).left;
    pattern.allowed += pattern.allowed_deg(next_column_) * pattern.allowed_deg(next_column_) * left;
    ++next_column_;
    return false;
  }
  pattern.p = pattern_p(pattern);
  next_column_ = 0;
  return ++pattern_ == patterns_.size();
}

// p-value of the sum of squares that the pattern explains beyond the fit's parameters and `allowed`.
double LackOfFitTests::pattern_p(const Pattern& pattern) const {
  const LinearFit without = linear_fit(derivatives_, residuals_, rank_threshold);
  Eigen::MatrixXd both(residuals_.size(), derivatives_.cols() + pattern.columns.cols());
  both << derivatives_, pattern.columns;
  const LinearFit with = linear_fit(both, residuals_, rank_threshold);
  const auto gained = static_cast<double>(with.rank - without.rank);
  const double degrees = residual_freedom_ - gained;
  if (gained < 1.0 || degrees < 4.0) return 1.0;
  return f_tail((without.left - with.left) / (gained * with.left / degrees + pattern.allowed), gained, degrees);
}

}  // namespace hrt
