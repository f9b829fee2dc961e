#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "haptic_retargeting/plate.h"
#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_failure.h"
#include "plugin/include/plate_driver/plate_file.h"
#include "plugin/src/plate/file_watch.h"
#include "plugin/src/plate/snapshot.h"

namespace hrt::plate {

/// Driver of one plate, with a thread that communicates with the device. set(), stop() and report() may be called on
/// any thread, take no lock and allocate nothing; report() may make a system call, to read the monotonic clock.
class PlateDriver {
 public:
  /// Starts to open the device. Failures name `path`. `file`: nullopt if the plate was not opened by a plate file.
  /// Throws std::system_error if no thread can be started.
  PlateDriver(DeviceMaker maker, LineOpener opener, std::string path, std::optional<PlateFile> file,
              const hrt_plate_options& options);
  /// Stops the plate and waits for the thread, at most half a second. In the child of a fork, only releases memory.
  ~PlateDriver();
  PlateDriver(const PlateDriver&) = delete;
  PlateDriver& operator=(const PlateDriver&) = delete;

  void set(double orientation_deg);
  void stop();
  hrt_plate_report report() const;
  /// True in the child of a fork, which does not have the thread.
  bool is_inherited() const;
  /// True if set() may home a plate whose orientation is unknown.
  bool homes() const { return options_.homing == HRT_PLATE_HOMING_SLOW; }

 private:
  struct Published {
    hrt_plate_report report;
    std::int64_t reported_ns;  // time of the orientation, on the monotonic clock
  };
  using Time = Line::Time;

  void run() noexcept;
  void operate(Device& device);
  void update_command(Device& device, Time now);
  void publish(const Device& device);
  void check_file(Device& device) const;
  void fail(Fault fault, const char* sentence) noexcept;
  Time now() const { return std::chrono::steady_clock::now(); }

  DeviceMaker maker_;
  LineOpener opener_;
  std::string path_;
  std::optional<PlateFile> file_;
  hrt_plate_options options_;
  std::uint32_t forks_;  // value of the counter of forks when the plate was opened

  std::atomic<double> wanted_deg_;               // NaN: hold the present orientation
  mutable std::atomic<std::uint32_t> calls_{0};  // calls of set(), stop() and report()
  std::atomic<bool> is_closing_{false};

  // Used only by the thread of the driver.
  Published state_{};
  std::uint32_t calls_seen_ = 0;
  Time last_call_;
  bool host_is_silent_ = false;
  bool is_holding_ = true;    // the plate has no command, or was stopped
  bool has_arrived_ = false;  // the plate has reached a command since it was opened
  std::optional<FileWatch> watch_;

  Snapshot<Published> published_;
  std::unique_ptr<std::thread> thread_;
};

}  // namespace hrt::plate
