#include "plate_node.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>

#include "pose.h"

namespace hrt_godot {
namespace {

/** Why samples are refused: the plugin's errors, up to 99, then the node's own. */
constexpr size_t kFlagsReason = 126, kPoseReason = 127;
constexpr size_t reason_of(hrt_result error) {
  return static_cast<size_t>(-error) % kFlagsReason;
}
constexpr const char* kNotRigid =
    "the node is scaled, sheared or mirrored in the world; allowed: moved and turned, as a plate";

int64_t to_int(const Value& value) {
  return std::get<int64_t>(value);
}
double to_real(const Value& value) {
  const int64_t* integer = std::get_if<int64_t>(&value);
  return integer ? static_cast<double>(*integer) : std::get<double>(value);
}
const std::string& to_text(const Value& value) {
  return std::get<std::string>(value);
}
hrt_target to_target(const Value& value) {
  return {static_cast<uint64_t>(to_int(value))};
}

/** GDScript writes 5 for 5.0. */
bool fits(const Value& value, Type type) {
  return type_of(value) == type || (type == Type::kReal && type_of(value) == Type::kInt);
}

std::string signature(const Method& method) {
  std::string text = std::string(method.name) + '(';
  for (const Argument& argument : method.arguments) {
    if (text.back() != '(') text += ", ";
    text += std::string(argument.name) + ": " + type_name(argument.type);
  }
  return text + ')';
}

hrt_mark_touch mark_touch(const Value* arguments) {
  hrt_mark_touch touch{};
  copy(std::get<Vector3>(arguments[0]), touch.mark_m);
  copy(std::get<Vector3>(arguments[1]), touch.touched_m);
  return touch;
}

hrt_joint_touch joint_touch(const Pose& joint) {
  hrt_joint_touch touch{};
  copy(joint.origin, touch.position_m);
  const std::array<double, 4> rotation = to_quaternion(joint);
  std::copy(rotation.begin(), rotation.end(), touch.rotation);
  return touch;
}

/** A name that does not fit has no zero at its end, which the plugin refuses. */
hrt_target_config target_config(uint32_t role, const std::string& name) {
  hrt_target_config config = hrt_target_config_init();
  config.role = role;
  name.copy(config.name, sizeof config.name);
  return config;
}

hrt_target_config polar_target(uint32_t role, const Value* arguments) {
  hrt_target_config config = target_config(role, to_text(arguments[0]));
  config.direction_deg = to_real(arguments[1]);
  config.distance_m = to_real(arguments[2]);
  return config;
}

void place_at(const Vector3& world_position, hrt_target_config& config) {
  config.place = HRT_PLACE_WORLD_POSITION;
  copy(world_position, config.position_m);
}

hrt_target_config placed_target(uint32_t role, const Value* arguments) {
  hrt_target_config config = target_config(role, to_text(arguments[0]));
  place_at(std::get<Vector3>(arguments[1]), config);
  return config;
}

}  // namespace

int64_t to_godot_error(hrt_result result) {
  switch (result) {
    case HRT_OK:
      return 0;  // OK
    case HRT_ERROR_WRONG_STATE:
      return 2;  // ERR_UNAVAILABLE
    case HRT_ERROR_OUT_OF_RANGE:
      return 5;  // ERR_PARAMETER_RANGE_ERROR
    case HRT_ERROR_OUT_OF_MEMORY:
      return 6;  // ERR_OUT_OF_MEMORY
    case HRT_ERROR_SYSTEM:
      return 13;  // ERR_FILE_CANT_WRITE
    case HRT_ERROR_LIMIT_REACHED:
      return 20;  // ERR_CANT_CREATE
    case HRT_ERROR_INSUFFICIENT_DATA:
    case HRT_ERROR_TIME_REVERSED:
      return 30;  // ERR_INVALID_DATA
    case HRT_ERROR_NULL_ARGUMENT:
      return kErrInvalidParameter;
    case HRT_ERROR_NAME_TAKEN:
      return 32;  // ERR_ALREADY_EXISTS
    case HRT_ERROR_INVALID_HANDLE:
    case HRT_ERROR_NOT_FOUND:
      return 33;  // ERR_DOES_NOT_EXIST
    case HRT_ERROR_BAD_FORMAT:
      return 43;  // ERR_PARSE_ERROR
    case HRT_ERROR_BUSY:
      return 44;  // ERR_BUSY
    default:
      return 47;  // ERR_BUG
  }
}

PlateNode::PlateNode(Engine& engine) : engine_(engine), config_(hrt_session_config_init()) {}

PlateNode::~PlateNode() {
  if (calibration_.value) hrt_calibration_destroy(calibration_);
  if (session_.value) hrt_session_destroy(session_);
}

Value PlateNode::call(const Method& method, std::span<const Value> arguments) noexcept try {
  bool valid = arguments.size() == method.arguments.size();
  for (size_t i = 0; valid && i < arguments.size(); ++i) valid = fits(arguments[i], method.arguments[i].type);
  if (!valid) {
    std::string text = "called with (";
    for (const Value& argument : arguments) {
      if (text.back() != '(') text += ", ";
      text += type_name(type_of(argument));
    }
    engine_.push_error((text + "); it is " + signature(method)).c_str());
    return method.failure;
  }
  return (this->*method.function)(arguments.data());
} catch (const std::exception& error) {
  engine_.push_error(error.what());
  return method.failure;
}

void PlateNode::set(const Field& property, const Value& value) noexcept try {
  if (set_field(&config_, property, value)) return;
  std::string text = std::string(property.name) + " was given a value of type " + type_name(type_of(value)) +
                     "; allowed: " + type_name(type_of(property));
  if (property.kind == FieldKind::kUint32) text += " from 0 to 4294967295";
  engine_.push_error(text.c_str());
} catch (const std::exception& error) {
  engine_.push_error(error.what());
}

/** Whether it succeeded; otherwise the reason has been shown to the user. */
bool PlateNode::ok(hrt_result result) {
  result_ = result;
  if (result == HRT_OK) return true;
  engine_.push_error(hrt_last_error());
  return false;
}

/** Whether there is a result of an earlier call; otherwise the user has been shown `text`. */
template <typename Result>
bool PlateNode::is_fitted(const Result& result, const char* text) {
  if (result.struct_size) return true;
  result_ = HRT_ERROR_WRONG_STATE;
  engine_.push_error(text);
  return false;
}

/** Brings the session to the properties and the node's pose, between reaches. Properties are set one by one,
 *  when a scene loads for example, and are valid or not only together: this is where they are checked. */
bool PlateNode::configure() {
  if (reaching_) return true;
  if (!read_pose(config_.plate_position_m, config_.plate_rotation)) {
    engine_.push_error(kNotRigid);
    return false;
  }
  if (plate_pose_ && !(engine_.node_pose() == *plate_pose_)) {
    plate_pose_.reset();
    config_.flags &= ~HRT_SESSION_REGISTERED;
  }
  if (!session_.value) {
    if (!ok(hrt_session_create(&config_, &session_))) return false;
  } else if (std::memcmp(&config_, &configured_, sizeof config_) != 0) {
    if (!ok(hrt_session_set_config(session_, &config_))) return false;
  }
  configured_ = config_;
  return true;
}

/** Shows why a sample was refused, once in a reach or trial for each reason: samples come in every frame. */
void PlateNode::report_sample(size_t reason, const char* text) {
  if (!refused_.test(reason)) engine_.push_error(text);
  refused_.set(reason);
}

bool PlateNode::read_pose(double (&position_m)[3], double (&rotation)[4]) {
  const Pose pose = engine_.node_pose();
  if (plate_pose_ && pose == *plate_pose_) {
    std::copy_n(configured_.plate_position_m, 3, position_m);
    std::copy_n(configured_.plate_rotation, 4, rotation);
    return true;
  }
  if (!is_rigid(pose)) {
    result_ = HRT_ERROR_OUT_OF_RANGE;
    return false;
  }
  copy(pose.origin, position_m);
  const std::array<double, 4> quaternion = to_quaternion(pose);
  std::copy(quaternion.begin(), quaternion.end(), rotation);
  return true;
}

/** Puts the node where the library has the plate: in floats, beside which the session keeps its doubles. */
void PlateNode::move_to_plate() {
  take_changes();
  engine_.move_node(to_pose(configured_.plate_position_m, configured_.plate_rotation));
  plate_pose_ = engine_.node_pose();
}

Value PlateNode::add_target(const hrt_target_config& config) {
  hrt_target target{};
  if (!configure() || !ok(hrt_target_add(session_, &config, &target))) return kNoTarget;
  return static_cast<int64_t>(target.value);
}

Value PlateNode::add_real_target(const Value* arguments) {
  return add_target(polar_target(HRT_TARGET_REAL, arguments));
}

Value PlateNode::add_virtual_target(const Value* arguments) {
  return add_target(polar_target(HRT_TARGET_VIRTUAL, arguments));
}

Value PlateNode::add_real_target_at(const Value* arguments) {
  return add_target(placed_target(HRT_TARGET_REAL, arguments));
}

Value PlateNode::add_virtual_target_at(const Value* arguments) {
  return add_target(placed_target(HRT_TARGET_VIRTUAL, arguments));
}

Value PlateNode::move_target_to(const Value* arguments) {
  hrt_target_config config{};
  config.struct_size = sizeof config;
  if (!configure() || !ok(hrt_target_get(session_, to_target(arguments[0]), &config)))
    return to_godot_error(result_);
  place_at(std::get<Vector3>(arguments[1]), config);
  ok(hrt_target_set(session_, to_target(arguments[0]), &config));
  return to_godot_error(result_);
}

Value PlateNode::remove_target(const Value* arguments) {
  ok(hrt_target_remove(session_, to_target(arguments[0])));
  return to_godot_error(result_);
}

Value PlateNode::begin(const Value* arguments) {
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = to_target(arguments[0]);
  config.virtual_target = to_target(arguments[1]);
  return begin_reach(config);
}

Value PlateNode::begin_with_plate_at(const Value* arguments) {
  hrt_reach_config config = hrt_reach_config_init();
  config.flags = HRT_REACH_PLATE_ORIENTATION;
  config.real_target = to_target(arguments[0]);
  config.virtual_target = to_target(arguments[1]);
  config.plate_orientation_deg = to_real(arguments[2]);
  return begin_reach(config);
}

Value PlateNode::begin_for(const Value* arguments) {
  hrt_reach_config config = hrt_reach_config_init();
  config.real_target = to_target(arguments[0]);
  config.virtual_target = to_target(arguments[1]);
  config.duration_s = to_real(arguments[2]);
  return begin_reach(config);
}

Value PlateNode::begin_reach(const hrt_reach_config& config) {
  if (configure() && ok(hrt_reach_begin(session_, &config))) {
    reaching_ = true;
    command_ = {};
    refused_.reset();
  }
  return to_godot_error(result_);
}

/** A sample of the fingertip in the world, with the plate where the node is. */
bool PlateNode::finger_sample(const Value* arguments, hrt_sample& out_sample) {
  out_sample = {};
  out_sample.struct_size = sizeof out_sample;
  out_sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
  out_sample.time_ns = to_int(arguments[1]);
  copy(std::get<Vector3>(arguments[0]), out_sample.finger_position_m);
  if (const std::optional<double> orientation_deg = device_.orientation_deg()) {
    out_sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    out_sample.plate_orientation_deg = *orientation_deg;
  }
  if (read_pose(out_sample.plate_position_m, out_sample.plate_rotation)) return true;
  report_sample(kPoseReason, kNotRigid);
  return false;
}

Value PlateNode::update(const Value* arguments) {
  hrt_sample sample;
  return finger_sample(arguments, sample) ? send(sample) : to_godot_error(result_);
}

Value PlateNode::update_lost(const Value* arguments) {
  hrt_sample sample{};
  sample.time_ns = to_int(arguments[0]);
  return send(sample);
}

Value PlateNode::update_sample(const Value* arguments) {
  const int64_t flags = to_int(arguments[0]);
  constexpr int64_t kTaken =
      HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_PLATE_ORIENTATION | HRT_SAMPLE_LIFTED;
  if (flags & ~kTaken) {
    report_sample(kFlagsReason,
                  ("flags " + std::to_string(flags) +
                   "; allowed: sums of 1 direction, 2 position on the plate, 4 plate's orientation, 8 lifted")
                      .c_str());
    return kErrInvalidParameter;
  }
  hrt_sample sample{};
  sample.flags = static_cast<uint32_t>(flags);
  sample.time_ns = to_int(arguments[1]);
  sample.finger_direction_deg = to_real(arguments[2]);
  for (int i = 0; i < 3; ++i) sample.finger_position_m[i] = to_real(arguments[3 + i]);
  sample.plate_orientation_deg = to_real(arguments[6]);
  return send(sample);
}

Value PlateNode::send(const hrt_sample& filled) {
  hrt_sample sample = filled;
  sample.struct_size = sizeof sample;
  hrt_command command{};
  command.struct_size = sizeof command;
  result_ = hrt_reach_update(session_, &sample, &command);
  if (result_ != HRT_OK) {
    report_sample(reason_of(result_), hrt_last_error());
    return to_godot_error(result_);
  }
  const uint32_t changed = (command.flags ^ command_.flags) & ~HRT_COMMAND_HELD;
  command_ = command;
  // Handlers may call this node again, so nothing is read from it after the first signal.
  if (changed) engine_.emit(kFlagsChanged, int64_t{command.flags});
  if (!(command.flags & HRT_COMMAND_HELD)) engine_.emit(kPlateCommanded, command.plate_orientation_deg);
  return int64_t{0};
}

Value PlateNode::retarget(const Value* arguments) {
  ok(hrt_reach_retarget(session_, to_target(arguments[0]), to_target(arguments[1])));
  return to_godot_error(result_);
}

Value PlateNode::cancel(const Value*) {
  if (ok(hrt_reach_cancel(session_))) reaching_ = false;
  return to_godot_error(result_);
}

Value PlateNode::end(const Value*) {
  hrt_reach_summary summary{};
  summary.struct_size = sizeof summary;
  if (!ok(hrt_reach_end(session_, &summary))) return to_godot_error(result_);
  reaching_ = false;
  summary_ = summary;
  take_changes();  // under HRT_ADAPTATION_CARRIED there are some
  engine_.emit(kReachEnded, summary.final_miss_deg);
  return int64_t{0};
}

Value PlateNode::is_reaching(const Value*) {
  return reaching_;
}

Value PlateNode::get_command(const Value*) {
  return command_.struct_size ? to_record(&command_, command_fields()) : Record{};
}

Value PlateNode::get_summary(const Value*) {
  return summary_.struct_size ? to_record(&summary_, summary_fields()) : Record{};
}

Value PlateNode::get_authority(const Value* arguments) {
  hrt_authority authority{};
  authority.struct_size = sizeof authority;
  if (!configure() ||
      !ok(hrt_authority_query(session_, to_target(arguments[0]), to_target(arguments[1]), &authority)))
    return Record{};
  return to_record(&authority, authority_fields());
}

Value PlateNode::get_best_authority(const Value* arguments) {
  hrt_authority authority{};
  authority.struct_size = sizeof authority;
  if (!configure() || !ok(hrt_authority_query_best(session_, to_target(arguments[0]), &authority)))
    return Record{};
  return to_record(&authority, authority_fields());
}

bool PlateNode::list_targets(uint32_t role, std::vector<hrt_target>& out_targets) {
  uint64_t count = 0;
  if (!ok(hrt_target_list(session_, role, 0, nullptr, &count))) return false;
  out_targets.resize(count);
  return ok(hrt_target_list(session_, role, count, out_targets.data(), &count));
}

Value PlateNode::assign_targets(const Value* arguments) {
  std::vector<hrt_target> real, felt;
  if (!configure() || !list_targets(HRT_TARGET_REAL, real) || !list_targets(HRT_TARGET_VIRTUAL, felt))
    return to_godot_error(result_);
  hrt_authority one{};
  one.struct_size = sizeof one;
  std::vector<hrt_authority> assigned(felt.size() + 1, one);  // one more: the plugin reads the first
  const uint32_t flags = std::get<bool>(arguments[0]) ? HRT_ASSIGN_EXCLUSIVE : 0;
  if (ok(hrt_target_assign(session_, felt.data(), felt.size(), real.data(), real.size(), flags, felt.size(),
                           assigned.data()))) {
    assigned.pop_back();
    assigned_ = std::move(assigned);
  }
  return to_godot_error(result_);
}

Value PlateNode::get_assigned(const Value* arguments) {
  const auto found = std::find_if(assigned_.begin(), assigned_.end(), [&](const hrt_authority& one) {
    return one.virtual_target.value == to_target(arguments[0]).value;
  });
  if (found != assigned_.end()) return to_record(&*found, authority_fields());
  engine_.push_error("get_assigned: no assignment of this virtual target; call assign_targets() first");
  return Record{};
}

Value PlateNode::load_scene(const Value* arguments) {
  hrt_scene scene{};
  if (!configure() || !ok(hrt_scene_load_file(to_text(arguments[0]).c_str(), &scene)))
    return to_godot_error(result_);
  const bool registered = ok(hrt_scene_register(scene, session_, 0, nullptr));
  const hrt_result result = result_;
  hrt_scene_destroy(scene);
  if (registered) move_to_plate();
  return to_godot_error(result);
}

Value PlateNode::find_target(const Value* arguments) {
  hrt_target target{};
  if (!configure() || !ok(hrt_target_find(session_, to_text(arguments[0]).c_str(), &target)))
    return kNoTarget;
  return static_cast<int64_t>(target.value);
}

Value PlateNode::begin_calibration(const Value* arguments) {
  hrt_calibration_config config = hrt_calibration_config_init();
  config.goal_direction_deg = to_real(arguments[0]);
  return create_calibration(config);
}

Value PlateNode::begin_calibration_within(const Value* arguments) {
  hrt_calibration_config config = hrt_calibration_config_init();
  config.goal_direction_deg = to_real(arguments[0]);
  config.lower_plate_deg = to_real(arguments[1]);
  config.upper_plate_deg = to_real(arguments[2]);
  config.enough_weight_width = to_real(arguments[3]);
  return create_calibration(config);
}

Value PlateNode::create_calibration(const hrt_calibration_config& config) {
  hrt_calibration calibration{};
  if (!configure() || !ok(hrt_calibration_create(session_, &config, &calibration)))
    return to_godot_error(result_);
  if (calibration_.value) hrt_calibration_destroy(calibration_);
  calibration_ = calibration;
  if (user_.struct_size) before_ = user_;
  user_ = {};
  return int64_t{0};
}

Value PlateNode::get_next_angle(const Value*) {
  double orientation_deg = 0.0;
  uint32_t enough = 0;
  if (!ok(hrt_calibration_next_angle(calibration_, &orientation_deg, &enough))) return Record{};
  return Record{{"plate_orientation_deg", orientation_deg}, {"enough", int64_t{enough}}};
}

Value PlateNode::begin_trial(const Value* arguments) {
  refused_.reset();
  ok(hrt_calibration_begin_trial(calibration_, to_real(arguments[0])));
  return to_godot_error(result_);
}

Value PlateNode::add_trial_sample(const Value* arguments) {
  hrt_sample sample;
  if (finger_sample(arguments, sample)) {
    result_ = hrt_calibration_add_sample(calibration_, &sample);
    if (result_ != HRT_OK) report_sample(reason_of(result_), hrt_last_error());
  }
  return to_godot_error(result_);
}

Value PlateNode::end_trial(const Value*) {
  ok(hrt_calibration_end_trial(calibration_));
  return to_godot_error(result_);
}

Value PlateNode::cancel_trial(const Value*) {
  ok(hrt_calibration_cancel_trial(calibration_));
  return to_godot_error(result_);
}

Value PlateNode::solve_calibration(const Value*) {
  hrt_calibration_result user{};
  user.struct_size = sizeof user;
  if (!ok(hrt_calibration_solve(calibration_, &user))) return Record{};
  user_ = user;
  return to_record(&user_, calibration_fields());
}

Value PlateNode::get_slide(const Value* arguments) {
  hrt_calibration_slide slide{};
  slide.struct_size = sizeof slide;
  const int64_t number = to_int(arguments[0]);
  const uint32_t wanted = number >= 0 && number < UINT32_MAX ? static_cast<uint32_t>(number) : UINT32_MAX;
  if (!ok(hrt_calibration_get_residual(calibration_, wanted, &slide))) return Record{};
  return to_record(&slide, slide_fields());
}

Value PlateNode::apply_calibration(const Value*) {
  if (!is_fitted(user_, "apply_calibration: no calibration is solved; call solve_calibration() first"))
    return to_godot_error(result_);
  if (configure() && ok(hrt_calibration_apply(session_, &user_))) take_changes();
  return to_godot_error(result_);
}

Value PlateNode::compare_calibrations(const Value*) {
  if (!user_.struct_size || !before_.struct_size) {
    engine_.push_error("compare_calibrations: it needs two calibrations of this node that were solved");
    return Record{};
  }
  hrt_calibration_comparison comparison{};
  comparison.struct_size = sizeof comparison;
  if (!ok(hrt_calibration_compare(&before_, &user_, &comparison))) return Record{};
  return to_record(&comparison, comparison_fields());
}

Value PlateNode::end_calibration(const Value*) {
  if (ok(hrt_calibration_destroy(calibration_))) calibration_ = {};
  return to_godot_error(result_);
}

/** Takes what the plugin itself has changed of the configuration, which is what it has learnt of the user,
 * into the properties; others may have been set and wait. */
void PlateNode::take_changes() {
  const hrt_session_config before = configured_;
  if (!ok(hrt_session_get_config(session_, &configured_))) return;
  for (const Field& field : config_fields())
    if (is_different(&before, &configured_, field))
      set_field(&config_, field, get_field(&configured_, field));
  copy_hidden(configured_, config_);
}

Value PlateNode::clear_touches(const Value*) {
  mark_touches_.clear();
  joint_touches_.clear();
  return int64_t{0};
}

Value PlateNode::add_mark_touch(const Value* arguments) {
  mark_touches_.push_back(mark_touch(arguments));
  return int64_t{0};
}

Value PlateNode::fit_registration(const Value*) {
  hrt_registration registration{};
  registration.struct_size = sizeof registration;
  if (!ok(hrt_registration_fit(nullptr, mark_touches_.data(), mark_touches_.size(), 0, nullptr,
                               &registration)))
    return Record{};
  registration_ = registration;
  return to_record(&registration_, registration_fields());
}

Value PlateNode::get_registration_advice(const Value*) {
  return std::string(hrt_registration_advice(registration_.verdict));
}

Value PlateNode::apply_registration(const Value* arguments) {
  if (!is_fitted(registration_, "apply_registration: nothing is fitted; call fit_registration() first"))
    return to_godot_error(result_);
  if (configure() && ok(hrt_registration_apply(session_, &registration_, to_int(arguments[0]))))
    move_to_plate();
  return to_godot_error(result_);
}

Value PlateNode::confirm_registration(const Value* arguments) {
  const hrt_mark_touch touch = mark_touch(arguments);
  hrt_touch_check check{};
  check.struct_size = sizeof check;
  if (!is_fitted(registration_, "confirm_registration: nothing is fitted; call fit_registration() first") ||
      !configure() ||
      !ok(hrt_registration_confirm(session_, &registration_, &touch, to_int(arguments[2]), &check)))
    return Record{};
  take_changes();
  return to_record(&check, touch_fields());
}

Value PlateNode::add_joint_touch(const Value* arguments) {
  joint_touches_.push_back(joint_touch(std::get<Pose>(arguments[0])));
  return int64_t{0};
}

Value PlateNode::fit_fingertip(const Value*) {
  hrt_fingertip fingertip{};
  fingertip.struct_size = sizeof fingertip;
  if (!ok(hrt_fingertip_fit(nullptr, joint_touches_.data(), joint_touches_.size(), &fingertip)))
    return Record{};
  fingertip_ = fingertip;
  return to_record(&fingertip_, fingertip_fields());
}

/** The skin's place in the world. Comes with every frame, as samples do. */
Value PlateNode::place_fingertip(const Value* arguments) {
  if (!is_fitted(fingertip_, "place_fingertip: nothing is fitted; call fit_fingertip() first"))
    return kNowhere;
  const hrt_joint_touch joint = joint_touch(std::get<Pose>(arguments[0]));
  hrt_sample sample{};
  sample.struct_size = sizeof sample;
  result_ = hrt_fingertip_place(&fingertip_, &joint, &sample);
  if (result_ == HRT_OK) {
    const auto [x, y, z] = sample.finger_position_m;
    return Vector3{x, y, z};
  }
  report_sample(reason_of(result_), hrt_last_error());
  return kNowhere;
}

Value PlateNode::load_profile(const Value* arguments) {
  const std::string& json = to_text(arguments[0]);
  if (configure() && ok(hrt_profile_load(session_, json.data(), json.size()))) take_changes();
  return to_godot_error(result_);
}

Value PlateNode::save_profile(const Value*) {
  uint64_t length = 0;
  if (!configure() || !ok(hrt_profile_save(session_, 0, nullptr, &length))) return std::string();
  std::string json(length + 1, '\0');
  if (!ok(hrt_profile_save(session_, json.size(), json.data(), &length))) return std::string();
  json.resize(length);
  return json;
}

Value PlateNode::set_conditions(const Value* arguments) {
  hrt_conditions now{};
  now.struct_size = sizeof now;
  // A name that is too long fills its field without a zero, which the plugin refuses.
  to_text(arguments[0]).copy(now.plate, sizeof now.plate);
  to_text(arguments[1]).copy(now.tracker, sizeof now.tracker);
  now.time_s = to_int(arguments[2]);
  if (configure()) ok(hrt_profile_set_conditions(session_, &now));
  return to_godot_error(result_);
}

Value PlateNode::get_conditions(const Value*) {
  hrt_conditions measured{};
  measured.struct_size = sizeof measured;
  if (!configure() || !ok(hrt_profile_get_conditions(session_, &measured))) return Record{};
  return Record{{"differing", int64_t{measured.differing}}, {"time_s", measured.time_s}};
}

Value PlateNode::start_recording(const Value* arguments) {
  if (configure()) ok(hrt_recording_start(session_, to_text(arguments[0]).c_str()));
  return to_godot_error(result_);
}

Value PlateNode::get_recording_status(const Value*) {
  hrt_recording_status status{};
  status.struct_size = sizeof status;
  if (!ok(hrt_recording_get_status(session_, &status))) return Record{};
  return to_record(&status, recording_fields());
}

Value PlateNode::stop_recording(const Value*) {
  hrt_recording_status status{};
  status.struct_size = sizeof status;
  if (!ok(hrt_recording_stop(session_, &status))) return to_godot_error(result_);
  if (status.rows_lost == 0) return int64_t{0};
  engine_.push_error(
      ("the recording lacks " + std::to_string(status.rows_lost) + " calls: the disk was too slow or failed")
          .c_str());
  return to_godot_error(HRT_ERROR_SYSTEM);
}

// Each frame may turn a device that is being opened, or has failed: the reason of a failure is shown once.
Value PlateNode::after_device(hrt_result result) {
  if (result == HRT_ERROR_WRONG_STATE) {
    if (device_.has_failed_anew()) engine_.push_error(device_.message().c_str());
  } else if (result != HRT_OK) {
    engine_.push_error(hrt_plate_last_error());
  }
  return to_godot_error(result);
}

Value PlateNode::open_device(const Value* arguments) {
  return after_device(device_.open(to_text(arguments[0])));
}

Value PlateNode::turn_device(const Value* arguments) {
  return after_device(device_.turn_to(to_real(arguments[0])));
}

Value PlateNode::stop_device(const Value*) {
  return after_device(device_.stop());
}

Value PlateNode::get_device_report(const Value*) {
  return device_.report();
}

Value PlateNode::get_device_description(const Value*) {
  return device_.description();
}

Value PlateNode::get_device_message(const Value*) {
  return device_.message();
}

Value PlateNode::close_device(const Value*) {
  return after_device(device_.close());
}

Value PlateNode::get_version(const Value*) {
  uint32_t major = 0, minor = 0, patch = 0;
  hrt_get_version(&major, &minor, &patch);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

}  // namespace hrt_godot
