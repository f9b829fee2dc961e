#include "samples/reach/xr/watchdog.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"
#include "samples/reach/base/interrupt.h"
#include "samples/reach/base/say.h"
#include "samples/reach/person/keyboard.h"

namespace hrt::reach {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto look_period = 10ms;
constexpr auto call_after_signal = 500ms;     // that a call may still take
constexpr auto program_after_signal = 900ms;  // that the program may still take
constexpr auto files_after_signal = 5s;       // while it closes its files
constexpr auto last_will_limit = 2s;          // what it waits for may never come
constexpr std::array crashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// A crash, wherever it was: the signal's number.
std::atomic<int> crash = 0;

[[noreturn]] void end_process(ExitCode code) {
  restore_terminal();
  if (const int signal = crash; signal != 0) {
    std::signal(signal, SIG_DFL);
    kill(getpid(), signal);
    pause();
  }
  std::_Exit(static_cast<int>(code));
}

class Watchdog {
 public:
  void start(std::chrono::milliseconds limit) {
    limit_ = limit;
    std::thread([this] { watch(); }).detach();
    std::thread([this] { limit_last_will(); }).detach();
    look_out_for_exit();
    catch_crashes();
  }

  // Never destroyed: its threads live as long as the process.
  static Watchdog& the() {
    static auto* const watchdog = new Watchdog;
    return *watchdog;
  }

  void set_last_will(std::function<void()> put_in_order) {
    if (put_in_order) look_out_for_exit();
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
      if (crash != 0) end_after_crash();
      std::unique_lock lock(mutex_);
      const auto now = Clock::now();
      const bool in_call = !call_.empty();
      if (in_call && now - call_began_ > limit_)
        end_program(lock, exit_code_ ? ExitCode{*exit_code_} : ExitCode::runtime_blocked,
                    "the OpenXR runtime has not returned from " + std::string(call_) +
                        format(" within %g s", static_cast<double>(limit_.count()) * 1e-3));
      if (!is_interrupted()) continue;
      if (!interrupted_at) interrupted_at = now;
      const auto passed = now - *interrupted_at;
      if (passed > call_after_signal) closed_ = true;
      if (passed > call_after_signal && in_call)
        end_program(lock, ExitCode::interrupted, "interrupted while the OpenXR runtime was in " + std::string(call_));
      // The other thread runs: its streams and files are out of reach.
      if (passed > (ending_ ? files_after_signal : program_after_signal)) {
        say("hrt-reach: interrupted; files may be incomplete\n");
        end_process(ExitCode::interrupted);
      }
    }
  }

  // The thread in the runtime is blocked, or this one.
  [[noreturn]] void end_program(std::unique_lock<std::mutex>& lock, ExitCode code, const std::string& why) {
    taken_over_ = true;
    const std::function<void()> put_in_order = std::exchange(put_in_order_, nullptr);
    lock.unlock();
    end_code_ = code;
    if (exit_code_) end_process(code);
    last_will_began_ = Clock::now().time_since_epoch().count();
    try {
      if (put_in_order) put_in_order();
    } catch (const std::exception& error) {
      say(format("hrt-reach: %s\n", error.what()));
    }
    say("hrt-reach: " + why + "\n");
    end_process(code);
  }

  // The thread that crashed waits, perhaps with a lock of ours or of the allocator.
  [[noreturn]] void end_after_crash() {
    last_will_began_ = Clock::now().time_since_epoch().count();
    std::unique_lock lock(mutex_);
    const std::string where = call_.empty() ? "" : " while the OpenXR runtime was in " + std::string(call_);
    end_program(lock, ExitCode::runtime_failed, "it crashed" + where);
  }

  // Libraries that were loaded since the last call are still there when the program exits.
  static void look_out_for_exit() {
    std::atexit([] { the().program_exits(); });
  }

  // The program's own exit is expected. Any other one is the runtime's, and no success.
  void program_exits() {
    std::unique_lock lock(mutex_);
    if (exit_code_) return;
    if (taken_over_) park(lock);
    end_program(lock, ExitCode::runtime_failed,
                call_.empty() ? "the OpenXR runtime ended the program"
                              : "the OpenXR runtime ended the program in " + std::string(call_));
  }

  void limit_last_will() {
    for (;;) {
      std::this_thread::sleep_for(look_period);
      const Clock::rep began = last_will_began_;
      if (began != 0 && Clock::now() - Clock::time_point(Clock::duration(began)) > last_will_limit)
        end_process(end_code_);
    }
  }

  // On a stack of its own, since a thread may have used up the other.
  static void catch_crashes() {
    static std::array<char, 65536> stack;
    const stack_t alternative{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
    sigaltstack(&alternative, nullptr);
    struct sigaction action{};
    action.sa_handler = [](int signal) {
      int none = 0;
      if (!crash.compare_exchange_strong(none, signal)) {  // in the last will, too
        std::signal(none, SIG_DFL);
        raise(none);
      }
      for (;;) pause();
    };
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    for (const int signal : crashes) sigaction(signal, &action, nullptr);
  }

  std::mutex mutex_;
  std::condition_variable never_;
  std::chrono::milliseconds limit_{};
  std::function<void()> put_in_order_;
  std::string_view call_;  // empty: none
  Clock::time_point call_began_;
  std::optional<int> exit_code_;  // the program exits with it
  std::atomic<Clock::rep> last_will_began_ = 0;
  std::atomic<ExitCode> end_code_ = ExitCode::runtime_failed;
  bool closed_ = false;  // for calls, since a signal came
  bool ending_ = false;
  bool taken_over_ = false;
};

}  // namespace

void watch_runtime(std::chrono::milliseconds limit) { Watchdog::the().start(limit); }

LastWill::LastWill(std::function<void()> put_in_order) { Watchdog::the().set_last_will(std::move(put_in_order)); }

LastWill::~LastWill() { Watchdog::the().set_last_will(nullptr); }

void put_in_order_now() { Watchdog::the().put_in_order_now(); }

bool is_runtime_blocked() { return Watchdog::the().has_taken_over(); }

void expect_exit(int exit_code) { Watchdog::the().expect_exit(exit_code); }

RuntimeCall::RuntimeCall(std::string_view name) { Watchdog::the().begin_call(name); }

RuntimeCall::~RuntimeCall() { Watchdog::the().end_call(); }

}  // namespace hrt::reach
