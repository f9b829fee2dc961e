// Assumptions of a session about the plate, the tracker and the user.
#pragma once

#include <cstdint>

#include "core/person/person_model.h"
#include "core/plate/plate_frame.h"
#include "core/retargeter_config.h"
#include "scene/geometry.h"

namespace hrt::plugin {

/// Range of a value that set-ups or reaches estimate; equal to the range of its field in hrt_session_config.
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
  reach,   ///< used in the same reach only
  carried  ///< also used in the following reaches
};

struct PlateSurface {
  double radius_m = 0.0;         ///< positive
  double lift_height_m = 0.015;  ///< positive; a finger that is tracked higher than this above the plate is lifted
};

/// Pose and surface of the plate, and position of the skin on the tracked finger. Lengths are in metres.
struct PlateMount {
  Pose pose;           ///< pose of the plate in the engine's world; does not turn with the ridges
  Transform frame;     ///< directions and centre of the plate in the world; set_pose() derives them from the pose
  double scale = 1.0;  ///< length in the world of 1 m on the plate, 0.5 to 2
  PlateSurface surface;
  Vec3 fingertip_offset_m;  ///< vector from the tracked joint to the skin, in the joint's axes; 0: unknown

  void set_pose(const Pose& of_plate) {
    pose = of_plate;
    frame = plate_frame(of_plate);
  }
};

/// Source of the plate's pose, and requirements on it.
struct PlateRegistration {
  bool made = false;  ///< true if the pose is from a registration that was made or checked at `time_ns`
  std::int64_t time_ns = 0;
  std::int64_t max_age_ns = 0;  ///< 0: not checked
  double max_sd_deg = 0.0;      ///< largest allowed SD of the bearing of a real target; 0: not checked
};

struct SessionModel {
  RetargeterConfig control;       ///< control.touched.home: start_m in the plane of the plate
  bool guides_to_arrival = true;  ///< true: HRT_GUIDANCE_ARRIVAL; false: HRT_GUIDANCE_FIXED_DIRECTION
  Adaptation adaptation = Adaptation::carried;
  bool knows_person = false;  ///< true: control.person was estimated; false: forget_person() has set it
  PlateMount mount;
  Vec3 start_m;  ///< start of reaches, in plate coordinates
  PlateRegistration registration;
};

bool is_valid(const SessionModel& model);

bool have_same_pose(const PlateMount& a, const PlateMount& b);

inline const PlatePoint& start_of(const SessionModel& model) { return model.control.touched.home; }

/// Computes control.person from the model's tactile weight, its SD and the bias: the prior of an unknown person or,
/// with Adaptation::off, a person with exactly these values.
void forget_person(SessionModel* model);

/// Resets the parameters of the user to those of `defaults`, and calls forget_person().
void forget_user(const SessionModel& defaults, SessionModel* model);

/// Sets the belief about the user, and derives the model's tactile weight and its SD from the belief.
void know_person(const PersonBelief& belief, SessionModel* model);

/// Returns the illusion curve of the user for a path of this length: linear if the person is unknown.
Illusion illusion_of(const SessionModel& model, double distance_mm);

void forget_contacts(SessionModel* model);

/// Completes `profile`, which is the model `session` with a profile read into it. Restores the pose of `session` and,
/// if the profile has no contacts, the contacts of `session`. Discards contacts of a profile with another pose, and
/// adds tracker drift to contacts of a profile with the same pose.
void take_contacts_of_profile(const SessionModel& session, bool has_contacts, SessionModel* profile);

/// Converts the covariance of the plate's pose from and to metres, the unit of files and of the C interface.
FrameCovariance frame_of_m(const Eigen::Matrix3d& covariance_m);
Eigen::Matrix3d frame_in_m(const FrameCovariance& covariance);

}  // namespace hrt::plugin
