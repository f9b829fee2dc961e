#include "samples/reach/command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "samples/app/base/exit_code.h"

namespace hrt::reach {
namespace {

constexpr const char* description =
    "Steers a tracked fingertip to real targets while the user feels that it reaches virtual ones: locates the\n"
    "fingertip by OpenXR hand tracking and turns the ridged plate. With the mock runtime, all results are\n"
    "simulated.";

constexpr const char* exit_codes = "Exit codes:\n"
#define HRT_EXIT_CODE(name, number, words) "  " #number "  " words "\n"
    HRT_EXIT_CODES(HRT_EXIT_CODE);
#undef HRT_EXIT_CODE

// CLI::Range accepts NaN; this validator does not.
CLI::Validator between(double low, double high, const std::string& range) {
  return {[=](const std::string& text) -> std::string {
            double value = 0.0;
            if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
            return "\"" + text + "\" is not " + range;
          },
          range};
}

// Arguments that are converted to fields of Options after parsing.
struct Words {
  std::string hand = "right";
  std::string plate = "runtime";
  std::string controller = "people";
  double runtime_limit_s = 10.0;
  bool speak = false;
};

void add_reaches(CLI::App& app, Options& options, Words& words) {
  app.add_option("scene", options.scene, "glTF file with haptic roles (scene/README.md)")->required();
  app.add_option("--plugin", options.plugin,
                 "Plugin library [../lib/libhaptic_retargeting.so, seen from the folder of this program, if it\n"
                 "exists; else the installed library]");
  app.add_option("--target", options.targets, "Name of a virtual target to reach for; can be repeated [all targets]");
  app.add_option("--repeat", options.repeat, "Number of reaches for each target [1]")->check(CLI::Range(1, 1'000'000));
  app.add_option("--seed", options.seed, "Seed of a simulated user and of the noise [1]")
      ->check(CLI::Validator(
          [](const std::string& text) -> std::string {
            const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
            return digits && text.size() < 20 ? "" : "\"" + text + "\" is not a whole number from 0, below 10^19";
          },
          "a whole number from 0"));
  app.add_option("--hand", words.hand, "left, right, or either (the first hand at the start) [right]")
      ->check(CLI::IsMember({"left", "right", "either"}));
  app.add_option("--plate", words.plate,
                 "Plate to turn: runtime (simulated by the runtime), servo[:SPEED] (simulated by this program; SPEED\n"
                 "in degrees per second [400]), serial:LINE (a board with the plate's firmware), dynamixel:LINE (a\n"
                 "Dynamixel servo), or a plate.json that hrt-plate commission wrote [runtime]")
      ->check(CLI::Validator(
          [](const std::string& text) -> std::string {
            if (parse_plate(text)) return "";
            return "\"" + text +
                   "\" is not a plate; allowed: runtime, servo, servo:SPEED (1 to 1000000), serial:LINE, "
                   "dynamixel:LINE or a file *.json";
          },
          "PLATE"));
  app.add_option("--time-limit", options.time_limit_s,
                 "Maximum duration of a reach, and of each wait for the user, seconds [30]")
      ->check(between(0.1, 3600.0, "a number from 0.1 to 3600"));
  app.add_option("--runtime-limit", words.runtime_limit_s,
                 "Maximum duration of a call into the OpenXR runtime, and of a wait for the runtime, seconds [10]")
      ->check(between(0.1, 3600.0, "a number from 0.1 to 3600"));
}

void add_controller(CLI::App& app, Options& options, Words& words) {
  app.add_option(
         "--controller", words.controller,
         "people (estimates the parameters of the user, and steers to the target's position) or paper (assumes\n"
         "a known tactile weight, and steers in a fixed direction) [people]")
      ->check(CLI::IsMember({"people", "paper"}));
  app.add_option("--tactile-weight", options.tactile_weight,
                 "Tactile weight w_T: initial estimate with --controller people [0.2], constant with\n--controller "
                 "paper [0.15]")
      ->check(between(0.001, 0.499, "a number from 0.001 to 0.499"));
  app.add_option("--motor-variance", options.motor_variance_deg2,
                 "Variance of motor noise that the paper's controller assumes, degrees squared per step [0.5]")
      ->check(between(1e-9, 1e4, "a number from 1e-9 to 10000"));
}

void add_place(CLI::App& app, Options& options) {
  CLI::Option* register_to = app.add_option(
      "--register", options.register_to,
      "Ask a person to touch the plate's marks, fit the pose of the plate to the touches, and write it to\n"
      "this file");
  app.add_option("--registered", options.registered,
                 "Read the plate's pose from this file, and ask for a touch of one mark that checks it")
      ->excludes(register_to);
  app.add_flag("--fingertip", options.fingertip,
               "Before the registration, measure the offset from the tracked joint to the skin of the fingertip, so\n"
               "that the hand (--hand) may have any attitude; the offset is written to the same file")
      ->needs(register_to);
  app.add_flag("--measure-tracker", options.measure_tracker,
               "Instead of reaches, ask for 20 slides between two dimples 100 mm apart, and print the error of the\n"
               "tracker's bearings and the percentage of reaches on target that this error allows")
      ->excludes(register_to, "--registered");
  app.add_flag("--check-each", options.check_each,
               "Also before every later reach, ask for the touch that checks the registered plate");
  app.add_option("--marks", options.marks,
                 "CSV file of the marks to touch, with the columns name,x_m,y_m,z_m [the scene's start and five marks\n"
                 "on the rim]")
      ->needs(register_to);
  app.add_option("--eye-height", options.eye_height_m,
                 "Height of the eyes above the floor in metres, for a runtime without a floor space, whose LOCAL\n"
                 "space has its origin at the eyes [asked on the terminal]")
      ->check(between(0.3, 2.5, "a number from 0.3 to 2.5"));
}

void add_files(CLI::App& app, Options& options) {
  app.add_option("--record", options.record, "Record the plugin's inputs and outputs into this CSV file");
  app.add_option("--profile", options.profile, "Start from this user's profile, which --calibrate wrote")
      ->check(CLI::ExistingFile)
      ->excludes("--tactile-weight");
  CLI::Option* calibrate =
      app.add_option("--calibrate", options.calibrate,
                     "Instead of reaches, guide the user through slides that measure the user's response to the\n"
                     "ridges, and write the user's profile into this file")
          ->excludes("--target", "--repeat", "--profile", "--tactile-weight");
  app.add_option("--max-slides", options.max_slides, "Maximum number of slides of a calibration [40]")
      ->check(CLI::Range(16, 200))
      ->needs(calibrate);
}

void add_person(CLI::App& app, Options& options, Words& words) {
  app.add_flag("--person", options.person, "Instruct a person on the terminal, even if the runtime simulates a user");
  app.add_option(
         "--finger", options.finger,
         "Track the fingertip by a multitouch device, such as an infrared touch frame, instead of the runtime:\n"
         "evdev:/dev/input/by-id/NAME?width_mm=W&... (samples/reach/README.md). Tested with an emulated device\n"
         "only")
      ->needs("--person")
      ->excludes("--register", "--registered");
  CLI::Option* aloud = app.add_flag("--speak", words.speak, "Speak all requests and results by espeak-ng");
  app.add_option("--speak-with", options.speak_with,
                 "Speak with this program: its name and arguments, separated by spaces; each text is a line\n"
                 "on its standard input")
      ->excludes(aloud);
  app.add_flag("--verbose,-v", options.verbose, "Print a line per frame");
}

void take(const Words& words, Options& options) {
  options.plate = *parse_plate(words.plate);
  options.runtime_limit = std::chrono::milliseconds(std::llround(words.runtime_limit_s * 1e3));
  if (words.speak) options.speak_with = "espeak-ng";
  options.for_people = words.controller == "people";
  if (words.hand == "left") options.hands = {Hand::left};
  if (words.hand == "right") options.hands = {Hand::right};
  if (words.hand == "either") options.hands = {Hand::right, Hand::left};
  if (options.fingertip && options.hands.size() > 1)
    throw CLI::ValidationError("--fingertip", "needs --hand left or right, as the offset is valid for one hand only");
  if (options.check_each && options.register_to.empty() && options.registered.empty())
    throw CLI::ValidationError("--check-each", "needs --register or --registered");
}

}  // namespace

std::optional<int> parse_command_line(int argc, const char* const* argv, Options& options) {
  CLI::App app(description, "hrt-reach");
  app.footer(exit_codes);
  options.plugin = default_plugin();
  Words words;
  add_reaches(app, options, words);
  add_controller(app, options, words);
  add_place(app, options);
  add_files(app, options);
  add_person(app, options, words);
  try {
    app.parse(argc, argv);
    take(words, options);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hrt-reach: " << error.what() << " (--help lists the options)\n";
    return static_cast<int>(ExitCode::usage);
  }
  return std::nullopt;
}

}  // namespace hrt::reach
