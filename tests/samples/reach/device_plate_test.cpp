// The plate's library, as hrt-reach uses it, against a plate at the other end of a pseudo-terminal.
#include "samples/reach/device_plate.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "samples/reach/exit_code.h"
#include "tests/samples/reach/pty_plate.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;

// What a failed plate says; empty if `action` does not fail.
template <class Action>
std::string failure_of(Action action) {
  try {
    action();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::plate);
    return failure.what();
  }
  return {};
}

// Serves the plate until it fails, for five seconds at most.
std::string failure_of_service(DevicePlate& plate) {
  return failure_of([&] {
    eventually([&] {
      plate.service(0);
      return false;
    });
  });
}

bool has_heard(const PtyPlate& plate, const std::string& body) {
  const auto heard = plate.heard();
  return std::find(heard.begin(), heard.end(), body) != heard.end();
}

TEST(OrientationWithin, TakesWhatIsFeltTheSame) {
  EXPECT_EQ(orientation_within(-90, 90, 30, 0), 30);
  EXPECT_EQ(orientation_within(-90, 90, 100, 0), -80);
  EXPECT_EQ(orientation_within(-90, 90, -100, 0), 80);
  EXPECT_EQ(orientation_within(-90, 90, 370, 0), 10);
  EXPECT_EQ(orientation_within(0, 180, -10, 0), 170);
}

TEST(OrientationWithin, TakesTheNearerOfSeveral) {
  EXPECT_EQ(orientation_within(-180, 180, 100, 90), 100);
  EXPECT_EQ(orientation_within(-180, 180, 100, -60), -80);
  EXPECT_EQ(orientation_within(-360, 360, 0, 350), 360);
  EXPECT_EQ(orientation_within(-360, 360, 0, 1000), 360);
}

TEST(OrientationWithin, TakesTheNearestLimitIfNothingIsFeltTheSame) {
  EXPECT_EQ(orientation_within(-45, 45, 60, 0), 45);
  EXPECT_EQ(orientation_within(-45, 45, -60, 0), -45);
  EXPECT_EQ(orientation_within(-45, 45, 130, 0), -45);  // felt like -50
}

TEST(DevicePlate, LearnsLimitsAndOrientation) {
  PtyPlate device({.greeting = "PLATE 2 -80.00 85.00 300.00 20.00 measured"});
  DevicePlate plate("serial:" + device.device());
  EXPECT_EQ(plate.limits()->least_deg, -80.0);
  EXPECT_EQ(plate.limits()->most_deg, 85.0);
  EXPECT_EQ(plate.limits()->speed_deg_s, 300.0);
  // What the plate says, and half of the line there and back: some milliseconds over a pseudo-terminal.
  EXPECT_GE(plate.limits()->latency_ns, 20'000'000);
  EXPECT_LT(plate.limits()->latency_ns, 70'000'000);
  EXPECT_NE(plate.description().find("firmware 0.1, serial number 000007"), std::string::npos)
      << plate.description();
  plate.command(0, 12.345);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return std::abs(plate.orientation_deg(0).value_or(0.0) - 12.35) < 0.011;
  }));
}

TEST(DevicePlate, SendsAnAngleWithinTheLimits) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  plate.command(0, 94.5);
  EXPECT_TRUE(eventually([&] { return has_heard(device, "SET -085.50"); }));
}

TEST(DevicePlate, DoesNotRepeatACommandButKeepsBeating) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  for (int i = 0; i < 50; ++i) {
    plate.command(0, 20.0);
    plate.service(0);
    std::this_thread::sleep_for(10ms);
  }
  const auto heard = device.heard();
  // Once; and after each stop for want of a heartbeat, if this machine is busy.
  EXPECT_GE(std::count(heard.begin(), heard.end(), "SET +020.00"), 1);
  EXPECT_LE(std::count(heard.begin(), heard.end(), "SET +020.00"), 1 + device.heartbeat_stops());
  EXPECT_GE(std::count(heard.begin(), heard.end(), "BEAT"), 4);
}

TEST(DevicePlate, SurvivesGarbage) {
  const std::string bytes("\xff\0\x13 AT 5*00\nAT 77.0*11\n\n\r\nPLATE 9 9 9*1F\n", 41);
  ASSERT_EQ(bytes.back(), '\n');
  PtyPlate device({.noise = bytes + std::string(500, 'z') + "\n"});
  DevicePlate plate("serial:" + device.device());
  plate.command(0, -33.0);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return plate.orientation_deg(0) == -33.0;
  }));
}

TEST(DevicePlate, SurvivesLinesThatComeByteByByte) {
  PtyPlate device({.byte_delay = 500us});
  DevicePlate plate("serial:" + device.device());
  plate.command(0, 5.0);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return plate.orientation_deg(0) == 5.0;
  }));
}

// The host is late (it hangs, or its machine is busy): the plate stops by itself, and the next command moves
// it again.
TEST(DevicePlate, StopsWithoutHeartbeatAndGoesOnWithTheNextCommand) {
  PtyPlate device({.speed_deg_s = 20.0});
  DevicePlate plate("serial:" + device.device());
  plate.command(0, 40.0);
  ASSERT_TRUE(eventually([&] { return device.moving_allowed(); }));
  ASSERT_TRUE(eventually([&] { return !device.moving_allowed(); }));
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    plate.command(0, 40.0);
    return device.moving_allowed();
  }));
}

TEST(DevicePlate, SpeaksVersionOneToAPlateThatKnowsNoOther) {
  PtyPlate device({.greeting = "PLATE 1 -90.00 90.00 400.00"});
  DevicePlate plate("serial:" + device.device());
  EXPECT_EQ(plate.limits()->speed_deg_s, 400.0);
  EXPECT_EQ(plate.limits()->latency_ns, 0);
  plate.command(0, -34.25);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return has_heard(device, "SET -34.25") && plate.orientation_deg(0) == -34.25;
  }));
}

// Boards start when their line is opened, and need two seconds.
TEST(DevicePlate, WaitsForABoardThatStarts) {
  PtyPlate device({.boot = 2200ms});
  DevicePlate plate("serial:" + device.device());
  EXPECT_EQ(plate.limits()->speed_deg_s, 400.0);
}

TEST(DevicePlate, FailsWhenThePlateNeverReports) {
  PtyPlate device({.reports = false});
  EXPECT_NE(failure_of([&] {
              DevicePlate plate("serial:" + device.device());
            }).find("never reports its orientation"),
            std::string::npos);
}

TEST(DevicePlate, FailsWhenThePlateReportsAnAngleBeyondItsLimits) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.send("AT +095.00 00001");
  EXPECT_NE(failure_of_service(plate).find("reports 95.0 deg, outside its limits of -90.0 to 90.0 deg"),
            std::string::npos);
}

TEST(DevicePlate, FailsWhenThePlateIsStuck) {
  PtyPlate device({.turns = false});
  DevicePlate plate("serial:" + device.device());
  plate.command(0, 45.0);
  EXPECT_NE(failure_of_service(plate).find("is stuck at 0.0 deg; it was commanded to 45.0 deg"),
            std::string::npos);
}

TEST(DevicePlate, FailsWhenThePlateRestarts) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.restart();
  EXPECT_NE(failure_of_service(plate).find("has restarted"), std::string::npos);
}

TEST(DevicePlate, FailsWhenThePlateAnnouncesItselfAnew) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.send("PLATE 2 -90.00 90.00 100.00 10.00 measured");
  EXPECT_NE(failure_of_service(plate).find("has announced itself anew"), std::string::npos);
}

TEST(DevicePlate, FailsOnAnEmergency) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.send("STOPPED emergency");
  EXPECT_NE(failure_of_service(plate).find("was stopped by its emergency stop"), std::string::npos);
}

// It says 400 and turns at 120 degrees a second.
TEST(DevicePlate, PlansWithTheSpeedThatItSees) {
  PtyPlate device({.speed_deg_s = 120.0});
  DevicePlate plate("serial:" + device.device());
  EXPECT_EQ(plate.limits()->speed_deg_s, 400.0);
  EXPECT_TRUE(eventually([&] {
    plate.command(0, 85.0);  // sent again if this machine was too busy for a heartbeat
    plate.service(0);
    return plate.orientation_deg(0) == 85.0;
  }));
  EXPECT_NEAR(plate.limits()->speed_deg_s, 120.0, 40.0);
}

TEST(DevicePlate, LeavesTheLineAsItWas) {
  PtyPlate device;
  const auto settings = [&] {
    const int line = open(device.device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_GE(line, 0);  // nor is it locked
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
  { DevicePlate plate("serial:" + device.device()); }
  const termios after = settings();
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  EXPECT_EQ(after.c_iflag, before.c_iflag);
  EXPECT_EQ(after.c_oflag, before.c_oflag);
  EXPECT_EQ(after.c_cflag, before.c_cflag);
  EXPECT_EQ(cfgetospeed(&after), cfgetospeed(&before));
}

TEST(DevicePlate, FailsWhenThePlateFallsSilent) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.fall_silent();
  EXPECT_NE(failure_of_service(plate).find("has not been heard for half a second"), std::string::npos);
  EXPECT_TRUE(eventually([&] { return has_heard(device, "STOP"); }));
}

TEST(DevicePlate, FailsWhenUnplugged) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.unplug();
  EXPECT_NE(failure_of_service(plate).find("is unplugged"), std::string::npos);
}

TEST(DevicePlate, FailsWhenThePlateHasAFault) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.send("STOPPED fault");
  EXPECT_NE(failure_of_service(plate).find("reports a fault"), std::string::npos);
}

TEST(DevicePlate, FailsWhenThePlateRefusesAnAngle) {
  PtyPlate device;
  DevicePlate plate("serial:" + device.device());
  device.send("STOPPED limit");
  EXPECT_NE(failure_of_service(plate).find("beyond its limits"), std::string::npos);
}

TEST(DevicePlate, StopsThePlateAtTheEnd) {
  PtyPlate device;
  {
    DevicePlate plate("serial:" + device.device());
    plate.command(0, 10.0);
  }
  EXPECT_TRUE(eventually([&] { return has_heard(device, "STOP"); }));
  EXPECT_FALSE(device.moving_allowed());
}

TEST(DevicePlate, NeedsAPlateThatAnswers) {
  PtyPlate device({.answers = false});
  const std::string failure = failure_of([&] { DevicePlate plate("serial:" + device.device()); });
  EXPECT_NE(failure.find(device.device() + " does not answer as a plate"), std::string::npos) << failure;
}

TEST(DevicePlate, NeedsASerialLine) {
  EXPECT_NE(failure_of([] { DevicePlate plate("serial:/dev/null"); }).find("/dev/null is not a serial line"),
            std::string::npos);
  EXPECT_NE(
      failure_of([] { DevicePlate plate("serial:/nonexistent"); }).find("/nonexistent cannot be opened"),
      std::string::npos);
}

}  // namespace
}  // namespace hrt::reach
