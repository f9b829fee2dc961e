// What is known of the finger's motion: tracked samples in, the direction of each model step out.
//
// Samples carry either directions, taken as exact (the paper's way), or positions on the plate, whose
// displacement within a step gives its direction.
#pragma once

#include <cstdint>
#include <optional>

namespace hrt {

/// A place in the plane of the plate, in metres: `right_m` to the user's right, `away_m` along the
/// mid-line away from the user.
struct PlatePoint {
  double right_m = 0.0;
  double away_m = 0.0;
};

/// Direction from `from` to `to`, degrees counter-clockwise from the mid-line; 0 if they coincide.
double bearing_deg(const PlatePoint& from, const PlatePoint& to);

double distance_m(const PlatePoint& from, const PlatePoint& to);

/// What a sample observed of the finger.
enum class Observation {
  none,       ///< nothing usable: tracking lost, finger lifted
  direction,  ///< FingerSample::direction_deg
  position,   ///< FingerSample::position
};

/// One tracked sample. Fields that its observation does not name are not read.
struct FingerSample {
  std::int64_t time_ns = 0;  ///< the caller's monotonic clock; not before the last sample's
  Observation observation = Observation::none;
  double direction_deg = 0.0;  ///< finite
  PlatePoint position;         ///< finite
  /// Where the plate stands, if its device reports it.
  std::optional<double> plate_orientation_deg;
};

/// Nanoseconds from `from_ns` to `to_ns`, which is not before it; whatever their signs, without overflow.
constexpr std::uint64_t elapsed_ns(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns);
}

/// Turns samples into one direction a model step. No heap, no lock, no exception. One thread at a time.
class Estimator {
 public:
  /// `step_period_ns` > 0.
  explicit Estimator(std::int64_t step_period_ns)
      : step_period_ns_(static_cast<std::uint64_t>(step_period_ns)) {}

  /// Takes a sample in; its time must not be before the last one's.
  void observe(const FingerSample& sample);

  /// When the finger began to move, and the first model step with it: the time of the first direction,
  /// or of the last position before the finger was `least_travel_m` from where it rested. Nothing before.
  std::optional<std::int64_t> motion_start_ns() const { return motion_start_ns_; }

  /// Starts a further model step at `time_ns`: only what is observed from then on counts for direction_deg().
  void begin_step(std::int64_t time_ns);

  /// The finger's direction in this step, once it can be told: from a direction sample at once, from
  /// positions when the step is half over and the finger has moved at least `least_travel_m`.
  std::optional<double> direction_deg() const;

  /// The last observed position.
  std::optional<PlatePoint> position() const { return position_; }

  /// A displacement shorter than this tells no direction.
  static constexpr double least_travel_m = 0.0002;

 private:
  std::uint64_t step_period_ns_;
  std::optional<std::int64_t> motion_start_ns_;
  std::optional<PlatePoint> rest_;  // first position of the reach
  std::optional<PlatePoint> position_;
  std::int64_t position_ns_ = 0;
  std::optional<double> observed_direction_deg_;
  std::int64_t step_start_ns_ = 0;
  std::optional<PlatePoint> step_base_;  // first position of the step
};

}  // namespace hrt
