#include "samples/reach/xr/watchdog.h"

#include <unistd.h>

#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/base/interrupt.h"
#include "samples/reach/person/keyboard.h"

namespace hrt::reach {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto look_period = 10ms;
constexpr auto call_after_signal = 500ms;     // that a call may still take
constexpr auto program_after_signal = 900ms;  // that the program may still take

class Watchdog {
 public:
  void start(std::chrono::milliseconds limit) {
    limit_ = limit;
    std::thread([this] { watch(); }).detach();
  }

  void set_last_will(std::function<void()> put_in_order) {
    const std::lock_guard lock(mutex_);
    put_in_order_ = std::move(put_in_order);
  }

  void put_in_order_now() {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }

  bool has_taken_over() {
    const std::lock_guard lock(mutex_);
    return taken_over_;
  }

  void expect_exit(int exit_code) {
    const std::lock_guard lock(mutex_);
    exit_code_ = exit_code;
    enter("exit");
  }

  void begin_call(std::string_view name) {
    std::unique_lock lock(mutex_);
    enter(name);
    // No call begins any more; the watchdog finds this one and ends the program.
    if (closed_) park(lock);
  }

  void end_call() {
    std::unique_lock lock(mutex_);
    if (taken_over_) park(lock);
    call_ = {};
  }

 private:
  void enter(std::string_view name) {
    call_ = name.substr(0, name.find('('));
    call_began_ = Clock::now();
  }

  [[noreturn]] void park(std::unique_lock<std::mutex>& lock) {
    for (;;) never_.wait(lock);
  }

  void watch() {
    std::optional<Clock::time_point> interrupted_at;
    for (;;) {
      std::this_thread::sleep_for(look_period);
      std::unique_lock lock(mutex_);
      const auto now = Clock::now();
      const bool in_call = !call_.empty();
      if (in_call && now - call_began_ > limit_) end_program(lock, ExitCode::runtime_blocked);
      if (!is_interrupted()) continue;
      if (!interrupted_at) interrupted_at = now;
      const auto passed = now - *interrupted_at;
      if (passed > call_after_signal) closed_ = true;
      if (passed > call_after_signal && in_call) end_program(lock, ExitCode::interrupted);
      if (passed > program_after_signal && !ending_) end_without_order();
    }
  }

  [[noreturn]] void end_program(std::unique_lock<std::mutex>& lock, ExitCode code) {
    taken_over_ = true;
    const std::function<void()> put_in_order = std::exchange(put_in_order_, nullptr);
    const std::string call(call_);
    lock.unlock();
    if (exit_code_) std::_Exit(code == ExitCode::interrupted ? static_cast<int>(code) : *exit_code_);
    try {
      if (put_in_order) put_in_order();
    } catch (const std::exception& error) {
      std::cerr << "hrt-reach: " << error.what() << "\n";
    }
    if (code == ExitCode::interrupted)
      std::cerr << "hrt-reach: interrupted while the OpenXR runtime was in " << call << "\n";
    else
      std::cerr << "hrt-reach: the OpenXR runtime has not returned from " << call
                << format(" within %g s", static_cast<double>(limit_.count()) * 1e-3) << "\n";
    std::cout.flush();
    std::_Exit(static_cast<int>(code));
  }

  // The other thread runs: its streams and files are out of reach.
  [[noreturn]] static void end_without_order() {
    restore_terminal();
    constexpr std::string_view text = "hrt-reach: interrupted; files may be incomplete\n";
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) std::_Exit(static_cast<int>(ExitCode::output));
    std::_Exit(static_cast<int>(ExitCode::interrupted));
  }

  std::mutex mutex_;
  std::condition_variable never_;
  std::chrono::milliseconds limit_{};
  std::function<void()> put_in_order_;
  std::string_view call_;  // empty: none
  Clock::time_point call_began_;
  std::optional<int> exit_code_;  // the program exits with it
  bool closed_ = false;           // for calls, since a signal came
  bool ending_ = false;
  bool taken_over_ = false;
};

// Never destroyed: its thread lives as long as the process.
Watchdog& watchdog() {
  static auto* const the = new Watchdog;
  return *the;
}

}  // namespace

void watch_runtime(std::chrono::milliseconds limit) {
  watchdog().start(limit);
}

LastWill::LastWill(std::function<void()> put_in_order) {
  watchdog().set_last_will(std::move(put_in_order));
}

LastWill::~LastWill() {
  watchdog().set_last_will(nullptr);
}

void put_in_order_now() {
  watchdog().put_in_order_now();
}

bool is_runtime_blocked() {
  return watchdog().has_taken_over();
}

void expect_exit(int exit_code) {
  watchdog().expect_exit(exit_code);
}

RuntimeCall::RuntimeCall(std::string_view name) {
  watchdog().begin_call(name);
}

RuntimeCall::~RuntimeCall() {
  watchdog().end_call();
}

}  // namespace hrt::reach
