// The servos that can turn a plate, and what of their control tables the plate needs (ROBOTIS e-manuals of
// XL330-M077 and XL330-M288).
#pragma once

#include <array>
#include <cstdint>

namespace hrt::plate::dynamixel {

/// An entry of the control table. Those below 64 keep their value without power, and may be written only
/// while torque is off.
struct Entry {
  int address;
  int size;
};
inline constexpr Entry operating_mode{11, 1}, homing_offset{20, 4}, current_limit{38, 2}, velocity_limit{44, 4},
    torque_enable{64, 1}, hardware_error{70, 1}, bus_watchdog{98, 1}, goal_current{102, 2}, profile_velocity{112, 4},
    goal_position{116, 4}, present_position{132, 4}, present_voltage{144, 2}, present_temperature{146, 1};

struct Model {
  int number;
  const char* name;
  double stall_nm;  ///< torque at its limit of current
};
inline constexpr std::array models = {Model{1190, "XL330-M077", 0.215}, Model{1200, "XL330-M288", 0.52}};
inline constexpr double max_torque_nm = 5.0 * 0.075;  ///< 5 N at the rim of a plate of 150 mm

inline constexpr int current_based_position_mode = 5;
inline constexpr int middle_step = 2048;
inline constexpr int max_homing_steps = 1024;  ///< to either side; some modes ignore more
inline constexpr double deg_per_step = 360.0 / 4096.0;
inline constexpr double deg_s_per_unit = 0.229 * 6.0;  ///< of velocity: 0.229 revolutions a minute
inline constexpr int watchdog_ticks = 15;              ///< of 20 ms
inline constexpr int watchdog_expired = -1;

}  // namespace hrt::plate::dynamixel
