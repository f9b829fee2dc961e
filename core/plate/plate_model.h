// Model of the servo: predicts the plate orientation from commands and reports.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/plate/plate_limits.h"

namespace hrt {

/// Dynamics of the servo. Default: a plate that follows immediately and turns freely.
struct PlateDynamics {
  double max_speed_deg_s = std::numeric_limits<double>::infinity();          ///< > 0
  double max_acceleration_deg_s2 = std::numeric_limits<double>::infinity();  ///< > 0
  std::int64_t latency_ns = 0;  ///< time from a command to the first motion, 0 to 1 s
  PlateStops stops;
};

bool is_valid(const PlateDynamics& dynamics);

/// Uses no heap, lock or exception. One thread at a time.
class PlateModel {
 public:
  /// Begins at rest at `orientation_deg`. Requires is_valid(dynamics).
  PlateModel(const PlateDynamics& dynamics, double orientation_deg);

  /// Advances to `time_ns`; a time before that of the model has no effect. With an acceleration limit, an advance of
  /// more than two seconds is integrated more coarsely.
  void advance(std::int64_t time_ns) {
    if (timed_ && at_rest())
      motion_.now_ns = std::max(motion_.now_ns, time_ns);
    else
      advance_turning(time_ns);
  }

  void command(double orientation_deg);

  /// Sets the orientation to that reported by the device; see reported_orientation_deg().
  void report(double orientation_deg);

  /// Sets the orientation without a motion.
  void put(double orientation_deg) { motion_.orientation_deg = motion_.target_deg = orientation_deg; }

  double orientation_deg() const { return motion_.orientation_deg; }

  /// Returns the plate orientation at `time_ns`, which must not be before the model's time, under the commands given.
  double orientation_at_deg(std::int64_t time_ns) const {
    return at_rest() ? motion_.orientation_deg : turning_at_deg(time_ns);
  }

  /// Returns the largest rotation in `seconds`, from rest to rest; infinity for a plate that follows immediately.
  double reach_deg(double seconds) const;

 private:
  struct Command {
    std::int64_t effective_ns;
    double orientation_deg;
  };
  struct Motion {
    double orientation_deg = 0.0;
    double speed_deg_s = 0.0;
    double target_deg = 0.0;
    std::int64_t now_ns = 0;
  };
  bool at_rest() const { return pending_count_ == 0 && motion_.orientation_deg == motion_.target_deg; }
  void advance_turning(std::int64_t time_ns);
  double turning_at_deg(std::int64_t time_ns) const;
  int turn_until(std::int64_t time_ns, Motion& motion) const;
  void turn(double seconds, Motion& motion) const;

  PlateDynamics dynamics_;
  Motion motion_;
  bool timed_ = false;
  // Commands that have not taken effect, oldest first. A command within 1/63 of the latency after another one replaces
  // that one, and takes effect early by at most 1/63 of the latency.
  std::array<Command, 64> pending_{};
  int pending_count_ = 0;
};

/// Plate orientations of at least the last second, for models with delays. Uses no heap, lock or exception. One thread
/// at a time.
class PlateTrace {
 public:
  void clear() { count_ = 0; }

  /// Adds an orientation at `time_s`, which must not be earlier than that of the last entry.
  void add(double time_s, double orientation_deg);

  /// Returns the orientation at a time: linear between entries, constant before and after them. Requires an entry.
  double at(double time_s) const;

 private:
  struct Entry {
    double time_s;
    double orientation_deg;
  };
  const Entry& entry(int i) const { return entries_[static_cast<unsigned>(first_ + i) % capacity]; }

  static constexpr int capacity = 128;
  // Minimum spacing of an entry and the second one after it, so that all entries span a second.
  static constexpr double min_spacing_s = 0.016;
  std::array<Entry, capacity> entries_{};
  int first_ = 0;
  int count_ = 0;
};

}  // namespace hrt
