// The simulation: a ridged plate on a servo, and the hands of participants, whose fingertips slide over the plate.
// World coordinates are those of STAGE when the session is created.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <optional>
#include <vector>

#include "samples/mock_runtime/world/reach.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

/// Orientation of the wrist of a hand at rest, which points straight ahead and 20 degrees down.
Eigen::Quaterniond resting_hand_orientation();

struct HandState {
  Eigen::Vector3d index_tip_m;
  Eigen::Quaterniond orientation;  ///< of the wrist; zero if the rotation is lost
};

/// Pose of LOCAL when the session is created: at the eyes of a seated user.
Pose local_space_in_world();

/// Origins of the reference spaces in the world. Recentring moves an origin, but neither the hands nor the plate.
class Origins {
 public:
  /// Moves the origin of LOCAL or STAGE from time `change` on; `pose` is that of the new origin in the old space.
  void recenter(XrReferenceSpaceType type, XrTime change, const Pose& pose);

  /// Returns the pose of LOCAL, STAGE or LOCAL_FLOOR (below LOCAL, on the floor of STAGE) at a time.
  Pose in_world(XrReferenceSpaceType type, XrTime time) const;

 private:
  struct Change {
    XrTime time;
    Pose in_world;
  };
  Pose latest(const std::vector<Change>& changes, const Pose& first, XrTime time) const;

  std::vector<Change> local_;  // in order of time
  std::vector<Change> stage_;
};

class World {
 public:
  World(const WorldSettings& settings, XrTime start);

  /// Sets the pose of the plate frame: origin at the centre of rotation, +Y normal, -Z mid-line away from the user.
  void place_plate(const Pose& plate) { plate_ = plate; }
  bool plate_is_placed() const { return plate_.has_value(); }

  /// Sets the seed of later reaches and of the tracker noise, and the number of the next reach.
  void set_seed(std::uint64_t seed, std::uint32_t next_reach);

  void command_plate(double orientation_deg) { servo_.command(orientation_deg); }
  /// Returns the plate orientation now or at a future time; a past time counts as now.
  double plate_orientation_deg(XrTime time) const { return servo_.orientation_at_deg(time); }

  /// Starts a reach, with the index tip joint at `height_m` above the plate. Requires plate_is_placed().
  void instruct(XrHandEXT hand, const ReachInstruction& instruction, double height_m, XrTime now);
  /// Returns the latest reach of a hand, or null.
  const Reach* reach(XrHandEXT hand) const;
  /// Returns the present position of the index tip joint in plate coordinates. Requires that the hand has a reach.
  Eigen::Vector3d true_index_tip_m(XrHandEXT hand) const;

  /// These functions begin (true) or end (false) a fault of the tracker; jump() adds to the reported position, in world
  /// coordinates.
  void lose_tracking(XrHandEXT hand, bool lost) { at(hand).lost = lost; }
  void freeze(XrHandEXT hand, bool frozen);
  void lose_rotation(XrHandEXT hand, bool lost) { at(hand).rotation_lost = lost; }
  void jump(XrHandEXT hand, const Eigen::Vector3d& by_m) { at(hand).jump_m += by_m; }

  /// Begins or ends a loss of head tracking. Meanwhile the head is reported where it was.
  void lose_head(bool lost) { head_lost_at_ = lost ? std::optional(head_lost_at_.value_or(now_)) : std::nullopt; }
  bool head_is_lost() const { return head_lost_at_.has_value(); }

  Pose head(XrTime time) const;

  Origins origins;

  /// Advances the simulation to `now`, which is also the time of commands that the caller gives later. The plate
  /// follows a command after the latency of its servo.
  void advance(XrTime now);

  /// Returns the state that the tracker reports for `time`; nullopt while the hand is not tracked. A future state is
  /// predicted as if no further plate command arrived.
  std::optional<HandState> hand(XrHandEXT hand, XrTime time) const;

 private:
  struct Hand {
    bool tracked = false;
    bool lost = false;
    bool rotation_lost = false;  // quaternions are reported as zero
    std::optional<XrTime> frozen_at;
    Eigen::Vector3d jump_m = Eigen::Vector3d::Zero();
    std::optional<Reach> reach;
    double height_m = 0.0;
  };

  Hand& at(XrHandEXT hand) { return hands_[hand == XR_HAND_LEFT_EXT ? 0 : 1]; }
  const Hand& at(XrHandEXT hand) const { return hands_[hand == XR_HAND_LEFT_EXT ? 0 : 1]; }
  const HandSettings& settings_of(XrHandEXT side) const { return settings_.hands[side == XR_HAND_LEFT_EXT ? 0 : 1]; }
  void start_slide_if_due(XrHandEXT side);
  HandState hand_on_path(XrHandEXT side, XrTime time) const;
  HandState sliding_hand(const Hand& hand, XrHandEXT side, XrTime time) const;
  Eigen::Vector3d tracker_noise_m(XrHandEXT side, XrTime time) const;

  WorldSettings settings_;
  PlateModel servo_;
  std::optional<Pose> plate_;
  std::array<Hand, 2> hands_;
  std::optional<XrTime> head_lost_at_;
  std::uint32_t reaches_ = 0;
  XrTime start_;
  XrTime now_;
};

}  // namespace hrt::mock
