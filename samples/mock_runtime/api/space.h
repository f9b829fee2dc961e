#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <utility>

#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {

class Space : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SPACE;

  Space(Session* session, SpaceName of, Pose pose, std::uint64_t of_action = 0, XrPath of_subaction = XR_NULL_PATH)
      : Object(object_type, session),
        name(std::move(of)),
        offset(std::move(pose)),
        action(of_action),
        subaction(of_subaction) {}

  Session& session() const { return static_cast<Session&>(*parent()); }

  /// In the world at a time; none while not tracked.
  std::optional<Motion> motion(XrTime time) const;
  std::optional<Pose> in_world(XrTime time) const;

  /// A reference space other than VIEW. What the headset sees or is has guessed positions in it while the
  /// headset has lost track.
  bool stands_in_room() const;
  bool can_see_room() const;

  SpaceName name;  ///< as a recording has it
  Pose offset;
  std::uint64_t action;  ///< id of the pose action; 0: a reference space
  XrPath subaction;
};

/// The space of a handle. Throws XR_ERROR_VALIDATION_FAILURE if it is of another session.
Space& space_of(const Session& session, XrSpace handle);

class HandTracker : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_HAND_TRACKER_EXT;
  HandTracker(Session* session, XrHandEXT side) : Object(object_type, session), hand(side) {}
  Session& session() const { return static_cast<Session&>(*parent()); }

  XrHandEXT hand;
};

}  // namespace hrt::mock
