// Packets of the Dynamixel Protocol 2.0, and the driver's device on an emulated servo, in simulated time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/dynamixel_packet.h"
#include "samples/app/emulator/dynamixel.h"
#include "tests/plugin/plate/emulated_line.h"
#include "tests/plugin/plate/failing_test.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace dynamixel;
using namespace std::chrono_literals;

std::string bytes_of(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

std::optional<Packet> only_packet(const std::string& bytes) {
  PacketReader reader;
  reader.append(bytes);
  auto packet = reader.next();
  EXPECT_FALSE(reader.next());
  return packet;
}

// The packets are examples of ROBOTIS' page of the protocol.
TEST(DynamixelPacket, HasThePublishedBytes) {
  EXPECT_EQ(encode({.id = 1, .instruction = ping}), bytes_of({0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 1, 0x19, 0x4E}));
  EXPECT_EQ(encode({.id = 1, .instruction = dynamixel::read, .parameters = bytes_of({132, 0, 4, 0})}),
            bytes_of({0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 2, 0x84, 0, 4, 0, 0x1D, 0x15}));
  EXPECT_EQ(encode({.id = 1, .instruction = dynamixel::write, .parameters = bytes_of({116, 0, 0, 2, 0, 0})}),
            bytes_of({0xFF, 0xFF, 0xFD, 0, 1, 9, 0, 3, 0x74, 0, 0, 2, 0, 0, 0xCA, 0x89}));
  EXPECT_EQ(encode({.id = 1, .instruction = status, .parameters = bytes_of({6, 4, 0x26})}),
            bytes_of({0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 0x55, 0, 6, 4, 0x26, 0x65, 0x5D}));
  EXPECT_EQ(encode({.id = 1, .instruction = status, .parameters = bytes_of({0xA6, 0, 0, 0})}),
            bytes_of({0xFF, 0xFF, 0xFD, 0, 1, 8, 0, 0x55, 0, 0xA6, 0, 0, 0, 0x8C, 0xC0}));
  EXPECT_EQ(encode({.id = 1, .instruction = status}), bytes_of({0xFF, 0xFF, 0xFD, 0, 1, 4, 0, 0x55, 0, 0xA1, 0x0C}));
}

// If the parameters contain the bytes of a header, another FD follows them, which the length includes.
TEST(DynamixelPacket, StuffsAHeaderInTheParameters) {
  const std::string plain = bytes_of({0xFF, 0xFF, 0xFD, 0xFD, 0, 0xFF, 0xFF, 0xFF, 0xFD});
  const std::string packet = encode({.id = 7, .instruction = dynamixel::write, .parameters = plain});
  EXPECT_EQ(packet.size(), 7 + 1 + plain.size() + 2 + 2);
  EXPECT_EQ(packet.substr(8, 5), bytes_of({0xFF, 0xFF, 0xFD, 0xFD, 0xFD}));
  EXPECT_EQ(only_packet(packet)->parameters, plain);
}

TEST(DynamixelPacket, ReadsBackWhatItWrites) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    Packet packet{.id = static_cast<std::uint8_t>(random() % 253),
                  .instruction = random() % 2 == 0 ? status : dynamixel::write};
    if (packet.instruction == status) packet.error = static_cast<std::uint8_t>(random());
    for (auto n = random() % 60; n > 0; --n)
      packet.parameters += random() % 3 == 0 ? static_cast<char>(random()) : bytes_of({0xFF, 0xFD, 0x00})[random() % 3];
    const auto read = only_packet(encode(packet));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->id, packet.id);
    EXPECT_EQ(read->instruction, packet.instruction);
    EXPECT_EQ(read->error, packet.error);
    EXPECT_EQ(read->parameters, packet.parameters);
  }
}

TEST(DynamixelPacket, RejectsDamagedPackets) {
  const Packet packet{.id = 1, .instruction = status, .parameters = bytes_of({0xA6, 1, 2, 3})};
  const std::string good = encode(packet);
  int read = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int value = 0; value < 256; ++value) {
      std::string bad = good;
      if (static_cast<unsigned char>(bad[at]) == value) continue;
      bad[at] = static_cast<char>(value);
      PacketReader reader;
      reader.append(bad + std::string(300, '\0') + good);
      const auto found = reader.next();
      ASSERT_TRUE(found) << at << " " << value;
      EXPECT_EQ(found->parameters, packet.parameters);
      EXPECT_FALSE(reader.next());
      ++read;
    }
  }
  EXPECT_EQ(read, 255 * static_cast<int>(good.size()));
}

TEST(DynamixelPacket, MemoryIsBounded) {
  PacketReader reader;
  for (int i = 0; i < 1000; ++i) {
    reader.append(std::string(1000, '\xFF'));
    EXPECT_FALSE(reader.next());
  }
  reader.append(encode({.id = 3, .instruction = ping}));
  EXPECT_EQ(reader.next()->id, 3);
}

class DynamixelTest : public FailingTest {
 protected:
  std::unique_ptr<Device> open(const std::string& options = "", Start start = Start::hold) {
    return device_named("dynamixel:bus" + options)(
        [&](const std::string& path, int) {
          EXPECT_EQ(path, "bus");
          auto made = std::make_unique<EmulatedLine<EmulatedDynamixel>>(servo);
          line = made.get();
          return made;
        },
        start);
  }
  std::string failure_of_opening(const std::string& options = "") {
    return failure_of([&] { open(options); });
  }

  static void turn(Device& device, double orientation_deg, std::chrono::milliseconds time) {
    device.turn_to(orientation_deg);
    serve(device, time);
  }

  EmulatedDynamixel servo;
  EmulatedLine<EmulatedDynamixel>* line = nullptr;
};

TEST_F(DynamixelTest, OpeningWritesTheControlTable) {
  servo.set(132, 4, 2148);
  const auto device = open("?speed=200&effort=40");
  EXPECT_EQ(servo.get(11, 1), 5);     // operating mode: current-based position
  EXPECT_EQ(servo.get(102, 2), 588);  // goal current: 40 % of 1470 mA
  EXPECT_EQ(servo.get(112, 4), 1);    // profile velocity: slow until the first command
  EXPECT_EQ(servo.get(98, 1), 15);    // bus watchdog: 15 times 20 ms
  EXPECT_EQ(servo.get(64, 1), 1);     // torque: on
  EXPECT_EQ(device->description(), "Dynamixel XL330-M288, id 1, firmware 52");
  EXPECT_NEAR(device->limits().speed_deg_s, 200.0, 0.7);
  EXPECT_EQ(device->limits().max_deg, 360.0);
  EXPECT_TRUE(device->is_measured());
  // Reads of the position: a request of 14 bytes and an answer of 15, 174 us per byte, and the servo's delay of 500 us.
  EXPECT_NEAR(std::chrono::duration<double>(*device->round_trip()).count(), 5.4e-3, 0.4e-3);
  turn(*device, 9.0, 100ms);
  EXPECT_EQ(servo.get(112, 4), 146);  // 200 degrees/s, in units of 0.229 * 6
}

// Calculated by hand from ROBOTIS' pages: stall torque at 5 V and 1.47 A: 0.52 N m (M288), 0.215 N m (M077).
// The rim is at 75 mm: 4 N are 0.3 N m, 848 mA of an M288; 1470 mA of an M077 are 2.87 N.
TEST_F(DynamixelTest, PushesWithAtMost4NewtonsAtTheRim) {
  const struct {
    int model;
    const char* options;
    int current_ma;
  } rows[] = {{1200, "?effort=100", 848},
              {1190, "?effort=100", 1470},
              {1200, "", 735},
              {1190, "", 735},
              {1200, "?effort=5", 73}};
  for (const auto& row : rows) {
    servo = EmulatedDynamixel(1, row.model);
    open(row.options);
    EXPECT_EQ(servo.get(102, 2), row.current_ma);
  }
  servo = EmulatedDynamixel(1, 1200);
  servo.set(38, 2, 300);  // the servo's own limit, in mA, is lower
  open();
  EXPECT_EQ(servo.get(102, 2), 300);
}

// Drive mode 5 is reversed, with a profile by time: 90 degrees would take 218 ms, in the wrong direction.
TEST_F(DynamixelTest, SetsTheNormalDriveMode) {
  servo.set(10, 1, 5);
  const auto device = open();
  EXPECT_EQ(servo.get(10, 1), 0);
  turn(*device, 90.0, 200ms);
  EXPECT_GT(servo.orientation_deg(), 20.0);
  EXPECT_LT(servo.motor.max_speed_deg_s(), 301.0);
}

// The driver reads the limits of force and speed, torque and supply while the plate turns.
TEST_F(DynamixelTest, ReportsChangesOfTheControlTableDuringAMotion) {
  const struct {
    int address, size;
    std::int64_t value;
    Fault fault;
  } rows[] = {{102, 2, 1750, Fault::line},  {112, 4, 0, Fault::line},    {64, 1, 0, Fault::device},
              {70, 1, 0x20, Fault::device}, {144, 2, 36, Fault::device}, {144, 2, 61, Fault::device}};
  for (const auto& row : rows) {
    servo = EmulatedDynamixel();
    const auto device = open();
    turn(*device, 45.0, 300ms);
    servo.set(row.address, row.size, row.value);
    EXPECT_NE(failure_of([&] { serve(*device, 400ms); }), "");
    EXPECT_EQ(fault, row.fault) << row.address;
  }
}

// A damaged length announces more bytes than arrive: the packet is dropped after the time limit of the answer.
TEST_F(DynamixelTest, ADamagedLengthLosesOneAnswer) {
  for (const int length : {0x20, 0x60, 0xF0}) {
    servo = EmulatedDynamixel();
    const auto device = open();
    servo.damages_length = length;
    auto oldest = 0ns;
    for (const auto begin = device->now(); device->now() < begin + 3s;) {
      device->turn_to((device->now() - begin) / 500ms % 2 == 0 ? 30.0 : 50.0);
      device->wait(5ms);
      oldest = std::max<std::chrono::nanoseconds>(oldest, device->now() - device->reported());
    }
    EXPECT_LT(oldest, 120ms) << length;
    EXPECT_GT(device->refusals(), 1U);
  }
}

TEST_F(DynamixelTest, OpensWithoutAMotion) {
  const auto device = open("", Start::passive);
  EXPECT_EQ(device->description(), "Dynamixel XL330-M288, id 1, firmware 52");
  const auto details = device->details();
  EXPECT_NE(std::find(details.begin(), details.end(), "setting operating mode 3"), details.end());
  EXPECT_EQ(servo.get(64, 1), 0);
  EXPECT_EQ(servo.get(98, 1), 0);
  EXPECT_EQ(servo.writes_to_eeprom(), 0);
}

// Orientation 0 moves by 3 degrees clockwise, and the shaft turns to the new orientation 0.
TEST_F(DynamixelTest, MovesItsZeroByTheHomingOffset) {
  const auto device = open();
  turn(*device, 0.0, 100ms);
  EXPECT_EQ(device->zero_deg(), 0.0);
  device->set_zero(-3.0);
  serve(*device, 300ms);
  EXPECT_EQ(servo.get(20, 4), 34);
  EXPECT_NEAR(servo.orientation_deg(), -3.0, 0.05);
  EXPECT_EQ(device->orientation_deg(), 0.0);
  EXPECT_NEAR(device->zero_deg(), -3.0, 0.05);
  EXPECT_TRUE(has(failure_of([&] { device->set_zero(91.0); }), "-1035 steps; allowed: -1024 to 1024"));
  EXPECT_EQ(servo.get(20, 4), 34);
}

// Each write wears the EEPROM in which the servo stores its mode.
TEST_F(DynamixelTest, WritesTheModeOnlyIfItDiffers) {
  open();
  open();
  EXPECT_EQ(servo.writes_to_eeprom(), 1);
}

TEST_F(DynamixelTest, TurnsCounterClockwiseByItsProfile) {
  const auto device = open();
  EXPECT_EQ(device->orientation_deg(), 0.0);
  turn(*device, 90.0, 200ms);
  EXPECT_GT(servo.orientation_deg(), 40.0);
  EXPECT_LT(servo.orientation_deg(), 60.5);
  serve(*device, 500ms);
  EXPECT_EQ(servo.get(116, 4), 2048 + 1024);
  EXPECT_EQ(device->orientation_deg(), 90.0);
  EXPECT_NEAR(device->limits().speed_deg_s, 300.0, 15.0);
}

// The servo counts turns, so that the plate can turn past half a turn without turning back.
TEST_F(DynamixelTest, ContinuesPastHalfATurn) {
  const auto device = open();
  for (const double orientation_deg : {170.0, 200.0, -250.0}) {
    turn(*device, orientation_deg, 2000ms);
    EXPECT_NEAR(*device->orientation_deg(), orientation_deg, 0.1);
    EXPECT_NEAR(servo.orientation_deg(), orientation_deg, 0.1);
  }
  servo.restart();  // clears the count of turns: -250 degrees are 110
  EXPECT_NEAR(servo.orientation_deg(), -250.0, 0.1);
  EXPECT_EQ(servo.get(132, 4), 2048 + 1252);
}

// An exchange of up to 15 ms must end before the stop is sent, which takes 3.5 ms.
TEST_F(DynamixelTest, AStopEndsTheMotion) {
  for (auto moving = 60ms; moving < 200ms; moving += 7ms) {
    auto device = open();
    turn(*device, servo.orientation_deg() > 0.0 ? -80.0 : 80.0, moving);
    const double at_stop_deg = servo.orientation_deg();
    if (moving % 2ms == 0ms)
      device->stop();
    else
      device.reset();
    double farthest_deg = 0.0;
    for (int i = 0; i < 60; ++i) {
      if (device)
        serve(*device, 5ms);
      else
        servo.run_until(servo.now() + 5ms);
      farthest_deg = std::max(farthest_deg, std::abs(servo.orientation_deg() - at_stop_deg));
    }
    EXPECT_LT(farthest_deg, 2.0 + 300.0 * 0.02) << moving.count();
  }
}

// When the host hangs, the servo's watchdog stops it after 300 ms and clears its profile, which the next command sets.
TEST_F(DynamixelTest, TheWatchdogStopsItAndTheNextCommandContinues) {
  const auto device = open("?speed=100");
  turn(*device, 150.0, 100ms);
  line->pause(2000ms);
  EXPECT_EQ(servo.get(98, 1), -1);
  const double stopped_deg = servo.orientation_deg();
  EXPECT_LT(stopped_deg, 45.0);
  turn(*device, 150.0, 500ms);
  EXPECT_EQ(servo.get(98, 1), 15);
  EXPECT_GT(servo.orientation_deg(), stopped_deg + 30.0);
  EXPECT_LT(servo.orientation_deg(), stopped_deg + 51.0);
}

TEST_F(DynamixelTest, ReportsTheCauseOfAFailureToOpen) {
  const struct {
    std::function<void()> cause;
    Fault fault;
    const char* words;
  } rows[] = {{[&] { servo.is_silent = true; }, Fault::no_answer, "Dynamixel of id 1 within 3 s"},
              {[&] { servo = EmulatedDynamixel(2); }, Fault::no_answer, "Dynamixel of id 1 within 3 s"},
              {[&] { servo.set(0, 2, 350); }, Fault::no_answer, "model number 350; allowed: 1190"},
              {[&] { servo.set(70, 1, 0x24); }, Fault::device, "overheating, overload"},
              {[&] { servo.set(144, 2, 61); }, Fault::device, "6.1 V; allowed: 3.7 V to 6.0 V"},
              {[&] { servo.motor.turn_by_hand(1080.0); }, Fault::limits, "1080 degrees; allowed: -360 to 360"}};
  for (const auto& row : rows) {
    servo = EmulatedDynamixel();
    row.cause();
    EXPECT_TRUE(has(failure_of_opening(), row.words));
    EXPECT_EQ(fault, row.fault) << row.words;
  }
}

TEST_F(DynamixelTest, ReportsAnErrorOfTheServo) {
  const auto device = open();
  servo.forced_error = 7;
  EXPECT_TRUE(has(failure_of([&] { serve(*device, 500ms); }), "refuses a read of address 98: access error. Switch"));
  EXPECT_EQ(fault, Fault::protocol);
}

// Another program writes a goal while the driver has no command, holds one, or moves the plate: the plate is stopped
// without torque, so that later goals do not turn it. Writing the present goal again changes nothing.
TEST_F(DynamixelTest, CommandsOfAnotherProgramEndTheTorque) {
  const auto send_goal = [&](std::int64_t step) {
    const std::string goal = little_endian(116, 2) + little_endian(step, 4);
    servo.receive(encode({.id = 1, .instruction = dynamixel::write, .parameters = goal}), servo.now());
  };
  for (const double command_deg : {-1.0, 0.0, 90.0}) {
    auto device = open();
    if (command_deg >= 0.0) device->turn_to(command_deg);
    serve(*device, 200ms);
    for (const int aside : {0, 500}) {
      send_goal(servo.get(116, 4) + aside);
      EXPECT_EQ(failure_of([&] { serve(*device, 100ms); }).empty(), aside == 0);
    }
    EXPECT_EQ(fault, Fault::line);
    EXPECT_EQ(servo.get(64, 1), 0);
    const double stopped_deg = servo.orientation_deg();
    device.reset();
    for (int i = 0; i < 20; ++i) {
      send_goal(3000);
      servo.run_until(servo.now() + 50ms);
    }
    EXPECT_EQ(servo.orientation_deg(), stopped_deg);
  }
}

// A profile velocity of 1 is 1.4 degrees a second: a goal of another program turns the plate slowly.
TEST_F(DynamixelTest, APlateAtRestHasASlowProfile) {
  const auto device = open();
  turn(*device, 45.0, 500ms);
  EXPECT_EQ(servo.get(112, 4), 1);
  turn(*device, -45.0, 100ms);
  EXPECT_EQ(servo.get(112, 4), 218);  // 300 degrees/s, in units of 0.229 * 6
  device->stop();
  serve(*device, 50ms);
  EXPECT_EQ(servo.get(112, 4), 1);
}

// Damaged answers, answers that some adapters delay by up to 40 ms, and adapters that echo the bytes of the host.
TEST_F(DynamixelTest, ReachesItsCommandOnADisturbedLine) {
  const std::function<void()> disturbances[] = {[&] { servo.damages_answers = true; }, [&] { servo.delay = 40ms; },
                                                [&] { servo.echoes = true; }};
  for (const auto& disturb : disturbances) {
    servo = EmulatedDynamixel();
    disturb();
    const auto device = open();
    turn(*device, -30.0, 1500ms);
    EXPECT_NEAR(*device->orientation_deg(), -30.0, 0.1);
    EXPECT_EQ(device->refusals() > 5U, servo.damages_answers);
  }
}

// The host discards an answer that arrives after 90 ms, so that it is not taken for the answer to the next request.
TEST_F(DynamixelTest, IgnoresLateAnswers) {
  servo.delay = 90ms;
  EXPECT_NE(failure_of_opening(), "");
}

// Names of devices, and a part of the text that rejects each; empty if the name is valid.
TEST(DeviceName, IsCheckedBeforeTheDeviceIsOpened) {
  const std::pair<const char*, const char*> rows[] = {
      {"", "device \"\" has no kind; allowed: serial:..., dynamixel:..."},
      {"usb:x", "kind \"usb\"; allowed: serial:..., dynamixel:..."},
      {"serial:", "names no serial line"},
      {"serial:/dev/x?id=1", "no option \"id\"; allowed: none"},
      {"dynamixel:/dev/x?id", "option \"id\" of the device must have the form name=value"},
      {"dynamixel:/dev/x?", "option \"\" of the device must have the form name=value"},
      {"dynamixel:/dev/x?id=1&id=2", "option id is given twice"},
      {"dynamixel:/dev/x?id=253", "option id is \"253\"; allowed: 0 to 252"},
      {"dynamixel:/dev/x?id=1x", "option id is \"1x\"; allowed: 0 to 252"},
      {"dynamixel:/dev/x?baud=60000", "baud is 60000; allowed: 57600, 115200, 1000000"},
      {"dynamixel:/dev/x?colour=1", "no option \"colour\"; allowed: id, baud, speed, effort"},
      {"dynamixel:/dev/x?id=0&baud=1000000&speed=10&effort=100", ""}};
  for (const auto& [name, words] : rows) {
    std::string refusal;
    try {
      device_named(name);
    } catch (const std::invalid_argument& wrong) {
      refusal = wrong.what();
    }
    EXPECT_TRUE(*words == 0 ? refusal.empty() : refusal.find(words) != std::string::npos) << name << ": " << refusal;
  }
}

}  // namespace
}  // namespace hrt::plate
