// The simulated plate behind a pseudo-terminal, which a program commands like a built plate.
#include <fstream>

#include "tests/plugin/plate/eventually.h"
#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

using plate::eventually;

class MockPlateTerminal : public MockRuntime {
 protected:
  void TearDown() override {
    hrt_plate_close(plate_);
    MockRuntime::TearDown();
  }

  std::string terminal() const { return folder_ / "plate"; }
  // A plate 40 cm below and 35 cm in front of the eyes, over which a finger repeatedly slides straight ahead.
  std::string script() const {
    return R"({"clock": "real-time", "servo": {"speed_deg_per_s": 400, "latency_ms": 20},
      "plate": {"position_m": [0, -0.4, -0.35], "terminal": ")" +
           terminal() + R"("},
      "participants": [{"tactile_weight": 0.3, "illusion": "linear", "noise_deg2_per_s": 0, "habit_deg": 0, "duration_ms": 1000,
                        "reaction_ms": 0, "start_direction_deg": 0}],
      "hands": {"right": {"slides": {"start_m": [0, 0.008, 0.05], "direction_deg": 0}}}})";
  }
  void open() {
    ASSERT_EQ(hrt_plate_open(("serial:" + terminal()).c_str(), nullptr, &plate_), HRT_OK) << hrt_plate_last_error();
    ASSERT_TRUE(eventually([&] { return report().state == HRT_PLATE_STATE_READY; })) << report().message;
  }
  hrt_plate_report report() const { return plate::report_of(plate_); }
  double true_orientation_deg() {
    double orientation_deg = 0.0;
    EXPECT_XR(XR_SUCCESS, XR(xrGetPlateOrientationHRTX)(session, 1, &orientation_deg));
    return orientation_deg;
  }

  const TemporaryFolder folder_;
  hrt_plate plate_{};
};

TEST_F(MockPlateTerminal, CommandsRotateThePlateWhichSteersTheParticipant) {
  begin_with(script());
  open();
  EXPECT_EQ(report().max_speed_deg_s, 400.0);
  // The command is repeated, because the driver stops a plate that receives no commands.
  const auto reaches_50_deg = [&](auto orientation_deg) {
    return eventually([&] {
      EXPECT_EQ(hrt_plate_set(plate_, 50.0), HRT_OK);
      return std::abs(orientation_deg() - 50.0) < 0.5;
    });
  };
  EXPECT_TRUE(reaches_50_deg([&] { return true_orientation_deg(); }));
  EXPECT_TRUE(reaches_50_deg([&] { return report().orientation_deg; }));

  // The plate at 50 degrees shifts the perceived direction to the left, so that a participant who intends to move
  // straight ahead moves to the right.
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
  EXPECT_TRUE(eventually([&] {
    EXPECT_EQ(hrt_plate_set(plate_, 50.0), HRT_OK);
    EXPECT_XR(XR_SUCCESS, XR(xrGetReachTruthHRTX)(session, XR_HAND_RIGHT_EXT, &truth));
    return truth.trueDirection < -10.0;
  })) << truth.trueDirection;
  EXPECT_LT(std::abs(truth.perceivedDirection), std::abs(truth.trueDirection));
}

TEST_F(MockPlateTerminal, SessionFailsIfAFileExistsAtTheTerminal) {
  std::ofstream(terminal()) << "thesis";
  apply(script());
  EXPECT_XR(XR_ERROR_RUNTIME_FAILURE,
            result_of(xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, system}));
  EXPECT_TRUE(has(last_call(), "script.plate.terminal: " + terminal()));
  EXPECT_EQ(read_file(terminal()), "thesis");
}

}  // namespace
}  // namespace hrt::mock
