// The plate's servo: where the ridges stand, and how soon they can stand elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

namespace hrt {

/// What a servo can do. The defaults are a plate that follows at once and turns freely.
struct PlateDynamics {
  double max_speed_deg_s = std::numeric_limits<double>::infinity();          ///< > 0
  double max_acceleration_deg_s2 = std::numeric_limits<double>::infinity();  ///< > 0
  std::int64_t latency_ns = 0;  ///< from a command to the first motion, 0 to 1 s
  /// The stops, degrees from the mid-line; infinite: none. At least 180 apart, so that every direction of
  /// ridges can be had.
  double lower_stop_deg = -std::numeric_limits<double>::infinity();
  double upper_stop_deg = std::numeric_limits<double>::infinity();
};

/// True if every field is in its range.
bool is_valid(const PlateDynamics& dynamics);

/// Ridges repeat every 180 degrees: of the orientations that feel the same as `orientation_deg` and lie
/// between the stops, the one nearest to `current_deg`.
double nearest_equivalent_deg(double orientation_deg, double current_deg, const PlateDynamics& dynamics);

/// For a plate that shall turn anywhere from `lowest_deg` to `highest_deg` without a swing of half a turn in
/// between: how many half turns further it does so while the stops cut the least from that range, and of
/// those the ones nearest to `current_deg`. A whole number.
double half_turns_between_stops(double lowest_deg, double highest_deg, double current_deg,
                                const PlateDynamics& dynamics);

/// Follows a plate through its commands and reports. No heap, no lock, no exception. One thread at a time.
class Plate {
 public:
  /// At rest at `orientation_deg`. Requires is_valid(dynamics).
  Plate(const PlateDynamics& dynamics, double orientation_deg);

  /// Lets time pass until `time_ns`; earlier than now does nothing. A gap of more than two seconds counts
  /// as two: any motion has ended by then.
  void advance(std::int64_t time_ns);

  /// Commands an orientation as of now.
  void command(double orientation_deg);

  /// The device reports where it stands now. A plate without stops may count its turns as it likes: of the
  /// orientations that feel the same, the one nearest to where it was expected is taken.
  void report(double orientation_deg);

  /// Puts the plate there at once.
  void put(double orientation_deg) { orientation_deg_ = target_deg_ = orientation_deg; }

  /// Where the plate stands now.
  double orientation_deg() const { return orientation_deg_; }

  /// Where the plate will stand at `time_ns` with the commands it has, not before now.
  double orientation_at_deg(std::int64_t time_ns) const;

  /// How far the plate can turn in `seconds`, from rest to rest.
  double reach_deg(double seconds) const;

  const PlateDynamics& dynamics() const { return dynamics_; }

 private:
  struct Command {
    std::int64_t effective_ns;
    double orientation_deg;
  };
  void turn(double seconds);

  PlateDynamics dynamics_;
  double orientation_deg_;
  double speed_deg_s_ = 0.0;
  double target_deg_;
  std::int64_t now_ns_ = 0;
  bool timed_ = false;
  // Commands under way, oldest first. Of those that follow each other within 1/63 of the latency only the
  // last is kept, early by no more than that.
  std::array<Command, 64> pending_{};
  int pending_count_ = 0;
};

}  // namespace hrt
