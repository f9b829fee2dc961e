// A headless OpenXR session with two hand trackers. Locates fingertips in plate coordinates, also after recentring.
#pragma once

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "samples/app/xr/runtime.h"

namespace hrt::app {

enum class Hand { left = 0, right = 1 };

/// Name and space type of XR_EXT_local_floor, as in Khronos' registry. The header of Debian 12 lacks them.
inline constexpr const char* local_floor_extension = "XR_EXT_local_floor";
inline constexpr auto local_floor_space = static_cast<XrReferenceSpaceType>(1000426000);

const char* name_of(XrReferenceSpaceType space);

/// The tip joint of an index finger, or a contact with a touch frame. Position and rotation are valid if `tracked`.
struct Fingertip {
  bool tracked = false;
  std::array<double, 3> position_m{};  ///< in plate coordinates
  /// Rotation from the joint's axes to the plate's, quaternion x, y, z, w; unset if the runtime does not report it.
  std::optional<std::array<double, 4>> rotation;
  bool lifted = false;  ///< the finger does not touch the touch frame; a hand above the plate is `tracked`
};

/// Motion of the runtime's reference spaces when the user recentres the view (XrEventDataReferenceSpaceChangePending):
/// objects at rest in the room then have other coordinates. Serves all sessions of a run. For use by one thread.
class SpaceMotion {
 public:
  /// Queues a change that takes effect later.
  void announce(const XrEventDataReferenceSpaceChangePending& change);

  enum class Change { none, moved, unknown };
  /// Applies the announced changes of this space that are in effect at `time`. Returns `unknown` if the runtime moved
  /// the origin without reporting its new pose; the present coordinates then become the initial ones.
  Change advance(XrReferenceSpaceType space, XrTime time);

  /// Present pose of an object whose pose was `pose_at_first` in the initial coordinates of the space.
  XrPosef now(XrReferenceSpaceType space, const XrPosef& pose_at_first) const;

 private:
  std::vector<XrEventDataReferenceSpaceChangePending> pending_;
  std::map<XrReferenceSpaceType, XrPosef> first_;  // pose of the initial origin in present coordinates
};

/// One session from IDLE to its end. For use by one thread.
class XrHeadlessSession {
 public:
  /// `motion` keeps the motion of the spaces across sessions. `limit` bounds each wait. Throws XrFailure.
  XrHeadlessSession(XrRuntime& runtime, SpaceMotion& motion, std::chrono::milliseconds limit);
  ~XrHeadlessSession();
  XrHeadlessSession(const XrHeadlessSession&) = delete;
  XrHeadlessSession& operator=(const XrHeadlessSession&) = delete;

  /// Waits for the next frame and returns its time, which is later than that of the previous frame. Skips frames
  /// without a time, or whose time steps by more than 5 s; if no frame has a time, makes frames at 90 Hz. Throws XrLost
  /// if the session must be created again, also after 90 such steps in a row; Failure (ExitCode::runtime_failed) if the
  /// runtime ended the session or a wait exceeded its limit; Failure (ExitCode::registration) if the runtime moved the
  /// plate's space by an unknown amount; Interrupted after a signal.
  XrTime next_frame();

  /// STAGE, whose origin persists from run to run, or LOCAL if the runtime has no STAGE.
  XrReferenceSpaceType steady_space() const { return steady_space_; }
  /// STAGE or LOCAL_FLOOR, whose origins are on the floor, or else LOCAL, whose origin is at the user's eyes.
  XrReferenceSpaceType floor_space() const { return floor_space_; }

  /// Locates fingertips in plate coordinates from now on. `pose`: pose of the plate's mount in the initial coordinates
  /// of `space`. The mount keeps its place in the room when the runtime moves the space. Throws Failure
  /// (ExitCode::registration) if the runtime lacks the space.
  void place_plate(XrReferenceSpaceType space, const XrPosef& pose);
  XrSpace plate_space() const { return plate_space_; }

  /// Converts `pose` from the initial to the present coordinates of a space.
  XrPosef now(XrReferenceSpaceType space, const XrPosef& pose) const { return motion_.now(space, pose); }

  /// Number of times that the runtime has moved the space of the plate.
  int recentrings() const { return recentrings_; }

  /// Locates a fingertip at a time that next_frame() returned. Returns an untracked fingertip for an impossible pose,
  /// and while the runtime refuses the time, for up to a second. Throws XrFailure.
  Fingertip locate(Hand hand, XrTime time);

  /// Asks the runtime to end the session, and waits until the session has ended.
  void end();

  XrSession handle() const { return session_; }

 private:
  using Clock = std::chrono::steady_clock;

  // After this constructor, an exception in the public one runs the destructor.
  XrHeadlessSession(XrRuntime* runtime, SpaceMotion* motion, std::chrono::milliseconds limit)
      : runtime_(*runtime), limit_(limit), motion_(*motion) {}
  void find_spaces();
  bool has_space(XrReferenceSpaceType space) const;
  bool can_be_made(XrReferenceSpaceType type) const;
  void make_plate_space();
  void follow_spaces(XrTime time);
  void poll_events();
  void change_state(XrSessionState state);
  void wait_until_running();
  std::optional<XrTime> frame_of_runtime();
  XrTime time_now() const;
  bool steps(XrTime time);

  XrRuntime& runtime_;
  std::chrono::milliseconds limit_;
  XrSession session_ = XR_NULL_HANDLE;
  SpaceMotion& motion_;
  std::vector<XrReferenceSpaceType> spaces_;  // spaces of the runtime
  XrReferenceSpaceType plate_base_ = XR_REFERENCE_SPACE_TYPE_LOCAL;
  XrPosef plate_pose_{};  // in plate_base_, in its initial coordinates
  XrSpace plate_space_ = XR_NULL_HANDLE;
  int recentrings_ = 0;
  XrReferenceSpaceType floor_space_ = XR_REFERENCE_SPACE_TYPE_LOCAL;
  XrReferenceSpaceType steady_space_ = XR_REFERENCE_SPACE_TYPE_LOCAL;
  std::array<XrHandTrackerEXT, 2> trackers_{};
  bool running_ = false;
  bool ending_ = false;            // end() has requested the end
  bool frames_have_times_ = true;  // false: time_now() gives the times of frames
  Clock::time_point frame_began_;  // real time at which frame last_frame_ began
  std::optional<XrTime> refused_since_;
  int untimed_ = 0, stepped_ = 0;  // frames in a row without a time, and frames in a row with a step of time
  struct LeftOut {
    int untimed = 0, stepped = 0, refused = 0, impossible = 0;
  };
  LeftOut left_out_;
  Clock::time_point own_frame_;  // start of the last frame that was paced by this class
  XrTime last_frame_ = 0;

  PFN_xrCreateHandTrackerEXT create_hand_tracker_ = nullptr;
  PFN_xrDestroyHandTrackerEXT destroy_hand_tracker_ = nullptr;
  PFN_xrLocateHandJointsEXT locate_hand_joints_ = nullptr;
  PFN_xrConvertTimespecTimeToTimeKHR convert_timespec_ = nullptr;  // null if unsupported
};

}  // namespace hrt::app
