// Runs a command with emulated plates at the other end of pseudo-terminals: the firmware on an emulated board, and a
// Dynamixel servo. Environment variables of the command name the board, and the file of the servo, as of `hrt-plate
// commission`:
//   with_plate COMMAND...    HRT_PLATE_DEVICE=serial:/dev/pts/1 HRT_PLATE_FILE=/tmp/with_plate.1.json
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "plugin/include/plate_driver/plate_file.h"
#include "samples/app/emulator/pty_device.h"
#include "tests/samples/plate/board_with_servo.h"

namespace {

using namespace std::chrono_literals;

// A homed board without a sensor, whose reported orientation is therefore exactly the command.
struct HomedBoard : hrt::plate::EmulatedBoard {
  HomedBoard()
      : EmulatedBoard(
            hrt::plate::eeprom_with(hrt::plate::settings_with({{SETTING_MIN_DEG, -90}, {SETTING_MAX_DEG, 90}}))) {
    run_for(50ms);
    receive_line("HELLO 2");
    receive_line(hrt::plate::motion_body(0.0, 1, "HOME"));
    while (now() < 8200ms) {
      run_for(100ms);
      receive_line(hrt::plate::with_number("BEAT", 2));
    }
    take_output();
  }
};

}  // namespace

int main(int argc, char** argv) {
  constexpr int cannot_run = 127;
  if (argc < 2) return cannot_run;
  const hrt::plate::PtyDevice<HomedBoard> board;
  const hrt::plate::PtyDynamixel servo;
  setenv("HRT_PLATE_DEVICE", ("serial:" + board.device()).c_str(), 1);
  const std::string file = "/tmp/with_plate." + std::to_string(getpid()) + ".json";
  std::ofstream(file) << hrt::plate::with_checksum(R"({
  "format": "haptic plate 1", "device": "dynamixel:)" +
                                                   servo.device() + R"(",
  "description": "Dynamixel XL330-M288, id 1, firmware 52", "details": [],
  "session": {"plate_max_speed_deg_s": 123.0, "plate_max_acceleration_deg_s2": 5000.0}, "measured": {"latency_ms": [4.0, 1.0]}, "max_error_deg": 1.0,
)");
  setenv("HRT_PLATE_FILE", file.c_str(), 1);
  const pid_t child = fork();
  if (child == 0) {
    execvp(argv[1], argv + 1);
    _exit(cannot_run);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    std::perror("with_plate");
    return cannot_run;
  }
  std::remove(file.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : cannot_run;
}
