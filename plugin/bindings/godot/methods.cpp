// The table of the class: what scripts call, with what.
#include "plate_node.h"

namespace hrt_godot {
namespace {

constexpr Signal kSignals[] = {kPlateCommanded, kFlagsChanged, kReachEnded, kSetupStep, kSetupFinished};

constexpr Argument kPolarTarget[] = {
    {"name", Type::kString}, {"direction_deg", Type::kReal}, {"distance_m", Type::kReal}};
constexpr Argument kPlacedTarget[] = {{"name", Type::kString}, {"world_position", Type::kVector3}};
constexpr Argument kTarget[] = {{"target", Type::kInt}};
constexpr Argument kTargetAndPlace[] = {{"target", Type::kInt}, {"world_position", Type::kVector3}};
constexpr Argument kPair[] = {{"real_target", Type::kInt}, {"virtual_target", Type::kInt}};
constexpr Argument kVirtualTarget[] = {{"virtual_target", Type::kInt}};
constexpr Argument kPairAndPlate[] = {
    {"real_target", Type::kInt}, {"virtual_target", Type::kInt}, {"plate_orientation_deg", Type::kReal}};
constexpr Argument kPairAndDuration[] = {
    {"real_target", Type::kInt}, {"virtual_target", Type::kInt}, {"duration_s", Type::kReal}};
constexpr Argument kFinger[] = {{"world_position", Type::kVector3}, {"time_ns", Type::kInt}};
constexpr Argument kTime[] = {{"time_ns", Type::kInt}};
constexpr Argument kSample[] = {{"flags", Type::kInt},
                                {"time_ns", Type::kInt},
                                {"finger_direction_deg", Type::kReal},
                                {"finger_x_m", Type::kReal},
                                {"finger_y_m", Type::kReal},
                                {"finger_z_m", Type::kReal},
                                {"plate_orientation_deg", Type::kReal}};
constexpr Argument kConditions[] = {
    {"plate", Type::kString}, {"tracker", Type::kString}, {"time_s", Type::kInt}};
constexpr Argument kPlate[] = {{"plate_orientation_deg", Type::kReal}};
constexpr Argument kExclusive[] = {{"exclusive", Type::kBool}};
constexpr Argument kName[] = {{"name", Type::kString}};
constexpr Argument kJoint[] = {{"joint", Type::kPose}, {"time_ns", Type::kInt}};
constexpr Argument kWhat[] = {{"what", Type::kInt}};
constexpr Argument kPerson[] = {{"virtual_target", Type::kInt}, {"seed", Type::kInt}};
constexpr Argument kDevice[] = {{"device", Type::kString}};
constexpr Argument kOrientation[] = {{"orientation_deg", Type::kReal}};
constexpr Argument kJson[] = {{"json", Type::kString}};
constexpr Argument kPath[] = {{"path", Type::kString}};

const Method kMethods[] = {
    {"add_real_target", Type::kInt, kNoTarget, kPolarTarget, &PlateNode::add_real_target},
    {"add_virtual_target", Type::kInt, kNoTarget, kPolarTarget, &PlateNode::add_virtual_target},
    {"add_real_target_at", Type::kInt, kNoTarget, kPlacedTarget, &PlateNode::add_real_target_at},
    {"add_virtual_target_at", Type::kInt, kNoTarget, kPlacedTarget, &PlateNode::add_virtual_target_at},
    {"move_target_to", Type::kInt, kErrInvalidParameter, kTargetAndPlace, &PlateNode::move_target_to},
    {"remove_target", Type::kInt, kErrInvalidParameter, kTarget, &PlateNode::remove_target},
    {"begin", Type::kInt, kErrInvalidParameter, kPair, &PlateNode::begin},
    {"begin_with_plate_at", Type::kInt, kErrInvalidParameter, kPairAndPlate, &PlateNode::begin_with_plate_at},
    {"begin_for", Type::kInt, kErrInvalidParameter, kPairAndDuration, &PlateNode::begin_for},
    {"update", Type::kInt, kErrInvalidParameter, kFinger, &PlateNode::update},
    {"update_joint", Type::kInt, kErrInvalidParameter, kJoint, &PlateNode::update_joint},
    {"update_lost", Type::kInt, kErrInvalidParameter, kTime, &PlateNode::update_lost},
    {"update_sample", Type::kInt, kErrInvalidParameter, kSample, &PlateNode::update_sample},
    {"retarget", Type::kInt, kErrInvalidParameter, kPair, &PlateNode::retarget},
    {"cancel", Type::kInt, kErrInvalidParameter, {}, &PlateNode::cancel},
    {"end", Type::kInt, kErrInvalidParameter, {}, &PlateNode::end},
    {"is_reaching", Type::kBool, false, {}, &PlateNode::is_reaching},
    {"get_command", Type::kRecord, Record{}, {}, &PlateNode::get_command},
    {"get_summary", Type::kRecord, Record{}, {}, &PlateNode::get_summary},
    {"get_gap", Type::kRecord, Record{}, kPair, &PlateNode::get_gap},
    {"assign_targets", Type::kInt, kErrInvalidParameter, kExclusive, &PlateNode::assign_targets},
    {"get_assigned", Type::kRecord, Record{}, kVirtualTarget, &PlateNode::get_assigned},
    {"load_scene", Type::kInt, kErrInvalidParameter, kPath, &PlateNode::load_scene},
    {"find_target", Type::kInt, kNoTarget, kName, &PlateNode::find_target},
    {"begin_setup", Type::kInt, kErrInvalidParameter, kWhat, &PlateNode::begin_setup},
    {"finish_setup", Type::kRecord, Record{}, {}, &PlateNode::finish_setup},
    {"cancel_setup", Type::kInt, kErrInvalidParameter, {}, &PlateNode::cancel_setup},
    {"is_setting_up", Type::kBool, false, {}, &PlateNode::is_setting_up},
    {"begin_simulated_finger", Type::kInt, kErrInvalidParameter, kPerson, &PlateNode::begin_simulated_finger},
    {"update_simulated_finger", Type::kVector3, kNowhere, kTime, &PlateNode::update_simulated_finger},
    {"load_profile", Type::kInt, kErrInvalidParameter, kJson, &PlateNode::load_profile},
    {"save_profile", Type::kString, std::string(), {}, &PlateNode::save_profile},
    {"set_conditions", Type::kInt, kErrInvalidParameter, kConditions, &PlateNode::set_conditions},
    {"get_conditions", Type::kRecord, Record{}, {}, &PlateNode::get_conditions},
    {"start_recording", Type::kInt, kErrInvalidParameter, kPath, &PlateNode::start_recording},
    {"get_recording_status", Type::kRecord, Record{}, {}, &PlateNode::get_recording_status},
    {"stop_recording", Type::kInt, kErrInvalidParameter, {}, &PlateNode::stop_recording},
    {"open_device", Type::kInt, kErrInvalidParameter, kDevice, &PlateNode::open_device},
    {"turn_device", Type::kInt, kErrInvalidParameter, kOrientation, &PlateNode::turn_device},
    {"stop_device", Type::kInt, kErrInvalidParameter, {}, &PlateNode::stop_device},
    {"get_device_report", Type::kRecord, Record{}, {}, &PlateNode::get_device_report},
    {"close_device", Type::kInt, kErrInvalidParameter, {}, &PlateNode::close_device},
    {"get_version", Type::kString, std::string(), {}, &PlateNode::get_version},
};

}  // namespace

std::span<const Signal> signals() {
  return kSignals;
}
std::span<const Method> methods() {
  return kMethods;
}

}  // namespace hrt_godot
