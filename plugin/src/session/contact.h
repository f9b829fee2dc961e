// Contacts with real objects, which measure the error of the plate's registration.
#pragma once

#include <optional>

#include "plugin/src/session/targets.h"

namespace hrt::plugin {

/// Report of a contact by the host.
struct ContactReport {
  std::optional<TargetPlace> place;  ///< none: the near side of the reach's real target
  double sd_mm = 0.0;                ///< SD of the position; 0: the radius of the real target
};

/// The contact of a reach from `start` to `real` in which the finger was seen at `finger`. Fails if it cannot be
/// believed.
hrt_result check_contact(const SessionModel& model, const ContactReport& report, const PlatePoint& start,
                         const TargetPlace& real, const SeenFinger& finger, Contact* out);

/// The model learns from a contact, unless the result would not be valid.
void learn_contact(const Contact& contact, SessionModel* model);

}  // namespace hrt::plugin
