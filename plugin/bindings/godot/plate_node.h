// The class HapticRetargeting as scripts see it, without the engine's interface: extension.cpp hands calls in
// and signals out. One node is one session.
#pragma once

#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/plate.h>
#include <haptic_retargeting/setup.h>
#include <haptic_retargeting/study.h>

#include <bitset>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields.h"
#include "value.h"

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
inline constexpr Signal kReachEnded{"reach_ended", {"miss_deg", Type::kReal}};
inline constexpr Signal kSetupStep{"setup_step", {"step", Type::kRecord}};
inline constexpr Signal kSetupFinished{"setup_finished", {"result", Type::kRecord}};
inline constexpr Signal kSignals[] = {kPlateCommanded, kFlagsChanged, kReachEnded, kSetupStep, kSetupFinished};

/** The engine, as the node needs it. */
class Engine {
 public:
  virtual ~Engine() = default;
  virtual Pose node_pose() = 0;
  virtual void move_node(const Pose& pose) = 0;
  virtual void emit(const Signal& signal, const Value& argument) = 0;
  virtual void push_error(const char* text) = 0;
  /** Properties have changed, so there may be other warnings. */
  virtual void update_warnings() = 0;
};

class PlateNode;

struct Method {
  const char* name;
  Type returns;
  Value failure;  ///< what a call returns that cannot be made
  std::vector<Argument> arguments;
  Value (*function)(PlateNode& node, const Value* arguments);
};
std::span<const Method> methods();
/** Arguments that a call is looked at for; one more than any method has, so that too many are noticed. */
inline constexpr size_t kArgumentsMax = 8;

/** Why samples are refused: the plugin's errors, up to 99, then the node's own. */
inline constexpr size_t kFlagsReason = 126, kPoseReason = 127;
constexpr size_t reason_of(hrt_result error) { return static_cast<size_t>(-error) % kFlagsReason; }
inline constexpr const char* kNotRigid =
    "the node is scaled, sheared or mirrored in the world; allowed: moved and turned, as a plate";

inline hrt_target target_of(int64_t id) { return {static_cast<uint64_t>(id)}; }

class PlateNode {
 public:
  explicit PlateNode(Engine& engine);
  ~PlateNode();
  PlateNode(const PlateNode&) = delete;
  PlateNode& operator=(const PlateNode&) = delete;

  /** Checks number and types of the arguments, then calls. Throws nothing. */
  Value call(const Method& method, std::span<const Value> arguments) noexcept;
  Value get(const Field& property) const { return to_value(property.get(of(property))); }
  void set(const Field& property, const Value& value) noexcept;
  /** What is wrong with the properties or the node's place, for the editor; empty: nothing. */
  std::string warning();

  // What the methods of the same names in methods.cpp do; targets are ids.
  int64_t add_real_target(std::string name, double direction_deg, double distance_m);
  int64_t add_virtual_target(std::string name, double direction_deg, double distance_m);
  int64_t add_real_target_at(std::string name, Vector3 world_position);
  int64_t add_virtual_target_at(std::string name, Vector3 world_position);
  Error move_target_to(int64_t target, Vector3 world_position);
  Error remove_target(int64_t target);
  Record get_gap(int64_t real, int64_t felt);
  Error assign_targets(bool exclusive);
  Record get_assigned(int64_t felt);
  Error load_scene(std::string path);
  int64_t find_target(std::string name);

  Error begin(int64_t real, int64_t felt);
  Error begin_with_plate_at(int64_t real, int64_t felt, double plate_orientation_deg);
  Error begin_for(int64_t real, int64_t felt, double duration_s);
  Error update(Vector3 world_position, int64_t time_ns);
  Error update_joint(Pose joint, int64_t time_ns);
  Error update_lost(int64_t time_ns);
  Error update_sample(int64_t flags, int64_t time_ns, double direction_deg, double x_m, double y_m, double z_m,
                      double plate_orientation_deg);
  Error retarget(int64_t real, int64_t felt);
  Error touched(Vector3 world_position, double sd_m);
  Error touched_real_target();
  Error cancel();
  Error end();
  bool is_reaching() { return reaching_; }
  Record get_command();
  Record get_summary();
  Error begin_simulated_finger(int64_t felt, int64_t seed);
  Vector3 move_simulated_finger(int64_t time_ns);
  Vector3 update_simulated_finger(int64_t time_ns);

  Error begin_setup(int64_t what);
  Record finish_setup();
  Error cancel_setup();
  Error new_person();
  bool is_setting_up() { return setting_up_; }

  Error load_profile(std::string json);
  std::string save_profile();
  Error set_conditions(std::string plate, std::string tracker, int64_t time_s);
  Record get_conditions();
  Error start_recording(std::string path);
  Record get_recording_status();
  Error stop_recording();

  Error open_device(std::string device);
  Error turn_device(double orientation_deg);
  Error stop_device();
  Record get_device_report();
  Error close_device();
  Error take_device();
  std::string get_version();

 private:
  const void* of(const Field& property) const;
  bool ok(hrt_result result);
  Error error() const;
  bool configure();
  bool read_pose(double (&position_m)[3], double (&rotation)[4]);
  void take_changes();
  void report_sample(size_t reason, const char* text);

  bool list_targets(uint32_t role, std::vector<hrt_target>& out_targets);
  int64_t add_target(const hrt_target_config& config);
  Error begin_reach(const hrt_reach_config& config);
  Error take_contact(const hrt_contact* contact);
  bool finger_sample(const Vector3& place, int64_t time_ns, hrt_sample& out_sample);
  Error send(const hrt_sample& sample);
  Error guide(const hrt_sample& sample);
  Vector3 move_person(int64_t time_ns, hrt_sample& out_sample);
  bool read_device(hrt_plate_report& out_report) const;
  Error after_device(hrt_result result);

  Engine& engine_;
  hrt_session session_{};
  hrt_person person_{};
  int64_t seed_ = 0;  ///< of the person
  hrt_plate device_{};
  bool failure_is_known_ = false;  ///< the device's
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
  std::bitset<128> refused_;  ///< samples of this reach or set-up, by the reason
};

}  // namespace hrt_godot
