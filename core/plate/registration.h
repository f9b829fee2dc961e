// Registration: estimates the pose of the plate in the tracker's frame from touches of known marks, by least squares
// over rotation R, position p and, on request, scale s:
//
//   touched_i = s R mark_i + p + noise
//
// in closed form (Umeyama, IEEE T-PAMI 13, 1991). Plate coordinates have their origin in the centre, x to the right, y
// up along the normal, and z towards the user. A constant offset between the tracked fingertip and the skin is part of
// the pose while the hand keeps its orientation; otherwise fit_fingertip() determines the offset.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace hrt {

struct MarkTouch {
  Eigen::Vector3d mark_mm;     ///< in plate coordinates
  Eigen::Vector3d touched_mm;  ///< tracked position of the fingertip
};

struct RegistrationConfig {
  /// Assumed SD of each coordinate of a touch, finite, > 0. Registration::touch_sd_mm combines it with the residuals.
  double touch_sd_mm = 3.0;
  /// True: estimates the scale of the tracker's unit of length; an estimate outside 0.5 to 2 is replaced by 1.
  bool fit_scale = false;
  /// Upward direction in the tracker's frame, of any length: the plate's normal must be within 60 degrees of it. Zero:
  /// no check, so that swapped left and right marks are accepted as an upside-down plate.
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
};

enum class RegistrationVerdict {
  accepted,
  too_few,       ///< fewer than 3 touches
  degenerate,    ///< the second largest spread of the marks is below 1 cm (RMS), as near a line: a rotation is unknown
  inconsistent,  ///< no pose fits the touches, and no single wrong touch was found
  upside_down,   ///< the plate's normal is not upward: marks on opposite sides were probably swapped
};

/// Result of fit_registration(). With the verdict `accepted`, all fields are valid. With `inconsistent` or
/// `upside_down`, the fields describe the rejected fit, so that residual_mm() shows the disagreement.
struct Registration {
  RegistrationVerdict verdict = RegistrationVerdict::too_few;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< from plate coordinates to the tracker's
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();   ///< position of the plate's centre, in the tracker's frame
  double scale = 1.0;                                      ///< 1 unless fitted
  /// Covariance of rotation about the plate's axes (rad), position (mm) and scale; 0 for a scale that was not fitted.
  Eigen::Matrix<double, 7, 7> covariance = Eigen::Matrix<double, 7, 7>::Zero();
  double touch_sd_mm = 0.0;     ///< SD of a coordinate of a touch, from the assumed SD and the residuals
  double residual_mm = 0.0;     ///< root mean square distance of touches from their marks
  std::optional<int> left_out;  ///< index of an excluded touch that does not fit the others
};

/// Estimates the pose from finite `touches`. If one of at least 5 touches does not fit the others, excludes this touch.
Registration fit_registration(const RegistrationConfig& config, std::span<const MarkTouch> touches);

/// Returns the distance, in mm, of a touch from the expected position of its mark.
double residual_mm(const Registration& registration, const MarkTouch& touch);

/// Result of comparing a later touch of a mark with an accepted registration.
struct RegistrationCheck {
  double distance_mm;  ///< distance of the touch from the expected position of the mark
  double allowed_mm;   ///< limit that 99.9 % of touches do not exceed while the registration is valid
  bool holds;
};
RegistrationCheck check_registration(const Registration& registration, const MarkTouch& touch);

/// One of several touches of the same mark, between which the finger must be rotated.
struct TurnedTouch {
  Eigen::Matrix3d joint_rotation;  ///< R: from the tracked joint's axes to the tracker's
  Eigen::Vector3d joint_mm;        ///< tracked position of the joint
};

/// Offset from the joint to the skin in the joint's axes, such that joint + R offset is the same for all touches.
struct FingertipOffset {
  Eigen::Vector3d offset_mm;
  Eigen::Vector3d sd_mm;
  bool known;  ///< there were at least 3 touches, and each SD is below 5 mm: the rotations differed enough
};
FingertipOffset fit_fingertip(const RegistrationConfig& config, std::span<const TurnedTouch> touches);

}  // namespace hrt
