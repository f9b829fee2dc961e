// Compares the reports of a plate with its commands: detects a plate that is silent, stuck, beyond its limits, or
// slower than it reports.
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <vector>

#include "plugin/src/plate/plate_line.h"

namespace hrt::plate {

/// Monitor of one plate. The caller passes times, which must not decrease. Throws PlateFailure. One thread.
class PlateWatch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  PlateWatch(const PlateGreeting& greeting, Time now) : greeting_(greeting), reported_(now) {}

  /// Notes a command: from now on, the plate must turn to this orientation.
  void commanded(double orientation_deg);
  /// Notes a stop: from now on, the plate must not move.
  void stopped();
  /// Notes a report. `orientation_deg`: nullopt if the orientation is unknown.
  void reported(Time time, std::optional<double> orientation_deg);
  /// Throws PlateFailure if no report has arrived for half a second. Call it regularly.
  void check(Time now) const;

  /// Highest speed over 20 degrees of one motion, or over a second; nullopt before the first motion.
  std::optional<double> speed_deg_s() const { return speed_deg_s_; }

 private:
  struct Place {
    Time time;
    double orientation_deg;
  };
  void measure_speed(const Place& now);
  void expect_motion(const Place& now);

  PlateGreeting greeting_;
  Time reported_;
  bool has_reported_ = false;
  std::optional<double> command_deg_;
  std::deque<Place> motion_;    // positions of one motion towards the command, without a stop
  std::optional<Place> moved_;  // position of the last observed motion while the plate had to move
  std::optional<double> speed_deg_s_;
};

/// Measures the time from a line to the report that echoes its sequence number.
class RoundTrips {
 public:
  using Time = PlateWatch::Time;

  void sent(Time time, std::uint16_t sequence);
  /// Notes an echo. False if it is another host's: no line of this host has that number, or a later one was echoed
  /// already.
  bool echoed(Time time, std::uint16_t sequence);
  /// Median; nullopt before the first echo.
  std::optional<std::chrono::nanoseconds> median() const { return median_; }
  std::size_t count() const { return times_.size(); }

 private:
  struct Sent {
    Time time;
    std::uint16_t sequence;
  };
  std::deque<Sent> sent_;
  std::uint16_t last_echo_ = 0;
  std::vector<std::chrono::nanoseconds> times_;
  std::optional<std::chrono::nanoseconds> median_;
};

}  // namespace hrt::plate
