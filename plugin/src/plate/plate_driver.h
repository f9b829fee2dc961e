// A plate with a thread of its own, which the host's threads never wait for.
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

/// Calls may come from any thread; set(), stop() and report() are lock-free, allocate nothing and make no
/// system call.
class PlateDriver {
 public:
  /// Starts to open the device. `path` is for messages, `file` what was measured of it. Throws
  /// std::system_error without a thread.
  PlateDriver(DeviceMaker maker, LineOpener opener, std::string path, std::optional<PlateFile> file,
              const hrt_plate_options& options);
  /// Stops the plate: within half a second. In the child of a fork it only lets go.
  ~PlateDriver();
  PlateDriver(const PlateDriver&) = delete;
  PlateDriver& operator=(const PlateDriver&) = delete;

  void set(double orientation_deg);
  void stop();
  hrt_plate_report report() const;
  /// True in the child of a fork: the thread is the parent's.
  bool is_inherited() const;
  /// set() moves a plate whose orientation is unknown.
  bool homes() const { return options_.homing == HRT_PLATE_HOMING_SLOW; }

 private:
  struct Published {
    hrt_plate_report report;
    std::int64_t reported_ns;  // time of the orientation, on the monotonic clock
  };
  using Time = Line::Time;

  void run() noexcept;
  void serve(Device& device);
  void follow_host(Device& device, Time now);
  void publish(const Device& device);
  void check_file(Device& device) const;
  void fail(Fault fault, const char* sentence) noexcept;
  Time now() const { return std::chrono::steady_clock::now(); }

  DeviceMaker maker_;
  LineOpener opener_;
  std::string path_;
  std::optional<PlateFile> file_;
  hrt_plate_options options_;
  std::uint32_t forks_;  // number of forks of this process and its parents when the plate was opened

  // From the host: the orientation, or not a number to stay; and that it lives.
  std::atomic<double> wanted_deg_;
  mutable std::atomic<std::uint32_t> calls_{0};
  std::atomic<bool> ending_{false};

  // The thread's own.
  Published now_known_{};
  std::uint32_t calls_seen_ = 0;
  Time host_heard_;
  bool host_is_silent_ = false;
  bool holds_ = true;
  bool has_arrived_ = false;  // the plate has reached a command
  std::optional<FileWatch> watch_;

  Snapshot<Published> published_;
  std::unique_ptr<std::thread> thread_;
};

}  // namespace hrt::plate
