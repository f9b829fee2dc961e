// A simulated person at a plate with a servo and a tracker, in the time of a host that calls at any rate.
#pragma once

#include <cstdint>
#include <optional>

#include "core/plate/plate_model.h"
#include "core/simulation/guided_hand.h"

namespace hrt {

class SimulatedHand {
 public:
  /// A person of the first family, drawn for a motion of `duration_s`.
  SimulatedHand(double duration_s, std::uint64_t seed);

  /// Person, tracker and plate as drawn, to be changed before begin().
  PersonCondition& condition() { return condition_; }

  /// At rest at `start`; will go `distance_mm` to the virtual target.
  void begin(const PlatePoint& start, double virtual_direction_deg, double distance_mm);
  bool has_begun() const { return finger_.has_value(); }
  /// True if `time_ns` is before the last move() of this reach.
  bool is_past(std::int64_t time_ns) const { return moved_ && time_ns < now_ns_; }

  /// Rests, and will do what the steps of a set-up ask for.
  void begin_setup();
  /// As move(), with the position of the skin in plate coordinates. Without a position the person does not move.
  /// Requires is_guided().
  Eigen::Vector3d follow(std::int64_t time_ns, double plate_orientation_deg, const std::optional<SetupStep>& step);
  bool is_guided() const { return guided_.has_value(); }
  /// Rotation of the tracked joint in the plate's axes. Requires is_guided().
  const Eigen::Quaterniond& attitude() const { return guided_->attitude(); }

  /// Commands the plate and advances the time; the first call of a reach places the plate at the orientation. Returns
  /// the tracked position of the finger. Requires has_begun().
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
  double commanded_deg_ = 0.0;  // of the orientations with the same ridges, the nearest to the last one
  std::int64_t began_ns_ = 0;
  std::int64_t now_ns_ = 0;
  std::int64_t ticks_ = 0;  // milliseconds of this reach
  bool moved_ = false;
};

}  // namespace hrt
