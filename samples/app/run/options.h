// Options of hrt-reach, some of which hrt-experiment has, too.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "samples/app/xr/session.h"

namespace hrt::app {

struct PlateChoice {
  enum class Kind { runtime, servo, device } kind = Kind::runtime;
  double servo_speed_deg_per_s = 400.0;
  std::string name = "runtime";  ///< text of the option; for a device, the name that hrt_plate_open() takes
};

/// Parses "runtime", "servo", "servo:SPEED" or the name of a device, which hrt_plate_open() checks later. Returns
/// nullopt for any other text.
std::optional<PlateChoice> parse_plate(const std::string& text);

/// Returns ../lib/libhaptic_retargeting.so, relative to the program's folder, if it exists, else the name of the
/// installed library.
std::filesystem::path default_plugin();

struct Options {
  std::filesystem::path scene;
  std::filesystem::path plugin;
  std::vector<std::string> targets;  ///< virtual targets, in this order; empty: all, in the scene's order
  int repeat = 1;
  std::uint64_t seed = 1;  ///< seed of a simulated user and of the noise
  std::vector<Hand> hands;
  PlateChoice plate;
  std::string finger;  ///< device of a touch frame (see TouchFrame); empty: hand tracking
  double time_limit_s = 30.0;
  std::chrono::milliseconds runtime_limit{10'000};  ///< limit of each call into the runtime and wait for it
  bool for_people = true;                           ///< true: the default controller; false: the paper's
  std::optional<double> tactile_weight;             ///< unset: 0.15 if !for_people, else the plugin's default
  double motor_variance_deg2 = 0.5;
  std::filesystem::path register_to;   ///< file that a registration writes; empty: no registration
  std::filesystem::path registered;    ///< file with the plate's pose; empty: the scene has the pose
  bool fingertip = false;              ///< the registration also measures the offset from joint to skin
  bool measure_tracker = false;        ///< measure the tracker by touches of two dimples, instead of reaches
  bool check_each = false;             ///< check the plate's pose by a touch before every reach
  std::filesystem::path marks;         ///< marks of the registration; empty: the scene's start and rim
  std::filesystem::path record;        ///< file of the recording; empty: no recording
  std::filesystem::path profile;       ///< profile of the user; empty: an unknown user
  std::filesystem::path calibrate;     ///< profile that a calibration writes; empty: reaches, no calibration
  std::uint32_t max_slides = 40;       ///< largest number of slides of a calibration
  std::optional<double> eye_height_m;  ///< height of the eyes above the floor, for a runtime without a floor space
  std::string speak_with;              ///< speech program and its arguments; empty: no speech
  bool person = false;                 ///< the user is a person, even if the runtime simulates one
  bool verbose = false;
};

}  // namespace hrt::app
