#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <utility>

#include "samples/mock_runtime/api/session.h"

namespace hrt::mock {

inline constexpr XrSpaceLocationFlags position_inferred = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT |
                                                          XR_SPACE_LOCATION_POSITION_VALID_BIT |
                                                          XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
inline constexpr XrSpaceLocationFlags all_location_flags = position_inferred | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

class Space : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SPACE;

  /// `of`: unset for the space of an action.
  Space(Session* session, std::optional<XrReferenceSpaceType> of, Pose at)
      : Object(object_type, session), reference_(of), offset_(std::move(at)) {}

  Session& session() const { return static_cast<Session&>(*parent()); }

  /// World pose at a time; unset for the space of an action, since there are no controllers.
  std::optional<Pose> in_world(XrTime time) const;

  /// True for a reference space other than VIEW. Positions in it are inferred while the headset is not tracked.
  bool is_in_room() const;
  bool can_see_room() const;

 private:
  std::optional<XrReferenceSpaceType> reference_;
  Pose offset_;
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
