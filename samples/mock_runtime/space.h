#pragma once

#include <openxr/openxr.h>

#include <optional>

#include "samples/mock_runtime/session.h"

namespace hrt::mock {

class Space : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SPACE;

  Space(Session* session, XrReferenceSpaceType type, const Pose& pose)
      : Object(object_type, session), reference(type), offset(pose) {}

  Session& session() const { return static_cast<Session&>(*parent()); }

  /// Where the space's origin is in the world at a time; nothing while it is not tracked.
  std::optional<Pose> in_world(XrTime time) const;

  XrReferenceSpaceType reference;
  Pose offset;
};

/// Where `space` is in `base`: nothing while one of them is not tracked, but for a space in itself.
std::optional<Pose> locate(const Space& space, const Space& base, XrTime time);

}  // namespace hrt::mock
