#include "samples/mock_runtime/playback/player.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

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
    if (event.buffer.type != XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING)
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

std::size_t Player::number_of(const SpaceName& space) const {
  const auto& spaces = recording_->spaces;
  return static_cast<std::size_t>(std::find(spaces.begin(), spaces.end(), space) - spaces.begin());
}

template <typename Map>
auto Player::read_of(const Map& streams, const typename Map::key_type& key, XrTime time) {
  using Value = typename Map::mapped_type::mapped_type;
  const auto found = streams.find(key);
  return found == streams.end() ? std::optional<Value>() : std::optional<Value>(read(found->second, time));
}

RecordedJoints Player::joints(XrHandEXT hand, const SpaceName& base, XrTime time) {
  return read_of(session_.joints, {hand, number_of(base)}, time).value_or(RecordedJoints{});
}

RecordedLocation Player::location(const SpaceName& space, const SpaceName& base, XrTime time) {
  const RecordedLocation unknown{.pose = to_xr(Pose{})};
  return read_of(session_.locations, {number_of(space), number_of(base)}, time).value_or(unknown);
}

RecordedViews Player::views(const SpaceName& base, XrTime time) {
  return read_of(session_.views, number_of(base), time).value_or(RecordedViews{});
}

std::optional<double> Player::plate_deg(XrTime time) {
  if (session_.plate_deg.empty()) return std::nullopt;
  return read(session_.plate_deg, time);
}

std::optional<RecordedTruth> Player::truth(XrHandEXT hand) { return read_of(session_.truths, int{hand}, present_); }

}  // namespace hrt::mock
