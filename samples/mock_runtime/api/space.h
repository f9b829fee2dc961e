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

  /// What a space is attached to: a reference space, or the pose action that drives it.
  struct ActionOrigin {
    std::uint64_t action;  ///< its id
    XrPath subaction;
  };
  using Origin = std::variant<XrReferenceSpaceType, ActionOrigin>;

  Space(Session* session, const Origin& of, Pose pose)
      : Object(object_type, session), origin(of), offset(std::move(pose)) {}

  Session& session() const { return static_cast<Session&>(*parent()); }

  /// Where the space is in the world at a time; nothing while it is not tracked.
  std::optional<Pose> in_world(XrTime time) const;

  Origin origin;
  Pose offset;
};

/// Where `space` is in `base`: nothing while one of them is not tracked.
std::optional<Pose> locate(const Space& space, const Space& base, XrTime time);

}  // namespace hrt::mock
