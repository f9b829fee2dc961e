#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_text.h"
#include "plugin/src/plate/plate_line.h"
#include "plugin/src/plate/plate_watch.h"

namespace hrt::plate {

/// Plate with the line protocol (plugin/src/plate/protocol.md). limits() has the speed that the plate reports, or the
/// observed speed if that is lower, and the reported latency plus half of the measured round trip. The destructor waits
/// up to 0.1 s to send a stop. Functions throw PlateFailure if the plate fails. All calls are made on one thread.
class PlateLink : public Device, public BoardSettings {
 public:
  /// Greets the plate and measures the round trip; does not move the plate. Waits up to five seconds for the answer,
  /// because boards restart when their serial line is opened. With Start::passive, a pressed emergency stop or a
  /// missing supply is not a failure.
  explicit PlateLink(std::unique_ptr<Line> line, Start start = Start::hold);
  ~PlateLink() override;  ///< stops the plate if it is still connected
  PlateLink(const PlateLink&) = delete;
  PlateLink& operator=(const PlateLink&) = delete;

  Line::Time now() const override { return line_->now(); }

  std::string description() const override;
  DeviceLimits limits() const override;
  bool is_measured() const override { return greeting_->is_measured; }
  std::optional<double> orientation_deg() const override { return orientation_deg_; }
  Line::Time reported() const override { return reported_; }
  /// Median time from a line to the report that echoes its sequence number.
  std::optional<std::chrono::nanoseconds> round_trip() const override { return round_trips_.median(); }
  std::uint64_t refusals() const override { return refusals_; }

  void wait(std::chrono::milliseconds limit) override;
  void turn_to(double orientation_deg) override;
  void stop() override;

  std::vector<std::string> details() override;
  double zero_deg() override;
  void set_zero(double zero_deg) override;
  void save_zero() override { save_settings(); }
  void begin_measurement() override;
  double report_step_deg() const override { return 0.01; }
  std::chrono::nanoseconds sensor_filter() const override;

  BoardSettings* board_settings() override { return this; }
  double setting(const std::string& name) override;
  void change_setting(const std::string& name, double value) override;
  void save_settings() override;
  double sensor_reading() override;

  /// Sends `body`, and waits until `handler` returns true for a message. Throws PlateFailure after `limit`.
  void ask(const std::string& body, const std::function<bool(const PlateMessage&)>& handler,
           std::chrono::milliseconds limit = std::chrono::milliseconds(1000));

 private:
  void start_session();
  void measure_round_trip();
  double pulse_setting(const std::string& name);
  void run_for(std::chrono::milliseconds time);
  void receive();
  void handle(const PlateMessage& message);
  void handle_greeting(const PlateGreeting& greeting);
  void handle_report(const PlateReport& report);
  void handle_stop(StopReason reason);
  void handle_refusal(const PlateRefusal& refusal);
  void send_command(std::string_view word);
  void send_body(std::string_view body);
  void try_to_stop();

  std::unique_ptr<Line> line_;
  Start start_;
  std::uint16_t token_;  // number at the end of each line of this host
  LineBuffer buffer_{};
  std::optional<PlateGreeting> greeting_;
  std::optional<PlateInfo> info_;
  std::optional<PlateWatch> watch_;
  RoundTrips round_trips_;
  std::optional<double> orientation_deg_;
  std::optional<double> command_deg_;
  std::uint16_t sequence_ = 0;
  int expected_greetings_ = 0;  // HELLOs that were not answered yet
  bool has_other_host_ = false;
  std::uint64_t refusals_ = 0;
  const std::function<bool(const PlateMessage&)>* handler_ = nullptr;
  bool is_answered_ = false;
  Line::Time received_at_, reported_;
  Line::Time sent_at_;
  std::chrono::milliseconds heartbeat_period_{50};  // the protocol allows up to 100 ms
};

}  // namespace hrt::plate
