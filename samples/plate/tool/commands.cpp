#include "samples/plate/tool/commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "plugin/include/plate_driver/plate_failure.h"
#include "samples/app/text/format.h"
#include "samples/app/text/whole_file.h"
#include "samples/plate/tool/measure.h"

namespace hrt::plate {
namespace {

enum Code : int { success = 0, not_done = 1, usage = 2, plate_failed = 9, output_failed = 10 };

constexpr const char* exit_codes = R"(Exit codes:
  0  done
  1  no plate or more than one was found, or the input ended before the last answer; nothing was saved
  2  the command line is wrong
  9  the plate failed, or the device is not a plate
 10  a file cannot be written
)";

struct Options {
  std::string device;
  std::vector<std::string> devices;
  std::vector<std::string> changes;
  double angle_deg = 0.0;
  std::string out = "plate.json";
  Emulation emulation;
};

// Returns the device name for an argument of the command line, which may lack the kind "serial:".
std::string full_name(const std::string& name) { return name.find(':') == std::string::npos ? "serial:" + name : name; }

std::unique_ptr<Device> open(const std::string& name, const Environment& env, Start start) {
  return device_named(full_name(name))(env.open, start);
}

struct Found {
  std::string name;
  std::string description;
};

// Returns the first device that answers at `path`. Tries all kinds of devices, unless `path` begins with a kind or
// cannot be opened.
std::optional<Found> find_at(const std::string& path, const Environment& env) {
  std::vector<std::string> names;
  if (path.find(':') != std::string::npos) {
    names = {path};
  } else {
    for (const std::string& kind : device_kinds()) names.push_back(kind + ":" + path);
  }
  for (const std::string& name : names) {
    try {
      return Found{name, open(name, env, Start::passive)->description()};
    } catch (const PlateFailure& failure) {
      env.out << path << " " << failure.what() << "\n";
      if (failure.fault() == Fault::line) break;
    }
  }
  return std::nullopt;
}

// Does not move the plates that it finds, but many boards restart when their line is opened.
std::vector<Found> find_all(const std::vector<std::string>& paths, const Environment& env) {
  std::vector<Found> found;
  std::string tried;
  for (const std::string& path : paths) {
    tried += (tried.empty() ? "; tried: " : ", ") + path;
    const std::optional<Found> device = find_at(path, env);
    if (!device) continue;
    env.out << device->name << ": " << device->description << std::endl;
    found.push_back(*device);
  }
  if (found.empty())
    env.err << "hrt-plate: no plate was found"
            << (tried.empty() ? "; no serial board or adapter is connected. Connect the plate"
                              : tried + ". Check the plate's cable and supply")
            << "\n";
  return found;
}

int find(const Options& options, const Environment& env) {
  const auto paths = options.devices.empty() ? env.devices() : options.devices;
  return find_all(paths, env).empty() ? not_done : success;
}

int show(const Options& options, const Environment& env) {
  const auto device = open(options.device, env, Start::passive);
  const DeviceLimits limits = device->limits();
  env.out << device->description() << "\nrange " << limits.min_deg << " to " << limits.max_deg << " deg, "
          << limits.speed_deg_s << " deg/s, latency "
          << std::chrono::duration_cast<std::chrono::milliseconds>(limits.latency).count()
          << " ms including half of the round trip, orientation " << (device->is_measured() ? "measured" : "assumed")
          << "\n";
  for (const std::string& line : device->details()) env.out << line << "\n";
  return success;
}

Dialogue dialogue_in(const Environment& env) {
  return {env.read, [&env](const std::string& text) { env.out << text << std::endl; }};
}

// Moves orientation 0 until notch and arrow agree. If the input ends early, restores the previous orientation 0.
int run_trim(const Options& options, const Environment& env) {
  const auto device = open(options.device, env, Start::hold);
  const double before_deg = device->zero_deg();
  ask(*device, dialogue_in(env), "Keep your hands off the plate: it turns to 0. Press Enter to start.");
  turn_and_wait(*device, 0.0);
  std::string question =
      "The plate is at 0. How many degrees is the notch from the arrow? Counter-clockwise is positive. Press Enter "
      "alone to keep this 0.";
  try {
    while (const auto offset_deg = ask_number(*device, dialogue_in(env), question, -30.0, 30.0)) {
      device->set_zero(device->zero_deg() - *offset_deg);
      question =
          format("Orientation 0 has moved by %+.2f deg. How many degrees remain? Press Enter alone to keep this 0.",
                 device->zero_deg() - before_deg);
    }
  } catch (const InputEnded&) {
    device->set_zero(before_deg);
    throw;
  }
  device->save_zero();
  env.out << "saved. Commission the plate again: an earlier plate file has the old orientation 0\n";
  return success;
}

int run_turn(const Options& options, const Environment& env) {
  const auto device = open(options.device, env, Start::hold);
  const DeviceLimits limits = device->limits();
  if (options.angle_deg < limits.min_deg || options.angle_deg > limits.max_deg)
    throw std::invalid_argument(
        format("angle is %g; allowed: %g to %g", options.angle_deg, limits.min_deg, limits.max_deg));
  ask(*device, dialogue_in(env), "Keep your hands off the plate. Press Enter to turn it.");
  turn_and_wait(*device, options.angle_deg);
  ask(*device, dialogue_in(env), "The plate holds its orientation. Press Enter to end.");
  return success;
}

// Changes settings, which are given as "zero=1505 speed=150", and saves all of them, or none if one is refused.
int run_set(const Options& options, const Environment& env) {
  const auto device = open(options.device, env, Start::passive);
  BoardSettings* board = device->board_settings();
  if (board == nullptr)
    throw PlateFailure(Fault::protocol, "has no settings to change; only a board with the plate's firmware has them");
  for (const std::string& change : options.changes) {
    const std::size_t equals = std::min(change.find('='), change.size() - 1);
    const auto value = number_in(std::string_view(change).substr(equals + 1), -1e6, 1e6);
    if (!value)
      throw std::invalid_argument("\"" + change +
                                  "\" must be name=number, as in zero=1505, with a number from -1000000 to 1000000");
    board->change_setting(change.substr(0, equals), *value);
  }
  board->save_settings();
  env.out << "saved\n";
  return success;
}

std::string today() {
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return format("%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()));
}

int run_commission(Options& options, const Environment& env) {
  if (options.device.empty()) {
    const std::vector<Found> found = find_all(env.devices(), env);
    if (found.size() > 1)
      env.err << "hrt-plate: more than one plate was found; name one of them: hrt-plate commission DEVICE\n";
    if (found.size() != 1) return not_done;
    options.device = found.front().name;
  }
  if (const std::string why = why_not_writable(options.out); !why.empty())
    throw std::runtime_error("cannot write " + options.out + ": " + why + ". Name another file with --out");
  const Measurements found = commission([&] { return open(options.device, env, Start::hold); }, dialogue_in(env));
  env.out << text_of(found);
  write_file(options.out, file_of(found, full_name(options.device), today()));
  env.out << "Written: " << options.out << "\n";
  return success;
}

}  // namespace

int run_tool(int argc, const char* const* argv, const Environment& env) {
  Options options;
  CLI::App app("Finds, sets up and measures a plate (samples/plate/README.md).", "hrt-plate");
  app.footer(exit_codes);
  app.require_subcommand(1);
  const auto command = [&](const char* name, const char* text, bool must_name = true) {
    CLI::App* added = app.add_subcommand(name, text);
    added
        ->add_option("device", options.device,
                     "Serial device of a board (/dev/ttyACM0), or name of a plate (dynamixel:/dev/ttyUSB0)")
        ->required(must_name);
    return added;
  };
  CLI::App* find_command = app.add_subcommand("find", "Find plates. Moves nothing, but boards restart");
  find_command->add_option("device", options.devices, "Serial devices or names to try [all that are connected]");
  CLI::App* show_command = command("show", "Show settings and self-test. Moves nothing");
  CLI::App* set_command =
      command("set", "Change settings of the firmware and save them, for example: zero=1505 speed=150");
  set_command->add_option("changes", options.changes, "NAME=NUMBER; samples/plate/firmware/README.md lists the names")
      ->required();
  CLI::App* turn_command = command("turn", "Turn to an orientation, and wait there until Enter is pressed");
  turn_command->add_option("angle", options.angle_deg, "Orientation in degrees, counter-clockwise positive")
      ->required();
  CLI::App* trim_command = command("trim", "Move orientation 0 until notch and arrow agree, and save it in the plate");
  CLI::App* commission_command = command(
      "commission", "Find, set up and measure the plate, and write the plate file for hrt-reach --plate", false);
  commission_command->add_option("--out", options.out, "Plate file to write")->capture_default_str();
  if (env.emulate) {
    CLI::App* emulate_command = app.add_subcommand(
        "emulate", "Simulate a plate behind a pseudo-terminal, for a rehearsal, until Ctrl-C is pressed");
    emulate_command->add_option("plate", options.emulation.plate, "Kind of plate; hobby-new is not commissioned")
        ->check(CLI::IsMember({"xl330", "hobby", "hobby-new"}))
        ->capture_default_str();
    emulate_command->add_option("--link", options.emulation.link,
                                "Path of a symbolic link to the pseudo-terminal, to be created [no link]");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help, env.out, env.err);
  } catch (const CLI::ParseError& error) {
    env.err << "hrt-plate: " << error.what() << " (--help lists the commands)\n";
    return usage;
  }
  try {
    if (*find_command) return find(options, env);
    if (*show_command) return show(options, env);
    if (*trim_command) return run_trim(options, env);
    if (*set_command) return run_set(options, env);
    if (*turn_command) return run_turn(options, env);
    if (*commission_command) return run_commission(options, env);
    env.emulate(options.emulation, env.read, env.out);
    return success;
  } catch (const PlateFailure& failure) {
    env.err << "hrt-plate: the plate at " << options.device << " " << failure.what() << "\n";
    return plate_failed;
  } catch (const InputEnded& ended) {
    env.err << "hrt-plate: " << ended.what() << "; nothing was saved\n";
    return not_done;
  } catch (const std::invalid_argument& wrong) {
    env.err << "hrt-plate: " << wrong.what() << "\n";
    return usage;
  }
}

}  // namespace hrt::plate
