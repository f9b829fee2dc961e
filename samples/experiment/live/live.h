// A page on 127.0.0.1 that displays the session to the experimenter, by server-sent events.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "samples/app/run/run_context.h"

namespace httplib {
class Server;
}

namespace hrt::experiment {

class Live {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr auto show_period = std::chrono::milliseconds(100);

  /// Starts the server at a free port. `takes_keys`: adds a second address, whose page has keys.
  explicit Live(bool takes_keys);
  ~Live();
  Live(const Live&) = delete;
  Live& operator=(const Live&) = delete;

  /// Returns one line per address: "Live view: http://127.0.0.1:PORT/TOKEN/", and "Live view with keys: ...".
  std::string addresses() const;

  /// Values that page.html displays, by name. Only the thread of the session may use `facts` and the calls below.
  nlohmann::json facts;
  /// Publishes a copy of `facts` to the open pages without blocking.
  void show() { shown_.store(std::make_shared<const nlohmann::json>(facts)); }
  /// Updates the facts about the plate and the checks every 100 ms, and publishes them. Call in every frame.
  /// `registered`: time at which the plate's pose was last set or checked.
  void frame(app::RunContext& context, XrTime time, std::optional<Clock::time_point> registered);
  /// Extends the true and the perceived path in `facts`; `is_first` begins new paths. Call in every frame of a reach.
  void moment(const app::RunContext& context, const app::TargetPair& pair, const app::Moment& moment, bool is_first);
  std::optional<char> key();

 private:
  void route();
  void check(app::RunContext& context, std::optional<Clock::time_point> registered);

  std::atomic<std::shared_ptr<const nlohmann::json>> shown_ =
      std::make_shared<const nlohmann::json>(nlohmann::json::object());
  Clock::time_point shown_at_;
  XrTime last_frame_ = 0;
  double period_s_ = 0.0;             // moving average of the time between frames
  app::Point finger_m_{}, felt_m_{};  // ends of the true and the perceived path
  std::mutex mutex_;                  // protects pressed_
  std::string pressed_, look_token_, keys_token_;
  std::atomic<bool> is_ending_ = false;
  std::atomic<int> streams_ = 0;
  int port_ = 0;
  std::unique_ptr<httplib::Server> server_;
  std::thread thread_;
};

}  // namespace hrt::experiment
