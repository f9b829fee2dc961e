// A session's configuration: whether it can be used, and what the core makes of it.
#pragma once

#include "core/learning.h"
#include "core/plate/frame_error.h"
#include "core/plate/plate_frame.h"
#include "core/retargeter_config.h"
#include "haptic_retargeting/session.h"
#include "scene/plate_coordinates.h"

namespace hrt::plugin {

/// Fails naming the first field that is out of its range.
hrt_result check_session_config(const hrt_session_config& config);

/// Reads what a caller gave, null for the defaults, and checks it.
hrt_result read_session_config(const hrt_session_config* given, hrt_session_config* config);

/// True if person_mean and person_covariance hold something.
bool knows_person(const hrt_session_config& config);

/// True if what they hold can be believed of a person.
bool holds_belief(const hrt_session_config& config);

/// Leaves an unknown person.
void forget_person(hrt_session_config* config);
/// All that is known of the user.
void forget_user(hrt_session_config* config);

/// Writes what is believed of the person into person_mean, person_covariance, tactile_weight and its
/// deviation.
void write_person(const PersonBelief& belief, hrt_session_config* config);

/// What is believed of the person's illusion on a path of that length: linear unless person_covariance holds
/// something.
Illusion illusion_of(const hrt_session_config& config, double distance_mm);

/// Between plate_covariance and the core's matrix.
FrameCovariance frame_covariance_of(const hrt_session_config& config);
void write_frame_covariance(const FrameCovariance& covariance, hrt_session_config* config);

/// The point of the plate above which a position in plate coordinates is.
PlatePoint plate_point(Vec3 position_m);

/// A place in the engine's world as if plate_scale were 1, seen from a plate at `plate_position_m`.
Vec3 unscaled(const hrt_session_config& config, Vec3 plate_position_m, Vec3 world_position_m);

/// Of a checked configuration.
RetargeterConfig to_core(const hrt_session_config& checked_config);
PlatePoint start_of(const hrt_session_config& checked_config);
PlateSurface surface_of(const hrt_session_config& checked_config);
Pose plate_pose_of(const hrt_session_config& checked_config);

Pose to_pose(const double (&position_m)[3], const double (&rotation)[4]);

/// Fails, naming `field`, unless it is a unit quaternion.
hrt_result check_rotation(const char* field, const double (&rotation)[4]);

}  // namespace hrt::plugin
