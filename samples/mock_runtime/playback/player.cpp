#include "samples/mock_runtime/playback/player.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {
namespace {

const RecordedSession nothing_recorded{};

const RecordedSession& session_of(const Recording& recording, std::uint64_t number) {
  if (recording.sessions.empty()) return nothing_recorded;
  return recording.sessions[std::min<std::uint64_t>(number, recording.sessions.size()) - 1];
}

std::uint64_t distance(XrTime a, XrTime b) {
  return a < b ? static_cast<std::uint64_t>(b) - static_cast<std::uint64_t>(a)
               : static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b);
}

// Of a stream that is not empty.
template <typename Value>
XrTime nearest_time(const Stream<Value>& stream, XrTime time) {
  const auto after = stream.lower_bound(time);
  if (after == stream.end()) return stream.rbegin()->first;
  if (after == stream.begin()) return after->first;
  const XrTime before = std::prev(after)->first;
  return distance(before, time) <= distance(after->first, time) ? before : after->first;
}

// To the last bit.
bool same(const XrPosef& a, const XrPosef& b) {
  using Bits = std::array<std::uint32_t, 7>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

Pose pose_of(const XrPosef& pose) { return {from_xr(pose.orientation).normalized(), from_xr(pose.position)}; }

// From the base in which something was recorded to the one in which it is wanted, both of one origin.
Pose between_bases(const SpaceName& recorded, const SpaceName& wanted) {
  return inverse(pose_of(wanted.pose)) * pose_of(recorded.pose);
}

XrPosef moved(const Pose& by, const XrPosef& pose) { return to_xr(by * pose_of(pose)); }

XrVector3f turned(const Pose& by, const XrVector3f& vector) {
  return to_xr(Eigen::Vector3d(by.orientation * from_xr(vector)));
}

// Of the streams that fit, the one that has the nearest sample; of equally near ones, one that was recorded
// in just the spaces that are wanted.
template <typename Map, typename Fits, typename Exact>
auto choose(const Map& streams, XrTime time, Fits fits, Exact exact) {
  auto best = streams.end();
  std::uint64_t min = std::numeric_limits<std::uint64_t>::max();
  for (auto each = streams.begin(); each != streams.end(); ++each) {
    if (!fits(each->first)) continue;
    const std::uint64_t away = distance(nearest_time(each->second, time), time);
    if (best != streams.end() && (away > min || (away == min && !exact(each->first)))) continue;
    best = each;
    min = away;
  }
  return best;
}

}  // namespace

Player::Player(std::shared_ptr<const Recording> recording, std::uint64_t number)
    : recording_(std::move(recording)), session_(session_of(*recording_, number)) {
  for (const RecordedEvent& event : session_.events)
    has_states_ = has_states_ || event.buffer.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
  followed_ = has_states_;
}

template <typename Value>
const Value& Player::read(const Stream<Value>& stream, XrTime time) {
  const auto [first, past] = stream.equal_range(nearest_time(stream, time));
  // Asked for again, a time gives what it gave then.
  const auto [cursor, is_new] = cursors_.try_emplace(&stream, Cursor{time, 0});
  Cursor& at = cursor->second;
  if (!is_new) at.index = at.asked == time ? std::min(at.index + 1, std::distance(first, past) - 1) : 0;
  at.asked = time;
  return std::next(first, at.index)->second;
}

bool Player::follow(StateCall call) {
  followed_ = followed_ && calls_ < session_.calls.size() && session_.calls[calls_] == call;
  ++calls_;
  frames_since_ = 0;
  return followed_;
}

std::vector<XrEventDataBuffer> Player::take_events(XrSession session) {
  std::vector<XrEventDataBuffer> due;
  for (; followed_ && events_ < session_.events.size(); ++events_) {
    const RecordedEvent& event = session_.events[events_];
    if (calls_ < event.calls || (calls_ == event.calls && frames_since_ < event.frames)) break;
    due.push_back(event.buffer);
    // Events that name a session have it behind `next`.
    if (event.buffer.type != XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING &&
        event.buffer.type != XR_TYPE_EVENT_DATA_EVENTS_LOST)
      std::memcpy(reinterpret_cast<char*>(&due.back()) + offsetof(XrEventDataSessionStateChanged, session),
                  static_cast<const void*>(&session), sizeof session);
  }
  return due;
}

XrDuration Player::pace() const {
  constexpr XrDuration hour = 3'600'000'000'000;
  return std::clamp<XrDuration>(last_frame_.period, 1, hour);
}

std::optional<XrTime> Player::next_frame_start(XrTime now) {
  if (session_.frames.empty()) return std::nullopt;
  if (!began_) began_ = now;
  const RecordedFrame& first = session_.frames.front();
  if (frames_ >= session_.frames.size() || first.time <= 0) return now + pace();
  return *began_ + (session_.frames[frames_].time - first.time);
}

RecordedFrame Player::next_frame() {
  if (frames_ < session_.frames.size()) {
    last_frame_ = session_.frames[frames_];
  } else if (last_frame_.time > 0) {
    last_frame_.time += pace();
  }
  ++frames_;
  ++frames_since_;
  if (last_frame_.time > 0) present_ = last_frame_.time;
  return last_frame_;
}

std::optional<XrTime> Player::next_converted() {
  if (session_.converted.empty()) return std::nullopt;
  if (converted_ < session_.converted.size()) return present_ = session_.converted[converted_++];
  constexpr XrDuration own_pace = 11'111'111;
  return present_ += own_pace;
}

RecordedJoints Player::joints(XrHandEXT hand, const SpaceName& base, XrTime time) {
  const auto& spaces = recording_->spaces;
  const auto found = choose(
      session_.joints, time, [&](const auto& key) { return key.first == hand && spaces[key.second].same_origin(base); },
      [&](const auto& key) { return same(spaces[key.second].pose, base.pose); });
  if (found == session_.joints.end()) return {false, {}, {}};
  RecordedJoints joints = read(found->second, time);
  const SpaceName& recorded = spaces[found->first.second];
  if (same(recorded.pose, base.pose)) return joints;
  const Pose by = between_bases(recorded, base);
  for (XrHandJointLocationEXT& joint : joints.locations)
    if (joint.locationFlags != 0) joint.pose = moved(by, joint.pose);
  for (XrHandJointVelocityEXT& joint : joints.velocities) {
    joint.linearVelocity = turned(by, joint.linearVelocity);
    joint.angularVelocity = turned(by, joint.angularVelocity);
  }
  return joints;
}

RecordedLocation Player::location(const SpaceName& space, const SpaceName& base, XrTime time) {
  const auto& spaces = recording_->spaces;
  const auto is = [&](const auto& key) {
    return same(spaces[key.first].pose, space.pose) && same(spaces[key.second].pose, base.pose);
  };
  const auto found = choose(
      session_.locations, time,
      [&](const auto& key) { return spaces[key.first].same_origin(space) && spaces[key.second].same_origin(base); },
      is);
  if (found == session_.locations.end()) {
    RecordedLocation unknown{};
    unknown.pose.orientation.w = 1.0F;
    return unknown;
  }
  RecordedLocation location = read(found->second, time);
  if (location.flags == 0 || is(found->first)) return location;
  const Pose by = between_bases(spaces[found->first.second], base);
  const Pose offset = inverse(pose_of(spaces[found->first.first].pose)) * pose_of(space.pose);
  const Motion motion = Motion{pose_of(location.pose), from_xr(location.linear), from_xr(location.angular)} * offset;
  location.pose = to_xr(by * motion.pose);
  location.linear = to_xr(Eigen::Vector3d(by.orientation * motion.velocity_m_per_s));
  location.angular = to_xr(Eigen::Vector3d(by.orientation * motion.angular_velocity_rad_per_s));
  return location;
}

RecordedViews Player::views(const SpaceName& base, XrTime time) {
  const auto& spaces = recording_->spaces;
  const auto found = choose(
      session_.views, time, [&](std::size_t in) { return spaces[in].same_origin(base); },
      [&](std::size_t in) { return same(spaces[in].pose, base.pose); });
  if (found == session_.views.end()) return {0, {}};
  RecordedViews views = read(found->second, time);
  if (same(spaces[found->first].pose, base.pose)) return views;
  const Pose by = between_bases(spaces[found->first], base);
  for (XrView& view : views.views) view.pose = moved(by, view.pose);
  return views;
}

std::optional<double> Player::plate_deg(XrTime time) {
  if (session_.plate_deg.empty()) return std::nullopt;
  return read(session_.plate_deg, time);
}

std::optional<RecordedTruth> Player::truth(XrHandEXT hand) {
  const auto found = session_.truths.find(int{hand});
  if (found == session_.truths.end()) return std::nullopt;
  return read(found->second, present_);
}

}  // namespace hrt::mock
