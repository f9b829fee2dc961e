// What an application was given by a runtime, as the layer in ../capture notes it.
//
// Records are JSON arrays in the order in which things were given; numbers of sessions count from 1 over the
// process, and spaces from 0 in the order of their records. A pose is [x, y, z, w, position x, y, z].
//
//   ["instance", runtime name, version, [extensions enabled]]
//   ["system", name, has hand tracking]
//   ["failed", session, function, its how-many-th call of the session, result]
//   ["reference_space", type, pose]
//   ["spaces", session, [types of reference spaces]]
//   ["call", session, "begin", "exit" or "end"]
//   ["frame", session, predicted display time, period, should render]
//   ["converted", session, time]
//   ["event", session, calls before it, frames since the latest of these, kind, ...]
//   ["joints", session, time, hand, base space, active, 0,
//      [flags, pose, radius of each], [velocities]]
//   ["located", session, time, space, base space, flags, pose, velocity flags, [linear, angular]]
//   ["views", session, time, base space, flags, [pose, field of view of each]]
//   ["plate", session, time, orientation]
//   ["truth", session, present, hand, [directions and weight], [index tip], done]
//
// "present" is the latest frame time, or time of the machine's clock, that the application had been given.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "samples/mock_runtime/calls/faults.h"

namespace hrt::mock {

/// In order of time; what was given for the same time several times, in the order in which it was.
template <typename Value>
using Stream = std::multimap<XrTime, Value>;

/// A space as an application makes it.
struct SpaceName {
  static constexpr XrReferenceSpaceType of_action = XR_REFERENCE_SPACE_TYPE_MAX_ENUM;

  XrReferenceSpaceType reference = of_action;
  XrPosef pose{};  ///< in the reference space or the action's

  bool operator==(const SpaceName& other) const {
    const auto numbers = [](const XrPosef& p) {
      return std::array{p.orientation.x, p.orientation.y, p.orientation.z, p.orientation.w,
                        p.position.x,    p.position.y,    p.position.z};
    };
    return reference == other.reference && numbers(pose) == numbers(other.pose);
  }
};

struct RecordedJoints {
  bool active;
  std::vector<XrHandJointLocationEXT> locations;
  std::vector<XrHandJointVelocityEXT> velocities;  ///< empty: not asked for
};
struct RecordedLocation {
  XrSpaceLocationFlags flags;
  XrPosef pose;
  XrSpaceVelocityFlags velocity_flags;
  XrVector3f linear;
  XrVector3f angular;
};
struct RecordedViews {
  XrViewStateFlags flags;
  std::vector<XrView> views;
};
struct RecordedFrame {
  XrTime time;
  XrDuration period;
  bool should_render;
};
struct RecordedEvent {
  std::size_t calls;         ///< StateCalls before it
  std::size_t frames;        ///< since the latest of these
  XrEventDataBuffer buffer;  ///< without a session's handle
};
struct RecordedTruth {
  std::array<double, 6> numbers;
  XrVector3f index_tip;
  bool done;
};

/// Calls that change the state of a session.
enum class StateCall { begin, exit, end };

struct RecordedSession {
  std::optional<std::vector<XrReferenceSpaceType>> spaces;
  std::vector<StateCall> calls;
  std::vector<RecordedFrame> frames;
  std::vector<XrTime> converted;
  std::vector<RecordedEvent> events;
  std::map<std::pair<int, std::size_t>, Stream<RecordedJoints>> joints;               ///< hand, base
  std::map<std::pair<std::size_t, std::size_t>, Stream<RecordedLocation>> locations;  ///< space, base
  std::map<std::size_t, Stream<RecordedViews>> views;                                 ///< base
  Stream<double> plate_deg;
  std::map<int, Stream<RecordedTruth>> truths;  ///< by hand
};

struct Recording {
  std::string runtime = "unknown";
  XrVersion version = 0;
  std::set<std::string> extensions;  ///< that the application enabled
  std::string system = "unknown";
  bool hand_tracking = true;
  std::vector<SpaceName> spaces;
  std::vector<RecordedSession> sessions;  ///< the first is number 1
  std::vector<CallFault> failures;

  /// Adds the next record. Throws an Error that names it.
  void add(const nlohmann::json& record);

 private:
  RecordedSession& session(std::uint64_t number, const std::string& where);
  std::size_t records_ = 0;
};

}  // namespace hrt::mock
