#include "plugin/src/plate/plate_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "plugin/src/plate/file_watch.h"
#include "samples/app/emulator/hobby_plate.h"
#include "tests/plugin/plate/emulated_line.h"
#include "tests/plugin/plate/failing_test.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double sensor_deg = 0.35;  // resolution of the converter, and dead band of the servo

class PlateLinkTest : public FailingTest {
 protected:
  PlateLink& open(const HobbyPlate::Traits& traits = {}) {
    link.reset();
    plate.emplace(traits);
    auto made = std::make_unique<EmulatedLine<HobbyPlate>>(*plate);
    line = made.get();
    link = std::make_unique<PlateLink>(std::move(made));
    return *link;
  }
  void serve(std::chrono::milliseconds time) { FailingTest::serve(*link, time); }
  std::string failure_of_serving() {
    return failure_of([&] { serve(3s); });
  }
  auto times_received(const std::string& body) const {
    return std::count(plate->received_lines().begin(), plate->received_lines().end(), body);
  }

  std::optional<HobbyPlate> plate;
  std::unique_ptr<PlateLink> link;
  EmulatedLine<HobbyPlate>* line = nullptr;
};

TEST_F(PlateLinkTest, ReadsLimitsAndOrientation) {
  Settings settings = commissioned();
  settings.value[SETTING_SPEED_DEG_S] = 15000;
  open({.settings = settings});
  EXPECT_EQ(link->limits().min_deg, -90.0);
  EXPECT_EQ(link->limits().max_deg, 90.0);
  EXPECT_EQ(link->limits().speed_deg_s, 150.0);
  // A line and its answer have 22 bytes each; a byte takes 87 us.
  EXPECT_GE(*link->round_trip(), 44 * 87us);
  EXPECT_LT(*link->round_trip(), 44 * 87us + 2ms);
  EXPECT_EQ(link->limits().latency, 30ms + *link->round_trip() / 2);
  EXPECT_EQ(link->description(), "protocol 2, firmware 1.1.0, serial number 000007");
  EXPECT_FALSE(plate->has_pulses());
  link->turn_to(12.345);
  serve(500ms);
  EXPECT_EQ(times_received("SET +012.35"), 1);
  EXPECT_NEAR(*link->orientation_deg(), 12.35, sensor_deg);
}

TEST_F(PlateLinkTest, SendsAnEqualCommandOnceAndHeartbeats) {
  open();
  for (int i = 0; i < 50; ++i) {
    link->turn_to(20.0);
    link->wait(10ms);
  }
  EXPECT_EQ(times_received("SET +020.00"), 1);
  EXPECT_GE(times_received("BEAT"), 4);
  EXPECT_EQ(plate->heartbeat_stops(), 0);
}

TEST_F(PlateLinkTest, ThePlateStopsWithoutAHeartbeatAndTheNextCommandContinues) {
  open();
  link->turn_to(80.0);
  serve(100ms);
  EXPECT_TRUE(plate->is_following());
  line->pause(400ms);
  EXPECT_FALSE(plate->is_following());
  const double stopped_deg = plate->orientation_deg();
  EXPECT_LT(stopped_deg, 79.0);
  serve(100ms);
  EXPECT_EQ(plate->orientation_deg(), stopped_deg);
  link->turn_to(80.0);
  serve(2000ms);
  EXPECT_NEAR(*link->orientation_deg(), 80.0, sensor_deg);
}

// Boards start when their line is opened, which takes two seconds.
TEST_F(PlateLinkTest, WaitsForABoardThatStarts) {
  open({.boot_time = 2200ms});
  EXPECT_EQ(link->limits().speed_deg_s, 200.0);
}

TEST_F(PlateLinkTest, ReportsTheObservedSpeedIfItIsLower) {
  open({.servo = {.speed_deg_s = 120.0}});
  EXPECT_EQ(link->limits().speed_deg_s, 200.0);
  link->turn_to(85.0);
  serve(1s);
  EXPECT_NEAR(link->limits().speed_deg_s, 120.0, 8.0);
}

TEST_F(PlateLinkTest, FailsWhenThePlateSendsAnotherGreeting) {
  open();
  plate->send("PLATE 2 -90.00 90.00 100.00 10.00 measured");
  EXPECT_NE(failure_of_serving().find("has sent another greeting"), std::string::npos);
  EXPECT_EQ(fault, Fault::restarted);
}

// Four servos: as in the plate file, with a latency of 30 ms; slower; with an error at rest; with a higher latency.
TEST_F(PlateLinkTest, DetectsADeviationFromTheFile) {
  const struct {
    ServoTraits servo;
    bool deviates;
  } rows[] = {{{.acceleration_deg_s2 = 5000.0, .dead_time = 20ms}, false},
              {{.speed_deg_s = 100.0}, true},
              {{.dead_band_deg = 4.0}, true},
              {{.dead_time = 110ms}, true}};
  for (const auto& row : rows) {
    for (const double step_deg : {160.0, 3.0}) {  // steps of 160 degrees, and a ramp of 120 degrees a second
      open({.servo = row.servo});
      FileWatch watch({.speed_deg_s = 190.0, .acceleration_deg_s2 = 5000.0, .latency_ms = 30.0, .error_deg = 1.5});
      double command_deg = 0.0, to_deg = 80.0;
      const auto begin = link->now();
      for (auto next = begin; link->now() < begin + 16s;) {
        if (link->now() > next) {
          next += 25ms;
          command_deg += std::clamp(to_deg - command_deg, -step_deg, step_deg);
          if ((link->now() - begin) / 4s % 2 == 0 ? to_deg < 0.0 : to_deg > 0.0) to_deg = -to_deg;
          link->turn_to(command_deg);
        }
        link->wait(5ms);
        watch.update(link->now(), *link, command_deg);
      }
      if (step_deg > 100.0 || row.servo.speed_deg_s > 100.0) {
        EXPECT_EQ(watch.deviates(), row.deviates) << step_deg << " " << &row - rows;
      }
    }
  }
}

TEST_F(PlateLinkTest, CannotOpenAPlateOfAnotherHost) {
  struct PlateWithHost : HobbyPlate {
    void run_until(Time now) {
      if (now - sent_ < 100ms) return HobbyPlate::run_until(now);
      sent_ = now;
      receive_line("BEAT 00001 00042");
      HobbyPlate::run_until(now);
    }
    Time sent_{0};
  } used;
  used.receive_line("HELLO 2 00042");
  used.run_for(10ms);
  used.take_output();
  EXPECT_EQ(failure_of([&] { PlateLink(std::make_unique<EmulatedLine<PlateWithHost>>(used)); }),
            "is in use by another program. End that program");
  EXPECT_FALSE(used.has_pulses());
}

TEST_F(PlateLinkTest, FailsWhenThePlateReportsAStopOrAForeignNumber) {
  // A sequence number that this host has not sent is from another program.
  open();
  plate->send("AT +000.00 09999");
  EXPECT_EQ(failure_of_serving(), second_program_text);
  EXPECT_EQ(fault, Fault::line);
  const std::pair<const char*, Fault> stops[] = {
      {"emergency", Fault::emergency}, {"fault", Fault::device},  {"limit", Fault::limits},     {"stuck", Fault::stuck},
      {"sensor", Fault::device},       {"supply", Fault::device}, {"unhomed", Fault::restarted}};
  for (const auto& [reason, expected] : stops) {
    open();
    plate->send(std::string("STOPPED ") + reason);
    EXPECT_NE(failure_of_serving(), "");
    EXPECT_EQ(fault, expected) << reason;
  }
}

}  // namespace
}  // namespace hrt::plate
