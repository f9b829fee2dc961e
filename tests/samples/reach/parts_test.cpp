// Parts of hrt-reach that need no runtime. The plate's library is used against a plate at the other end of a
// pseudo-terminal.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>
#include <unistd.h>

#include "samples/app/base/exit_code.h"
#include "samples/app/emulator/pty_device.h"
#include "samples/app/person/prompt.h"
#include "samples/app/plate/device_plate.h"
#include "samples/app/plate/simulated_servo.h"
#include "samples/app/run/options.h"
#include "samples/reach/files.h"
#include "tests/samples/text.h"

namespace hrt::reach {
namespace {

using plate::PtyPlate;

// A serial line or the file of hrt-plate commission names a plate; other names are rejected without opening a device.
TEST(PlateChoice, IsWhatThePlatesLibraryOpens) {
  for (const char* device : {"serial:/dev/ttyACM0", "dynamixel:/dev/ttyUSB0", "plate.json", "C:\\lab\\plate.json"}) {
    const auto choice = parse_plate(device);
    ASSERT_TRUE(choice) << device;
    EXPECT_EQ(choice->kind, PlateChoice::Kind::device);
    EXPECT_EQ(choice->name, device);
  }
  for (const char* other : {"plate.txt", "serial:", "servo:fast", ""}) EXPECT_FALSE(parse_plate(other)) << other;
}

TEST(DevicePlate, LeavesTheLineAsItWas) {
  PtyPlate device;
  const auto settings = [&] {
    const int line = open(device.device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_GE(line, 0);  // the line is not locked
    termios now{};
    EXPECT_EQ(tcgetattr(line, &now), 0);
    close(line);
    return now;
  };
  termios odd = settings();
  odd.c_lflag |= ICANON;
  odd.c_iflag |= IXON;
  cfsetspeed(&odd, B9600);
  const int line = open(device.device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_EQ(tcsetattr(line, TCSANOW, &odd), 0);
  close(line);
  const termios before = settings();
  EXPECT_TRUE(has(DevicePlate("serial:" + device.device()).description(), "firmware 1.1.0, serial number 000007"));
  const termios after = settings();
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  EXPECT_EQ(after.c_iflag, before.c_iflag);
  EXPECT_EQ(after.c_oflag, before.c_oflag);
  EXPECT_EQ(after.c_cflag, before.c_cflag);
  EXPECT_EQ(cfgetospeed(&after), cfgetospeed(&before));
}

constexpr XrTime second = 1'000'000'000;

// -80 is equivalent to 100, which is nearer to 50; and 100 is reported as -80.
TEST(SimulatedServo, TurnsAtItsSpeedTheShortWayRoundAndStopsWhereItIs) {
  SimulatedServo servo(100.0);
  servo.command(1 * second, 50.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(1 * second), 0.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(1 * second + second / 4), 25.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(2 * second), 50.0);
  servo.command(2 * second, -80.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(2 * second + second / 4), 75.0);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(3 * second), -80.0);
  servo.command(3 * second, -90.0);
  servo.stop(3 * second + second / 20);
  EXPECT_DOUBLE_EQ(*servo.orientation_deg(9 * second), -85.0);
}

TEST(Spoken, HasUnitsInWordsAndNoNamesOfOptionsCallsAndFiles) {
  const std::pair<const char*, const char*> texts[] = {
      {"14 mm, 0.75 m, 30 s, 2.5 min, 6 deg, 4 V",
       "14 millimetres, 0.75 metres, 30 seconds, 2.5 minutes, 6 degrees, 4 volts"},
      {"1 mm, 1 m, 1 s, 1 min, 1 deg, 1 degrees",
       "one millimetre, one metre, one second, one minute, one degree, one degree"},
      {"2.1 min, 21 min, -1 deg", "2.1 minutes, 21 minutes, -1 degrees"},
      {"bias   -1.2 deg\nlimit  75 deg", "bias -1.2 degrees limit 75 degrees"},
      {"Slide to \"bottle\", ahead", "Slide to bottle, ahead"},
      {"register the plate (hrt-reach: --register FILE).", "register the plate."},
      {"Use it (or hrt-reach --hand left). Set --finger (--data)", "Use it. Set option finger"},
      {"another design (SHA-256 3f9a); use it", "another design; use it"},
      {"Please continue. [an SD of 9 mm] Lift your finger. [98 %]", "Please continue. Lift your finger."},
      {"failed (HRT_ERROR_WRONG_STATE): hrt_reach_touched: no reach", "failed: no reach"},
      {"the plate at /dev/serial/by-id/usb-0:1 is unplugged; open it", "the plate is unplugged; open it"},
      {"data/sub-01/ses-02/recordings/cond-B.csv: 96 rows", "participant 1, session 2: 96 rows"}};
  for (const auto& [text, words] : texts) EXPECT_EQ(spoken(text), words);
}

TEST(ReachRecordingFile, LostRowsFailTheRun) {
  Plugin plugin(HRT_PLUGIN);
  plugin.hrt_recording_start = [](hrt_session, const char*) noexcept { return HRT_OK; };
  plugin.hrt_recording_stop = [](hrt_session, hrt_recording_status* status) noexcept {
    status->rows_lost = 3;
    return HRT_OK;
  };
  RecordingFile file(plugin, {}, "reach.csv");
  try {
    file.finish();
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::output);
    EXPECT_TRUE(has(failure.what(), "3 rows are lost"));
  }
}

}  // namespace
}  // namespace hrt::reach
