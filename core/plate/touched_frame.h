// Correction of the tracker's frame by contacts. A finger that meets a real object is at a known position:
//
//   true - h = (1 + D) (seen - h),   place - seen = D (seen - h) + noise of place and finger
//
// with the start h of reaches. D is the rotation, scale and shear of the frame, and the effect of a shift at the
// targets. Its four entries are Gaussian: the prior is 2 % an entry, plus the error of the registration at the target.
// Each contact is a Kalman update of D. Because trackers drift, the SD of D grows by 0.2 % between contacts.
//
// Reaches show only the sum of the person's bias and the rotation of the frame, and the estimator takes it as the bias.
// When D changes, the bias changes by the opposite rotation, so that the sum stays as observed.
#pragma once

#include <Eigen/Core>

#include "core/plate/frame_error.h"
#include "core/plate/plate_frame.h"

namespace hrt {

struct TouchedFrame {
  PlatePoint home;
  Eigen::Matrix2d stretch = Eigen::Matrix2d::Zero();     ///< D: rows and columns right, away
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< covariance of D row by row; zero: no contact yet

  bool known() const { return covariance(0, 0) > 0.0; }
};

/// True if its numbers are finite, entries of D within 0.5, and the covariance zero or positive definite.
bool is_valid(const TouchedFrame& frame);

/// Corrects a tracked position.
PlatePoint corrected(const TouchedFrame& frame, const PlatePoint& seen);

/// A place of the finger as estimated, with the variance of a coordinate.
struct SeenFinger {
  PlatePoint place;
  double variance_mm2;
};

/// A finger on an object.
struct Contact {
  PlatePoint finger;    ///< corrected position of the finger
  PlatePoint place;     ///< known position of the contact
  double variance_mm2;  ///< variance of their difference in each coordinate, > 0
};

/// The frame after a contact; before the first one it is as `registered` has it at the contact's place, which
/// is not `home`. No heap.
TouchedFrame after_contact(const TouchedFrame& before, const FrameCovariance& registered, const Contact& contact);

/// True if a contact is further off than the frame allows in 99.9 % of cases: it was at another object. Requires
/// before.known().
bool is_elsewhere(const TouchedFrame& before, const Contact& contact);

/// The frame when trackers have drifted, as between contacts.
TouchedFrame drifted(const TouchedFrame& frame);

/// Change of the bearing from home, by the frame's rotation, of a finger at the estimated position.
double turned_deg(const TouchedFrame& before, const TouchedFrame& after, const PlatePoint& finger);

/// SD of the bearing from `start` of a finger whose estimated position is `target`: by contacts, or before the first
/// one by the registration (frame_error.h).
double bearing_sd_deg(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& start,
                      const PlatePoint& target);

/// Contacts move this place by more than the prior allows in 99.9 %: the registration does not hold.
bool contradicts(const TouchedFrame& frame, const FrameCovariance& registered, const PlatePoint& target);

}  // namespace hrt
