// The table of the class: what scripts call, with what. Types are those of the functions.
#include <array>
#include <utility>

#include "plate_node.h"

namespace hrt_godot {
namespace {

template <typename T>
Type type() {
  return type_of(to_value(T{}));
}

template <auto function, typename Result, typename... Arguments>
Method bind(const char* name, std::array<const char*, sizeof...(Arguments)> names,
            Result (PlateNode::*)(Arguments...)) {
  static_assert(sizeof...(Arguments) < kArgumentsMax);
  return [&]<size_t... i>(std::index_sequence<i...>) {
    return Method{name,
                  type<Result>(),
                  to_value(failure<Result>()),
                  {Argument{names[i], type<Arguments>()}...},
                  [](PlateNode& node, [[maybe_unused]] const Value* values) {
                    return to_value((node.*function)(from_value<Arguments>(values[i])...));
                  }};
  }(std::index_sequence_for<Arguments...>{});
}

#define METHOD(name, ...) bind<&PlateNode::name>(#name, {__VA_ARGS__}, &PlateNode::name)

const Method kMethods[] = {
    METHOD(add_real_target, "name", "direction_deg", "distance_m"),
    METHOD(add_virtual_target, "name", "direction_deg", "distance_m"),
    METHOD(add_real_target_at, "name", "world_position"),
    METHOD(add_virtual_target_at, "name", "world_position"),
    METHOD(move_target_to, "target", "world_position"),
    METHOD(remove_target, "target"),
    METHOD(begin, "real_target", "virtual_target"),
    METHOD(begin_with_plate_at, "real_target", "virtual_target", "plate_orientation_deg"),
    METHOD(begin_for, "real_target", "virtual_target", "duration_s"),
    METHOD(update, "world_position", "time_ns"),
    METHOD(update_joint, "joint", "time_ns"),
    METHOD(update_lost, "time_ns"),
    METHOD(update_sample, "flags", "time_ns", "finger_direction_deg", "finger_x_m", "finger_y_m", "finger_z_m",
           "plate_orientation_deg"),
    METHOD(retarget, "real_target", "virtual_target"),
    METHOD(touched, "world_position", "sd_m"),
    METHOD(touched_real_target),
    METHOD(cancel),
    METHOD(end),
    METHOD(is_reaching),
    METHOD(get_command),
    METHOD(get_summary),
    METHOD(get_gap, "real_target", "virtual_target"),
    METHOD(assign_targets, "exclusive"),
    METHOD(get_assigned, "virtual_target"),
    METHOD(load_scene, "path"),
    METHOD(find_target, "name"),
    METHOD(begin_setup, "what"),
    METHOD(finish_setup),
    METHOD(cancel_setup),
    METHOD(is_setting_up),
    METHOD(new_person),
    METHOD(begin_simulated_finger, "virtual_target", "seed"),
    METHOD(move_simulated_finger, "time_ns"),
    METHOD(update_simulated_finger, "time_ns"),
    METHOD(load_profile, "json"),
    METHOD(save_profile),
    METHOD(set_conditions, "plate", "tracker", "time_s"),
    METHOD(get_conditions),
    METHOD(start_recording, "path"),
    METHOD(get_recording_status),
    METHOD(stop_recording),
    METHOD(open_device, "device"),
    METHOD(turn_device, "orientation_deg"),
    METHOD(stop_device),
    METHOD(get_device_report),
    METHOD(close_device),
    METHOD(take_device),
    METHOD(get_version),
};

}  // namespace

std::span<const Method> methods() { return kMethods; }

}  // namespace hrt_godot
