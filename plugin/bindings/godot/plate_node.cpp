#include "plate_node.h"

#include <algorithm>
#include <cstring>
#include <exception>

namespace hrt_godot {
namespace {

std::string signature(const Method& method) {
  std::string text = std::string(method.name) + '(';
  for (const Argument& argument : method.arguments) {
    if (text.back() != '(') text += ", ";
    text += std::string(argument.name) + ": " + type_name(argument.type);
  }
  return text + ')';
}

}  // namespace

bool Property::set(Properties& of, const Value& value) const {
  if (!fits(value, type_of(get(of)))) return false;
  return std::visit(
      [&]<typename T>(T* at) {
        if constexpr (std::is_same_v<T, double>)
          *at = from_value<double>(value);
        else if constexpr (std::is_array_v<T>)
          Vector3::Map(*at) = std::get<Vector3>(value);
        else if (!std::in_range<T>(std::get<int64_t>(value)))
          return false;
        else
          *at = static_cast<T>(std::get<int64_t>(value));
        return true;
      },
      place(of));
}

PlateNode::~PlateNode() {
  if (person_.value) hrt_person_destroy(person_);
  hrt_plate_close(device_);
  if (session_.value) hrt_session_destroy(session_);
}

Value PlateNode::call(const Method& method, std::span<const Value> arguments) noexcept try {
  const auto fits_type = [](const Value& value, const Argument& argument) { return fits(value, argument.type); };
  if (std::ranges::equal(arguments, method.arguments, fits_type)) return method.function(*this, arguments.data());
  std::string text = "called with (";
  for (const Value& argument : arguments) {
    if (text.back() != '(') text += ", ";
    text += type_name(type_of(argument));
  }
  engine_.push_error((text + "); allowed: " + signature(method)).c_str());
  return method.failure;
} catch (const std::exception& error) {
  engine_.push_error(error.what());
  return method.failure;
}

void PlateNode::set(const Property& property, const Value& value) noexcept try {
  if (property.set(properties_, value)) return engine_.update_warnings();
  const bool is_unsigned = std::holds_alternative<uint32_t*>(property.place(properties_));
  const std::string text =
      std::string(property.name) + " was given a value of type " + type_name(type_of(value)) +
      "; allowed: " + (is_unsigned ? "int from 0 to 4294967295" : type_name(type_of(get(property))));
  engine_.push_error(text.c_str());
} catch (const std::exception& error) {
  engine_.push_error(error.what());
}

std::string PlateNode::warning() {
  hrt_session_config config = properties_.session;
  if (!read_pose(config.plate.position_m, config.plate.rotation)) return kNotRigid;
  hrt_session session{};
  if (hrt_session_create(HRT_VERSION, &config, &session) != HRT_OK) return script_names(hrt_last_error());
  hrt_session_destroy(session);
  return {};
}

/** Returns whether a call of the plugin succeeded. Shows the error if it did not. */
bool PlateNode::ok(hrt_result result) {
  result_ = result;
  if (result == HRT_OK) return true;
  push_last_error();
  return false;
}

/** Returns result_ as an Error of Godot. */
Error PlateNode::error() const {
  constexpr std::pair<hrt_result, Error> errors[] = {
      {HRT_OK, Error::kOk},
      {HRT_ERROR_WRONG_STATE, Error::kUnavailable},
      {HRT_ERROR_OUT_OF_RANGE, Error{5}},  // ERR_PARAMETER_RANGE_ERROR
      {HRT_ERROR_OUT_OF_MEMORY, Error{6}},
      {HRT_ERROR_SYSTEM, Error{12}},             // ERR_FILE_CANT_OPEN
      {HRT_ERROR_LIMIT_REACHED, Error{20}},      // ERR_CANT_CREATE
      {HRT_ERROR_INSUFFICIENT_DATA, Error{30}},  // ERR_INVALID_DATA
      {HRT_ERROR_TIME_REVERSED, Error{30}},
      {HRT_ERROR_NULL_ARGUMENT, Error::kInvalidParameter},
      {HRT_ERROR_NAME_TAKEN, Error{32}},      // ERR_ALREADY_EXISTS
      {HRT_ERROR_INVALID_HANDLE, Error{33}},  // ERR_DOES_NOT_EXIST
      {HRT_ERROR_BAD_FORMAT, Error{43}},      // ERR_PARSE_ERROR
      {HRT_ERROR_BUSY, Error{44}},
  };
  const auto* found = std::ranges::find(errors, result_, &std::pair<hrt_result, Error>::first);
  return found == std::end(errors) ? Error::kBug : found->second;
}

/** Shows the error of a call, if it failed, and returns its result as an Error of Godot. */
Error PlateNode::report(hrt_result result) {
  ok(result);
  return error();
}

/** Applies the properties and the node's pose to the session, which it creates if needed. Does nothing during a reach
 *  or set-up. Returns false, and shows the error, if properties or pose are not valid. */
bool PlateNode::configure() {
  if (reaching_ || setting_up_) return true;
  hrt_session_config& config = properties_.session;
  if (!read_pose(config.plate.position_m, config.plate.rotation)) {
    engine_.push_error(kNotRigid);
    return false;
  }
  if (plate_pose_ && engine_.node_pose() != *plate_pose_) {
    plate_pose_.reset();
    config.flags &= ~HRT_SESSION_REGISTERED;
  }
  if (!session_.value) {
    if (!ok(hrt_session_create(HRT_VERSION, &config, &session_)) || !take_log()) return false;
  } else if (std::memcmp(&config, &configured_, sizeof config) != 0) {
    if (!ok(hrt_session_set(session_, &config))) return false;
  }
  configured_ = config;
  return true;
}

/** Shows the session's log as warnings, including the lines that the last reach has stored. */
bool PlateNode::take_log() {
  hrt_host host = hrt_host_init();
  host.context = &engine_;
  host.log = [](void* context, uint32_t, const char* text) noexcept {
    static_cast<Engine*>(context)->push_warning(script_names(text).c_str());
  };
  return ok(hrt_host_set_log(session_, &host));
}

/** Shows the error of a sample. Samples are sent in every frame, so each reason is shown once per reach or set-up. */
void PlateNode::report_sample(size_t reason, const char* text) {
  if (!refused_.test(reason)) engine_.push_error(script_names(text).c_str());
  refused_.set(reason);
}

/** Returns whether the plugin accepted a sample. Shows its error once per reach or set-up. */
bool PlateNode::taken(hrt_result result) {
  result_ = result;
  if (result != HRT_OK) report_sample(static_cast<size_t>(-result) % kPoseReason, hrt_last_error());
  return result == HRT_OK;
}

std::string script_names(std::string text) {
  for (size_t at = 0; (at = text.find("hrt_", at)) != std::string::npos; ++at) {
    const size_t end = std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at), text.size());
    const std::string_view call(text.data() + at, end - at);
    const auto found = std::ranges::find(script_names_of_calls, call, &ScriptName::call);
    if (found != script_names_of_calls.end()) text.replace(at, end - at, found->method);
  }
  for (size_t at = 0; (at = text.find("HRT_", at)) != std::string::npos;) text.erase(at, 4);
  return text;
}

bool PlateNode::read_pose(double (&position_m)[3], double (&rotation)[4]) {
  const Pose pose = engine_.node_pose();
  if (plate_pose_ && pose == *plate_pose_) {
    std::ranges::copy(configured_.plate.position_m, position_m);
    std::ranges::copy(configured_.plate.rotation, rotation);
    return true;
  }
  // The tolerance allows for the precision of floats.
  if (!(pose.basis.transpose() * pose.basis).isIdentity(1e-3) || pose.basis.determinant() < 0) {
    result_ = HRT_ERROR_OUT_OF_RANGE;
    return false;
  }
  Vector3::Map(position_m) = pose.origin;
  Eigen::Vector4d::Map(rotation) = Eigen::Quaterniond(pose.basis).normalized().coeffs();
  return true;
}

/** Copies the fields that the plugin has changed in the session's configuration into the properties. Other properties
 *  keep the values that scripts have set since configure(). If the plugin has moved the plate, moves the node too, in
 *  floats; the session keeps its doubles. */
void PlateNode::take_changes() {
  Properties before = properties_, now = properties_;
  before.session = configured_;
  if (!ok(hrt_session_get(session_, &configured_, nullptr))) return;
  now.session = configured_;
  for (const Property& property : properties)
    if (property.get(now) == property.get(before)) property.set(now, get(property));
  properties_ = now;
  const auto &plate = configured_.plate, &last = before.session.plate;
  if (std::ranges::equal(plate.position_m, last.position_m) && std::ranges::equal(plate.rotation, last.rotation))
    return;
  engine_.move_node({Eigen::Quaterniond(plate.rotation).toRotationMatrix(), Vector3(plate.position_m)});
  plate_pose_ = engine_.node_pose();
}

std::string PlateNode::get_version() {
  uint32_t major = 0, minor = 0, patch = 0;
  hrt_get_version(&major, &minor, &patch);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

}  // namespace hrt_godot
