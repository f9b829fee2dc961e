// A simulated person at a plate with a servo and a tracker. The host may call at any rate.
#pragma once

#include <cstdint>
#include <optional>

#include "core/plate/plate_model.h"
#include "core/simulation/guided_hand.h"

namespace hrt {

class SimulatedHand {
 public:
  /// Draws a person of the first family for a motion of `duration_s`.
  SimulatedHand(double duration_s, std::uint64_t seed);

  /// Person, tracker and plate as drawn; may be changed before begin() or begin_setup(). Of the tracker, only white_mm
  /// is used.
  PersonCondition& condition() { return condition_; }

  /// Begins a reach at rest at `start`, over `distance_mm` towards the virtual target.
  void begin(const PlatePoint& start, double virtual_direction_deg, double distance_mm);
  bool has_begun() const { return finger_.has_value(); }
  /// True if `time_ns` is earlier than the time of the last move() or follow() in this reach or set-up.
  bool is_past(std::int64_t time_ns) const { return moved_ && time_ns < now_ns_; }

  /// Begins a set-up: the person rests until the first instruction.
  void begin_setup();
  /// Advances to `time_ns` like move(), but the person follows the instruction `step`, if any. Returns the tracked
  /// position of the skin in plate coordinates. Requires is_guided().
  Eigen::Vector3d follow(std::int64_t time_ns, double plate_orientation_deg, const std::optional<SetupStep>& step);
  bool is_guided() const { return guided_.has_value(); }
  /// Rotation of the tracked joint relative to the plate's axes. Requires is_guided().
  const Eigen::Quaterniond& attitude() const { return guided_->attitude(); }

  /// Commands the plate and advances to `time_ns`. The first call of a reach sets the plate orientation. Returns the
  /// tracked position of the finger. Requires has_begun().
  PlatePoint move(std::int64_t time_ns, double plate_orientation_deg);

  const SlidingPerson& finger() const { return *finger_; }
  double plate_orientation_deg() const { return plate_.orientation_deg(); }

 private:
  template <class Advance>
  void pass(std::int64_t time_ns, double plate_orientation_deg, const Advance& advance);
  void restart();
  double noise_mm() { return condition_.tracker.white_mm * tracking_->normal(); }

  PersonCondition condition_;
  double start_share_;  // initial direction as a fraction of the virtual direction
  std::uint64_t seed_;
  std::uint32_t reach_ = 0;
  std::optional<SlidingPerson> finger_;
  std::optional<GuidedHand> guided_;
  std::optional<Draws> tracking_;
  PlateModel plate_{PlateDynamics{}, 0.0};
  double commanded_deg_ = 0.0;  // continuous: of the orientations with the same ridges, the nearest to the last one
  std::int64_t began_ns_ = 0;
  std::int64_t now_ns_ = 0;
  std::int64_t ticks_ = 0;  // milliseconds simulated since the first move() or follow() of the reach or set-up
  bool moved_ = false;
};

}  // namespace hrt
