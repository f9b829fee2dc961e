// Correction of the tracker's frame by contacts. When the finger touches a real object, the finger's true position
// `place` is known, and its tracked position `seen` shows the error of the frame:
//
//   true - h = (1 + D) (seen - h),   place - seen = D (seen - h) + noise of both positions
//
// where h is the configured start of reaches. The matrix D describes rotation, scale and shear of the frame, and, near
// the targets, also a shift. D is unknown until the first contact, or until a caller sets its covariance. The prior
// of the four entries of an unknown D is Gaussian, with the SD 0.02 and, in addition, the uncertainty of the
// registration. Each contact is a Kalman update of D. Between contacts the variance of each entry grows by 0.002^2,
// because trackers drift.
//
// Reaches show only the sum of the person's bias and the rotation of the frame; the estimator attributes this sum to
// the bias. When D changes, the estimated bias therefore changes by the rotation of the corrected positions.
#pragma once

#include <Eigen/Core>

#include "core/plate/frame_error.h"
#include "core/plate/plate_frame.h"

namespace hrt {

struct TouchedFrame {
  PlatePoint home;                                       ///< h: configured start of reaches
  Eigen::Matrix2d stretch = Eigen::Matrix2d::Zero();     ///< D: rows and columns right, away
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< covariance of D row by row; zero: D is unknown

  bool known() const { return covariance(0, 0) > 0.0; }
};

/// Returns true if D and its covariance are finite, the entries of D within +-0.5, and the covariance zero or symmetric
/// and positive definite. Does not check `home`.
bool is_valid(const TouchedFrame& frame);

PlatePoint corrected(const TouchedFrame& frame, const PlatePoint& seen);

/// Estimated position of the finger, and the variance of each of its coordinates.
struct FingerPosition {
  PlatePoint place;
  double variance_mm2;
};

struct Contact {
  PlatePoint finger;    ///< estimated from tracked positions that the frame before the contact has corrected
  PlatePoint place;     ///< known position of the contact
  double variance_mm2;  ///< variance of each coordinate of `finger` - `place` without error of the frame, > 0
};

/// Returns the frame after a contact, whose `place` must not be `home`. If D is unknown, its prior includes the
/// uncertainty of the registration, `registered`, at `place`. Uses no heap.
TouchedFrame after_contact(const TouchedFrame& before, const FrameCovariance& registered, const Contact& contact);

/// Returns true if the contact was probably with another object: the difference of `place` and `finger` is beyond its
/// 99.9 % quantile. Requires before.known().
bool is_elsewhere(const TouchedFrame& before, const Contact& contact);

/// Returns the frame after a drift of the tracker, as between two contacts; unchanged if D is unknown.
TouchedFrame drifted(const TouchedFrame& frame);

/// Returns the angle, in degrees, by which the change of the frame rotates the bearing from home to the finger.
/// `finger`: position corrected by `before`.
double turned_deg(const TouchedFrame& before, const TouchedFrame& after, const PlatePoint& finger);

/// Returns the SD, in degrees, of the true bearing of a finger from `start`: by the covariance of D or, if D is
/// unknown, of the registration. `start`: a point of the plate, which is exact; `target`: corrected position of the
/// finger.
double bearing_sd_deg(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& start,
                      const PlatePoint& target);

/// Returns true if D moves `target` beyond the 99.9 % quantile of the prior: the registration is probably wrong. False
/// if D is unknown.
bool contradicts(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& target);

}  // namespace hrt
