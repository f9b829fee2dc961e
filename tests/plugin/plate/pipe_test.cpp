// Tests of the driver on Windows with an emulated servo behind a named pipe, which replaces the serial line.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// The headers below must follow windows.h.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include "plugin/include/plate_driver/plate_file.h"
#include "samples/app/emulator/dynamixel.h"
#include "tests/plugin/plate/eventually.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

// Servo behind a named pipe with two instances, so that one can be opened while the other is in use.
class PipeDynamixel {
 public:
  PipeDynamixel()
      : name_("\\\\.\\pipe\\hrt_plate_test_" + std::to_string(GetCurrentProcessId())),
        ends_{made(), made()},
        thread_([this] { simulate(); }) {}
  ~PipeDynamixel() {
    unplug();
    thread_.join();
  }
  PipeDynamixel(const PipeDynamixel&) = delete;
  PipeDynamixel& operator=(const PipeDynamixel&) = delete;

  const std::string& name() const { return name_; }
  void unplug() { ending_ = true; }

 private:
  void simulate() {
    const auto began = std::chrono::steady_clock::now();
    while (!ending_) {
      std::this_thread::sleep_for(1ms);
      const auto now = std::chrono::steady_clock::now() - began;
      servo_.run_until(now);
      for (HANDLE& end : ends_) serve(end, now);
    }
    for (HANDLE end : ends_) CloseHandle(end);
  }
  HANDLE made() const {
    return CreateNamedPipeA(name_.c_str(), PIPE_ACCESS_DUPLEX, PIPE_TYPE_BYTE | PIPE_WAIT, 2, 4096, 4096, 0, nullptr);
  }
  void serve(HANDLE& end, std::chrono::steady_clock::duration now) {
    DWORD waiting = 0, count = 0;
    std::array<char, 256> bytes{};
    if (!PeekNamedPipe(end, nullptr, 0, nullptr, &waiting, nullptr)) {
      if (GetLastError() != ERROR_BROKEN_PIPE) return;
      CloseHandle(end);
      end = made();
      return;
    }
    if (waiting == 0 || !ReadFile(end, bytes.data(), static_cast<DWORD>(bytes.size()), &count, nullptr)) return;
    servo_.receive({bytes.data(), count}, now);
    const std::string answer = servo_.take_output();
    WriteFile(end, answer.data(), static_cast<DWORD>(answer.size()), &count, nullptr);
  }

  std::string name_;
  std::array<HANDLE, 2> ends_;
  EmulatedDynamixel servo_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

TEST(WindowsLine, DrivesAServoOverANamedPipe) {
  PipeDynamixel servo;
  hrt_plate plate{};
  ASSERT_EQ(hrt_plate_open(("dynamixel:" + servo.name()).c_str(), nullptr, &plate), HRT_OK);
  ASSERT_TRUE(eventually([&] { return report_of(plate).state == HRT_PLATE_STATE_READY; })) << report_of(plate).message;
  ASSERT_EQ(hrt_plate_set(plate, -45.0), HRT_OK);
  EXPECT_TRUE(eventually([&] { return std::abs(report_of(plate).orientation_deg + 45.0) < 0.1; }));
  servo.unplug();
  EXPECT_TRUE(eventually([&] { return report_of(plate).state == HRT_PLATE_STATE_FAILED; }));
  EXPECT_EQ(report_of(plate).fault, HRT_PLATE_FAULT_UNPLUGGED) << report_of(plate).message;
  EXPECT_EQ(hrt_plate_close(plate), HRT_OK);
}

TEST(WindowsLine, HrtPlateCommissionsAServo) {
  PipeDynamixel servo;
  const std::string command =
      "echo.| \"" HRT_PLATE_PROGRAM "\" commission dynamixel:" + servo.name() + " --out plate.json";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_plate_file("plate.json").description, "Dynamixel XL330-M288, id 1, firmware 52");
}

TEST(WindowsLine, ReportsADeviceThatIsNotALine) {
  const auto failure_of = [](const char* device) {
    hrt_plate plate{};
    EXPECT_EQ(hrt_plate_open(device, nullptr, &plate), HRT_OK);
    EXPECT_TRUE(eventually([&] { return report_of(plate).state == HRT_PLATE_STATE_FAILED; }));
    const std::string message = report_of(plate).message;
    EXPECT_EQ(hrt_plate_close(plate), HRT_OK);
    return message;
  };
  EXPECT_EQ(failure_of("serial:COM99"),
            "the plate at COM99 cannot be opened: Windows error 2. Check its name and cable");
  EXPECT_EQ(failure_of("serial:NUL"), "the plate at NUL is not a serial line; name a serial device, such as COM3");
}

}  // namespace
}  // namespace hrt::plate
