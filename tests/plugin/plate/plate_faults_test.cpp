// Injects each pair of faults in each phase of operation. Measures the motion before the first command and after a
// stop, the speed and the largest force at the rim, and checks which fault is reported. Prints a table:
// hrt_plate_driver_tests --gtest_filter='PlateFaults*'
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_failure.h"
#include "samples/app/emulator/dynamixel.h"
#include "samples/app/emulator/hobby_plate.h"
#include "tests/plugin/plate/emulated_line.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

// Interval over which the speed is measured (five pulses of a hobby servo), and the time between the two faults.
constexpr auto window = 100ms;
constexpr double initial_deg = -20.0;
enum Phase { open, idle, home, move, hold, close };
constexpr const char* phases[] = {"open", "idle", "home", "move", "hold", "close"};

template <class Emulated>
struct Kind {
  const char* name;
  std::function<void(Emulated&)> begin;  ///< injects the fault; null: the serial line is unplugged
  std::vector<std::string> texts;  ///< the reported failure contains one of these; empty: the fault is not observable
  Phase first_phase = open;        ///< first phase in which the fault is observable
  std::function<void(Emulated&)> end;  ///< ends the fault 300 ms later; null: the fault lasts
};

template <class Emulated>
void disturb(Emulated& device) {
  static std::mt19937 random{5};
  std::string noise(200, '\0');
  for (char& byte : noise) byte = static_cast<char>(random());
  device.receive(noise, device.now());
  device.send(noise);
}

// The firmware with a hobby servo. In the phase "home" it has no sensor.
struct Hobby {
  using Emulated = HobbyPlate;
  static constexpr const char *name = "hobby servo", *device = "serial:line";
  static constexpr double speed_limit_deg_s = 200.0;  // limit of the firmware
  static constexpr double latency_s = 0.03;           // dead time of 10 ms, and one period of the pulses
  static constexpr bool homes = true, refuses_second_host = true;

  static HobbyPlate make(Phase phase) {
    return HobbyPlate(
        {.settings = phase == home ? settings_default() : commissioned(), .orientation_deg = initial_deg});
  }
  static void greet(HobbyPlate& board) { board.receive_line("HELLO 2 00042"); }
  static double force_n(const HobbyPlate&) { return 0.0; }  // unknown: the firmware does not limit the force
  static bool is_silent(const HobbyPlate&) { return false; }
  static inline const std::vector<Kind<HobbyPlate>> kinds = {
      {"unplug", {}, {"is unplugged"}},
      {"power loss",
       [](HobbyPlate& board) {
         board.restart();
         board.servo.supply = 0.0;
       },
       {"has restarted", "is stuck"},
       idle},
      {"reset", [](HobbyPlate& board) { board.restart(); }, {"has restarted"}, idle},
      {"emergency", [](HobbyPlate& board) { board.press_emergency_stop(true); }, {"emergency stop"}},
      {"second host", [](HobbyPlate& board) { board.receive_line("SET -040.00 40000"); }, {"another program"}, idle},
      {"garbage", disturb<HobbyPlate>, {}},
      {"silence", [](HobbyPlate& board) { board.stop_answering(); }, {"not answer", "not reported"}},
      {"stuck", [](HobbyPlate& board) { board.servo.is_jammed = true; }, {"is stuck"}},
      {"stall", [](HobbyPlate& board) { board.servo.supply = 0.3; }, {"less than 4 V"}},
      {"supply loss",
       [](HobbyPlate& board) { board.servo.supply = 0.0; },
       {"less than 4 V"},
       open,
       [](HobbyPlate& board) { board.servo.supply = 1.0; }}};
};

// The stronger XL330, with the largest effort. It needs no homing, because its orientation is always known. Its
// emergency stop cuts its supply.
struct Xl330 {
  using Emulated = EmulatedDynamixel;
  static constexpr const char *name = "XL330", *device = "dynamixel:line?effort=100";
  static constexpr double speed_limit_deg_s = 300.0;  // speed of its profile
  static constexpr double latency_s = 0.02;           // an exchange that must end first, and the exchange of the stop
  static constexpr bool homes = false, refuses_second_host = false;

  static EmulatedDynamixel make(Phase) {
    EmulatedDynamixel servo;
    servo.motor.turn_by_hand(initial_deg);
    servo.restart();
    return servo;
  }
  static void greet(EmulatedDynamixel& servo) {
    servo.receive(dynamixel::encode({.id = 1, .instruction = dynamixel::ping}), servo.now());
  }
  // ROBOTIS: stall torque 0.52 N m at 1.47 A. The rim is at 75 mm.
  static double force_n(const EmulatedDynamixel& servo) {
    return servo.get(64, 1) == 0 ? 0.0 : static_cast<double>(servo.get(102, 2)) / 1470.0 * 0.52 / 0.075;
  }
  static bool is_silent(const EmulatedDynamixel& servo) { return servo.is_silent; }
  static void lose_power(EmulatedDynamixel& servo) {
    servo.restart();
    servo.is_silent = true;
  }
  static inline const std::vector<Kind<EmulatedDynamixel>> kinds = {
      {"unplug", {}, {"is unplugged"}},
      {"power loss", lose_power, {"not answer"}},
      {"reset", [](EmulatedDynamixel& servo) { servo.restart(); }, {"has restarted"}, idle},
      {"emergency", lose_power, {"not answer"}},
      {"second host",
       [](EmulatedDynamixel& servo) {
         const std::string goal = dynamixel::little_endian(116, 2) + dynamixel::little_endian(1593, 4);
         servo.receive(dynamixel::encode({.id = 1, .instruction = dynamixel::write, .parameters = goal}), servo.now());
       },
       {"another program"},
       idle},
      {"garbage", disturb<EmulatedDynamixel>, {}},
      {"silence", [](EmulatedDynamixel& servo) { servo.is_silent = true; }, {"not answer"}},
      {"stuck", [](EmulatedDynamixel& servo) { servo.motor.is_jammed = true; }, {"is stuck"}},
      {"stall", [](EmulatedDynamixel& servo) { servo.motor.supply = 0.3; }, {}},
      {"supply loss", lose_power, {"has restarted", "not answer"}, idle, [](EmulatedDynamixel& servo) {
         servo.is_silent = false;
       }}};
};

// A plate with its host, into which faults are injected.
template <class Plate>
struct Operation {
  using Emulated = typename Plate::Emulated;

  explicit Operation(Phase phase) : board(Plate::make(phase)) {}

  Emulated board;
  std::unique_ptr<Device> host;
  std::set<std::string> reported;
  double before_first_set_deg = 0.0, after_stop_deg = 0.0, max_deg_s = 0.0, max_n = 0.0;
  bool is_set = false, is_unplugged = false;
  // Time of the stop: 300 ms later, by the plate's watchdog, if the line is unplugged or the plate is silent.
  std::optional<std::chrono::nanoseconds> stops;
  std::optional<double> stopped_deg;
  std::function<void(Emulated&)> ends;  // ends the injected fault
  std::chrono::nanoseconds ends_at{};

  void close_host() {
    if (host) stops = board.now() + (is_unplugged || Plate::is_silent(board) ? 300ms : 0ms);
    host.reset();
  }
  void watch_stop() {
    if (!stops || board.now() < *stops) return;
    if (!stopped_deg) stopped_deg = board.orientation_deg();
    after_stop_deg = std::max(after_stop_deg, std::abs(board.orientation_deg() - *stopped_deg));
  }

  // Runs the host for this time, and closes its device when the device fails. Without a host, only lets time pass.
  void run(std::chrono::milliseconds time) {
    for (const auto end = board.now() + time; board.now() < end;) {
      const double from_deg = board.orientation_deg();
      const auto from = board.now();
      while (board.now() < from + window) {
        try {
          if (host)
            host->wait(5ms);
          else
            board.run_until(board.now() + 5ms);
        } catch (const PlateFailure& failure) {
          reported.insert(failure.what());
          close_host();
        }
        watch_stop();
        if (ends && board.now() >= ends_at) std::exchange(ends, {})(board);
        max_n = std::max(max_n, Plate::force_n(board));
      }
      const double seconds = std::chrono::duration<double>(board.now() - from).count();
      max_deg_s = std::max(max_deg_s, std::abs(board.orientation_deg() - from_deg) / seconds);
      if (!is_set)
        before_first_set_deg = std::max(before_first_set_deg, std::abs(board.orientation_deg() - initial_deg));
    }
  }
  void open_host() {
    board.take_output();  // bytes that the plate sent before are lost
    try {
      host = device_named(Plate::device)(
          [this](const std::string&, int) { return std::make_unique<EmulatedLine<Emulated>>(board, is_unplugged); },
          Start::hold);
    } catch (const PlateFailure& failure) {
      reported.insert(failure.what());
    }
  }
  void set(double orientation_deg) {
    is_set = true;
    if (host) host->turn_to(orientation_deg);
  }
  void run_phases(Phase phase, const Kind<Emulated>& first, const Kind<Emulated>& second) {
    const auto inject = [&](Phase now) {
      if (now != phase) return;
      for (const auto* kind : {&first, &second}) {
        if (kind == &second) run(window);
        is_unplugged = is_unplugged || !kind->begin;
        if (kind->begin) kind->begin(board);
        if (!kind->end) continue;
        ends = kind->end;
        ends_at = board.now() + 300ms;
      }
    };
    if (phase == open) {  // the greeting of the host is interrupted
      Plate::greet(board);
      inject(open);
    }
    open_host();
    run(300ms);
    inject(idle);
    run(300ms);
    if (phase == home) {
      set(0.0);
      run(3s);
      inject(home);
      run(9s);
    }
    const double outermost_deg = phase == home ? 40.0 : 80.0;
    set(outermost_deg);
    run(100ms);
    inject(move);
    run(1500ms);
    inject(hold);
    run(300ms);
    set(-0.75 * outermost_deg);
    run(1500ms);
    inject(close);
    close_host();
    watch_stop();
    run(900ms);
  }
};

// True if the reported failures name the fault, or if it is not observable in this phase: after closing there is
// no host, and without a sensor a stuck servo is not detected.
template <class Emulated>
bool is_named(const Kind<Emulated>& kind, Phase phase, const std::string& reported) {
  const auto& words = kind.texts;
  return std::any_of(words.begin(), words.end(), [&](const auto& word) { return has(reported, word); }) ||
         words.empty() || phase < kind.first_phase || phase == close || (phase == home && words.front() == "is stuck");
}

// The serial line of an XL330 is unplugged while the servo moves, and a second host on its bus sends a goal. No
// driver can prevent that the servo executes the goal until 300 ms after the last packet. On the same computer, the
// lock of the serial line excludes a second program (PlateApi.ASecondProgramCannotUseTheLine).
template <class Plate>
bool has_only_second_host(Phase phase, const char* first, const char* second) {
  return !Plate::refuses_second_host && phase == move && std::string_view(first) == "unplug" &&
         std::string_view(second) == "second host";
}

// Runs all pairs of faults, prints the table, and returns the rows of plugin/src/plate/README.md that summarize it.
template <class Plate>
std::string run_all_pairs() {
  std::printf("%-12s %-12s %-12s %-6s %-14s %-14s %-8s %-8s %s\n", "plate", "fault", "and", "phase", "deg before set",
              "deg after stop", "deg/s", "N at rim", "reported");
  int runs = 0;
  double before_deg = 0.0, after_deg = 0.0, other_deg = 0.0, max_deg_s = 0.0, max_n = 0.0;
  const auto& kinds = Plate::kinds;
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = a; b < kinds.size(); ++b) {
      for (const Phase phase : {open, idle, home, move, hold, close}) {
        if (phase == home && !Plate::homes) continue;
        Operation<Plate> operation(phase);
        operation.run_phases(phase, kinds[a], kinds[b]);
        std::string reported;
        for (const std::string& what : operation.reported) reported += (reported.empty() ? "" : "; ") + what;
        std::printf("%-12s %-12s %-12s %-6s %14.1f %14.1f %8.0f %8.2f %s\n", Plate::name, kinds[a].name, kinds[b].name,
                    phases[phase], operation.before_first_set_deg, operation.after_stop_deg, operation.max_deg_s,
                    operation.max_n, reported.c_str());
        before_deg = std::max(before_deg, operation.before_first_set_deg);
        const bool is_other = has_only_second_host<Plate>(phase, kinds[a].name, kinds[b].name);
        (is_other ? other_deg : after_deg) = std::max(is_other ? other_deg : after_deg, operation.after_stop_deg);
        runs += is_other ? 0 : 1;
        max_deg_s = std::max(max_deg_s, operation.max_deg_s);
        max_n = std::max(max_n, operation.max_n);
        EXPECT_TRUE(is_named(kinds[a], phase, reported) || is_named(kinds[b], phase, reported)) << reported;
        EXPECT_TRUE(!reported.empty() || (is_named(kinds[a], phase, "") && is_named(kinds[b], phase, "")));
      }
    }
  }
  EXPECT_LE(before_deg, 2.0);
  EXPECT_LE(after_deg, 2.0 + Plate::latency_s * Plate::speed_limit_deg_s);
  EXPECT_LE(other_deg, Plate::speed_limit_deg_s * std::chrono::duration<double>(window).count());
  EXPECT_LE(max_deg_s, 1.1 * Plate::speed_limit_deg_s);
  EXPECT_LE(max_n, 5.0);
  std::array<char, 200> row{};
  std::snprintf(row.data(), row.size(), "| %s | %d | %.1f° | %.1f° | %.0f°/s (set to %.0f) | %s |\n", Plate::name, runs,
                before_deg, after_deg, max_deg_s, Plate::speed_limit_deg_s,
                max_n > 0.0 ? (std::to_string(max_n).substr(0, 4) + " N (set to 4)").c_str() : "not limited");
  std::string rows = row.data();
  if (!Plate::refuses_second_host) {
    std::snprintf(row.data(), row.size(), "| %s, unplugged, with a second host on its bus | 1 | | %.1f° | | |\n",
                  Plate::name, other_deg);
    rows += row.data();
  }
  std::printf("%s", rows.c_str());
  return rows;
}

TEST(PlateFaults, EachPairStaysWithinTheLimitsOfMotionSpeedAndForceAndIsReported) {
  std::ifstream file(HRT_PLATE_PAGES "/README.md");
  const std::string readme(std::istreambuf_iterator<char>(file), {});
  EXPECT_TRUE(has(readme, run_all_pairs<Hobby>()));
  EXPECT_TRUE(has(readme, run_all_pairs<Xl330>()));
}

}  // namespace
}  // namespace hrt::plate
