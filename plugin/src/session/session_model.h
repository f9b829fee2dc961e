// Assumptions of a session about the plate, the tracker and the user, in core types.
#pragma once

#include <cstdint>

#include "core/person/illusion.h"
#include "core/plate/plate_frame.h"
#include "core/retargeter_config.h"
#include "scene/plate_coordinates.h"

namespace hrt::plugin {

/// Ranges of what set-ups and reaches find. Each value is checked again when a recording is replayed.
struct Range {
  double low, high;
  bool has(double value) const { return value >= low && value <= high; }
};
inline constexpr Range weight_range{0.001, 0.499}, weight_sd_range{0.001, 0.49}, bias_range_deg{-45.0, 45.0};
inline constexpr Range motion_bound_range_deg{1.0, 89.0}, noise_range_mm{0.0, 100.0}, scale_range{0.5, 2.0};
inline constexpr Range position_range_m{-1000.0, 1000.0}, fingertip_range_m{-1.0, 1.0};

/// Use of the estimates from a reach.
enum class Adaptation : std::uint8_t {
  off,     ///< the estimates are not used
  reach,   ///< within that reach
  carried  ///< carried to the following reaches
};

/// Pose of the plate, and the location of a tracked finger on it. Lengths are in metres, as in scenes.
struct PlateMount {
  Pose pose;           ///< pose of the plate in the engine's world; does not turn with the ridges
  double scale = 1.0;  ///< length in the world of 1 m on the plate, 0.5 to 2
  PlateSurface surface;
  Vec3 fingertip_offset_m;  ///< from the tracked joint to the skin, in the joint's axes; 0: unknown
};

/// Source of the plate's pose, and requirements on it.
struct PlateRegistration {
  bool made = false;  ///< the pose is from a registration, made at `time_ns`
  std::int64_t time_ns = 0;
  std::int64_t max_age_ns = 0;  ///< 0: not checked
  double max_sd_deg = 0.0;      ///< largest SD of the bearing of a real target; 0: not checked
};

struct SessionModel {
  /// Configuration of each reach. Its person is the prior of an unknown person unless `knows_person`; its touched.home
  /// is the start.
  RetargeterConfig control;
  bool guides_to_arrival = true;  ///< otherwise in a fixed direction; read if the plate turns
  Adaptation adaptation = Adaptation::carried;
  bool knows_person = false;  ///< control.person is from reaches or a calibration
  PlateMount mount;
  Vec3 start_m;  ///< start of reaches, in plate coordinates
  PlateRegistration registration;
};

bool is_valid(const SessionModel& model);

/// The start of reaches in the plane of the plate.
inline const PlatePoint& start_of(const SessionModel& model) { return model.control.touched.home; }

/// The point of the plate above which a position in plate coordinates is.
PlatePoint plate_point(Vec3 position_m);

/// A position in the engine's world, or in plate coordinates, as seen from the plate.
FingerOnPlate locate(const PlateMount& mount, Vec3 world_position_m);
FingerOnPlate locate_on_plate(const PlateMount& mount, Vec3 plate_position_m);

/// The person becomes unknown; or, of an unknown person, the prior follows what the model says of them.
void forget_person(SessionModel* model);

/// The person becomes unknown, with the parameters that `defaults` has for one.
void forget_user(const SessionModel& defaults, SessionModel* model);

/// The person is known from now on.
void know_person(const PersonBelief& belief, SessionModel* model);

/// The illusion of the person on a path of this length: linear if the person is unknown.
Illusion illusion_of(const SessionModel& model, double distance_mm);

/// Forgets what contacts have shown of the registration.
void forget_contacts(SessionModel* model);

/// Contacts are of one registration: those that `next` only has from `before` are forgotten with another pose.
void forget_contacts_elsewhere(const SessionModel& before, SessionModel* next);

/// The model `profile`, which is `session` with a profile read into it, keeps the session's pose. Contacts of another
/// pose are forgotten; those of the same pose have drifted. A profile without contacts leaves the session's.
void take_contacts_of_profile(const SessionModel& session, bool has_contacts, SessionModel* profile);

/// A covariance of the plate's pose in metres, as files and the C interface have it.
FrameCovariance frame_of_m(const Eigen::Matrix3d& covariance_m);
Eigen::Matrix3d frame_in_m(const FrameCovariance& covariance);

}  // namespace hrt::plugin
