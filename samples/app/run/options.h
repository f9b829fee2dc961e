// What the command lines of hrt-reach and hrt-experiment choose.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "samples/app/xr/session.h"

namespace hrt::app {

/// Which plate turns.
struct PlateChoice {
  enum class Kind { runtime, servo, device } kind = Kind::runtime;
  double servo_speed_deg_per_s = 400.0;
  std::string name = "runtime";  ///< of a device as in hrt_plate_open()
};

/// "runtime", "servo", "servo:SPEED", or a device, whose name hrt_plate_open() checks; nothing if it is none
/// of them.
std::optional<PlateChoice> parse_plate(const std::string& text);

/// The plugin beside the program, as in the build, or where the system keeps its libraries.
std::filesystem::path default_plugin();

struct Options {
  std::filesystem::path scene;
  std::filesystem::path plugin;
  std::vector<std::string> targets;  ///< virtual ones, in this order; empty: all, in the scene's order
  int repeat = 1;
  std::uint64_t seed = 1;  ///< of a simulated user and of the noise
  std::vector<Hand> hands;
  PlateChoice plate;
  std::string finger;  ///< a touch frame, as TouchFrame takes it; empty: hand tracking
  double time_limit_s = 30.0;
  std::chrono::milliseconds runtime_limit{10'000};  ///< for every wait for the runtime
  bool for_people = true;                           ///< else the paper's controller
  std::optional<double> tactile_weight;             ///< none: the plugin's default, or the paper's 0.15
  double motor_variance_deg2 = 0.5;
  std::filesystem::path register_to;   ///< registers the plate and keeps it here; empty: does not
  std::filesystem::path registered;    ///< takes the plate from here; empty: from the scene
  bool fingertip = false;              ///< registering finds where the hand's skin is, from its joint
  bool measure_tracker = false;        ///< by touches of two dimples, in place of reaches
  bool check_each = false;             ///< a touch checks the plate before every reach
  std::filesystem::path marks;         ///< that registering asks for; empty: the scene's start and rim
  std::filesystem::path record;        ///< empty: none
  std::filesystem::path profile;       ///< of the user; empty: an unknown user
  std::filesystem::path calibrate;     ///< into this profile, in place of reaches; empty: reaches
  std::uint32_t max_slides = 40;       ///< of a calibration
  std::optional<double> eye_height_m;  ///< above the floor, where the runtime knows of none
  std::string speak_with;              ///< program and arguments; empty: nobody speaks
  bool person = false;
  bool verbose = false;
};

}  // namespace hrt::app
