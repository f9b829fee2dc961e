#include "plate_node.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>

#include "pose.h"

namespace hrt_godot {
namespace {

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

}  // namespace

/** Of the last call of the plugin. */
Error PlateNode::error() const {
  constexpr std::pair<hrt_result, Error> errors[] = {
      {HRT_OK, Error::kOk},
      {HRT_ERROR_WRONG_STATE, Error::kUnavailable},
      {HRT_ERROR_OUT_OF_RANGE, Error::kParameterRange},
      {HRT_ERROR_OUT_OF_MEMORY, Error::kOutOfMemory},
      {HRT_ERROR_SYSTEM, Error::kFileCannotWrite},
      {HRT_ERROR_LIMIT_REACHED, Error::kCannotCreate},
      {HRT_ERROR_INSUFFICIENT_DATA, Error::kInvalidData},
      {HRT_ERROR_TIME_REVERSED, Error::kInvalidData},
      {HRT_ERROR_NULL_ARGUMENT, Error::kInvalidParameter},
      {HRT_ERROR_NAME_TAKEN, Error::kAlreadyExists},
      {HRT_ERROR_INVALID_HANDLE, Error::kDoesNotExist},
      {HRT_ERROR_BAD_FORMAT, Error::kParse},
      {HRT_ERROR_BUSY, Error::kBusy},
  };
  for (const auto& [ours, godots] : errors)
    if (ours == result_) return godots;
  return Error::kBug;
}

PlateNode::PlateNode(Engine& engine)
    : engine_(engine), setup_config_(hrt_setup_config_init()), config_(hrt_session_config_init()) {}

PlateNode::~PlateNode() {
  if (person_.value) hrt_person_destroy(person_);
  hrt_plate_close(device_);
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
  return method.function(*this, arguments.data());
} catch (const std::exception& error) {
  engine_.push_error(error.what());
  return method.failure;
}

/** The struct that has the property. */
const void* PlateNode::of(const Field& property) const {
  const bool is_of_setup = &property >= setup_fields.data() && &property < &setup_fields.back() + 1;
  return is_of_setup ? static_cast<const void*>(&setup_config_) : &config_;
}

void PlateNode::set(const Field& property, const Value& value) noexcept try {
  if (property.set(const_cast<void*>(of(property)), value)) return engine_.update_warnings();
  const std::string text = std::string(property.name) + " was given a value of type " + type_name(type_of(value)) +
                           "; allowed: " + property.allowed;
  engine_.push_error(text.c_str());
} catch (const std::exception& error) {
  engine_.push_error(error.what());
}

std::string PlateNode::warning() {
  hrt_session_config config = config_;
  if (!read_pose(config.plate.position_m, config.plate.rotation)) return kNotRigid;
  hrt_session session{};
  if (hrt_session_create(HRT_VERSION, &config, &session) != HRT_OK) return hrt_last_error();
  hrt_session_destroy(session);
  return {};
}

/** Whether it succeeded; otherwise the reason has been shown to the user. */
bool PlateNode::ok(hrt_result result) {
  result_ = result;
  if (result == HRT_OK) return true;
  engine_.push_error(hrt_last_error());
  return false;
}

/** Brings the session to the properties and the node's pose, between reaches and set-ups. Properties are set
 * one by one, when a scene loads for example, and are valid or not only together: this is where they are
 * checked. */
bool PlateNode::configure() {
  if (reaching_ || setting_up_) return true;
  if (!read_pose(config_.plate.position_m, config_.plate.rotation)) {
    engine_.push_error(kNotRigid);
    return false;
  }
  if (plate_pose_ && !(engine_.node_pose() == *plate_pose_)) {
    plate_pose_.reset();
    config_.flags &= ~HRT_SESSION_REGISTERED;
  }
  if (!session_.value) {
    if (!ok(hrt_session_create(HRT_VERSION, &config_, &session_))) return false;
  } else if (std::memcmp(&config_, &configured_, sizeof config_) != 0) {
    if (!ok(hrt_session_set(session_, &config_))) return false;
  }
  configured_ = config_;
  return true;
}

/** Shows why a sample was refused, once in a reach or set-up for each reason: samples come in every frame. */
void PlateNode::report_sample(size_t reason, const char* text) {
  if (!refused_.test(reason)) engine_.push_error(text);
  refused_.set(reason);
}

bool PlateNode::read_pose(double (&position_m)[3], double (&rotation)[4]) {
  const Pose pose = engine_.node_pose();
  if (plate_pose_ && pose == *plate_pose_) {
    std::copy_n(configured_.plate.position_m, 3, position_m);
    std::copy_n(configured_.plate.rotation, 4, rotation);
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

/** Takes what the plugin itself has changed of the configuration into the properties, of which others may
 * have been set and wait. Where it has moved the plate, the node moves too: in floats, beside which the
 * session keeps its doubles. */
void PlateNode::take_changes() {
  const hrt_session_config before = configured_;
  if (!ok(hrt_session_get(session_, &configured_, nullptr))) return;
  for (const Field& field : config_fields)
    if (const Entry now = field.get(&configured_); now != field.get(&before)) field.set(&config_, to_value(now));
  copy_hidden(configured_, config_);
  if (std::memcmp(before.plate.position_m, configured_.plate.position_m, sizeof before.plate.position_m) == 0 &&
      std::memcmp(before.plate.rotation, configured_.plate.rotation, sizeof before.plate.rotation) == 0)
    return;
  engine_.move_node(to_pose(configured_.plate.position_m, configured_.plate.rotation));
  plate_pose_ = engine_.node_pose();
}

std::string PlateNode::get_version() {
  uint32_t major = 0, minor = 0, patch = 0;
  hrt_get_version(&major, &minor, &patch);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

}  // namespace hrt_godot
