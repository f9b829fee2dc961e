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

  /// `type`: unset for the space of an action. `pose`: pose of the origin in the reference space.
  Space(Session* session, std::optional<XrReferenceSpaceType> type, Pose pose)
      : Object(object_type, session), reference_(type), offset_(std::move(pose)) {}

  Session& session() const { return static_cast<Session&>(*parent()); }

  /// Returns the pose in the world at a time; nullopt for the space of an action, since there are no controllers.
  std::optional<Pose> in_world(XrTime time) const;

  /// True for a reference space other than VIEW: positions in it are inferred, not tracked, while the head is lost.
  bool is_fixed_to_room() const;
  bool head_is_tracked() const;

 private:
  std::optional<XrReferenceSpaceType> reference_;
  Pose offset_;
};

/// Returns the space of a handle. Throws XR_ERROR_VALIDATION_FAILURE if the space belongs to another session.
Space& space_of(const Session& session, XrSpace handle);

void require_hand(XrHandEXT hand);

class HandTracker : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_HAND_TRACKER_EXT;
  HandTracker(Session* session, XrHandEXT side) : Object(object_type, session), hand(side) {}
  Session& session() const { return static_cast<Session&>(*parent()); }

  XrHandEXT hand;
};

}  // namespace hrt::mock
