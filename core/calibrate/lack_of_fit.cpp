#include "core/calibrate/lack_of_fit.h"

#include <algorithm>

#include "core/math/distributions.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

constexpr double rank_threshold = 1e-5;

// Residuals and derivatives of all slides, in units in which residuals are independent with one variance, and below
// them what the parameters' prior expects.
struct Whitened {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd derivatives;
  double degrees;  ///< of freedom that the fit leaves
};

// The probability of the share that `patterns` explain beyond the fit's own derivatives, and beyond what the
// steering law may be wrong by: `allowed_deg`, the standard deviation of each pattern's size.
double pattern_p(const Whitened& whitened, const Eigen::MatrixXd& patterns, const Eigen::VectorXd& allowed_deg) {
  const LinearFit without = linear_fit(whitened.derivatives, whitened.residuals, rank_threshold);
  Eigen::MatrixXd both(whitened.residuals.size(), whitened.derivatives.cols() + patterns.cols());
  both << whitened.derivatives, patterns;
  const LinearFit with = linear_fit(both, whitened.residuals, rank_threshold);
  const auto gained = static_cast<double>(with.rank - without.rank);
  const double degrees = whitened.degrees - gained;
  if (gained < 1.0 || degrees < 4.0) return 1.0;
  double allowed = 0.0;
  for (Eigen::Index i = 0; i < patterns.cols(); ++i)
    allowed += allowed_deg(i) * allowed_deg(i) * linear_fit(whitened.derivatives, patterns.col(i), rank_threshold).left;
  return f_tail((without.left - with.left) / (gained * with.left / degrees + allowed), gained, degrees);
}

}  // namespace

LackOfFit lack_of_fit(const CurveFit& fit, std::span<const SlideTrack> slides, std::span<const double> order,
                      const PartsMatrix& parts_covariance, int degree) {
  const auto count = static_cast<Eigen::Index>(slides.size());
  const PartsMatrix whitening = whitening_of(parts_covariance);
  const Eigen::Index rows = count * slide_parts + fit_parameters;
  Whitened whitened{Eigen::VectorXd(rows), Eigen::MatrixXd::Zero(rows, fit_parameters),
                    static_cast<double>(count * slide_parts) - fit.effective};
  whitened.residuals.tail(fit_parameters) = fit.prior_off;
  whitened.derivatives.bottomRows(fit_parameters).diagonal() = fit.prior_deviation.cwiseInverse();
  Eigen::MatrixXd angle = Eigen::MatrixXd::Zero(rows, degree - 1);
  Eigen::MatrixXd trend = Eigen::MatrixXd::Zero(rows, 2);
  Eigen::MatrixXd path = Eigen::MatrixXd::Zero(rows, Eigen::Index{2} * slide_parts);
  const double last = *std::max_element(order.begin(), order.end());
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Index row = i * slide_parts;
    whitened.residuals.segment<slide_parts>(row) = whitening * fit.residuals[k];
    whitened.derivatives.middleRows<slide_parts>(row) = product(whitening, fit.jacobians[k]);
    const Eigen::VectorXd powers = plate_powers(slides[k].plate_deg, degree);
    // The settled parts follow the curve; the first one is on its way.
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
  return {.angle_p = degree > 1 ? pattern_p(whitened, angle, Eigen::VectorXd::Constant(degree - 1, settled_deg)) : 1.0,
          .order_p = pattern_p(whitened, trend, Eigen::VectorXd::Zero(2)),
          .path_p = pattern_p(whitened, path, path_deg)};
}

}  // namespace hrt
