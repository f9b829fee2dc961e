// The fingertip on a multitouch device of Linux (evdev), such as an infrared touch frame around the plate.
#pragma once

#include <haptic_retargeting/session.h>

#include <chrono>
#include <deque>
#include <memory>
#include <string>

#include "samples/app/xr/session.h"

struct libevdev;

namespace hrt::app {

/// For use by one thread. No call blocks.
class TouchFrame {
 public:
  /// Opens "evdev:PATH?NAME=NUMBER&..." for this program alone, so that touches do not reach the desktop. Throws
  /// Failure: ExitCode::usage if `text` is invalid, ExitCode::tracker if the device cannot be used.
  explicit TouchFrame(const std::string& text);

  std::string description() const;  ///< name and size of the device, and positions of objects on it, in one line
  /// Sets noise_m, latency_ns and bearing_sd_deg of `tracker` where they are 0.
  void configure(hrt_session_tracker& tracker) const;
  /// Returns the fingertip 12 ms before `now_ns` (CLOCK_MONOTONIC), in plate coordinates, interpolated between two
  /// reports of the device. Fingertip::lifted is true if the finger did not touch the device then. Throws Failure
  /// (ExitCode::tracker) if the device was unplugged.
  Fingertip locate(std::int64_t now_ns = std::chrono::steady_clock::now().time_since_epoch() /
                                         std::chrono::nanoseconds(1));

 private:
  struct Contact {
    int id = -1;                      // tracking id of the kernel; negative: no contact
    std::array<double, 3> place_m{};  // in plate coordinates
    std::int64_t time_ns = 0;
  };
  void take_report(std::int64_t time_ns);
  std::array<double, 3> place_m(unsigned slot) const;

  std::map<std::string, double> settings_{{"width_mm", 0.0},      {"height_mm", 0.0}, {"right_mm", 0.0},
                                          {"towards_mm", 0.0},    {"turn_deg", 0.0},  {"latency_ms", 15.0},
                                          {"bearing_sd_deg", 0.2}};
  std::string path_;
  std::unique_ptr<libevdev, void (*)(libevdev*)> device_;
  std::vector<Contact> contacts_;  // present contacts, by slot
  std::vector<Contact> objects_;   // contacts that existed when the device was opened: objects on the plate
  std::deque<Contact> history_;    // the finger in the latest reports, oldest first
  bool is_in_sync_ = true;         // false: events were dropped, and the device's state is being read
};

}  // namespace hrt::app
