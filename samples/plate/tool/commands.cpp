#include "samples/plate/tool/commands.h"

#include <CLI/CLI.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "samples/plate/driver/plate_failure.h"
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

// Nothing moves, but boards start anew when their line is opened.
int find(const Options& options, const Surroundings& around) {
  bool found = false;
  for (const std::string& device : options.devices.empty() ? around.devices() : options.devices) {
    try {
      const PlateLink link(around.open(device), PlateLink::Start::quiet);
      const PlateInfo info = link.info().value_or(PlateInfo{"unknown (protocol 1)", "unknown"});
      around.out << device << ": plate, firmware " << info.firmware << ", serial number " << info.serial
                 << "\n";
      found = true;
    } catch (const PlateFailure& failure) {
      around.out << device << " " << failure.what() << "\n";
    }
  }
  if (!found) around.err << "hrt-plate: no plate was found\n";
  return found ? success : not_done;
}

int show(const Options& options, const Surroundings& around) {
  PlateLink link(around.open(options.device), PlateLink::Start::quiet);
  const PlateGreeting& greeting = link.greeting();
  around.out << "range " << greeting.least_deg << " to " << greeting.most_deg << " deg, "
             << greeting.speed_deg_s << " deg/s, latency " << greeting.latency_ms << " ms, orientation "
             << (greeting.is_measured ? "measured" : "assumed") << "\n";
  if (!link.info()) {
    around.out << "protocol 1: no settings, no self-test\n";
    return success;
  }
  around.out << "firmware " << link.info()->firmware << ", serial number " << link.info()->serial << "\n";
  link.ask("CONF", [&](const PlateMessage& message) {
    const auto* setting = std::get_if<PlateSetting>(&message);
    if (setting != nullptr) around.out << "setting " << setting->name << " " << setting->value << "\n";
    return setting != nullptr && setting->name == "serial";
  });
  link.ask("TEST", [&](const PlateMessage& message) {
    const auto* test = std::get_if<PlateTest>(&message);
    if (test != nullptr && test->what != "end")
      around.out << "test " << test->what << " " << test->result << "\n";
    return test != nullptr && test->what == "end";
  });
  return success;
}

int run_trim(const Options& options, const Surroundings& around) {
  PlateLink link(around.open(options.device));
  const bool saved =
      trim(link, around.read, [&](const std::string& text) { around.out << text << std::endl; });
  around.out << (saved ? "saved\n" : "not saved: the old trim holds\n");
  return saved ? success : not_done;
}

int run_measure(const Options& options, const Surroundings& around) {
  PlateLink link(around.open(options.device));
  const Measurements found = measure(link, [&](const std::string& text) { around.err << text << "\n"; });
  around.out << text_of(found);
  if (!options.out.empty()) write_file(options.out, json_of(found));
  if (!options.plot.empty()) write_file(options.plot, svg_of(found));
  if (options.save) {
    if (!found.latency_ms)
      throw PlateFailure(Fault::protocol, "has no sensor: there is no measured latency to save");
    change_setting(link, "latency", std::min(200.0, *found.latency_ms));
    if (found.speed_deg_s && *found.speed_deg_s < found.greeting.speed_deg_s)
      change_setting(link, "speed", std::max(1.0, *found.speed_deg_s));
    save_settings(link);
    around.out << "saved in the plate\n";
  }
  return success;
}

}  // namespace

int run_tool(int argc, const char* const* argv, const Surroundings& around) {
  Options options;
  CLI::App app("Puts a plate on a serial line into operation (samples/plate/README.md).", "hrt-plate");
  app.footer(exit_codes);
  app.require_subcommand(1);
  const auto command = [&](const char* name, const char* text) {
    CLI::App* added = app.add_subcommand(name, text);
    added->add_option("device", options.device, "Serial device of the plate")->required();
    return added;
  };
  CLI::App* finder = app.add_subcommand("find", "Find plates; moves nothing, but boards restart");
  finder->add_option("device", options.devices, "Devices to try [/dev/ttyACM*, /dev/ttyUSB*]");
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
  }
  return usage;
}

}  // namespace hrt::plate
