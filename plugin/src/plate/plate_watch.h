#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <vector>

#include "plugin/src/plate/plate_line.h"

namespace hrt::plate {

/// Detects a plate that sends no reports, is stuck or is beyond its limits, and measures the plate's speed. Reads no
/// clock: the caller passes times, which must not decrease. All calls are made on one thread.
class PlateWatch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  PlateWatch(const PlateGreeting& greeting, Time now) : greeting_(greeting), reported_(now) {}

  /// Starts to expect that the plate turns to this orientation; note_stop() ends the expectation.
  void note_command(double orientation_deg);
  void note_stop();
  /// `orientation_deg`: nullopt if it is unknown. Throws PlateFailure if the plate is stuck or beyond its limits.
  void note_report(Time time, std::optional<double> orientation_deg);
  /// Throws PlateFailure if no report has arrived for half a second. Call it regularly.
  void check(Time now) const;

  /// Highest speed over at least 20 degrees or one second of a motion; nullopt if no such motion was observed.
  std::optional<double> speed_deg_s() const { return speed_deg_s_; }

 private:
  struct Position {
    Time time;
    double orientation_deg;
  };
  void measure_speed(const Position& now);
  void expect_motion(const Position& now);

  PlateGreeting greeting_;
  Time reported_;
  bool has_reported_ = false;
  std::optional<double> command_deg_;
  std::deque<Position> motion_;    // recent positions of the motion towards the command, without a stop
  std::optional<Position> moved_;  // last position at which expect_motion() observed a motion
  std::optional<double> speed_deg_s_;
};

/// Measures the time from a message to the report that echoes its sequence number.
class RoundTrips {
 public:
  using Time = PlateWatch::Time;

  void sent(Time time, std::uint16_t sequence);
  /// Notes an echo. Returns false if the number is not one of the last 64 sent, or if a later number was echoed before.
  bool echoed(Time time, std::uint16_t sequence);
  /// Returns nullopt before the first echo.
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
