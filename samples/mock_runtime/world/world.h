// The simulation: a ridged plate on a servo, two hands, and the person whose fingertip slides over
// the plate. All poses are in world coordinates, those of STAGE as it was when the session was created.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <optional>
#include <vector>

#include "samples/mock_runtime/world/reach.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

/// Of the wrist of a hand that points straight ahead, down onto a plate.
Eigen::Quaterniond resting_hand_orientation();

/// A hand at a time.
struct HandState {
  Eigen::Vector3d index_tip_m;
  Eigen::Quaterniond orientation;  ///< of the wrist
};

/// The head of the seated user, and LOCAL space, when the session is created.
Pose local_space_in_world();

/// Where the origins of the reference spaces are in the world. A user who recentres moves an origin; nothing in
/// the room moves.
class Origins {
 public:
  /// From `change` on, LOCAL or STAGE is where `pose` is in it before.
  void recenter(XrReferenceSpaceType type, XrTime change, const Pose& pose);

  /// LOCAL, LOCAL_FLOOR (below LOCAL, on the floor of STAGE) or STAGE, at a time.
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
  /// A world that begins at `start`.
  World(const WorldSettings& settings, XrTime start);

  /// Plate frame: origin in the centre of rotation, +Y the normal, -Z the mid-line away from the user.
  void place_plate(const Pose& plate) { plate_ = plate; }
  bool plate_is_placed() const { return plate_.has_value(); }

  /// Sets the seed of all draws to come and the number of the next reach.
  void set_seed(std::uint64_t seed, std::uint32_t next_reach);

  void command_plate(double orientation_deg) { servo_.command(orientation_deg); }
  /// At a time from now on; an earlier one counts as now.
  double plate_orientation_deg(XrTime time) const { return servo_.orientation_at_deg(time); }

  /// Starts a reach, with the index tip joint at `height_m` above the plate. Requires plate_is_placed().
  void instruct(XrHandEXT hand, const ReachInstruction& instruction, double height_m, XrTime now);
  /// The hand's latest reach, or null.
  const Reach* reach(XrHandEXT hand) const;
  /// The index tip joint of a hand with a reach, now, in plate coordinates.
  Eigen::Vector3d true_index_tip_m(XrHandEXT hand) const;

  /// Faults of a hand.
  void lose_tracking(XrHandEXT hand, bool lost) { at(hand).lost = lost; }
  void freeze(XrHandEXT hand, bool frozen);
  void lose_rotation(XrHandEXT hand, bool lost) { at(hand).unturned = lost; }
  void jump(XrHandEXT hand, const Eigen::Vector3d& by_m) { at(hand).jump_m += by_m; }

  /// The headset loses track of the room: it stays where it was for the application, and what it sees is
  /// known from there alone.
  void lose_head(bool lost) { head_lost_at_ = lost ? std::optional(head_lost_at_.value_or(now_)) : std::nullopt; }
  bool head_is_lost() const { return head_lost_at_.has_value(); }

  Pose head(XrTime time) const;

  /// The origins of the reference spaces.
  Origins origins;

  /// Lets time pass up to `now`. Commands given before now have been given before.
  void advance(XrTime now);

  /// The hand as the tracker reports it for `time`; none while not tracked. A future time is predicted
  /// without further plate commands.
  std::optional<HandState> hand(XrHandEXT hand, XrTime time) const;

 private:
  struct Hand {
    bool tracked = false;
    bool lost = false;
    bool unturned = false;  // its quaternions are zero
    std::optional<XrTime> frozen_at;
    Eigen::Vector3d jump_m = Eigen::Vector3d::Zero();
    std::optional<Reach> reach;
    double height_m = 0.0;
  };

  Hand& at(XrHandEXT hand) { return hands_[hand == XR_HAND_LEFT_EXT ? 0 : 1]; }
  const Hand& at(XrHandEXT hand) const { return hands_[hand == XR_HAND_LEFT_EXT ? 0 : 1]; }
  const HandSettings& settings_of(XrHandEXT side) const { return settings_.hands[side == XR_HAND_LEFT_EXT ? 0 : 1]; }
  /// Lets a hand slide that nobody instructs, if it is time to.
  void slide_again(XrHandEXT side);
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
