// Conversion of the structs of the C interface to core types. A function that finds a field out of range fails, naming
// the field.
#pragma once

#include <string_view>

#include "haptic_retargeting/setup.h"
#include "plugin/src/session/session.h"

namespace hrt::plugin {

/// Fails, naming `field`, unless `rotation` is a quaternion (x, y, z, w) of length 1, within 0.001.
hrt_result check_rotation(const char* field, const double (&rotation)[4]);

/// Fails, naming `target` or else position_m, unless `position_m`, in plate coordinates, is within 10 m of the plate's
/// centre.
hrt_result check_distance_from_plate(Vec3 position_m, std::string_view target = {});

hrt_result read(const hrt_session_config& given, SessionModel* out);
hrt_result read_or_default(const hrt_session_config* given, SessionModel* out);

hrt_result read(const hrt_target_config& given, Target* out);

/// Converts a sample to plate coordinates, and corrects it by `touched`, which contacts with real objects determine.
hrt_result read(const PlateMount& mount, const TouchedFrame& touched, const hrt_sample& given, FingerSample* out);
/// Converts a sample to the coordinates that a part of a set-up needs.
hrt_result read(const SessionModel& model, SetupPart part, const hrt_sample& given, SetupSample* out);

hrt_result read(const hrt_reach_config& given, ReachRequest* out);
hrt_result read(const hrt_contact& given, ContactReport* out);
hrt_result read(const hrt_setup_config& given, SetupConfig* out);

}  // namespace hrt::plugin
