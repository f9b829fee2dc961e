#include "samples/plate/tool/commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
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
  1  no plate was found, or the input ended before the last answer: nothing was written
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
  std::string plot;
  Emulation emulation;
};

// Returns the device name for the argument of a command, which may also be the path of a serial line.
std::string full_name(const std::string& name) { return name.find(':') == std::string::npos ? "serial:" + name : name; }

std::unique_ptr<Device> open(const std::string& name, const Surroundings& around, Start start) {
  return device_named(full_name(name))(around.open, start);
}

struct Found {
  std::string name;
  std::string description;
};

// Finds the first kind of device that answers at a line, within 8 s; nullopt if none answers.
std::optional<Found> find_at(const std::string& place, const Surroundings& around) {
  std::vector<std::string> names;
  if (place.find(':') != std::string::npos) {
    names = {place};
  } else {
    for (const std::string& kind : device_kinds()) names.push_back(kind + ":" + place);
  }
  for (const std::string& name : names) {
    try {
      return Found{name, open(name, around, Start::quiet)->description()};
    } catch (const PlateFailure& failure) {
      around.out << place << " " << failure.what() << "\n";
      if (failure.fault() == Fault::line) break;
    }
  }
  return std::nullopt;
}

// Finds all plates. Moves nothing, but boards restart when their line is opened.
std::vector<Found> find_all(const std::vector<std::string>& places, const Surroundings& around) {
  std::vector<Found> found;
  std::string tried;
  for (const std::string& place : places) {
    tried += (tried.empty() ? "; tried: " : ", ") + place;
    const std::optional<Found> device = find_at(place, around);
    if (!device) continue;
    around.out << device->name << ": " << device->description << std::endl;
    found.push_back(*device);
  }
  if (found.empty())
    around.err << "hrt-plate: no plate was found"
               << (tried.empty() ? "; this computer has no serial device" : tried + ". Check its cable and supply")
               << "\n";
  return found;
}

int find(const Options& options, const Surroundings& around) {
  const auto places = options.devices.empty() ? around.devices() : options.devices;
  return find_all(places, around).empty() ? not_done : success;
}

int show(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::quiet);
  const DeviceLimits limits = device->limits();
  around.out << device->description() << "\nrange " << limits.min_deg << " to " << limits.max_deg << " deg, "
             << limits.speed_deg_s << " deg/s, latency "
             << std::chrono::duration_cast<std::chrono::milliseconds>(limits.latency).count()
             << " ms with half of the line, orientation " << (device->is_measured() ? "measured" : "assumed") << "\n";
  for (const std::string& line : device->details()) around.out << line << "\n";
  return success;
}

Person person_at(const Surroundings& around) {
  return {around.read, [&around](const std::string& text) { around.out << text << std::endl; }};
}

// Moves 0 until its mark is right. If the input ends early, the old trim is restored.
int run_trim(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::hold);
  const double before_deg = device->zero_deg();
  ask(*device, person_at(around), "Hands off the plate: it turns to 0. Enter starts it.");
  turn_and_wait(*device, 0.0);
  std::string question =
      "The plate is at 0. By how many degrees is its mark off? Counter-clockwise is positive. An empty line keeps "
      "this 0.";
  try {
    while (const auto offset_deg = ask_number(*device, person_at(around), question, -30.0, 30.0)) {
      device->set_zero(device->zero_deg() - *offset_deg);
      question = format("0 has moved by %+.2f deg. How many degrees remain?", device->zero_deg() - before_deg);
    }
  } catch (const Abandoned&) {
    device->set_zero(before_deg);
    throw;
  }
  device->keep_zero();
  around.out << "saved. Commission the plate again: an earlier plate.json has the old 0\n";
  return success;
}

int run_turn(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::hold);
  const DeviceLimits limits = device->limits();
  if (options.angle_deg < limits.min_deg || options.angle_deg > limits.max_deg)
    throw std::invalid_argument(
        format("angle is %g; allowed: %g to %g", options.angle_deg, limits.min_deg, limits.max_deg));
  ask(*device, person_at(around), "Hands off the plate. Enter turns it.");
  turn_and_wait(*device, options.angle_deg);
  ask(*device, person_at(around), "The plate holds its orientation until Enter.");
  return success;
}

// Changes settings, given as "zero=1505 speed=150", and saves all of them or none.
int run_set(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::quiet);
  BoardSettings* board = device->board_settings();
  if (board == nullptr) throw PlateFailure(Fault::protocol, "has no settings to change; only a board has them");
  for (const std::string& change : options.changes) {
    const std::size_t equals = std::min(change.find('='), change.size() - 1);
    const auto value = number_in(std::string_view(change).substr(equals + 1), -1e6, 1e6);
    if (!value) throw std::invalid_argument("\"" + change + "\" must have the form name=number, as in zero=1505");
    board->change_setting(change.substr(0, equals), *value);
  }
  board->save_settings();
  around.out << "saved\n";
  return success;
}

std::string today() {
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return format("%04d-%02u-%02u", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                static_cast<unsigned>(date.day()));
}

int run_commission(Options& options, const Surroundings& around) {
  if (options.device.empty()) {
    const std::vector<Found> found = find_all(around.devices(), around);
    if (found.size() > 1) around.err << "hrt-plate: more than one plate was found; name one of them\n";
    if (found.size() != 1) return not_done;
    options.device = found.front().name;
  }
  if (const std::string why = why_not_writable(options.out); !why.empty())
    throw std::runtime_error("cannot write " + options.out + ": " + why);
  const Measurements found = commission([&] { return open(options.device, around, Start::hold); }, person_at(around));
  around.out << text_of(found);
  write_file(options.out, file_of(found, full_name(options.device), today()));
  std::filesystem::path plot = options.plot;
  if (plot.empty()) plot = std::filesystem::path(options.out).replace_extension(".svg");
  write_file(plot, svg_of(found));
  around.out << "Written: " << options.out << ", and its plot " << plot.string() << "\n";
  return success;
}

}  // namespace

int run_tool(int argc, const char* const* argv, const Surroundings& around) {
  Options options;
  CLI::App app("Puts a plate into operation (samples/plate/README.md).", "hrt-plate");
  app.footer(exit_codes);
  app.require_subcommand(1);
  const auto command = [&](const char* name, const char* text, bool must_name = true) {
    CLI::App* added = app.add_subcommand(name, text);
    added->add_option("device", options.device, "Serial device of the plate, or a device name of hrt_plate_open()")
        ->required(must_name);
    return added;
  };
  CLI::App* finder = app.add_subcommand("find", "Find plates; moves nothing, but boards restart");
  finder->add_option("device", options.devices, "Devices or names to try [/dev/ttyACM*, /dev/ttyUSB*]");
  CLI::App* shower = command("show", "Show settings and self-test; moves nothing");
  CLI::App* setter = command("set", "Change settings of the firmware, and save them: zero=1505 speed=150");
  setter->add_option("changes", options.changes, "name=number; firmware/README.md lists the names")->required();
  CLI::App* turner = command("turn", "Turn to an angle, and hold it until Enter");
  turner->add_option("angle", options.angle_deg, "Degrees, counter-clockwise positive")->required();
  CLI::App* trimmer = command("trim", "Move 0 until notch and arrow meet, and save it in the plate");
  CLI::App* commissioner =
      command("commission", "Find, set up and measure the plate, and write the file for hrt-reach --plate", false);
  commissioner->add_option("--out", options.out, "File to write")->capture_default_str();
  commissioner->add_option("--plot", options.plot, "Plot of the sweep [the file's name with .svg]");
  if (around.emulate) {
    CLI::App* emulator =
        app.add_subcommand("emulate", "Simulate a plate at a pseudo-terminal until Ctrl-C, for a rehearsal");
    emulator->add_option("plate", options.emulation.plate, "Kind of plate; hobby-new has not been commissioned yet")
        ->check(CLI::IsMember({"xl330", "hobby", "hobby-new"}))
        ->capture_default_str();
    emulator->add_option("--link", options.emulation.link, "Symbolic link to create to the pseudo-terminal");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help, around.out, around.err);
  } catch (const CLI::ParseError& error) {
    around.err << "hrt-plate: " << error.what() << " (--help lists the commands)\n";
    return usage;
  }
  try {
    if (*finder) return find(options, around);
    if (*shower) return show(options, around);
    if (*trimmer) return run_trim(options, around);
    if (*setter) return run_set(options, around);
    if (*turner) return run_turn(options, around);
    if (*commissioner) return run_commission(options, around);
    around.emulate(options.emulation, around.read, around.out);
    return success;
  } catch (const PlateFailure& failure) {
    around.err << "hrt-plate: the plate at " << options.device << " " << failure.what() << "\n";
    return plate_failed;
  } catch (const Abandoned& abandoned) {
    around.err << "hrt-plate: " << abandoned.what() << "; nothing was saved\n";
    return not_done;
  } catch (const std::invalid_argument& wrong) {
    around.err << "hrt-plate: " << wrong.what() << "\n";
    return usage;
  }
}

}  // namespace hrt::plate
