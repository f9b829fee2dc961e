#include "samples/mock_runtime/world/world.h"

#include <algorithm>

#include "core/math/elementary.h"
#include "core/simulation/random.h"

namespace hrt::mock {
namespace {

constexpr double eye_height_m = 1.2;

// Position of the right elbow from the plate's centre: to the right, and towards the user. The left elbow mirrors it.
constexpr double elbow_right_m = 0.10;
constexpr double elbow_back_m = 0.45;
// Pitch of the hand; negative: it points down.
constexpr double hand_pitch_deg = -20.0;

Eigen::Quaterniond hand_orientation(double yaw_deg) {
  return rotation(yaw_deg, Eigen::Vector3d::UnitY()) * rotation(hand_pitch_deg, Eigen::Vector3d::UnitX());
}

// State of a hand that has neither a path nor a reach.
HandState resting_hand(XrHandEXT side) {
  const double right_m = side == XR_HAND_LEFT_EXT ? -0.15 : 0.15;
  return {local_space_in_world() * Eigen::Vector3d(right_m, -0.40, -0.35), hand_orientation(0.0)};
}

}  // namespace

Pose local_space_in_world() { return {Eigen::Quaterniond::Identity(), {0.0, eye_height_m, 0.0}}; }

void Origins::recenter(XrReferenceSpaceType type, XrTime change, const Pose& pose) {
  auto& changes = type == XR_REFERENCE_SPACE_TYPE_STAGE ? stage_ : local_;
  const Pose before = in_world(type, change);
  std::erase_if(changes, [&](const Change& later) { return later.time >= change; });
  changes.push_back({change, before * pose});
}

Pose Origins::latest(const std::vector<Change>& changes, const Pose& first, XrTime time) const {
  const auto after = std::upper_bound(changes.begin(), changes.end(), time,
                                      [](XrTime t, const Change& change) { return t < change.time; });
  return after == changes.begin() ? first : std::prev(after)->in_world;
}

Pose Origins::in_world(XrReferenceSpaceType type, XrTime time) const {
  Pose stage = latest(stage_, {}, time);
  if (type == XR_REFERENCE_SPACE_TYPE_STAGE) return stage;
  Pose local = latest(local_, local_space_in_world(), time);
  if (type != XR_REFERENCE_SPACE_TYPE_LOCAL) local.position_m.y() = stage.position_m.y();
  return local;
}

Eigen::Quaterniond resting_hand_orientation() { return hand_orientation(0.0); }

World::World(const WorldSettings& settings, XrTime start)
    : settings_(settings), servo_(settings.servo, 0.0), start_(start), now_(start) {
  servo_.advance(start);
  for (const XrHandEXT side : {XR_HAND_LEFT_EXT, XR_HAND_RIGHT_EXT}) at(side).tracked = settings_of(side).tracked;
  if (settings_.plate)
    place_plate({settings_.plate->pose.orientation, local_space_in_world() * settings_.plate->pose.position_m});
}

void World::set_seed(std::uint64_t seed, std::uint32_t next_reach) {
  settings_.seed = seed;
  reaches_ = next_reach;
}

void World::instruct(XrHandEXT side, const ReachInstruction& instruction, double height_m, XrTime now) {
  const auto number = static_cast<std::uint32_t>(reaches_ % settings_.participants.size());
  Hand& hand = at(side);
  hand.tracked = true;
  hand.height_m = height_m;
  hand.reach.emplace(draw(settings_.participants[number], settings_.seed, number), instruction, settings_.seed,
                     reaches_, now);
  ++reaches_;
}

const Reach* World::reach(XrHandEXT side) const {
  const Hand& hand = at(side);
  return hand.reach ? &*hand.reach : nullptr;
}

Eigen::Vector3d World::true_index_tip_m(XrHandEXT side) const {
  const Hand& hand = at(side);
  const Eigen::Vector2d tip_m = hand.reach->position_m(now_, servo_);
  return {tip_m.x(), hand.height_m, tip_m.y()};
}

void World::freeze(XrHandEXT side, bool frozen) { at(side).frozen_at = frozen ? std::optional(now_) : std::nullopt; }

void World::advance(XrTime now) {
  now_ = now;
  for (const XrHandEXT side : {XR_HAND_LEFT_EXT, XR_HAND_RIGHT_EXT}) {
    if (std::optional<Reach>& reach = at(side).reach; reach && !reach->done()) reach->advance(now, servo_);
    start_slide_if_due(side);
  }
  servo_.advance(now);
}

void World::start_slide_if_due(XrHandEXT side) {
  const std::optional<SlideSettings>& slides = settings_of(side).slides;
  const Reach* latest = reach(side);
  if (!slides || !plate_is_placed()) return;
  if (latest != nullptr && (!latest->done() || now_ - latest->ended() < slides->rest_ns)) return;
  instruct(side, {{slides->start_m.x(), slides->start_m.z()}, slides->direction_deg, slides->length_m},
           slides->start_m.y(), now_);
}

std::optional<HandState> World::hand(XrHandEXT side, XrTime time) const {
  const Hand& hand = at(side);
  if (!hand.tracked || hand.lost) return std::nullopt;
  XrTime sampled = hand.frozen_at.value_or(time) - settings_.tracker.latency_ns;
  if (settings_.tracker.period_ns > 0) sampled -= sampled % settings_.tracker.period_ns;
  HandState state = hand.reach ? sliding_hand(hand, side, sampled) : hand_on_path(side, sampled);
  state.index_tip_m += tracker_noise_m(side, sampled) + hand.jump_m;
  if (hand.rotation_lost) state.orientation.coeffs().setZero();
  return state;
}

HandState World::hand_on_path(XrHandEXT side, XrTime time) const {
  const HandSettings& settings = settings_of(side);
  if (settings.path.empty()) return resting_hand(side);
  const Pose pose = pose_at(settings.path, time - start_);
  return {local_space_in_world() * pose.position_m, pose.orientation};
}

Pose World::head(XrTime time) const {
  if (settings_.head.empty()) return local_space_in_world();
  Pose head = pose_at(settings_.head, head_lost_at_.value_or(time) - start_);
  head.position_m = local_space_in_world() * head.position_m;  // the axes of LOCAL are initially those of the world
  return head;
}

HandState World::sliding_hand(const Hand& hand, XrHandEXT side, XrTime time) const {
  const Eigen::Vector2d tip_m = hand.reach->position_m(time, servo_);
  // The hand points from the elbow to the fingertip, since the forearm rotates about the elbow.
  const Eigen::Vector2d elbow_m(side == XR_HAND_LEFT_EXT ? -elbow_right_m : elbow_right_m, elbow_back_m);
  const Eigen::Vector2d arm_m = tip_m - elbow_m;
  const double yaw_deg = atan2_deg(-arm_m.x(), -arm_m.y());
  return {*plate_ * Eigen::Vector3d(tip_m.x(), hand.height_m, tip_m.y()),
          plate_->orientation * hand_orientation(yaw_deg)};
}

Eigen::Vector3d World::tracker_noise_m(XrHandEXT side, XrTime time) const {
  if (settings_.tracker.noise_m == 0.0) return Eigen::Vector3d::Zero();
  const auto condition = static_cast<std::uint32_t>(side) * 3;
  const auto high = static_cast<std::uint32_t>(time >> 32);
  const auto low = static_cast<std::uint32_t>(time);
  const auto draw = [&](std::uint32_t axis) {
    return settings_.tracker.noise_m * standard_normal({settings_.seed, condition + axis, high, low});
  };
  return {draw(0), draw(1), draw(2)};
}

}  // namespace hrt::mock
