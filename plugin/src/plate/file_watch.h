// Compares the behaviour of a plate with the measurements of its commissioning.
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_file.h"

namespace hrt::plate {

/// Detects a plate that is slower, later or less accurate than its file. Reads no clock. One thread.
class FileWatch {
 public:
  using Time = Line::Time;

  explicit FileWatch(PlateFile file) : file_(std::move(file)) {}

  /// Call after each Device::wait(). `command_deg`: nullopt while the plate has no command.
  void look(Time now, const Device& device, std::optional<double> command_deg);
  /// True if the plate is slower than 80 % of the file's speed, rests farther from its command than the file's error,
  /// or follows 40 ms later than the file says.
  bool deviates() const { return deviates_; }

 private:
  struct Command {
    Time acts;
    double orientation_deg;
  };
  void follow(Time now, const Device& device);

  PlateFile file_;
  std::optional<double> command_deg_;
  Time commanded_, near_;  // time of the last change of the command, and of the last position near it
  bool deviates_ = false;
  // Model of a plate that follows its commands as in the file; lateness of the reported plate against it.
  std::deque<Command> coming_;
  std::optional<double> goal_deg_;
  double model_deg_ = 0.0;
  Time looked_, reported_;
  double late_sum_ = 0.0, square_sum_ = 0.0, way_deg_ = 0.0;
};

}  // namespace hrt::plate
