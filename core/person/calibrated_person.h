// What is believed of a person after a calibration.
#pragma once

#include "core/math/interval.h"
#include "core/person/person_belief.h"

namespace hrt {

/// Of the controller's curve, the goal and the paths; all known.
struct CalibratedTraits {
  Interval weight;
  Interval curve;
  double weight_curve_correlation;
  Interval bias_deg;
  Interval habit_deg;
};

/// A person of whom these are known, and of the rest nothing. Deviations are at least what people change by,
/// and what a curve of another family costs.
PersonBelief calibrated_person(const CalibratedTraits& traits);

}  // namespace hrt
