// Host's side of the line protocol (plugin/src/plate/protocol.md) with a plate on a serial line.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "plugin/include/plate_driver/device.h"
#include "plugin/src/plate/plate_line.h"
#include "plugin/src/plate/plate_watch.h"

namespace hrt::plate {

/// Plate with the line protocol. limits() has the reported speed, or the observed one if that is lower, and the
/// reported latency plus half of the measured round trip. Calls return immediately, except the constructor, wait(),
/// ask() and calls that use ask(). All throw PlateFailure when the plate has failed, after they stopped it if it is
/// still connected. One thread.
class PlateLink : public Device, public BoardSettings {
 public:
  /// Greets the plate, waits up to five seconds for its answer (boards start when their line is opened), and measures
  /// the round trip. Moves nothing. With Start::quiet, an open emergency stop or a missing supply is not a failure.
  explicit PlateLink(std::unique_ptr<Line> line, Start start = Start::hold);
  /// Stops the plate if it is still connected.
  ~PlateLink() override;
  PlateLink(const PlateLink&) = delete;
  PlateLink& operator=(const PlateLink&) = delete;

  Line::Time now() const override { return line_->now(); }

  std::string description() const override;
  DeviceLimits limits() const override;
  bool is_measured() const override { return greeting_->is_measured; }
  const PlateGreeting& greeting() const { return *greeting_; }
  /// Last reported orientation; nullopt before the first report.
  std::optional<double> orientation_deg() const override { return orientation_deg_; }
  Line::Time reported() const override { return reported_; }
  /// Time from a line to its echo, measured at the start.
  std::optional<std::chrono::nanoseconds> round_trip() const override { return round_trips_.median(); }
  std::uint64_t refusals() const override { return refusals_; }

  /// Reads the plate's messages and sends heartbeats. Call at least every 50 ms, or the plate's watchdog stops it.
  void service();
  /// Waits up to `limit` for the plate's next bytes, then calls service().
  void wait(std::chrono::milliseconds limit) override;
  /// Turns the plate. @p orientation_deg is within the greeting's limits. An equal command is not sent again.
  void turn_to(double orientation_deg) override;
  void stop() override;

  std::vector<std::string> details() override;
  double zero_deg() override;
  void set_zero(double zero_deg) override;
  void keep_zero() override { save_settings(); }
  void hurry() override;
  double report_step_deg() const override { return 0.01; }
  /// Time constant of the filter that the firmware applies to its readings.
  std::chrono::nanoseconds sensor_filter() const override;

  BoardSettings* board_settings() override { return this; }
  double setting(const std::string& name) override;
  void change_setting(const std::string& name, double value) override;
  void save_settings() override;
  double sensor_reading() override;

  /// Sends a service command, and passes each message to `take` until it returns true. Throws PlateFailure after
  /// `limit`.
  void ask(const std::string& body, const std::function<bool(const PlateMessage&)>& take,
           std::chrono::milliseconds limit = std::chrono::milliseconds(1000));

 private:
  void greet();
  void measure_line();
  double pulse_setting(const std::string& name);
  void serve_for(std::chrono::milliseconds time);
  void listen();
  void take(const PlateMessage& message);
  void take_greeting(const PlateGreeting& greeting);
  void take_report(const PlateReport& report);
  void take_stop(StopReason reason);
  void take_refusal(const PlateRefusal& refusal);
  void drive(std::string_view word);
  void say(std::string_view body);
  void stop_if_heard();

  std::unique_ptr<Line> line_;
  Start start_;
  std::uint16_t session_;  // token that marks the lines of this host
  LineReader reader_;
  std::optional<PlateGreeting> greeting_;
  std::optional<PlateInfo> info_;
  std::optional<PlateWatch> watch_;
  RoundTrips round_trips_;
  std::optional<double> orientation_deg_;
  std::optional<double> command_deg_;
  std::uint16_t sequence_ = 0;
  int unanswered_hellos_ = 0;
  bool is_taken_ = false;  // another host uses the plate
  std::uint64_t refusals_ = 0;
  const std::function<bool(const PlateMessage&)>* asked_ = nullptr;
  bool answered_ = false;
  Line::Time heard_, reported_;
  Line::Time said_;
  std::chrono::milliseconds beat_period_{50};  // half of the protocol's limit
};

}  // namespace hrt::plate
