// Complete reaches in real time: scene, OpenXR runtime, plugin, serial line, board and servo, and a simulated user.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <regex>
#include <thread>

#include "samples/app/emulator/pty_device.h"
#include "tests/plugin/plate/eventually.h"
#include "tests/samples/plate/board_with_servo.h"
#include "tests/samples/reach/program.h"

namespace hrt::plate {
namespace {

using reach::desk;

const std::string real_time = R"({"clock": "real-time", )" + reach::calm + "}";

template <class Board>
double max_turn_deg(PtyDevice<Board>& board) {
  double turn_deg = 0.0;
  for (const Pulse& pulse : board.with(&EmulatedBoard::pulses))
    turn_deg = std::max(turn_deg, std::abs(pulse.width_us() - 1500.0) * 180.0 / 2000.0);
  return turn_deg;
}

// Returns the number `name` of the last configuration in a recording; -1 if there is no such number.
double planned(const std::string& recording, const std::string& name) {
  const std::size_t config = recording.rfind("# config ");
  const std::size_t at = recording.find("\"" + name + "\":", config);
  if (config == std::string::npos || at == std::string::npos) return -1.0;
  return std::stod(recording.substr(at + name.size() + 3, 30));
}

TEST(ReachWithFirmware, ReachesTheTarget) {
  PtyDevice<BoardWithServo> board;
  const std::string recording = reach::scratch_folder() + "/reach.csv";
  const Outcome outcome = expect_exit(
      0, reach::run_scripted(
             real_time, {desk, "--target", "goblet", "--plate", "serial:" + board.device(), "--record", recording}));
  ASSERT_EQ(reach::rows_of(outcome).size(), 1U) << outcome.err;
  EXPECT_TRUE(has(outcome.out, {"protocol 2, firmware 1.1.0", "orientation measured"}));
  EXPECT_GT(max_turn_deg(board), 30.0);
  // The controller used the measured latency: 30 ms of the plate, and half of the round trip.
  const std::string recorded = read_file(recording);
  const double latency_ms = planned(recorded, "plate_latency_ns") * 1e-6;
  EXPECT_GT(latency_ms, 31.0);
  EXPECT_LT(latency_ms, 70.0);
  EXPECT_EQ(planned(recorded, "plate_max_speed_deg_s"), 200.0);
  EXPECT_EQ(planned(recorded, "plate_upper_stop_deg"), 90.0);
  std::printf("%s", outcome.out.c_str());
}

TEST(ReachWithFirmware, IsEndedByAResetOfTheBoardAndByTheEmergencyStop) {
  for (const bool reset : {true, false}) {
    PtyDevice<BoardWithServo> board;
    reach::Program program({desk, "--target", "goblet", "--plate", "serial:" + board.device()},
                           reach::scripted_environment(real_time));
    const auto pulses = [&] { return board.with(&EmulatedBoard::pulses).size(); };
    while (max_turn_deg(board) < 10.0 && pulses() < 300) std::this_thread::yield();
    const std::size_t before = board.with([&](BoardWithServo& emulated) {
      if (reset)
        emulated.reset();
      else
        emulated.open_emergency_stop(true);
      return emulated.pulses().size();
    });
    const Outcome outcome = expect_exit(9, program.wait());
    const char* const why = reset ? "has restarted" : "was stopped by its emergency stop";
    EXPECT_TRUE(has(outcome.err, why));
    EXPECT_LE(pulses(), before + (reset ? 0 : 2));
  }
}

// Process of hrt-plate emulate, with its input and output.
class EmulatedPlate {
 public:
  explicit EmulatedPlate(const std::string& kind)
      : process_({HRT_PLATE_PROGRAM, "emulate", kind, "--link", link_}, {}, -1, input_.descriptor()) {
    EXPECT_TRUE(eventually([&] { return process_.out().find("Ctrl-C") != std::string::npos; })) << process_.err();
  }
  const std::string& link() const { return link_; }
  void type(const std::string& line) { input_.type(line + "\n"); }
  Outcome end() {
    process_.send_signal(SIGINT);
    return process_.wait();
  }

 private:
  std::string link_ = reach::scratch_folder() + "/plate";
  Pty input_{80};
  Process process_;
};

// A rehearsal on one computer. The simulated user is slow, so that the finger does not move far while a busy machine
// sends no command to the plate.
TEST(ReachWithEmulatedPlate, ReachesTheTarget) {
  const std::regex pace("\"duration_ms\": 2400");
  const std::string unhurried = std::regex_replace(real_time, pace, "\"duration_ms\": 4800");
  for (const bool hobby : {true, false}) {
    EmulatedPlate plate(hobby ? "hobby" : "xl330");
    const std::string name = (hobby ? "serial:" : "dynamixel:") + plate.link();
    const Outcome outcome =
        expect_exit(0, reach::run_scripted(unhurried, {desk, "--target", "goblet", "--plate", name}));
    EXPECT_EQ(reach::rows_of(outcome).size(), 1U) << outcome.err;
    EXPECT_TRUE(has(outcome.out, hobby ? "firmware 1.1.0-emulated" : "XL330-M077, id 1, firmware 0"));
    const Outcome ended = expect_exit(0, plate.end());
    EXPECT_TRUE(has(ended.out, "SIMULATION") && has(ended.out, name));
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(plate.link())));
  }
}

TEST(ReachWithEmulatedPlate, IsEndedByItsEmergencyStopAndAJam) {
  for (const bool pressed : {true, false}) {
    EmulatedPlate plate("hobby");
    reach::Program program({desk, "--target", "goblet", "--plate", "serial:" + plate.link()},
                           reach::scripted_environment(real_time));
    EXPECT_TRUE(eventually([&] { return program.out().find("Plate at") != std::string::npos; }));
    plate.type(pressed ? "e" : "j");
    const Outcome outcome = expect_exit(9, program.wait());
    EXPECT_TRUE(has(outcome.err, pressed ? "emergency stop" : "stuck"));
    EXPECT_TRUE(has(plate.end().out, pressed ? "the emergency stop is pressed" : "the servo is jammed"));
  }
}

}  // namespace
}  // namespace hrt::plate
