#include "samples/plate/tool/commands.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "plugin/src/plate/device.h"
#include "plugin/src/plate/plate_failure.h"
#include "samples/plate/tool/measure.h"
#include "samples/plate/tool/report.h"

namespace hrt::plate {
namespace {

enum Code : int { success = 0, not_done = 1, usage = 2, plate_failed = 9, output_failed = 10 };

constexpr const char* exit_codes = R"(Exit codes:
  0  done
  1  no plate was found, or the trim was not saved
  2  the command line is wrong
  9  the plate failed, or is none
 10  a file cannot be written
)";

struct Options {
  std::string device;
  std::vector<std::string> devices;
  std::string out;
  std::string plot;
  bool save = false;
};

// Opens what a command names: a device's name, or the path of a plate's serial line.
std::unique_ptr<Device> open(const std::string& name, const Surroundings& around, Start start) {
  return device_named(name.find(':') == std::string::npos ? "serial:" + name : name)(around.open, start);
}

// The first kind of device that answers at a line; nothing if none does.
std::optional<std::string> find_at(const std::string& place, const Surroundings& around) {
  std::vector<std::string> names;
  if (place.find(':') != std::string::npos) {
    names = {place};
  } else {
    for (const std::string& kind : device_kinds()) names.push_back(kind + ":" + place);
  }
  for (const std::string& name : names) {
    try {
      return name + ": " + open(name, around, Start::quiet)->description();
    } catch (const PlateFailure& failure) {
      around.out << place << " " << failure.what() << "\n";
      if (failure.fault() == Fault::line) break;
    }
  }
  return std::nullopt;
}

// Nothing moves, but boards start anew when their line is opened.
int find(const Options& options, const Surroundings& around) {
  bool found = false;
  for (const std::string& place : options.devices.empty() ? around.devices() : options.devices) {
    const std::optional<std::string> device = find_at(place, around);
    if (!device) continue;
    around.out << *device << "\n";
    found = true;
  }
  if (!found) around.err << "hrt-plate: no plate was found\n";
  return found ? success : not_done;
}

int show(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::quiet);
  const DeviceLimits limits = device->limits();
  around.out << device->description() << "\nrange " << limits.min_deg << " to " << limits.max_deg << " deg, "
             << limits.speed_deg_s << " deg/s, latency "
             << std::chrono::duration_cast<std::chrono::milliseconds>(limits.latency).count()
             << " ms with half of the line, orientation " << (device->is_measured() ? "measured" : "assumed")
             << "\n";
  for (const std::string& line : device->details()) around.out << line << "\n";
  return success;
}

int run_trim(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::hold);
  const bool saved =
      trim(*device, around.read, [&](const std::string& text) { around.out << text << std::endl; });
  around.out << (saved ? "saved\n" : "not saved: the old trim holds\n");
  return saved ? success : not_done;
}

// What a plate can keep of a measurement is known before it moves.
void check_that_it_keeps_a_plan(const Device& device) {
  if (!device.keeps_plan())
    throw PlateFailure(Fault::protocol,
                       "keeps neither latency nor speed: measure without --save, and give the numbers of "
                       "--out to the session");
  if (!device.is_measured())
    throw PlateFailure(Fault::protocol, "has no sensor: there is no measured latency to save");
}

int run_measure(const Options& options, const Surroundings& around) {
  const auto device = open(options.device, around, Start::hold);
  if (options.save) check_that_it_keeps_a_plan(*device);
  const Measurements found = measure(*device, [&](const std::string& text) { around.err << text << "\n"; });
  around.out << text_of(found);
  if (!options.out.empty()) write_file(options.out, json_of(found));
  if (!options.plot.empty()) write_file(options.plot, svg_of(found));
  if (options.save && found.latency_ms) {
    const bool is_slower = found.speed_deg_s && *found.speed_deg_s < found.limits.speed_deg_s;
    device->keep_plan(*found.latency_ms, is_slower ? found.speed_deg_s : std::nullopt);
    around.out << "saved in the plate\n";
  }
  return success;
}

}  // namespace

int run_tool(int argc, const char* const* argv, const Surroundings& around) {
  Options options;
  CLI::App app("Puts a plate into operation (samples/plate/README.md).", "hrt-plate");
  app.footer(exit_codes);
  app.require_subcommand(1);
  const auto command = [&](const char* name, const char* text) {
    CLI::App* added = app.add_subcommand(name, text);
    added
        ->add_option("device", options.device, "Serial device of the plate, or a name as of hrt_plate_open()")
        ->required();
    return added;
  };
  CLI::App* finder = app.add_subcommand("find", "Find plates; moves nothing, but boards restart");
  finder->add_option("device", options.devices, "Devices or names to try [/dev/ttyACM*, /dev/ttyUSB*]");
  CLI::App* shower = command("show", "Show settings and self-test; moves nothing");
  CLI::App* trimmer = command("trim", "Trim 0 against the base's mark, and save it in the plate");
  CLI::App* measurer =
      command("measure", "Home, sweep, time steps: takes half a minute. Keep hands off the plate");
  measurer->add_option("--out", options.out, "Write the numbers into this JSON file");
  measurer->add_option("--plot", options.plot, "Draw the sweep into this SVG file");
  measurer->add_flag("--save", options.save, "Save the measured latency, and a lower speed, in the plate");
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
    if (*measurer) return run_measure(options, around);
  } catch (const PlateFailure& failure) {
    around.err << "hrt-plate: the plate at " << options.device << " " << failure.what() << "\n";
    return plate_failed;
  } catch (const std::invalid_argument& wrong) {
    around.err << "hrt-plate: " << wrong.what() << "\n";
    return usage;
  }
  return usage;
}

}  // namespace hrt::plate
