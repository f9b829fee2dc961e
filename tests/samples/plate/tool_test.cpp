// Tests of hrt-plate: its commands on emulated plates in simulated time, on the firmware's ELF, and as a program.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <sstream>

#include "plugin/include/plate_driver/plate_failure.h"
#include "plugin/include/plate_driver/plate_file.h"
#include "plugin/src/plate/plate_link.h"
#include "samples/app/emulator/pty_device.h"
#include "samples/app/text/format.h"
#include "samples/plate/tool/commands.h"
#include "samples/plate/tool/measure.h"
#include "tests/plugin/plate/emulated_line.h"
#include "tests/samples/plate/board_with_servo.h"
#include "tests/samples/process.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

template <class Emulated>
std::unique_ptr<Line> line_to(Emulated& device) {
  return std::make_unique<EmulatedLine<Emulated>>(device);
}

using Answers = std::vector<std::function<std::string()>>;

// Returns a reader that gives these answers, and then the end of the input. Its copies share the position.
std::function<Input()> reader_of(const Answers& answers) {
  return [answers, next = std::make_shared<std::size_t>(0)]() -> Input {
    if (*next == answers.size()) return {.ended = true};
    return {.line = answers[(*next)++]()};
  };
}

Answers entered(const std::vector<std::string>& lines) {
  Answers answers;
  for (const std::string& line : lines) answers.emplace_back([line] { return line; });
  return answers;
}

// Runs a command with the device at the serial line "board". `lines` are the serial devices of the computer.
template <class Emulated>
Outcome run_with(Emulated& device, const std::vector<std::string>& arguments, const Answers& answers = {},
                 const std::vector<std::string>& lines = {"/nonexistent", "board"}) {
  std::ostringstream out, err;
  const auto open = [&](const std::string& path, int baud) {
    return path == "board" ? line_to(device) : open_serial_line(path, baud);
  };
  std::vector<const char*> words = {"hrt-plate"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  const auto devices = [&lines] { return lines; };
  const int code =
      run_tool(static_cast<int>(words.size()), words.data(), {devices, open, reader_of(answers), out, err});
  return {code, out.str(), err.str()};
}

// Answers of the operator: Enter, then two readings of the scale, to a degree.
template <class Board>
Answers scale_readings(Board& board) {
  const auto seen = [&board] { return std::to_string(std::lround(board.servo.plate_deg())); };
  return {[] { return std::string(); }, seen, seen};
}

// Replaces each number, for outputs whose last digits depend on the compiler of the firmware.
std::string without_numbers(const std::string& text) {
  return std::regex_replace(text, std::regex("[0-9][0-9.]*(e[+-][0-9]+)?"), "#");
}

// True if the guide has this output, with `other` in place of `own`.
testing::AssertionResult is_in_guide(const std::string& printed, const std::string& own, const std::string& other,
                                     bool with_its_numbers = true) {
  std::string shown;
  std::istringstream lines(printed);
  for (std::string text; std::getline(lines, text); shown += "    " + text + "\n")
    for (std::size_t at; (at = text.find(own)) != std::string::npos;) text.replace(at, own.size(), other);
  const std::string guide = HRT_PLATE_SOURCE "/guide/";
  const std::string pages = read_file(guide + "README.md") + read_file(guide + "hobby.md");
  return with_its_numbers ? has(pages, shown) : has(without_numbers(pages), without_numbers(shown));
}

TEST(PlateTool, FindsThePlate) {
  HobbyPlate board;
  const Outcome outcome = expect_exit(0, run_with(board, {"find"}));
  EXPECT_TRUE(has(outcome.out, {"/nonexistent cannot be opened: No such file or directory. Check its name",
                                "serial:board: protocol 2, firmware 1.1.0, serial number 000007\n"}));
  HobbyPlate mute({.answers = false});
  const Outcome none = expect_exit(1, run_with(mute, {"find"}));
  EXPECT_TRUE(
      has(none.out, {"board does not answer as a plate within 5 s", "board does not answer as a Dynamixel of id 1"}));
  EXPECT_TRUE(has(none.err, "no plate was found; tried: /nonexistent, board. Check"));
  EXPECT_LT(mute.now(), 8500ms);
  EXPECT_TRUE(has(run_with(mute, {"find"}, {}, {}).err, "no serial board or adapter is connected"));
}

// One serial device has no plate, the other device is a pseudo-terminal with a servo. The input ends before Enter.
TEST(PlateTool, CommissionsTheOnlyPlateThatItFinds) {
  PtyDynamixel servo(std::uint8_t{1}, 1190);
  HobbyPlate board;
  const Outcome found = expect_exit(1, run_with(board, {"commission"}, {}, {"/nonexistent", servo.device()}));
  EXPECT_TRUE(
      has(found.out, "dynamixel:" + servo.device() + ": Dynamixel XL330-M077, id 1, firmware 52\nKeep your hands"));
  const Outcome two = expect_exit(1, run_with(board, {"commission"}, {}, {"board", "board"}));
  EXPECT_TRUE(has(two.err, "more than one plate was found"));
}

TEST(PlateTool, ShowsSettingsAndSelfTest) {
  HobbyPlate board({.settings = settings_default()});
  const Outcome outcome = expect_exit(0, run_with(board, {"show", "board"}));
  EXPECT_TRUE(has(outcome.out,
                  {"protocol 2, firmware 1.1.0, serial number 000000\n",
                   "range -45 to 45 deg, 60 deg/s, latency 32 ms including half of the round trip, orientation assumed",
                   "setting zero 1500", "setting serial 0", "test emergency closed"}));
  EXPECT_FALSE(board.has_pulses());
}

TEST(PlateTool, RefusesAWrongCommandLine) {
  HobbyPlate board;
  EXPECT_EQ(run_with(board, {}).exit_code, 2);
  EXPECT_EQ(run_with(board, {"show"}).exit_code, 2);
  EXPECT_EQ(run_with(board, {"paint", "/dev/null"}).exit_code, 2);
  EXPECT_EQ(run_with(board, {"show", "dynamixel:board?id=300"}).err,
            "hrt-plate: option id is \"300\"; allowed: 0 to 252\n");
  EXPECT_EQ(run_with(board, {"turn", "board", "91"}).err, "hrt-plate: angle is 91; allowed: -90 to 90\n");
  EXPECT_EQ(run_with(board, {"set", "board", "zero"}).err,
            "hrt-plate: \"zero\" must be name=number, as in zero=1505, with a number from -1000000 to 1000000\n");
}

TEST(PlateTool, SetsSettings) {
  BoardWithServo board;
  EXPECT_EQ(run_with(board, {"set", "board", "zero=1510", "speed=150"}).out, "saved\n");
  EXPECT_EQ(run_with(board, {"set", "board", "zero=9"}).err,
            "hrt-plate: the plate at board refuses CONF zero 9: the value is out of range or inconsistent with other "
            "settings; samples/plate/firmware/README.md has the ranges\n");
  EXPECT_TRUE(has(run_with(board, {"set", "board", "size=9"}).err, "has no setting of this name"));
  BoardWithServo kept({}, 0.0, board.eeprom());
  EXPECT_TRUE(has(run_with(kept, {"show", "board"}).out, "setting speed 150\n"));
}

TEST(PlateTool, TurnsAndHolds) {
  HobbyPlate board({.orientation_deg = 60.0});
  double before_deg = 0.0, after_deg = 0.0;
  const Outcome outcome = run_with(board, {"turn", "board", "-30"},
                                   {[&] {
                                      before_deg = board.orientation_deg();
                                      return "";
                                    },
                                    [&] {
                                      after_deg = board.orientation_deg();
                                      return "";
                                    }});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(before_deg, 60.0);
  EXPECT_NEAR(after_deg, -30.0, 0.5);
}

// The notch is 3 degrees too far counter-clockwise: the pulse at 0 becomes 33.3 us shorter. The trim is kept across
// power-off, and after a second trim whose input ended early.
TEST(PlateTool, TrimsAndSaves) {
  BoardWithServo board;
  const Outcome outcome = expect_exit(0, run_with(board, {"trim", "board"}, entered({"", "x", "31", "3", ""})));
  EXPECT_TRUE(has(outcome.out, {"\"x\" is not a number from -30 to 30", "\"31\" is not a number",
                                "Orientation 0 has moved by -2.97 deg."}));
  const auto& pulses = board.pulses();
  EXPECT_NEAR(pulses.back().width_us(), 1467.0, 4.0);
  for (std::size_t i = 1; i < pulses.size(); ++i)
    EXPECT_LE(std::abs(pulses[i].width_us() - pulses[i - 1].width_us()), 45.0);
  BoardWithServo again({}, 0.0, board.eeprom());
  EXPECT_EQ(run_with(again, {"trim", "board"}, entered({"", "-2"})).err,
            "hrt-plate: the input ended before the last answer; nothing was saved\n");
  EXPECT_EQ(PlateLink(line_to(again)).setting("zero"), 1467.0);
}

TEST(PlateTool, FindsShowsAndTrimsADynamixel) {
  EmulatedDynamixel servo(1, 1190);
  const Outcome found = run_with(servo, {"find", "board"});
  EXPECT_TRUE(is_in_guide(found.out, "board", "/dev/ttyUSB0"));
  EXPECT_TRUE(has(found.out, "dynamixel:board: Dynamixel XL330-M077, id 1, firmware 52\n"));
  const Outcome shown = run_with(servo, {"show", "dynamixel:board"});
  EXPECT_TRUE(has(shown.out, {"range -360 to 360 deg, 299.532 deg/s", "orientation measured\n",
                              "setting operating mode 3\n", "setting homing offset 0 steps\n", "hardware error 0\n"}));
  EXPECT_TRUE(is_in_guide(shown.out, "board", ""));
  EXPECT_EQ(servo.get(64, 1), 0);
  const Outcome trimmed = expect_exit(0, run_with(servo, {"trim", "dynamixel:board"}, entered({"", "3", "-1", ""})));
  EXPECT_TRUE(has(trimmed.out, "0 has moved by -2.02 deg."));
  servo.restart();
  EXPECT_EQ(servo.get(20, 4), 23);
  EXPECT_EQ(run_with(servo, {"trim", "dynamixel:board"}, entered({"", "5"})).exit_code, 1);
  EXPECT_EQ(servo.get(20, 4), 23);
}

// Onset at 40 ms, then 25 ms of constant acceleration to 250 degrees a second, sampled every 5 ms, also with a filter.
TEST(PlateStep, IsFitted) {
  for (const double filter_s : {0.0, 0.007}) {
    std::vector<StepSample> samples;
    double place_deg = 0.0, speed_deg_s = 0.0, shown_deg = 0.0;
    for (int i = 0; place_deg < 80.0; ++i) {
      const double time_s = i * 1e-4;
      speed_deg_s = time_s < 0.04 ? 0.0 : std::min(250.0, speed_deg_s + 1.0);
      place_deg += speed_deg_s * 1e-4;
      shown_deg += (place_deg - shown_deg) * (filter_s > 0.0 ? 1e-4 / filter_s : 1.0);
      if (i % 50 == 0) samples.push_back({time_s, shown_deg});
    }
    const auto fit = fit_steps({{90.0, samples}, {90.0, samples}}, filter_s);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->onset_s.value, 0.04, 0.5e-3) << filter_s;
    EXPECT_NEAR(fit->speed_deg_s.value, 250.0, 1.0);
    EXPECT_NEAR(fit->acceleration_deg_s2.value, 10'000.0, 1000.0);
  }
  EXPECT_FALSE(fit_steps({{90.0, {{0.0, 0.0}, {0.1, 40.0}}}}, 0.0));
}

// The firmware's own ELF, with a servo that turns clockwise, has 1.1 times the usual span, and starts at 20 degrees.
TEST(PlateCommission, WritesTheFileOfAPlate) {
  BoardWithServo board({.speed_deg_s = 160.0, .backlash_deg = 2.0, .lower_stop_deg = -72.0}, 20.0,
                       eeprom_with(settings_default()));
  board.servo.span_us = -2200.0;
  const TemporaryFolder folder;
  const Outcome outcome =
      run_with(board, {"commission", "board", "--out", folder / "plate.json"}, scale_readings(board));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(is_in_guide(outcome.out, folder / "", "", false));
  const auto file = nlohmann::json::parse(read_file(folder / "plate.json"));
  EXPECT_EQ(file.at("device"), "serial:board");
  EXPECT_TRUE(has(file.at("details").dump(), "setting span -2") &&
              has(file.at("details").dump(), "test emergency closed"));
  EXPECT_NEAR(file.at("session").at("plate_max_speed_deg_s").get<double>(), 144.0, 8.0);
  // Dead time of 10 ms, half a pulse period, a pulse of 1.5 ms; the largest error of simulated plates is 11 ms.
  EXPECT_NEAR(file.at("measured").at("latency_ms").at(0).get<double>(), 21.5, 11.0);
  EXPECT_NEAR(file.at("measured").at("backlash_deg").at(0).get<double>(), 2.2, 0.3);
  const PlateFile read = read_plate_file(folder / "plate.json");
  EXPECT_TRUE(has(read.description, "protocol 2, firmware 1.1.0, serial number "));
  EXPECT_NE(read.description.substr(read.description.size() - 6), "000000");
  EXPECT_TRUE(has(read.settings.front(), "setting zero "));
  BoardWithServo kept({}, 0.0, board.eeprom());
  PlateLink link(line_to(kept));
  EXPECT_TRUE(link.is_measured());
  EXPECT_GT(link.limits().min_deg, -72.0);
  EXPECT_LT(link.limits().min_deg, -64.0);
  EXPECT_NEAR(link.setting("span"), -2200.0, 60.0);
  EXPECT_NEAR(link.setting("speed"), 0.9 * 160.0, 8.0);
}

TEST(PlateCommission, RefusesAPlateWithoutASensorAndAnEndOfTheInput) {
  HobbyPlate board({.settings = settings_default()});
  board.has_sensor = false;
  const TemporaryFolder folder;
  const Outcome blind =
      expect_exit(9, run_with(board, {"commission", "board", "--out", folder / "plate.json"}, scale_readings(board)));
  EXPECT_TRUE(has(blind.err, "the sensor at pin A0 does not change")) << blind.err;
  EXPECT_EQ(run_with(board, {"commission", "board", "--out", folder / "plate.json"}).exit_code, 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

struct Uniform {
  std::mt19937 random{33};
  double operator()(double low, double high) { return std::uniform_real_distribution(low, high)(random); }
};

ServoTraits random_traits(Uniform& between, unsigned seed, double fastest_deg_s) {
  return {.speed_deg_s = between(120.0, fastest_deg_s),
          .acceleration_deg_s2 = between(4000.0, 20'000.0),
          .dead_time = std::chrono::microseconds(std::lround(between(4e3, 25e3))),
          .dead_band_deg = between(0.05, 0.3),
          .backlash_deg = between(0.0, 3.0),
          .load = between(0.0, 0.3),
          .lower_stop_deg = between(-120.0, -60.0),
          .upper_stop_deg = between(60.0, 120.0),
          .noise_deg = between(0.0, 0.15),
          .seed = seed};
}

template <class Emulated>
struct Disturbed : Emulated {
  using Emulated::Emulated;
  std::function<void(Emulated&)> disturb = [](Emulated&) {};
  double ran_s = 0.0;
  void run_until(std::chrono::nanoseconds now) {
    ran_s = std::chrono::duration<double>(now).count();
    disturb(*this);
    Emulated::run_until(now);
  }
};

struct Hobby : Disturbed<HobbyPlate> {
  Hobby(Uniform& between, unsigned seed)
      : Disturbed({.settings = settings_default(),
                   .servo = random_traits(between, seed, 400.0),
                   .orientation_deg = between(-40.0, 40.0)}) {
    servo.bend_deg = between(0.0, 3.0);
    servo.bend_waves = 1 + static_cast<int>(between.random() % 2);
    servo.bend_phase_deg = between(0.0, 360.0);
    servo.span_us = between(1500.0, 2300.0) * (between.random() % 2 == 0 ? 1.0 : -1.0);
  }
  Measurements commissioned() {
    return commission([&] { return std::make_unique<PlateLink>(line_to(*this)); },
                      {reader_of(scale_readings(*this)), [](const std::string&) {}});
  }
  EmulatedServo& physics() { return servo; }
  static constexpr double exchange_ms = 10.0;  // mean time until the next pulse: half a period
};

struct Xl330 : Disturbed<EmulatedDynamixel> {
  Xl330(Uniform& between, unsigned seed)
      : Disturbed(1, 1190, without_stops(random_traits(between, seed, 600.0))), speed_deg_s(between(20.0, 400.0)) {}
  // An XL330 has no stops.
  static ServoTraits without_stops(ServoTraits traits) {
    traits.lower_stop_deg = -(traits.upper_stop_deg = 1e4);
    return traits;
  }
  Measurements commissioned() {
    const auto name = "dynamixel:board?speed=" + std::to_string(std::lround(speed_deg_s));
    const auto open = [&](const std::string&, int) { return line_to(*this); };
    const Measurements found = commission([&] { return device_named(name)(open, Start::hold); },
                                          {reader_of(entered({"", "y", ""})), [](const std::string&) {}});
    // Restores the speed, because closing the device has reduced the profile velocity, whose unit is 1.374 degrees/s.
    motor.limit_speed(std::round(std::round(speed_deg_s) / 1.374) * 1.374);
    return found;
  }
  EmulatedServo& physics() { return motor; }
  // Sum of the mean time until an exchange in progress ends and the additional duration of the message of a command.
  static constexpr double exchange_ms = 3.9;
  double speed_deg_s;
};

// Compares measurements with the ground truth. The true latency is the dead time plus exchange_ms, the true backlash
// the play plus both sides of the dead band.
struct Accuracy {
  std::map<std::string, std::vector<double>> errors;  // in stated standard errors
  double mean_ms = 0.0, max_ms = 0.0;                 // errors of the latency

  // Returns the errors that exceed the tolerance, which is the largest of three stated standard errors, 5 % of the true
  // value, and `least`.
  std::string compare(const Measurements& found, const EmulatedServo& servo, double exchange_ms) {
    std::string wrong;
    const auto check = [&](const char* name, const Measured& measured, double truth, double least) {
      const double error = measured.value - truth;
      errors[name].push_back(error / measured.deviation);
      if (std::abs(error) > std::max({least, 0.05 * truth, 3.0 * measured.deviation}))
        wrong += format("%s %g +- %g of %g; ", name, measured.value, measured.deviation, truth);
    };
    const ServoTraits& traits = servo.traits();
    const double truth_ms = static_cast<double>(traits.dead_time.count()) * 1e-3 + exchange_ms;
    check("speed", found.speed_deg_s, servo.full_speed_deg_s(), 0.0);
    check("latency", found.latency_ms, truth_ms, 3.0);
    check("acceleration", found.acceleration_deg_s2, traits.acceleration_deg_s2, traits.acceleration_deg_s2 / 3.0);
    check("backlash", found.backlash_deg, traits.backlash_deg + 2.0 * traits.dead_band_deg, 0.15);
    max_ms = std::max(max_ms, std::abs(found.latency_ms.value - truth_ms));
    mean_ms += (found.latency_ms.value - truth_ms) / 200.0;
    // Tolerance: the scale was read to a degree in 60, and half a degree of the last step is not detected.
    if (0.98 * found.limits.min_deg < traits.lower_stop_deg - 0.5 ||
        0.98 * found.limits.max_deg > traits.upper_stop_deg + 0.5)
      wrong += "a limit is beyond its stop";
    return wrong;
  }
};

template <class Plate>
class PlateCommissionOf : public testing::Test {};
using Plates = testing::Types<Hobby, Xl330>;
TYPED_TEST_SUITE(PlateCommissionOf, Plates);

TYPED_TEST(PlateCommissionOf, MeasuresTwoHundredPlatesWithinTheirStatedErrors) {
  Uniform between;
  Accuracy accuracy;
  double longest_s = 0.0;
  int wrong = 0, refused = 0;
  for (unsigned i = 0; i < 200; ++i) {
    TypeParam plate(between, i);
    try {
      const std::string found = accuracy.compare(plate.commissioned(), plate.physics(), TypeParam::exchange_ms);
      wrong += found.empty() ? 0 : 1;
      if (!found.empty()) std::printf("plate %u: %s\n", i, found.c_str());
      longest_s = std::max(longest_s, plate.ran_s);
    } catch (const PlateFailure& failure) {
      ++refused;
      std::printf("plate %u is refused: %s\n", i, failure.what());
    }
  }
  EXPECT_LE(refused, (std::is_same_v<TypeParam, Hobby>) ? 50 : 0);  // plates whose sensor is too nonlinear
  EXPECT_LE(wrong, 6);                                              // plates with a number beyond its tolerance
  EXPECT_NEAR(accuracy.mean_ms, 0.0, (std::is_same_v<TypeParam, Hobby>) ? 1.5 : 0.5);
  EXPECT_LT(longest_s, 180.0);
  double covered = 0.0, numbers = 0.0;
  for (const auto& [name, errors] : accuracy.errors) {
    const auto is_covered = [](double error) { return std::abs(error) <= 2.0; };
    const auto count = static_cast<double>(std::count_if(errors.begin(), errors.end(), is_covered)),
               n = static_cast<double>(errors.size());
    std::printf("%-12s %3.0f %% within two standard errors\n", name.c_str(), 100.0 * count / n);
    covered += count;
    numbers += n;
  }
  EXPECT_NEAR(covered / numbers, 0.95, 0.02);
  std::printf("in all %.1f %%; latency at most %.1f ms wrong; commissioning takes at most %.0f s\n",
              100.0 * covered / numbers, accuracy.max_ms, longest_s);
}

// A supply that dips, a sensor that slips, or (hobby servo only) a converter that returns even readings only.
TYPED_TEST(PlateCommissionOf, ADefectivePlateIsRefusedOrMeasuredCorrectly) {
  Uniform between;
  Accuracy accuracy;
  int refused = 0;
  for (unsigned i = 0; i < 100; ++i) {
    TypeParam plate(between, i);
    const double from_s = between(0.0, 60.0), to_s = from_s + between(0.2, 5.0), dip = between(0.1, 0.7),
                 slip_deg = between(0.5, 4.0);
    plate.disturb = [&](auto& emulated) {
      const double now_s = std::chrono::duration<double>(emulated.now()).count();
      if (i % 3 == 0) plate.physics().supply = now_s > from_s && now_s < to_s ? dip : 1.0;
      if (i % 3 == 1) plate.physics().slip_deg = now_s > from_s ? slip_deg : 0.0;
      if constexpr (std::is_same_v<TypeParam, Hobby>) plate.converter_step = i % 3 == 2 ? 2 : 1;
    };
    try {
      const Measurements found = plate.commissioned();
      plate.physics().supply = 1.0;
      EXPECT_EQ(accuracy.compare(found, plate.physics(), TypeParam::exchange_ms), "")
          << i << " from " << from_s << " s";
    } catch (const PlateFailure&) {
      ++refused;
    }
  }
  std::printf("100 defective plates: %d refused, all others measured correctly\n", refused);
  EXPECT_GT(refused, 5);
}

TEST(PlateCommission, WritesTheFileOfADynamixel) {
  EmulatedDynamixel servo(1, 1190);
  const TemporaryFolder folder;
  const Outcome outcome =
      run_with(servo, {"commission", "dynamixel:board", "--out", folder / "plate.json"}, entered({"", "y", ""}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(is_in_guide(outcome.out, folder / "", ""));
  EXPECT_EQ(read_plate_file(folder / "plate.json").description, "Dynamixel XL330-M077, id 1, firmware 52");
  EXPECT_TRUE(has(read_file(folder / "plate.json"), "hardware error 0"));
}

TEST(PlateCommission, RefusesAServoThatTurnsClockwise) {
  EmulatedDynamixel servo(1, 1190);
  const TemporaryFolder folder;
  const Outcome outcome =
      run_with(servo, {"commission", "dynamixel:board", "--out", folder / "plate.json"}, entered({"", "n"}));
  EXPECT_EQ(outcome.exit_code, 9);
  EXPECT_TRUE(has(outcome.err, "the answer was not y"));
}

TEST(PlateFile, IsRefusedIfDamagedOrIncomplete) {
  Measurements found;
  found.device = "protocol 2, firmware 1.1.0, serial number 000007";
  found.limits = {-90.0, 90.0, 200.0, 30ms};
  found.speed_deg_s = {180.0, 1.0};
  found.acceleration_deg_s2 = {6000.0, 300.0};
  found.latency_ms = {24.0, 0.5};
  found.details = {"setting span 2000", "test loop 1"};
  found.sweep = {{-90.0, -90.0, true}, {90.0, 90.0, true}, {-90.0, -90.0, false}};
  const TemporaryFolder folder;
  const std::string path = folder / "plate.json", text = file_of(found, "serial:/dev/x", "2026-11-24");
  const auto refusal = [&](const std::string& content) -> std::string {
    write_file(path, content);
    try {
      read_plate_file(path);
    } catch (const std::invalid_argument& wrong) {
      return wrong.what();
    }
    return {};
  };
  EXPECT_EQ(refusal(text), "");
  const PlateFile read = read_plate_file(path);
  EXPECT_EQ(read.device, "serial:/dev/x");
  EXPECT_EQ(read.settings, std::vector<std::string>{"setting span 2000"});
  EXPECT_EQ(read.speed_deg_s, 180.0);
  EXPECT_EQ(read.latency_ms, 24.0);
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string other = text;
    other[at] = static_cast<char>(other[at] ^ 1);
    EXPECT_NE(refusal(other), "") << at;
    EXPECT_NE(refusal(text.substr(0, at)), "") << at;
  }
  EXPECT_EQ(refusal("{}"),
            "plate file " + path + " has no checksum; give a file that hrt-plate commission has written");
  EXPECT_TRUE(has(refusal(with_checksum("{\n")), "lacks a member"));
  EXPECT_THROW(read_plate_file("/nonexistent.json"), std::system_error);
}

TEST(PlateTool, RunsAsAProgram) {
  const Outcome none = expect_exit(9, Process({HRT_PLATE_PROGRAM, "commission", "/dev/null"}, {}).wait());
  EXPECT_TRUE(has(none.err, "hrt-plate: the plate at /dev/null is not a serial line"));
  PtyPlate device;
  const Outcome saved =
      Process({"/bin/sh", "-c", "printf -- '\\n-1\\n\\n' | " HRT_PLATE_PROGRAM " trim " + device.device()}, {}).wait();
  EXPECT_TRUE(has(saved.out, "0 has moved by +0.99 deg.")) << saved.out << saved.err;
}

}  // namespace
}  // namespace hrt::plate
