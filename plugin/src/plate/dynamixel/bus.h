// Communication with one servo on a Dynamixel bus, and constants of the XL330-M077 and XL330-M288 (ROBOTIS e-manuals).
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "plugin/include/plate_driver/dynamixel_packet.h"
#include "plugin/include/plate_driver/line.h"
#include "plugin/src/plate/plate_watch.h"

namespace hrt::plate::dynamixel {

/// An entry of the servo's control table; its size is in bytes. Entries below address 64 keep their values across
/// power-off, and may be written only while the torque is off.
struct Entry {
  int address;
  int size;
};
inline constexpr Entry drive_mode{10, 1}, operating_mode{11, 1}, homing_offset{20, 4}, current_limit{38, 2},
    velocity_limit{44, 4}, torque_enable{64, 1}, hardware_error{70, 1}, bus_watchdog{98, 1}, goal_current{102, 2},
    profile_velocity{112, 4}, present_position{132, 4}, present_voltage{144, 2}, present_temperature{146, 1};
/// Two entries that one request reads or writes: profile velocity (lower four bytes) and goal position (upper four).
inline constexpr Entry motion{112, 8};

/// Model of a servo. stall_nm: stall torque at 5 V and 1.47 A, in N m, from
/// https://emanual.robotis.com/docs/en/dxl/x/xl330-m077/ and xl330-m288/, section "Specifications".
struct Model {
  int number;
  const char* name;
  double stall_nm;
};
inline constexpr std::array models = {Model{1190, "XL330-M077", 0.215}, Model{1200, "XL330-M288", 0.52}};
inline constexpr double stall_ma = 1470.0;
/// Torque to which the driver limits the servo: 4 N at the rim, 75 mm from the axis.
/// samples/plate/guide/safety.md allows 5 N; the difference is a margin, because the force was not measured.
inline constexpr double max_torque_nm = 4.0 * 0.075;

inline constexpr int current_based_position_mode = 5;
inline constexpr int normal_drive_mode = 0;  ///< counter-clockwise is positive; profiles are velocities
inline constexpr int middle_step = 2048;
inline constexpr int max_homing_steps = 1024;  ///< largest offset in either direction; some modes ignore a larger one
inline constexpr double deg_per_step = 360.0 / 4096.0;
inline constexpr double deg_s_per_unit = 0.229 * 6.0;   ///< unit of velocity: 0.229 revolutions a minute
inline constexpr int min_supply = 37, max_supply = 60;  ///< input voltage of an XL330, tenths of a volt
inline constexpr int watchdog_ticks = 15;               ///< value of bus_watchdog, in units of 20 ms: 300 ms
inline constexpr int watchdog_expired = -1;

/// Sends requests to one servo, one at a time, and receives the answers. Functions that send or receive throw
/// PlateFailure if the serial line has failed. All calls are made on one thread.
class Bus {
 public:
  Bus(std::unique_ptr<Line> line, std::uint8_t id) : line_(std::move(line)), id_(id) {}

  Line& line() const { return *line_; }
  std::uint8_t id() const { return id_; }
  /// Median time from a request to its answer.
  std::optional<std::chrono::nanoseconds> round_trip() const { return round_trips_.median(); }
  /// Number of requests and answers that were damaged in transmission.
  std::uint64_t damaged() const { return refused_ + reader_.damaged(); }

  Packet ping_request() const { return {.id = id_, .instruction = Instruction::ping}; }
  Packet read_request(Entry entry) const;
  Packet write_request(Entry entry, std::int64_t value) const;

  // ---- Calls that wait for the answer.

  /// Sends a request once. Returns nullopt if no answer arrives. The caller handles an error in the answer.
  std::optional<Packet> try_once(const Packet& request);
  /// Sends a request, up to ten times if it or its answer is lost or damaged. Throws PlateFailure after the tenth time,
  /// or if the servo refuses the request.
  Packet transact(const Packet& request);
  std::int64_t read(Entry entry);
  void write(Entry entry, std::int64_t value) { transact(write_request(entry, value)); }

  // ---- Calls that do not wait.

  /// Sends a request. Requires that awaits_answer() is false.
  void send(const Packet& request);
  /// Returns the answer to the last request if it has arrived. Returns each answer once.
  std::optional<Packet> answer();
  bool awaits_answer() const { return !is_answered_ && line_->now() - asked_ <= answer_limit; }
  /// Returns true, once for each request, if the last request was not answered within answer_limit.
  bool has_missed_answer();
  const Packet& request() const { return request_; }
  Line::Time asked() const { return asked_; }
  /// Throws PlateFailure if the servo has left requests unanswered for half a second.
  void check_silence() const;
  /// Adds a request that the servo reported as damaged to damaged().
  void count_refusal() { ++refused_; }
  /// Returns the text of a PlateFailure for `error`, which the servo has reported in its answer to `request`.
  static std::string describe(const Packet& request, StatusError error);

 private:
  // A request without an answer after this time counts as lost. The longest answer has 59 bytes: 10 ms at 57600 baud.
  static constexpr auto answer_limit = std::chrono::milliseconds(60);
  void discard_late_answer();
  void abandon_request();

  std::unique_ptr<Line> line_;
  std::uint8_t id_;
  PacketReader reader_;
  RoundTrips round_trips_;
  std::uint16_t sequence_ = 0;
  Packet request_;
  bool is_answered_ = true;
  std::uint64_t refused_ = 0;
  Line::Time asked_;
  std::optional<Line::Time> silent_since_;  // time of the first request since the last answer
};

}  // namespace hrt::plate::dynamixel
