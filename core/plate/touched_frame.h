// Correction of the tracker's frame by contacts. When the finger touches a real object, its true position `place` is
// known, and its tracked position `seen` shows the error of the frame:
//
//   true - h = (1 + D) (seen - h),   place - seen = D (seen - h) + noise of both positions
//
// where h is the start of reaches. The matrix D describes rotation, scale and shear of the frame, and includes the
// effect of a shift at the targets. Its four entries are Gaussian. Their prior SD is 2 %, plus the error of the
// registration at the target. Each contact is a Kalman update of D. Between contacts the SD of D grows by 0.2 %,
// because trackers drift.
//
// Reaches show only the sum of the person's bias and the rotation of the frame, which the estimator attributes to the
// bias. When D changes, the bias therefore changes by the rotation of the corrected positions.
#pragma once

#include <Eigen/Core>

#include "core/plate/frame_error.h"
#include "core/plate/plate_frame.h"

namespace hrt {

struct TouchedFrame {
  PlatePoint home;                                       ///< h: start of reaches
  Eigen::Matrix2d stretch = Eigen::Matrix2d::Zero();     ///< D: rows and columns right, away
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< covariance of D row by row; zero: no contact yet

  bool known() const { return covariance(0, 0) > 0.0; }
};

/// True if its numbers are finite, entries of D within 0.5, and the covariance zero or positive definite.
bool is_valid(const TouchedFrame& frame);

PlatePoint corrected(const TouchedFrame& frame, const PlatePoint& seen);

/// Estimated position of the finger, and the variance of a coordinate.
struct FingerPosition {
  PlatePoint place;
  double variance_mm2;
};

/// Contact of the finger with an object.
struct Contact {
  PlatePoint finger;    ///< corrected position of the finger
  PlatePoint place;     ///< known position of the contact
  double variance_mm2;  ///< variance of their difference in each coordinate, > 0
};

/// Returns the frame after a contact. The prior of the first contact includes the uncertainty of `registered` at the
/// contact, which must not be at `home`. No heap.
TouchedFrame after_contact(const TouchedFrame& before, const FrameCovariance& registered, const Contact& contact);

/// Returns true if the deviation of a contact exceeds the 99.9 % quantile: it was at another object. Requires
/// before.known().
bool is_elsewhere(const TouchedFrame& before, const Contact& contact);

/// Returns the frame with the uncertainty after a drift of the tracker.
TouchedFrame drifted(const TouchedFrame& frame);

/// Returns the change of the bearing from home to the finger that the change of the frame causes.
double turned_deg(const TouchedFrame& before, const TouchedFrame& after, const PlatePoint& finger);

/// Returns the SD of the bearing from `start` of a finger whose estimated position is `target`: from contacts, or
/// before the first contact from the registration (frame_error.h).
double bearing_sd_deg(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& start,
                      const PlatePoint& target);

/// Returns true if contacts move `target` by more than the 99.9 % quantile of the prior: the registration is wrong.
bool contradicts(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& target);

}  // namespace hrt
