// The class HapticRetargeting without the engine's interface, which is in extension.cpp. Each node owns a session.
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fields.h"

namespace hrt_godot {

inline constexpr const char* kClassName = "HapticRetargeting";

struct Argument {
  const char* name;
  Type type;
};

struct Signal {
  const char* name;
  Argument argument;
};
inline constexpr Signal kPlateCommanded{"plate_commanded", {"orientation_deg", Type::kReal}};
inline constexpr Signal kFlagsChanged{"flags_changed", {"flags", Type::kInt}};
inline constexpr Signal kArrived{"arrived", {"flags", Type::kInt}};
inline constexpr Signal kReachEnded{"reach_ended", {"miss_deg", Type::kReal}};
inline constexpr Signal kSetupStep{"setup_step", {"step", Type::kRecord}};
inline constexpr Signal kSetupFinished{"setup_finished", {"result", Type::kRecord}};
inline constexpr Signal kSignals[] = {kPlateCommanded, kFlagsChanged, kArrived,
                                      kReachEnded,     kSetupStep,    kSetupFinished};

/** The part of the engine that the node uses. */
class Engine {
 public:
  virtual ~Engine() = default;
  /** Returns the pose in the world, in metres; outside the scene tree, the pose relative to the parent. */
  virtual Pose node_pose() = 0;
  virtual void move_node(const Pose& pose) = 0;
  virtual void emit(const Signal& signal, const Value& argument) = 0;
  virtual void push_error(const char* text) = 0;
  /** May be called on any thread. */
  virtual void push_warning(const char* text) = 0;
  /** Converts a path that may begin with res:// or user:// to a path of the operating system. */
  virtual std::string system_path(std::string path) = 0;
  /** Called when properties, and thus the warnings, may have changed. */
  virtual void update_warnings() = 0;
};

class PlateNode;

struct Method {
  const char* name;
  Type returns;
  Value failure;  ///< result if the arguments do not fit or the function throws
  std::vector<Argument> arguments;
  Value (*function)(PlateNode& node, const Value* arguments);
};
/** Methods of PlateNode for scripts. The table is generated from the declarations below. */
extern const std::span<const Method> methods;
/** Maximum number of arguments that are read: one more than any method has, to detect too many. */
inline constexpr size_t kArgumentsMax = 8;

/** Bits of refused_: bits 1 to 99 are negated errors of the plugin; this bit is an error of the node's pose. */
inline constexpr size_t kPoseReason = 127;
inline constexpr const char* kNotRigid =
    "the node is scaled, sheared or mirrored in the world; set its scale, and that of its parents, to 1";

class PlateNode {
 public:
  explicit PlateNode(Engine& engine) : engine_(engine) {}
  ~PlateNode();
  PlateNode(const PlateNode&) = delete;
  PlateNode& operator=(const PlateNode&) = delete;

  /** Calls the method. If the arguments do not fit or the method throws, shows an error and returns method.failure. */
  Value call(const Method& method, std::span<const Value> arguments) noexcept;
  Value get(const Property& property) { return property.get(properties_); }
  void set(const Property& property, const Value& value) noexcept;
  /** Returns the error in the session's properties or the node's pose, for the editor; empty without one. */
  std::string warning();

  // Methods for scripts, with the names of their arguments. generator/godot.py reads this list.
  hrt_target add_real_target(std::string name, double direction_deg, double distance_m);
  hrt_target add_virtual_target(std::string name, double direction_deg, double distance_m);
  hrt_target add_real_target_at(std::string name, Vector3 world_position);
  hrt_target add_virtual_target_at(std::string name, Vector3 world_position);
  Error move_target_to(hrt_target target, Vector3 world_position);
  Error remove_target(hrt_target target);
  Error begin(hrt_target real_target, hrt_target virtual_target);
  Error begin_with_plate_at(hrt_target real_target, hrt_target virtual_target, double plate_orientation_deg);
  Error begin_for(hrt_target real_target, hrt_target virtual_target, double duration_s);
  Error update(Vector3 world_position, Time time_ns);
  Error update_joint(Pose joint, Time time_ns);
  Error update_lost(Time time_ns);
  Error update_sample(int64_t flags, Time time_ns, double finger_direction_deg, double finger_x_m, double finger_y_m,
                      double finger_z_m, double plate_orientation_deg);
  Error retarget(hrt_target real_target, hrt_target virtual_target);
  Error touched(Vector3 world_position, double sd_m);
  Error touched_real_target();
  Error cancel();
  Error end();
  bool is_reaching() { return reaching_; }
  Record get_command() { return to_record(command_); }
  int64_t get_command_flags() { return command_.flags; }
  double get_command_orientation_deg() { return command_.plate_orientation_deg; }
  double get_command_distance_to_go_m() { return command_.distance_to_go_m; }
  Record get_summary() { return to_record(summary_); }
  Record get_gap(hrt_target real_target, hrt_target virtual_target);
  Error assign_targets(bool exclusive);
  Record get_assigned(hrt_target virtual_target);
  Error load_scene(std::string path);
  hrt_target find_target(std::string name);
  hrt_target get_served_by(hrt_target virtual_target);
  Error begin_setup(int64_t what);
  Error cancel_setup();
  bool is_setting_up() { return setting_up_; }
  Error new_person();
  Error begin_simulated_finger(hrt_target virtual_target, int64_t seed);
  Vector3 move_simulated_finger(Time time_ns);
  Vector3 update_simulated_finger(Time time_ns);
  Error load_profile(std::string json);
  std::string save_profile();
  Error set_conditions(std::string plate, std::string tracker, int64_t time_s);
  Record get_conditions();
  Error start_recording(std::string path);
  Record get_recording_status();
  Error stop_recording();
  Error open_device(std::string device);
  Error turn_device(double orientation_deg) { return after_device(hrt_plate_set(device_, orientation_deg)); }
  Error stop_device() { return after_device(hrt_plate_stop(device_)); }
  Record get_device_report() { return to_record(read_device()); }
  Error close_device();
  Error take_device();
  std::string get_version();

 private:
  bool ok(hrt_result result);
  Error error() const;
  Error report(hrt_result result);
  bool configure();
  bool read_pose(double (&position_m)[3], double (&rotation)[4]);
  void take_changes();
  bool take_log();
  void report_sample(size_t reason, const char* text);
  bool taken(hrt_result result);

  bool list_targets(uint32_t role, std::vector<hrt_target>& out_targets);
  hrt_target add_target(uint32_t role, const std::string& name, hrt_target_config config);
  Error begin_reach(hrt_target real_target, hrt_target virtual_target, std::optional<double> plate_orientation_deg,
                    double duration_s);
  Error take_contact(const hrt_contact* contact);
  Error send_finger(const Pose& finger, uint32_t flags, Time time_ns);
  Error send(const hrt_sample& sample);
  Error guide(const hrt_sample& sample);
  Error continue_fit();
  Vector3 move_person(Time time_ns, hrt_sample& out_sample);
  hrt_plate_report read_device() const;
  Error after_device(hrt_result result);

  void push_last_error() { engine_.push_error(script_names(hrt_last_error()).c_str()); }

  Engine& engine_;
  hrt_session session_{};
  hrt_person person_{};
  int64_t person_seed_ = 0;
  hrt_plate device_{};
  bool device_failure_is_shown_ = false;
  std::vector<hrt_gap> assigned_;
  Properties properties_;            ///< values of the properties, and the node's pose
  hrt_session_config configured_{};  ///< the configuration that the session has
  std::optional<Pose> plate_pose_;   ///< pose to which the plugin has moved the node, in floats
  hrt_command command_{};            ///< last command; struct_size 0: no command yet in this reach
  hrt_reach_summary summary_{};      ///< last summary; struct_size 0: no reach has ended
  hrt_setup_step step_{};            ///< last step; struct_size 0: no step yet in this set-up
  hrt_setup_result found_{};         ///< results of this set-up so far
  hrt_result result_ = HRT_OK;       ///< result of the last operation, for error()
  bool reaching_ = false;
  bool setting_up_ = false;
  std::bitset<128> refused_;  ///< reasons for which samples of this reach or set-up were refused
};

/** Returns a row of `methods`, with the types of the function. */
template <auto function, typename Result, typename... Arguments>
Method bind(const char* name, std::array<const char*, sizeof...(Arguments)> names,
            Result (PlateNode::*)(Arguments...)) {
  static_assert(sizeof...(Arguments) < kArgumentsMax);
  return [&]<size_t... i>(std::index_sequence<i...>) {
    return Method{name,
                  type_of(to_value(failure<Result>())),
                  to_value(failure<Result>()),
                  {Argument{names[i], argument_type<Arguments>()}...},
                  [](PlateNode& node, [[maybe_unused]] const Value* values) {
                    return to_value((node.*function)(from_value<Arguments>(values[i])...));
                  }};
  }(std::index_sequence_for<Arguments...>{});
}

}  // namespace hrt_godot
