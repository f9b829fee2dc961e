#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_file.h"

namespace hrt::plate {

/// Detects a plate that is slower, later or less accurate than its plate file states. Reads no clock. One thread.
class FileWatch {
 public:
  using Time = Line::Time;

  explicit FileWatch(PlateFile file) : file_(std::move(file)) {}

  /// Call it after each Device::wait(). `command_deg` is nullopt while the plate has no command.
  void update(Time now, const Device& device, std::optional<double> command_deg);
  /// True if the plate has less than 80 % of the file's speed, rests for a second with more than the file's error, or
  /// follows its commands more than 40 ms later than the file's latency.
  bool deviates() const { return deviates_; }

 private:
  struct Command {
    Time acts;
    double orientation_deg;
  };
  void compare_with_model(Time now, const Device& device);

  PlateFile file_;
  std::optional<double> command_deg_;
  Time command_changed_, near_command_at_;  // near_command_at_: time of the last update without an error at rest
  bool deviates_ = false;
  // Model of a plate that behaves as in the file, and sums that estimate how much later than the model the plate moves.
  std::deque<Command> pending_;
  std::optional<double> goal_deg_;
  double model_deg_ = 0.0;
  Time updated_, reported_;
  double late_sum_ = 0.0, square_sum_ = 0.0, travelled_deg_ = 0.0;
};

}  // namespace hrt::plate
