#include "samples/plate/tool/bend.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "samples/plate/tool/measure.h"

namespace hrt::plate {
namespace {

using Basis = Eigen::Matrix<double, 6, 1>;

Basis basis_at(double orientation_deg) {
  const double angle = orientation_deg * std::numbers::pi / 180.0;
  return {1.0, angle, std::cos(angle), std::sin(angle), std::cos(2.0 * angle), std::sin(2.0 * angle)};
}

}  // namespace

std::vector<double> fit_bend(const std::vector<SweepPoint>& sweep, double min_deg, double max_deg, int count) {
  Eigen::MatrixXd rows(sweep.size(), 7);
  Eigen::VectorXd off_deg(sweep.size());
  for (Eigen::Index i = 0; i < off_deg.size(); ++i) {
    const SweepPoint& point = sweep[static_cast<std::size_t>(i)];
    rows.row(i) << basis_at(point.commanded_deg).transpose(), point.upwards ? -0.5 : 0.5;
    off_deg[i] = point.reported_deg - point.commanded_deg;
  }
  const Basis fitted = rows.colPivHouseholderQr().solve(off_deg).head<6>();
  std::vector<double> bend_deg;
  for (int i = 0; i < count; ++i) {
    const double reported_deg = min_deg + (max_deg - min_deg) * i / (count - 1);
    double found_deg = 0.0;  // nonlinearity at the orientation that is reported as reported_deg
    for (int k = 0; k < 3; ++k) found_deg = fitted.dot(basis_at(reported_deg - found_deg));
    bend_deg.push_back(found_deg);
  }
  return bend_deg;
}

}  // namespace hrt::plate
