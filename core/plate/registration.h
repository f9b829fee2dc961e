// Registration: pose of the plate in the tracker's frame from touches of known marks.
//
//   touched_i = s R mark_i + p + noise,   least squares over R, p and, on request, s
//
// The closed form is Umeyama's (IEEE T-PAMI 13, 1991). Uses no heap. A frame that is rotated by 1 degree rotates every
// reach by 1 degree, and nothing in a reach reveals it. A constant offset between the tracked fingertip and the skin is
// part of the pose while the hand keeps its orientation; otherwise, fit_fingertip() determines the offset.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace hrt {

/// A touch of one mark, millimetres.
struct MarkTouch {
  Eigen::Vector3d mark_mm;     ///< in plate coordinates
  Eigen::Vector3d touched_mm;  ///< tracked position of the fingertip
};

struct RegistrationConfig {
  /// Assumed SD of each coordinate of a touch; the residuals correct it. Finite, > 0.
  double touch_sd_mm = 3.0;
  /// Fits the tracker's unit of length, which may be wrong by a factor of 0.5 to 2.
  bool fit_scale = false;
  /// Upward direction in the tracker's frame, of any length: the plate's face must point within 60 degrees of it. Zero:
  /// not checked, and confused left and right marks are accepted as a plate that lies upside down.
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
};

enum class RegistrationVerdict {
  holds,
  too_few,       ///< fewer than 3 touches, or none left over to leave out a bad one
  degenerate,    ///< marks within 1 cm of a line: the plate could turn about it
  inconsistent,  ///< no pose explains the touches, even without one of them
  upside_down,   ///< the face looks away from `up`: marks on opposite sides were confused
};

/// The fields below the verdict mean something if it holds. Of inconsistent touches and of a plate upside
/// down they are those of the fit to all, for its residuals.
struct Registration {
  RegistrationVerdict verdict = RegistrationVerdict::too_few;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< from plate coordinates to the tracker's
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();   ///< position of the plate's centre
  double scale = 1.0;                                      ///< 1 unless fitted
  /// Covariance of the rotation about the plate's axes (radians), the position (millimetres) and the scale; 0 for a
  /// scale that was not fitted.
  Eigen::Matrix<double, 7, 7> covariance = Eigen::Matrix<double, 7, 7>::Zero();
  double touch_sd_mm = 0.0;     ///< SD of a touch, from the assumed and the observed one by their weights
  double residual_mm = 0.0;     ///< root mean square distance of touches from their marks
  std::optional<int> left_out;  ///< the one touch that does not fit the others
};

/// Fits the pose to `touches`, all finite. With 5 touches or more one bad one is found and left out.
Registration fit_registration(const RegistrationConfig& config, std::span<const MarkTouch> touches);

/// Distance of a touch from where the registration has its mark.
double residual_mm(const Registration& registration, const MarkTouch& touch);

/// Result of comparing a later touch of a mark with an accepted registration.
struct RegistrationCheck {
  double distance_mm;  ///< distance of the touch from the expected position of the mark
  double allowed_mm;   ///< limit that 99.9 % of touches do not exceed while the registration is valid
  bool holds;
};
RegistrationCheck check_registration(const Registration& registration, const MarkTouch& touch);

/// A touch of one and the same mark with the tracked joint turned differently each time.
struct TurnedTouch {
  Eigen::Matrix3d joint_rotation;
  Eigen::Vector3d joint_mm;
};

/// From the joint to the skin that touches, in the joint's axes: joint + R offset is the same for all
/// touches.
struct FingertipOffset {
  Eigen::Vector3d offset_mm;
  Eigen::Vector3d sd_mm;
  bool known;  ///< each SD is below 5 mm: the joint was turned enough
};
FingertipOffset fit_fingertip(const RegistrationConfig& config, std::span<const TurnedTouch> touches);

}  // namespace hrt
