#include "core/person/model_fit.h"

#include <algorithm>

namespace hrt {
namespace {

double dot(const PlatePoint& a, const PlatePoint& b) { return a.right_mm * b.right_mm + a.away_mm * b.away_mm; }

}  // namespace

void ModelFit::add(const Tuning& tuning, const PlatePoint& innovation_mm, double nis) {
  nis_ += tuning.fit_sample_weight * (std::min(nis, tuning.max_counted_nis) - nis_);
  const double mean_square_mm2 = 0.5 * (dot(innovation_mm, innovation_mm) + dot(previous_mm_, previous_mm_));
  const double correlation = mean_square_mm2 > 0.0 ? dot(innovation_mm, previous_mm_) / mean_square_mm2 : 0.0;
  correlation_ += tuning.fit_sample_weight * (correlation - correlation_);
  previous_mm_ = innovation_mm;
}

bool ModelFit::holds(const Tuning& tuning) const {
  return nis_ < tuning.misfit_nis && (correlation_ < tuning.misfit_correlation || nis_ < tuning.min_correlated_nis);
}

}  // namespace hrt
