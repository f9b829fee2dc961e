// The class HapticRetargeting as scripts see it, without the engine's interface: extension.cpp hands calls in
// and signals out. One node is one session.
#pragma once

#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/setup.h>
#include <haptic_retargeting/study.h>

#include <bitset>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields.h"
#include "plate_device.h"
#include "value.h"

namespace hrt_godot {

inline constexpr const char* kClassName = "HapticRetargeting";

/** The value of Godot's enumeration Error for a result. */
int64_t to_godot_error(hrt_result result);
inline constexpr int64_t kErrInvalidParameter = 31;

inline hrt_target to_target(const Value& value) {
  return {static_cast<uint64_t>(to_int(value))};
}

/** What methods return that fail: no target; a place that update() refuses. */
inline constexpr int64_t kNoTarget = 0;
inline constexpr Vector3 kNowhere{std::numeric_limits<double>::quiet_NaN(), 0, 0};

/** Why samples are refused: the plugin's errors, up to 99, then the node's own. */
inline constexpr size_t kFlagsReason = 126, kPoseReason = 127;
constexpr size_t reason_of(hrt_result error) {
  return static_cast<size_t>(-error) % kFlagsReason;
}
inline constexpr const char* kNotRigid =
    "the node is scaled, sheared or mirrored in the world; allowed: moved and turned, as a plate";

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
inline constexpr Signal kReachEnded{"reach_ended", {"miss_deg", Type::kReal}};
inline constexpr Signal kSetupStep{"setup_step", {"step", Type::kRecord}};
inline constexpr Signal kSetupFinished{"setup_finished", {"result", Type::kRecord}};
std::span<const Signal> signals();

/** The engine, as the node needs it. */
class Engine {
 public:
  virtual ~Engine() = default;
  virtual Pose node_pose() = 0;
  virtual void move_node(const Pose& pose) = 0;
  virtual void emit(const Signal& signal, const Value& argument) = 0;
  virtual void push_error(const char* text) = 0;
};

class PlateNode;

struct Method {
  const char* name;
  Type returns;
  Value failure;  ///< what a call returns that cannot be made
  std::span<const Argument> arguments;
  Value (PlateNode::*function)(const Value* arguments);
};
std::span<const Method> methods();
/** Arguments that a call is looked at for; one more than any method has, so that too many are noticed. */
inline constexpr size_t kArgumentsMax = 8;

class PlateNode {
 public:
  explicit PlateNode(Engine& engine);
  ~PlateNode();
  PlateNode(const PlateNode&) = delete;
  PlateNode& operator=(const PlateNode&) = delete;

  /** Checks number and types of the arguments, then calls. Throws nothing. */
  Value call(const Method& method, std::span<const Value> arguments) noexcept;
  Value get(const Field& property) const { return get_field(of(property), property); }
  void set(const Field& property, const Value& value) noexcept;

  Value add_real_target(const Value* arguments);
  Value add_virtual_target(const Value* arguments);
  Value add_real_target_at(const Value* arguments);
  Value add_virtual_target_at(const Value* arguments);
  Value move_target_to(const Value* arguments);
  Value remove_target(const Value* arguments);
  Value begin(const Value* arguments);
  Value begin_with_plate_at(const Value* arguments);
  Value begin_for(const Value* arguments);
  Value update(const Value* arguments);
  Value update_joint(const Value* arguments);
  Value update_lost(const Value* arguments);
  Value update_sample(const Value* arguments);
  Value retarget(const Value* arguments);
  Value cancel(const Value* arguments);
  Value end(const Value* arguments);
  Value is_reaching(const Value* arguments);
  Value get_command(const Value* arguments);
  Value get_summary(const Value* arguments);
  Value get_gap(const Value* arguments);
  Value assign_targets(const Value* arguments);
  Value get_assigned(const Value* arguments);
  Value load_scene(const Value* arguments);
  Value find_target(const Value* arguments);
  Value begin_setup(const Value* arguments);
  Value finish_setup(const Value* arguments);
  Value cancel_setup(const Value* arguments);
  Value is_setting_up(const Value* arguments);
  Value begin_simulated_finger(const Value* arguments);
  Value update_simulated_finger(const Value* arguments);
  Value load_profile(const Value* arguments);
  Value save_profile(const Value* arguments);
  Value set_conditions(const Value* arguments);
  Value get_conditions(const Value* arguments);
  Value start_recording(const Value* arguments);
  Value get_recording_status(const Value* arguments);
  Value stop_recording(const Value* arguments);
  Value open_device(const Value* arguments);
  Value turn_device(const Value* arguments);
  Value stop_device(const Value* arguments);
  Value get_device_report(const Value* arguments);
  Value close_device(const Value* arguments);
  Value get_version(const Value* arguments);

 private:
  const void* of(const Field& property) const;
  bool ok(hrt_result result);
  Value after_device(hrt_result result);
  bool configure();
  bool read_pose(double (&position_m)[3], double (&rotation)[4]);
  bool list_targets(uint32_t role, std::vector<hrt_target>& out_targets);
  Value add_target(const hrt_target_config& config);
  Value begin_reach(const hrt_reach_config& config);
  bool finger_sample(const Vector3& place, int64_t time_ns, hrt_sample& out_sample);
  Value send(const hrt_sample& sample);
  Value guide(const hrt_sample& sample);
  void report_sample(size_t reason, const char* text);
  void take_changes();

  Engine& engine_;
  hrt_session session_{};
  hrt_person person_{};
  int64_t seed_ = 0;  ///< of the person
  std::vector<hrt_gap> assigned_;
  hrt_setup_config setup_config_;    ///< the properties of set-ups
  hrt_session_config config_;        ///< the other properties and the node's pose
  hrt_session_config configured_{};  ///< what the session has of them
  std::optional<Pose> plate_pose_;   ///< the node's, where the library has placed it: doubles in floats
  hrt_command command_{};            ///< struct_size 0: none yet in this reach
  hrt_reach_summary summary_{};      ///< struct_size 0: no reach has ended
  hrt_setup_step step_{};            ///< struct_size 0: none yet in this set-up
  hrt_result result_ = HRT_OK;       ///< of the last call of the plugin
  bool reaching_ = false;
  bool setting_up_ = false;
  PlateDevice device_;
  std::bitset<128> refused_;  ///< samples of this reach or set-up, by the reason
};

}  // namespace hrt_godot
