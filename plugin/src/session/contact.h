// What contacts with real objects have shown of a session's registration.
#pragma once

#include "core/plate/touched_frame.h"
#include "haptic_retargeting/reach.h"

namespace hrt::plugin {

/// True if contact_covariance holds something, of the present registration.
bool knows_contacts(const hrt_session_config& config);

/// Leaves none.
void forget_contacts(hrt_session_config* config);

/// Fails, naming the field, unless contact_covariance is that of some contacts, or 0.
hrt_result check_contacts(const hrt_session_config& config);

TouchedFrame touched_of(const hrt_session_config& checked_config);
void write_touched(const TouchedFrame& frame, hrt_session_config* config);

/// Contacts are of one registration: those that `next` only has from `before` are forgotten with another
/// pose.
void forget_contacts_elsewhere(const hrt_session_config& before, hrt_session_config* next);

/// The same of a profile's configuration, which takes the session's pose. What stays has drifted. One without contacts
/// takes the session's.
void take_contacts_of_profile(const hrt_session_config& session, hrt_session_config* profile);

struct TouchedPlace {
  PlatePoint place;
  double sd_mm;
};

/// What a contact says in a reach from `start` to `real`. Fails naming the first field that is out of its
/// range.
hrt_result read_contact(const hrt_session_config& config, const hrt_contact& given, const PlatePoint& start,
                        const hrt_target_config& real, TouchedPlace* out);

/// A contact that can be believed, or fails.
hrt_result check_contact(const hrt_session_config& config, const TouchedPlace& touched, const SeenFinger& finger,
                         Contact* out);

/// The configuration after a contact.
hrt_session_config after_contact(const hrt_session_config& config, const Contact& contact);

}  // namespace hrt::plugin
