// The serial plate against a plate at the other end of a pseudo-terminal.
#include "samples/reach/serial_plate.h"

#include <gtest/gtest.h>

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
std::string failure_of_service(SerialPlate& plate) {
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

TEST(SerialPlate, LearnsLimitsAndOrientation) {
  PtyPlate device({.greeting = "PLATE 1 -80.00 85.00 300.00"});
  SerialPlate plate(device.device());
  EXPECT_EQ(plate.limits()->least_deg, -80.0);
  EXPECT_EQ(plate.limits()->most_deg, 85.0);
  EXPECT_EQ(plate.limits()->speed_deg_s, 300.0);
  plate.command(0, 12.345);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return std::abs(plate.orientation_deg(0).value_or(0.0) - 12.35) < 0.011;
  }));
}

TEST(SerialPlate, SendsAnAngleWithinTheLimits) {
  PtyPlate device;
  SerialPlate plate(device.device());
  plate.command(0, 94.5);
  EXPECT_TRUE(eventually([&] { return has_heard(device, "SET -85.50"); }));
}

TEST(SerialPlate, DoesNotRepeatACommandButKeepsBeating) {
  PtyPlate device;
  SerialPlate plate(device.device());
  for (int i = 0; i < 50; ++i) {
    plate.command(0, 20.0);
    plate.service(0);
    std::this_thread::sleep_for(10ms);
  }
  const auto heard = device.heard();
  EXPECT_EQ(std::count(heard.begin(), heard.end(), "SET 20.00"), 1);
  EXPECT_GE(std::count(heard.begin(), heard.end(), "BEAT"), 4);
}

TEST(SerialPlate, SurvivesGarbage) {
  const std::string bytes("\xff\0\x13 AT 5*00\nAT 77.0*11\n\n\r\nPLATE 9 9 9*1F\n", 41);
  ASSERT_EQ(bytes.back(), '\n');
  PtyPlate device({.noise = bytes + std::string(500, 'z') + "\n"});
  SerialPlate plate(device.device());
  plate.command(0, -33.0);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return plate.orientation_deg(0) == -33.0;
  }));
}

TEST(SerialPlate, SurvivesLinesThatComeByteByByte) {
  PtyPlate device({.byte_delay = 3ms});
  SerialPlate plate(device.device());
  plate.command(0, 5.0);
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    return plate.orientation_deg(0) == 5.0;
  }));
}

// The host is late (it hangs, or its machine is busy): the plate stops by itself, and the next command moves
// it again.
TEST(SerialPlate, StopsWithoutHeartbeatAndGoesOnWithTheNextCommand) {
  PtyPlate device;
  SerialPlate plate(device.device());
  plate.command(0, 40.0);
  ASSERT_TRUE(eventually([&] { return device.moving_allowed(); }));
  ASSERT_TRUE(eventually([&] { return !device.moving_allowed(); }));
  EXPECT_TRUE(eventually([&] {
    plate.service(0);
    plate.command(0, 40.0);
    return device.moving_allowed();
  }));
}

TEST(SerialPlate, FailsWhenThePlateFallsSilent) {
  PtyPlate device;
  SerialPlate plate(device.device());
  device.fall_silent();
  EXPECT_NE(failure_of_service(plate).find("has not been heard for half a second"), std::string::npos);
  EXPECT_TRUE(eventually([&] { return has_heard(device, "STOP"); }));
}

TEST(SerialPlate, FailsWhenUnplugged) {
  PtyPlate device;
  SerialPlate plate(device.device());
  device.unplug();
  EXPECT_NE(failure_of_service(plate).find("is unplugged"), std::string::npos);
}

TEST(SerialPlate, FailsWhenThePlateHasAFault) {
  PtyPlate device;
  SerialPlate plate(device.device());
  device.send("STOPPED fault");
  EXPECT_NE(failure_of_service(plate).find("reports a fault"), std::string::npos);
}

TEST(SerialPlate, FailsWhenThePlateRefusesAnAngle) {
  PtyPlate device;
  SerialPlate plate(device.device());
  device.send("STOPPED limit");
  EXPECT_NE(failure_of_service(plate).find("beyond its limits"), std::string::npos);
}

TEST(SerialPlate, StopsThePlateAtTheEnd) {
  PtyPlate device;
  {
    SerialPlate plate(device.device());
    plate.command(0, 10.0);
  }
  EXPECT_TRUE(eventually([&] { return has_heard(device, "STOP"); }));
  EXPECT_FALSE(device.moving_allowed());
}

TEST(SerialPlate, NeedsAPlateThatAnswers) {
  PtyPlate device({.answers = false});
  const std::string failure = failure_of([&] { SerialPlate plate(device.device()); });
  EXPECT_NE(failure.find(device.device() + " does not answer as a plate"), std::string::npos) << failure;
}

TEST(SerialPlate, NeedsASerialLine) {
  EXPECT_NE(failure_of([] { SerialPlate plate("/dev/null"); }).find("/dev/null is not a serial line"),
            std::string::npos);
  EXPECT_NE(failure_of([] { SerialPlate plate("/nonexistent"); }).find("/nonexistent cannot be opened"),
            std::string::npos);
}

}  // namespace
}  // namespace hrt::reach
