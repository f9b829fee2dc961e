// Where the runtime moves the origins of its reference spaces, as its user recentres the view
// (XrEventDataReferenceSpaceChangePending). What stands still in the room then has another pose in them.
#pragma once

#include <openxr/openxr.h>

#include <map>
#include <vector>

namespace hrt::reach {

/// Of one run, across its sessions. One thread.
class SpaceMotion {
 public:
  /// A change that is to come.
  void announce(const XrEventDataReferenceSpaceChangePending& change);

  enum class Change { none, moved, unknown };
  /// Makes the announced changes of this space that hold at `time`. `unknown`: the runtime moved its origin
  /// and did not report where to; the coordinates of the space then begin anew.
  Change advance(XrReferenceSpaceType space, XrTime time);

  /// The pose now of what stood at `pose_at_first` in the coordinates that the space had at first.
  XrPosef now(XrReferenceSpaceType space, const XrPosef& pose_at_first) const;

 private:
  std::vector<XrEventDataReferenceSpaceChangePending> pending_;
  std::map<XrReferenceSpaceType, XrPosef> first_;  // the first coordinates' origin, in the present ones
};

}  // namespace hrt::reach
