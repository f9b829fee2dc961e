// Outputs of the library if the controller computes NaN. The controller of this program is a test double, because no
// input is known for which the real one does.
#include <cmath>
#include <limits>

#include "core/person/reach_control.h"
#include "fixture.h"

namespace hrt {
namespace {

bool plans_fail = false;

}  // namespace

ReachPlan plan_reach(const ReachControlConfig&, const PersonFilter&, const PlatePoint&, double, double, double) {
  const double value = plans_fail ? std::numeric_limits<double>::quiet_NaN() : 20.0;
  return {.plate_deg = value, .felt_error_deg = value, .miss_mm = value, .active = ActiveBound::none};
}

double ready_orientation_deg(const ReachControlConfig&, const PersonFilter&, const PlatePoint&) { return 10.0; }

namespace test {
namespace {

class FaultTest : public SessionTest {
 protected:
  // Runs a reach with a slide of 1 s. If `fails`, the controller returns NaN in the second half of the slide.
  hrt_reach_summary reach(bool fails) {
    for (int i = 0; i < 100; ++i) {
      plans_fail = fails && i >= 50;
      const hrt_command command = update(position_sample(time_ns_, 0.0, -0.05 + 0.001 * i));
      time_ns_ += 10'000'000;
      EXPECT_TRUE(std::isfinite(command.plate_orientation_deg));
      EXPECT_TRUE(std::isfinite(command.felt_error_deg) && std::isfinite(command.predicted_miss_deg) &&
                  std::isfinite(command.time_to_go_s));
      if ((command.flags & HRT_COMMAND_FAULT) != 0) {
        ++faults_;
        EXPECT_EQ(command.plate_orientation_deg, held_deg_);
      }
      held_deg_ = command.plate_orientation_deg;
    }
    plans_fail = false;
    return end();
  }

  std::int64_t time_ns_ = 0;
  int faults_ = 0;
  double held_deg_ = 0.0;
  Log log_;
};

TEST_F(FaultTest, NonFiniteCommandHoldsThePlateSetsFaultAndIsLoggedOnce) {
  begin_reach();
  const hrt_session_config before = config_of(session);
  EXPECT_NE(reach(true).flags & HRT_COMMAND_FAULT, 0u);
  EXPECT_GT(faults_, 10);
  EXPECT_EQ(config_of(session).person.covariance[0], before.person.covariance[0]) << "the estimates changed";
  EXPECT_EQ(log_.text, "") << "a call of a reach is real-time";
  ASSERT_OK(hrt_session_set(session, &before));
  EXPECT_TRUE(
      log_.text.starts_with(std::to_string(HRT_LOG_ERROR) + " session " + std::to_string(session.value) + ": "));
  begin_reach();
  reach(true);
  destroy();
  EXPECT_EQ(std::count(log_.text.begin(), log_.text.end(), '\n'), 1);
}

TEST_F(FaultTest, DestroyingTheSessionLogsTheFault) {
  begin_reach();
  reach(true);
  destroy();
  EXPECT_NE(log_.text.find("a defect of the library"), std::string::npos);
}

TEST_F(FaultTest, FiniteCommandsLogNothing) {
  begin_reach();
  EXPECT_EQ(reach(false).flags & HRT_COMMAND_FAULT, 0u);
  destroy();
  EXPECT_EQ(faults_, 0);
  EXPECT_EQ(log_.text, "");
}

}  // namespace
}  // namespace test
}  // namespace hrt
