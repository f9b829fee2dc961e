// Contacts with real objects, from which the error of the plate's registration is estimated.
#pragma once

#include <optional>

#include "plugin/src/session/targets.h"

namespace hrt::plugin {

struct ContactReport {
  std::optional<TargetPlace> place;  ///< none: the near side of the reach's real target
  double sd_mm = 0.0;                ///< SD of the position; 0: the target's radius, or 10 mm if that is unknown
};

/// Computes the contact of a reach from `start` to `real` whose finger was tracked at `finger`. Fails if the contact
/// is too near to the configured start, or too far from the tracked finger.
hrt_result check_contact(const SessionModel& model, const ContactReport& report, const PlatePoint& start,
                         const TargetPlace& real, const FingerPosition& finger, Contact* out);

/// Updates the correction of the registration, and the estimated bias of the user, from a contact. Discards the contact
/// if the new correction is not valid.
void learn_contact(const Contact& contact, SessionModel* model);

}  // namespace hrt::plugin
