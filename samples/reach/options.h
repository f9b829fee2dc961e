// The command line of hrt-reach.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "samples/reach/xr/session.h"

namespace hrt::reach {

/// Which plate turns.
struct PlateChoice {
  enum class Kind { runtime, servo, serial } kind = Kind::runtime;
  double servo_speed_deg_per_s = 400.0;
  std::filesystem::path serial_device;
};

struct Options {
  std::filesystem::path scene;
  std::filesystem::path plugin;
  std::vector<std::string> targets;  ///< virtual ones, in this order; empty: all, in the scene's order
  int repeat = 1;
  std::uint64_t seed = 1;  ///< of a simulated user and of the noise
  std::vector<Hand> hands;
  PlateChoice plate;
  double time_limit_s = 30.0;
  std::chrono::milliseconds runtime_limit{10'000};  ///< for every wait for the runtime
  bool for_people = true;                           ///< else the paper's controller
  std::optional<double> tactile_weight;             ///< none: the plugin's default, or the paper's 0.15
  double motor_variance_deg2 = 0.5;
  std::filesystem::path record;  ///< empty: none
  std::filesystem::path plot;    ///< empty: none
  bool person = false;
  bool verbose = false;
};

/// Parses the command line. Returns the exit code if the program is to end at once: after --help, or with a
/// sentence on stderr about the mistake. `options` is then unspecified.
std::optional<int> parse_command_line(int argc, const char* const* argv, Options& options);

}  // namespace hrt::reach
