// A plate at the other end of a pseudo-terminal, which does what plate_protocol.md says, or fails to.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hrt::reach {

class PtyPlate {
 public:
  struct Behaviour {
    std::string greeting = "PLATE 1 -90.00 90.00 400.00";
    bool answers = true;                      ///< to HELLO
    bool reports = true;                      ///< where it is, every 20 ms
    std::string noise;                        ///< bytes sent before every line
    std::chrono::milliseconds byte_delay{0};  ///< after every byte
  };

  explicit PtyPlate(Behaviour behaviour);
  PtyPlate() : PtyPlate(Behaviour{}) {}
  ~PtyPlate();
  PtyPlate(const PtyPlate&) = delete;
  PtyPlate& operator=(const PtyPlate&) = delete;
  PtyPlate(PtyPlate&&) = delete;
  PtyPlate& operator=(PtyPlate&&) = delete;

  /// The line's name, to be opened by the host.
  const std::string& device() const { return device_; }

  /// Falls silent, as if it had crashed.
  void fall_silent() { silent_ = true; }
  /// The line is gone.
  void unplug();
  /// Sends this body as a line.
  void send(const std::string& body);

  /// Bodies of valid lines heard so far.
  std::vector<std::string> heard() const;
  bool moving_allowed() const { return allowed_; }
  double orientation_deg() const { return orientation_deg_; }

 private:
  void live();
  void hear(const std::string& body);
  void write_bytes(const std::string& bytes);

  Behaviour behaviour_;
  int master_ = -1;
  int slave_ = -1;
  std::string device_;
  std::atomic<bool> ending_ = false;
  std::atomic<bool> silent_ = false;
  std::atomic<bool> unplugged_ = false;
  std::atomic<bool> gone_ = false;     // unplugged, and the line is closed
  std::atomic<bool> allowed_ = false;  // to move: a SET came and heartbeats continue
  std::atomic<double> orientation_deg_ = 0.0;
  bool greeted_ = false;
  mutable std::mutex mutex_;  // of heard_ and to_send_
  std::vector<std::string> heard_;
  std::vector<std::string> to_send_;
  std::thread thread_;
};

/// True as soon as `condition` is, false if it is not within five seconds.
bool eventually(const std::function<bool()>& condition);

}  // namespace hrt::reach
