// The host's side of the line protocol against an emulated plate, in simulated time.
#include "plugin/src/plate/plate_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "plugin/src/plate/plate_failure.h"
#include "tests/plugin/plate/emulated_plate.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

class PlateLinkTest : public testing::Test {
 protected:
  PlateLink& open(const EmulatedPlate::Behaviour& behaviour = {}) {
    link.reset();
    plate.emplace(behaviour);
    auto made = std::make_unique<EmulatedPlateLine>(*plate);
    line = made.get();
    link = std::make_unique<PlateLink>(std::move(made));
    return *link;
  }
  // What a failed plate says; empty if `action` does not fail.
  template <class Action>
  std::string failure_of(Action action) {
    try {
      action();
    } catch (const PlateFailure& failed) {
      fault = failed.fault();
      return failed.what();
    }
    return {};
  }
  void serve(std::chrono::milliseconds time) {
    for (const auto end = line->now() + time; line->now() < end;) link->wait(5ms);
  }
  std::string failure_of_service() {
    return failure_of([&] { serve(3s); });
  }
  auto times_heard(const std::string& body) const {
    return std::count(plate->heard().begin(), plate->heard().end(), body);
  }

  std::optional<EmulatedPlate> plate;
  std::unique_ptr<PlateLink> link;
  EmulatedPlateLine* line = nullptr;
  Fault fault{};
};

TEST_F(PlateLinkTest, LearnsLimitsAndOrientation) {
  open({.greeting = "PLATE 2 -80.00 85.00 300.00 20.00 measured"});
  EXPECT_EQ(link->limits().min_deg, -80.0);
  EXPECT_EQ(link->limits().max_deg, 85.0);
  EXPECT_EQ(link->limits().speed_deg_s, 300.0);
  // An answer of 22 bytes at 87 us.
  EXPECT_GE(*link->round_trip(), 22 * 87us);
  EXPECT_LT(*link->round_trip(), 22 * 87us + 1ms);
  EXPECT_EQ(link->limits().latency, 20ms + *link->round_trip() / 2);
  EXPECT_EQ(link->description(), "protocol 2, firmware 0.1, serial number 000007");
  link->turn_to(12.345);
  serve(100ms);
  EXPECT_NEAR(*link->orientation_deg(), 12.35, 0.011);
}

TEST_F(PlateLinkTest, DoesNotRepeatACommandButKeepsBeating) {
  open();
  for (int i = 0; i < 50; ++i) {
    link->turn_to(20.0);
    link->wait(10ms);
  }
  EXPECT_EQ(times_heard("SET +020.00"), 1);
  EXPECT_GE(times_heard("BEAT"), 4);
  EXPECT_EQ(plate->heartbeat_stops(), 0);
}

TEST_F(PlateLinkTest, SurvivesGarbage) {
  const std::string bytes("\xff\0\x13 AT 5*00\nAT 77.0*11\n\n\r\nPLATE 9 9 9*1F\n", 41);
  ASSERT_EQ(bytes.back(), '\n');
  open({.noise = bytes + std::string(100, 'z') + "\n"});
  link->turn_to(-33.0);
  serve(500ms);
  EXPECT_EQ(link->orientation_deg(), -33.0);
}

// Half a millisecond a byte: a report of 22 bytes takes 11 ms of the 20 between two.
TEST_F(PlateLinkTest, SurvivesLinesThatComeByteByByte) {
  open({.byte_time = 500us});
  link->turn_to(5.0);
  serve(500ms);
  EXPECT_EQ(link->orientation_deg(), 5.0);
}

// The host is late (it hangs, or its machine is busy): the plate stops by itself, and the next command moves
// it again.
TEST_F(PlateLinkTest, ThePlateStopsWithoutAHeartbeatAndTheNextCommandContinues) {
  open({.speed_deg_s = 20.0});
  link->turn_to(40.0);
  serve(100ms);
  EXPECT_TRUE(plate->moving_allowed());
  line->pause(400ms);
  EXPECT_FALSE(plate->moving_allowed());
  const double stopped_deg = plate->orientation_deg();
  EXPECT_NEAR(stopped_deg, 8.0, 2.1);  // 0.3 s behind the last beat
  serve(100ms);
  EXPECT_EQ(plate->orientation_deg(), stopped_deg);
  link->turn_to(40.0);
  serve(2000ms);
  EXPECT_EQ(link->orientation_deg(), 40.0);
}

TEST_F(PlateLinkTest, SpeaksVersionOneToAPlateThatKnowsNoOther) {
  open({.greeting = "PLATE 1 -90.00 90.00 400.00"});
  EXPECT_EQ(link->limits().speed_deg_s, 400.0);
  EXPECT_EQ(link->limits().latency, 0ns);
  EXPECT_EQ(link->description(), "protocol 1");
  link->turn_to(-34.25);
  serve(100ms);
  EXPECT_EQ(times_heard("SET -34.25"), 1);
  EXPECT_EQ(link->orientation_deg(), -34.25);
}

// Boards start when their line is opened, and need two seconds.
TEST_F(PlateLinkTest, WaitsForABoardThatStarts) {
  open({.boot = 2200ms});
  EXPECT_EQ(link->limits().speed_deg_s, 400.0);
}

// It says 400 and turns at 120 degrees a second.
TEST_F(PlateLinkTest, PlansWithTheSpeedThatItSees) {
  open({.speed_deg_s = 120.0});
  EXPECT_EQ(link->limits().speed_deg_s, 400.0);
  link->turn_to(85.0);
  serve(1s);
  EXPECT_EQ(link->orientation_deg(), 85.0);
  EXPECT_NEAR(link->limits().speed_deg_s, 120.0, 5.0);
}

TEST_F(PlateLinkTest, FailsIfNothingAnswers) {
  EXPECT_EQ(failure_of([&] { open({.answers = false}); }), "does not answer as a plate within 5 s");
  EXPECT_EQ(fault, Fault::no_answer);
  EXPECT_TRUE(plate->heard().empty());
}

TEST_F(PlateLinkTest, FailsWhenThePlateNeverReports) {
  EXPECT_NE(failure_of([&] { open({.reports = false}); }).find("never reports its orientation"),
            std::string::npos);
  EXPECT_EQ(fault, Fault::no_report);
}

TEST_F(PlateLinkTest, FailsWhenThePlateReportsAnAngleBeyondItsLimits) {
  open();
  plate->send("AT +095.00 00001");
  EXPECT_NE(failure_of_service().find("reports 95.0 deg, outside its limits of -90.0 to 90.0 deg"),
            std::string::npos);
  EXPECT_EQ(fault, Fault::limits);
}

TEST_F(PlateLinkTest, FailsWhenThePlateIsStuck) {
  open({.turns = false});
  link->turn_to(45.0);
  EXPECT_NE(failure_of_service().find("is stuck at 0.0 deg; it was commanded to 45.0 deg"),
            std::string::npos);
  EXPECT_EQ(fault, Fault::stuck);
  EXPECT_EQ(plate->heard().back(), "STOP");
}

TEST_F(PlateLinkTest, FailsWhenThePlateRestarts) {
  open();
  plate->restart();
  EXPECT_EQ(failure_of_service(), "has restarted: its supply or its line failed");
  EXPECT_EQ(fault, Fault::restarted);
}

TEST_F(PlateLinkTest, FailsWhenThePlateAnnouncesItselfAnew) {
  open();
  plate->send("PLATE 2 -90.00 90.00 100.00 10.00 measured");
  EXPECT_NE(failure_of_service().find("has announced itself anew"), std::string::npos);
  EXPECT_EQ(fault, Fault::restarted);
}

TEST_F(PlateLinkTest, FailsWhenThePlateFallsSilent) {
  open();
  plate->fall_silent();
  EXPECT_EQ(failure_of_service(), "has not been heard for half a second");
  EXPECT_EQ(fault, Fault::silent);
  EXPECT_EQ(plate->heard().back(), "STOP");
}

TEST_F(PlateLinkTest, FailsWhenThePlateSaysThatItCannotGoOn) {
  const struct {
    std::string why;
    std::string said;
    Fault fault;
  } stops[] = {{"emergency", "was stopped by its emergency stop", Fault::emergency},
               {"fault", "reports a fault", Fault::device},
               {"limit", "refused an angle beyond its limits", Fault::limits},
               {"stuck", "reports that its servo is stuck", Fault::stuck}};
  for (const auto& stop : stops) {
    open();
    plate->send("STOPPED " + stop.why);
    EXPECT_EQ(failure_of_service(), stop.said);
    EXPECT_EQ(fault, stop.fault);
  }
}

}  // namespace
}  // namespace hrt::plate
