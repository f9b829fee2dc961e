// A whole reach through a Dynamixel: scene, OpenXR runtime, plugin, libhrt_plate, bus, servo, felt by the
// simulated person, in real time.
#include <gtest/gtest.h>

#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/reach/program.h"

namespace hrt::plate {
namespace {

// The calm person, at half the pace: a busy machine leaves the plate without a command now and then, and the
// finger must not be far meanwhile.
std::string unhurried() {
  std::string person = reach::calm;
  const std::string pace = R"("duration_ms": 2400)";
  return person.replace(person.find(pace), pace.size(), R"("duration_ms": 4800)");
}

TEST(ReachWithDynamixel, ReachesTheTarget) {
  PtyDynamixel servo;
  const std::string script = R"({"clock": "real-time", )" + unhurried() + "}";
  const Outcome outcome =
      reach::run_scripted(script, {reach::desk, "--target", "goblet", "--plate", "dynamixel:" + servo.device()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  ASSERT_EQ(reach::rows_of(outcome).size(), 1U) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "Dynamixel XL330-M288, id 1"));
  EXPECT_GT(servo.with([](EmulatedDynamixel& device) { return device.twin.max_turn_deg(); }), 30.0);
}

}  // namespace
}  // namespace hrt::plate
