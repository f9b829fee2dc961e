// Input and output of a set-up: samples of the finger, and instructions to the user and the plate.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/reach/finger_sample.h"

namespace hrt {

/// Parts of a set-up, as flags, in the order in which they are done: each may use the results of earlier parts.
enum SetupPart : std::uint32_t {
  setup_fingertip = 1,     ///< offset of the skin from the tracked joint
  setup_registration = 2,  ///< the plate's pose, from touches of marks
  setup_check = 4,         ///< check of the plate's pose by one touch, or by two if the first disagrees
  /// error of the tracker's frame about the start, from slides along guides, which are edges from the start to objects
  setup_guides = 8,
  setup_calibration = 16,  ///< parameters of the user, from slides
  setup_retest = 32,       ///< calibration again; its result is compared with the former values
};

enum class Instruction : std::uint32_t {
  wait,           ///< the plate rotates: lift the finger
  touch_mark,     ///< lift, and touch the mark at `SetupStep::place_mm`
  hold_still,     ///< hold the finger still on the mark
  rest_at_start,  ///< move to the start and rest
  slide,          ///< slide to `SetupStep::place_mm`, and rest there
  finish,         ///< no instruction: the fit of the part is due, or no part is pending
};

/// Problem of the last attempt.
enum class SetupProblem : std::uint32_t {
  none,
  too_fast,      ///< the slide took less than about 0.4 s
  too_slow,      ///< the slide took more than 8 s
  stopped,       ///< the finger stopped too early, or away from the requested end
  left_plate,    ///< the finger was lifted, or moved over the rim
  lost,          ///< the tracker lost the finger
  moved,         ///< the plate rotated during the slide
  plate,         ///< the plate did not reach the commanded orientation within 5 s
  disagrees,     ///< touches do not fit their marks, or slides are inconsistent
  upside_down,   ///< the touches fit a plate that is upside down or mirrored
  undetermined,  ///< the data do not determine the result: more data are needed
};

struct SetupSample {
  std::int64_t time_ns = 0;  ///< not earlier than in the previous sample
  /// Position of the finger in the tracker's frame, unless `in_plate`; nullopt: tracking is lost.
  std::optional<Eigen::Vector3d> tracked_mm;
  /// True: tracked_mm is in plate coordinates, so no registration is needed.
  bool in_plate = false;
  std::optional<Eigen::Matrix3d> joint_rotation;
  FingerSample on_plate;  ///< the sample in plate coordinates, by the present registration
  bool off_plate = false;
};

/// Diagnosis of a set-up that does not progress.
struct Observed {
  enum class Kind : std::uint32_t {
    none,
    no_finger,
    lifted,     ///< no sample has the finger on the plate
    time,       ///< sample times advance by only `first` ns per sample
    far_away,   ///< the finger is `first` mm from the requested position: the unit is probably wrong
    plate,      ///< the plate reports `first` degrees, but `second` degrees were commanded
    elsewhere,  ///< the finger is `first` mm from the requested position
    wrong_way,  ///< the finger slid towards `first` degrees; 0 is straight ahead
    no_rest,    ///< the finger did not rest at the requested position
  };
  Kind kind = Kind::none;
  double first = 0.0, second = 0.0;
};

struct SetupStep {
  SetupPart part;
  Instruction instruction;
  SetupProblem problem;
  int number;  ///< index of the mark, of the orientation of the finger, or of the object of a guide, from 0
  int done;    ///< completed touches or slides
  int of;      ///< requested touches or slides
  Eigen::Vector3d place_mm;  ///< requested position of the finger in plate coordinates
  double plate_orientation_deg;
  Observed observed;        ///< only Kind::none, time or wrong_way until 20 s after the last completed touch or slide
  std::string_view reason;  ///< reason of a rejected fit; valid until the set-up changes
};

/// A dropped part: the problem and reason of its last fit, or the problem of its last slides.
struct SetupDrop {
  SetupPart part;
  SetupProblem problem;
  Observed observed;
  std::string_view reason;
};

}  // namespace hrt
