#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <utility>
#include <variant>

#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {

class Space : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SPACE;

  /// The origin: a reference space, or a pose action.
  struct ActionOrigin {
    std::uint64_t action;  ///< its id
    XrPath subaction;
  };
  using Origin = std::variant<XrReferenceSpaceType, ActionOrigin>;

  Space(Session* session, const Origin& of, SpaceName as_made, Pose pose)
      : Object(object_type, session), origin(of), name(std::move(as_made)), offset(std::move(pose)) {}

  Session& session() const { return static_cast<Session&>(*parent()); }

  /// In the world at a time; none while not tracked.
  std::optional<Motion> motion(XrTime time) const;
  std::optional<Pose> in_world(XrTime time) const;

  /// A reference space other than VIEW. What the headset sees or is has guessed positions in it while the
  /// headset has lost track.
  bool stands_in_room() const;
  bool can_see_room() const;

  Origin origin;
  SpaceName name;  ///< as a recording has it
  Pose offset;
};

class HandTracker : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_HAND_TRACKER_EXT;
  HandTracker(Session* session, XrHandEXT side) : Object(object_type, session), hand(side) {}
  Session& session() const { return static_cast<Session&>(*parent()); }

  XrHandEXT hand;
};

}  // namespace hrt::mock
