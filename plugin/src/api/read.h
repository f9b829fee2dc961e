// Conversion of the structs of the C interface to core types. Each function checks all fields that it reads, and fails
// naming the first one that is out of range.
#pragma once

#include "haptic_retargeting/setup.h"
#include "plugin/src/session/session.h"

namespace hrt::plugin {

/// Fails, naming `field`, unless it is a unit quaternion.
hrt_result check_rotation(const char* field, const double (&rotation)[4]);

hrt_result read(const hrt_session_config& given, SessionModel* out);
/// Null means the defaults.
hrt_result read_or_default(const hrt_session_config* given, SessionModel* out);

hrt_result read(const hrt_target_config& given, Target* out);

/// The finger on the plate, as contacts correct it.
hrt_result read(const SessionModel& model, const hrt_sample& given, FingerSample* out);
/// The finger as the part of a set-up that is in progress needs it.
hrt_result read(const SessionModel& model, SetupPart part, const hrt_sample& given, SetupSample* out);

hrt_result read(const hrt_reach_config& given, ReachRequest* out);
hrt_result read(const hrt_contact& given, ContactReport* out);
hrt_result read(const hrt_setup_config& given, SetupConfig* out);

}  // namespace hrt::plugin
