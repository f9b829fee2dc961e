// Input and output of a set-up: samples of the finger, and instructions to the person and the plate.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/reach/finger_sample.h"

namespace hrt {

/// The parts of a set-up, as bits. They are done in this order: each uses the results of those before it.
enum SetupPart : std::uint32_t {
  setup_fingertip = 1,     ///< offset of the skin from the tracked joint
  setup_registration = 2,  ///< the plate's pose, from touches of marks
  setup_check = 4,         ///< check of that pose
  setup_guides = 8,        ///< the tracker's frame about the start, from slides along guides
  setup_calibration = 16,  ///< the person, from slides
  setup_retest = 32,       ///< as calibration, compared with the former values
};

enum class Instruction : std::uint32_t {
  wait,           ///< the plate turns: lift the finger
  touch_mark,     ///< lift, and touch the mark `SetupStep::number`
  hold_still,     ///< hold the finger still on the mark
  rest_at_start,  ///< move to the start and rest
  slide,          ///< slide to `SetupStep::place_mm`, and rest there
  finish,         ///< no instruction: the fit is due
};

/// Problem of the last attempt.
enum class SetupProblem : std::uint32_t {
  none,
  too_fast,      ///< the slide took less than 0.4 s or so
  too_slow,      ///< the slide took more than 8 s
  stopped,       ///< the finger rested before it was half way, or elsewhere
  left_plate,    ///< the finger was lifted, or moved over the rim
  lost,          ///< the tracker lost it
  moved,         ///< the plate turned within the slide
  plate,         ///< the plate has not turned to where it was asked within 5 s
  disagrees,     ///< touches do not fit their marks, or slides each other
  upside_down,   ///< the touches fit a plate that is upside down or mirrored
  undetermined,  ///< the fit does not know enough: more is needed
};

struct SetupSample {
  std::int64_t time_ns = 0;  ///< not before the last one's
  /// The finger in the tracker's frame; none: lost.
  std::optional<Eigen::Vector3d> tracked_mm;
  /// That frame is the plate's: its pose is not needed.
  bool in_plate = false;
  std::optional<Eigen::Matrix3d> joint_rotation;
  FingerSample on_plate;  ///< sample located by the pose of the plate that is known so far
  bool off_plate = false;
};

/// The diagnosis of a set-up that does not progress.
struct Observed {
  enum class Kind : std::uint32_t {
    none,
    no_finger,
    lifted,     ///< the finger is lifted in every sample
    time,       ///< advances by `first` ns per sample
    far_away,   ///< the finger is `first` mm from the place to go to: hardly in metres
    plate,      ///< reports `first` degrees although `second` were commanded
    elsewhere,  ///< the finger is `first` mm from the place to go to
    wrong_way,  ///< the finger slid towards `first` degrees, where 0 is straight ahead
    no_rest,    ///< the finger has not come and rested
  };
  Kind kind = Kind::none;
  double first = 0.0, second = 0.0;
};

struct SetupStep {
  SetupPart part;
  Instruction instruction;
  SetupProblem problem;
  int number;  ///< index of the mark, or of the attitude of the finger, from 0
  int done;    ///< touches or slides
  int of;
  Eigen::Vector3d place_mm;  ///< position to which the finger is to move, in plate coordinates
  double plate_orientation_deg;
  Observed observed;        ///< none within 20 s
  std::string_view reason;  ///< reason of a rejected fit; valid until the set-up changes
};

/// Reason for dropping a part: that of its last fit, or the problem of its last slides.
struct SetupDrop {
  SetupPart part;
  SetupProblem problem;
  Observed observed;
  std::string_view reason;
};

}  // namespace hrt
