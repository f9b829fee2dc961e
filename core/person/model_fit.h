// Fit statistics: how well the person filter predicts the positions that it then receives.
#pragma once

#include "core/person/tuning.h"
#include "core/plate/plate_frame.h"

namespace hrt {

/// Running means over about 20 positions in motion:
///
///   nis          normalised innovation squared; 2 if the model holds
///   correlation  of an innovation with the previous one; 0 if the model holds
class ModelFit {
 public:
  /// Adds a position, outliers included: its innovation and the innovation's NIS.
  void add(const Tuning& tuning, const PlatePoint& innovation_mm, double nis);

  double nis() const { return nis_; }

  /// True if the model describes the motion. Innovations far below the noise may correlate: a tracker without
  /// noise shows every trace of the person.
  bool holds(const Tuning& tuning) const;

 private:
  double nis_ = 2.0;
  double correlation_ = 0.0;
  PlatePoint previous_mm_{0.0, 0.0};
};

}  // namespace hrt
