// hrt-plate against the firmware's ELF: its commands in simulated time, and as a program over a
// pseudo-terminal.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "plugin/src/plate/plate_link.h"
#include "plugin/src/plate/serial_line.h"
#include "samples/plate/tool/commands.h"
#include "samples/plate/tool/measure.h"
#include "samples/plate/tool/report.h"
#include "samples/plate/tool/trim.h"
#include "tests/plugin/plate/pty_device.h"
#include "tests/samples/plate/emulated_servo.h"
#include "tests/samples/process.h"

namespace hrt::plate {
namespace {

Outcome run_program(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), HRT_PLATE_PROGRAM);
  return Process(arguments, {}).wait();
}

template <class Emulated>
std::unique_ptr<Line> line_to(Emulated& device) {
  return std::make_unique<EmulatedLine<Emulated>>(device);
}

// The commands, with the device at the line "board"; other lines are the computer's. The person enters
// `entries`, and then goes away.
template <class Emulated>
Outcome run_with(Emulated& device, const std::vector<std::string>& arguments,
                 std::vector<std::string> entries = {}) {
  std::ostringstream out, err;
  const auto open = [&](const std::string& path, int baud) {
    return path == "board" ? line_to(device) : open_serial_line(path, baud);
  };
  const auto read = [&] {
    if (entries.empty()) return Entry{.ended = true};
    Entry entry{.line = entries.front()};
    entries.erase(entries.begin());
    return entry;
  };
  std::vector<const char*> words = {"hrt-plate"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  const auto devices = [] { return std::vector<std::string>{"/nonexistent", "board"}; };
  const int code = run_tool(static_cast<int>(words.size()), words.data(), {devices, open, read, out, err});
  return {code, out.str(), err.str()};
}

TEST(PlateTool, FindsThePlate) {
  EmulatedBoard board(eeprom_with({{SETTING_SERIAL, 42}}));
  const Outcome outcome = run_with(board, {"find"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out,
            "/nonexistent cannot be opened: No such file or directory\n"
            "serial:board: protocol 2, firmware 1.0.0, serial number 000042\n");
  EXPECT_TRUE(board.pulses().empty());
}

TEST(PlateTool, SaysThatThereIsNoPlate) {
  EmulatedBoard board;
  const Outcome outcome = run_with(board, {"find", "/dev/null"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "/dev/null is not a serial line\n");
  EXPECT_EQ(outcome.err, "hrt-plate: no plate was found\n");
}

TEST(PlateTool, ShowsSettingsAndSelfTest) {
  EmulatedBoard board;
  const Outcome outcome = run_with(board, {"show", "board"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line :
       {"protocol 2, firmware 1.0.0, serial number 000000\n",
        "range -90 to 90 deg, 300 deg/s, latency 22 ms with half of the line, orientation assumed",
        "setting zero 1500", "setting serial 0", "test settings default", "test emergency closed"})
    EXPECT_TRUE(has(outcome.out, line));
  EXPECT_TRUE(board.pulses().empty());
}

TEST(PlateTool, RefusesAWrongCommandLine) {
  EmulatedBoard board;
  EXPECT_EQ(run_with(board, {}).exit_code, 2);
  EXPECT_EQ(run_with(board, {"measure"}).exit_code, 2);
  EXPECT_EQ(run_with(board, {"paint", "/dev/null"}).exit_code, 2);
  const Outcome wrong = run_with(board, {"show", "dynamixel:board?id=300"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.err, "hrt-plate: option id is \"300\"; allowed: 0 to 252\n");
}

// An answer takes 3 ms of line and a tick of the emulator's receiver.
TEST(PlateTool, MeasuresTheLineToTheFirmware) {
  EmulatedBoard board;
  PlateLink link(line_to(board));
  ASSERT_TRUE(link.round_trip());
  EXPECT_GT(*link.round_trip(), std::chrono::milliseconds(3));
  EXPECT_LT(*link.round_trip(), std::chrono::milliseconds(6));
  EXPECT_EQ(link.refusals(), 0U);
}

TEST(PlateTool, NamesWhatFails) {
  const Outcome outcome = run_program({"measure", "/dev/null"});
  EXPECT_EQ(outcome.exit_code, 9);
  EXPECT_EQ(outcome.err, "hrt-plate: the plate at /dev/null is not a serial line\n");
}

TEST(PlateTool, IsAProgram) {
  PtyDevice<EmulatedBoard> board;
  const Outcome outcome = run_program({"find", board.device()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "serial:" + board.device() + ": protocol 2, firmware 1.0.0, serial number 000000\n");
}

// A servo of 240 degrees a second, 4.8 a pulse, whose potentiometer the plate reads.
TEST(PlateTool, MeasuresAPlateWithASensor) {
  EmulatedBoard board(eeprom_with_feedback());
  const EmulatedServo servo(board, 0.0, 4.8);
  const TemporaryFolder folder;
  const Outcome outcome = run_with(
      board, {"measure", "board", "--out", folder / "plate.json", "--plot", folder / "plate.svg", "--save"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto file = nlohmann::json::parse(read_file(folder / "plate.json"));
  EXPECT_EQ(file.at("orientation"), "measured");
  EXPECT_NEAR(file.at("speed_deg_s").get<double>(), 240.0, 40.0);
  // A difference of two places, each read to a step of the converter.
  EXPECT_LT(std::abs(file.at("backlash_deg").get<double>()), 2.0 * 180.0 / (818 - 204));
  EXPECT_LT(file.at("repeatability_deg").get<double>(), 0.3);
  EXPECT_LT(file.at("max_error_deg").get<double>(), 1.0);
  // The line, a frame of 20 ms, the potentiometer's smoothing of 8 ms, a report's period of 20 ms.
  EXPECT_GT(file.at("latency_ms").get<double>(), 2.0);
  EXPECT_LT(file.at("latency_ms").get<double>(), 90.0);
  EXPECT_EQ(file.at("sweep").size(), 25U);
  const auto session = file.at("session");
  EXPECT_EQ(session.at("plate_lower_stop_deg"), -90.0);
  EXPECT_NEAR(session.at("plate_max_speed_deg_s").get<double>(), 240.0, 40.0);
  EXPECT_EQ(file.at("scene").at("haptic").at("role"), "plate");
  EXPECT_TRUE(has(read_file(folder / "plate.svg"), "</svg>"));

  const Outcome after = run_with(board, {"show", "board"});
  EXPECT_TRUE(has(after.out, "test settings saved"));
  EXPECT_FALSE(has(after.out, "setting speed 300\n"));
}

// 5 degrees of the servo's gears: the plate turns only when they have been taken up.
TEST(PlateTool, FindsBacklash) {
  struct Loose {
    explicit Loose(EmulatedBoard& board) {
      board.on_pulse = [this, &board](const Pulse& pulse) {
        gear_deg += std::clamp((pulse.width_us() - 1500.0) * 0.09 - gear_deg, -8.0, 8.0);
        plate_deg = std::clamp(plate_deg, gear_deg - 2.5, gear_deg + 2.5);
        board.set_feedback_mv(static_cast<std::uint32_t>(std::lround(2500.0 + plate_deg * 3000.0 / 180.0)));
      };
      board.set_feedback_mv(2500);
    }
    double gear_deg = 0.0, plate_deg = 0.0;
  };
  EmulatedBoard board(eeprom_with_feedback());
  const Loose servo(board);
  PlateLink link(line_to(board));
  const Measurements found = measure(link, [](const std::string&) {});
  ASSERT_TRUE(found.backlash_deg);
  EXPECT_NEAR(*found.backlash_deg, 5.0, 0.5);
  EXPECT_NEAR(found.max_error_deg, 2.5, 0.6);
}

TEST(PlateTool, SaysWhatAPlateWithoutASensorCannotShow) {
  Measurements found;
  found.limits = {-90.0, 90.0, 300.0, std::chrono::milliseconds(23)};
  found.round_trip = std::chrono::milliseconds(6);
  found.sweep = {{-90.0, -90.0, true}, {90.0, 90.0, true}, {-90.0, -90.0, false}};
  EXPECT_TRUE(has(text_of(found), "backlash      not measurable: the plate has no sensor"));
  const auto file = nlohmann::json::parse(json_of(found));
  EXPECT_TRUE(file.at("backlash_deg").is_null());
  EXPECT_TRUE(file.at("speed_deg_s").is_null());
  EXPECT_EQ(file.at("session").at("plate_latency_ns"), 23'000'000);
  EXPECT_EQ(file.at("session").at("plate_max_speed_deg_s"), 300.0);
  EXPECT_TRUE(has(svg_of(found), "has no sensor"));
}

TEST(PlateTool, WritesAFileWholeOrNotAtAll) {
  const TemporaryFolder folder;
  write_file(folder / "a", "one");
  write_file(folder / "a", "two");
  EXPECT_EQ(read_file(folder / "a"), "two");
  EXPECT_THROW(write_file("/nonexistent/a", "x"), std::runtime_error);
  EXPECT_THROW(write_file("/dev/full/a", "x"), std::runtime_error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

// The mark is 3 degrees too far counter-clockwise: 33.3 us less. The person looks again, is content, and the
// trim is there after power-off.
TEST(PlateTool, TrimsAndSaves) {
  EmulatedBoard board;
  const Outcome outcome = run_with(board, {"trim", "board"}, {"x", "31", "3", ""});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "\"x\" is not a number from -30 to 30"));
  EXPECT_TRUE(has(outcome.out, "\"31\" is not a number"));
  EXPECT_TRUE(has(outcome.out, "0 has moved by -2.97 deg\nsaved\n"));
  const auto& pulses = board.pulses();
  EXPECT_NEAR(pulses.back().width_us(), 1467.0, 0.6);
  for (std::size_t i = 1; i < pulses.size(); ++i)
    EXPECT_LE(std::abs(pulses[i].width_us() - pulses[i - 1].width_us()), 21.0);
  EmulatedBoard again(board.eeprom());
  PlateLink link(line_to(again));
  EXPECT_EQ(link.setting("zero"), 1467.0);
}

TEST(PlateTool, AnAbandonedTrimChangesNothing) {
  EmulatedBoard board;
  const Outcome outcome = run_with(board, {"trim", "board"}, {"-2"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(has(outcome.out, "0 has moved by +1.98 deg\nnot saved: the old trim holds\n"));
  PlateLink link(line_to(board));
  EXPECT_EQ(link.setting("zero"), 1500.0);
}

TEST(PlateTool, FindsADynamixel) {
  EmulatedDynamixel servo;
  const Outcome outcome = run_with(servo, {"find"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out,
            "/nonexistent cannot be opened: No such file or directory\n"
            "board does not answer as a plate within 5 s\n"
            "dynamixel:board: Dynamixel XL330-M288, id 1, firmware 52\n");
  EmulatedDynamixel other(7);
  EXPECT_EQ(run_with(other, {"find", "board"}).exit_code, 1);
  EXPECT_EQ(run_with(other, {"find", "dynamixel:board?id=7"}).out,
            "dynamixel:board?id=7: Dynamixel XL330-M288, id 7, firmware 52\n");
  EXPECT_EQ(servo.get(64, 1) + other.get(64, 1), 0);
}

TEST(PlateTool, ShowsADynamixel) {
  EmulatedDynamixel servo;
  const Outcome outcome = run_with(servo, {"show", "dynamixel:board"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line :
       {"Dynamixel XL330-M288, id 1, firmware 52\n", "range -179.9 to 179.9 deg, 299.532 deg/s",
        "orientation measured\n", "operating mode 3\n", "homing offset 0 steps\n", "hardware error 0\n"})
    EXPECT_TRUE(has(outcome.out, line));
  EXPECT_EQ(servo.get(64, 1), 0);
}

TEST(PlateTool, TrimsADynamixel) {
  EmulatedDynamixel servo;
  const Outcome outcome = run_with(servo, {"trim", "dynamixel:board"}, {"3", "-1", ""});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "0 has moved by -2.02 deg\nsaved\n"));
  servo.restart();
  EXPECT_EQ(servo.get(20, 4), 23);
  EXPECT_EQ(run_with(servo, {"trim", "dynamixel:board"}, {"5"}).exit_code, 1);
  EXPECT_EQ(servo.get(20, 4), 23);
}

// Its range is a whole turn, at 200 degrees a second.
TEST(PlateTool, MeasuresADynamixel) {
  EmulatedDynamixel servo;
  const TemporaryFolder folder;
  const std::string name = "dynamixel:board?speed=200";
  const Outcome refused = run_with(servo, {"measure", name, "--save"});
  EXPECT_EQ(refused.exit_code, 9);
  EXPECT_EQ(
      refused.err,
      "hrt-plate: the plate at dynamixel:board?speed=200 keeps neither latency nor speed: measure without "
      "--save, and give the numbers of --out to the session\n");
  const Outcome outcome =
      run_with(servo, {"measure", name, "--out", folder / "plate.json", "--plot", folder / "plate.svg"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto file = nlohmann::json::parse(read_file(folder / "plate.json"));
  EXPECT_EQ(file.at("device"), "Dynamixel XL330-M288, id 1, firmware 52");
  EXPECT_NEAR(file.at("speed_deg_s").get<double>(), 200.0, 25.0);
  EXPECT_LT(std::abs(file.at("backlash_deg").get<double>()), 0.1);
  EXPECT_LT(file.at("repeatability_deg").get<double>(), 0.1);
  EXPECT_LT(file.at("max_error_deg").get<double>(), 0.1);
  EXPECT_LT(file.at("latency_ms").get<double>(), 40.0);
  EXPECT_EQ(file.at("session").at("plate_upper_stop_deg"), 179.9);
  EXPECT_EQ(file.at("sweep").size(), 49U);
  EXPECT_TRUE(has(read_file(folder / "plate.svg"), "</svg>"));
}

// A turn through its range takes 7 s.
TEST(PlateTool, WaitsForASlowDynamixel) {
  EmulatedDynamixel servo;
  const auto device = device_named("dynamixel:board?speed=50")(
      [&](const std::string&, int) { return line_to(servo); }, Start::hold);
  const Measurements found = measure(*device, [](const std::string&) {});
  EXPECT_NEAR(*found.speed_deg_s, 50.0, 5.0);
}

TEST(PlateTool, TrimsFromStandardInput) {
  PtyDevice<EmulatedBoard> board;
  const Outcome saved =
      Process({"/bin/sh", "-c", "printf -- '-1\\n\\n' | " HRT_PLATE_PROGRAM " trim " + board.device()}, {})
          .wait();
  EXPECT_EQ(saved.exit_code, 0) << saved.out << saved.err;
  EXPECT_TRUE(has(saved.out, "0 has moved by +0.99 deg\nsaved\n"));
}

}  // namespace
}  // namespace hrt::plate
