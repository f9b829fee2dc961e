// The emulated plate at the other end of a pseudo-terminal, in real time.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/plugin/plate/emulated_plate.h"

namespace hrt::plate {

class PtyPlate {
 public:
  explicit PtyPlate(EmulatedPlate::Behaviour behaviour);
  PtyPlate() : PtyPlate(EmulatedPlate::Behaviour{}) {}
  ~PtyPlate();
  PtyPlate(const PtyPlate&) = delete;
  PtyPlate& operator=(const PtyPlate&) = delete;
  PtyPlate(PtyPlate&&) = delete;
  PtyPlate& operator=(PtyPlate&&) = delete;

  /// The line's name, to be opened by the host.
  const std::string& device() const { return device_; }
  /// The line is gone.
  void unplug();

  /// As of EmulatedPlate.
  void send(const std::string& body);
  void fall_silent();
  std::vector<std::string> heard() const;
  bool moving_allowed() const;
  double orientation_deg() const;

 private:
  void live();

  EmulatedPlate plate_;
  mutable std::mutex mutex_;  // of plate_
  int master_ = -1;
  int slave_ = -1;
  std::string device_;
  std::atomic<bool> ending_ = false;
  std::atomic<bool> unplugged_ = false;
  std::atomic<bool> gone_ = false;  // unplugged, and the line is closed
  std::thread thread_;
};

/// True as soon as `condition` is, false if it is not within 20 seconds.
bool eventually(const std::function<bool()>& condition);

}  // namespace hrt::plate
