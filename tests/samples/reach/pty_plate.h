// A plate at the other end of a pseudo-terminal, which does what samples/plate/protocol.md says, or fails to.
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
    std::string greeting = "PLATE 2 -90.00 90.00 400.00 10.00 measured";  ///< also selects the version
    bool answers = true;                                                  ///< to HELLO
    bool reports = true;                                                  ///< where it is, every 20 ms
    bool turns = true;                        ///< to where it is sent, at once; else it stays at 0
    double speed_deg_s = 1e9;                 ///< at which it really turns
    std::chrono::milliseconds boot{0};        ///< deaf and mute until then
    std::string noise;                        ///< bytes sent before every line
    std::chrono::microseconds byte_delay{0};  ///< after every byte
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

  /// Forgets its host, as after a reset.
  void restart();

  /// Bodies of valid lines heard so far, without sequence numbers.
  std::vector<std::string> heard() const;
  /// It was sent elsewhere than where it was, and neither stopped nor missed its heartbeats since.
  bool moving_allowed() const { return allowed_; }
  /// How often it stopped for want of a heartbeat.
  int heartbeat_stops() const { return heartbeat_stops_; }
  double orientation_deg() const { return orientation_deg_; }

 private:
  void live();
  void hear(std::string body);
  void turn(std::chrono::nanoseconds time);
  bool is_first_version() const;
  std::string place() const;
  std::string sealed(const std::string& body) const;
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
  std::atomic<int> heartbeat_stops_ = 0;
  std::atomic<double> target_deg_ = 0.0;
  std::atomic<bool> greeted_ = false;
  std::string sequence_ = " 00000";
  mutable std::mutex mutex_;  // of heard_ and to_send_
  std::vector<std::string> heard_;
  std::vector<std::string> to_send_;
  std::thread thread_;
};

/// True as soon as `condition` is, false if it is not within five seconds.
bool eventually(const std::function<bool()>& condition);

}  // namespace hrt::reach
