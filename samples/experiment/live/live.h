// A page on 127.0.0.1 that shows a session to its experimenter, fed by server-sent events.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "samples/app/run/stage.h"

namespace httplib {
class Server;
}

namespace hrt::experiment {

class Live {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr auto show_period = std::chrono::milliseconds(100);

  /// Serves at once, at a free port. `takes_keys`: there is a second address, whose page has keys.
  explicit Live(bool takes_keys);
  ~Live();
  Live(const Live&) = delete;
  Live& operator=(const Live&) = delete;

  /// A line each: "Live view: http://127.0.0.1:PORT/TOKEN/", and "Live view with keys: ...".
  std::string addresses() const;

  /// The values that page.html shows, by its names. Used by the thread that runs the session, as are the calls below.
  nlohmann::json facts;
  /// Gives readers a copy, and waits for none.
  void show() { shown_.store(std::make_shared<const nlohmann::json>(facts)); }
  /// Call in every frame. `registered`: when a touch checked the plate's place.
  void frame(app::Stage& stage, XrTime time, std::optional<Clock::time_point> registered);
  /// Call in every frame of a reach.
  void moment(const app::Stage& stage, const app::TargetPair& pair, const app::Moment& moment, bool is_first);
  /// The next key that has been pressed on a page, if any.
  std::optional<char> key();

 private:
  void route();
  void check(app::Stage& stage, std::optional<Clock::time_point> registered);

  std::atomic<std::shared_ptr<const nlohmann::json>> shown_ =
      std::make_shared<const nlohmann::json>(nlohmann::json::object());
  Clock::time_point shown_at_;
  XrTime last_frame_ = 0;
  double period_s_ = 0.0;             // of frames, a mean over the last ones
  app::Point finger_m_{}, felt_m_{};  // ends of the two paths
  std::mutex mutex_;                  // of pressed_
  std::string pressed_, look_token_, keys_token_;
  std::atomic<bool> is_ending_ = false;
  std::atomic<int> streams_ = 0;
  int port_ = 0;
  std::unique_ptr<httplib::Server> server_;
  std::thread thread_;
};

}  // namespace hrt::experiment
