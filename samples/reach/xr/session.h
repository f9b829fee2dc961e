// A headless OpenXR session with two hand trackers, located in the plate's space.
#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "samples/reach/xr/frame_waiter.h"
#include "samples/reach/xr/runtime.h"

namespace hrt::reach {

enum class Hand { left = 0, right = 1 };

/// An index fingertip. If not `tracked`, the position is meaningless.
struct Fingertip {
  bool tracked = false;
  std::array<double, 3> position_m{};  ///< in plate coordinates
};

/// One session from IDLE to its end. One thread.
class XrHeadlessSession {
 public:
  /// `plate_pose`: of the plate's mount in the LOCAL reference space. `limit` bounds every wait for the
  /// runtime. Throws XrFailure.
  XrHeadlessSession(XrRuntime& runtime, const XrPosef& plate_pose, std::chrono::milliseconds limit);
  ~XrHeadlessSession();
  XrHeadlessSession(const XrHeadlessSession&) = delete;
  XrHeadlessSession& operator=(const XrHeadlessSession&) = delete;

  /// Waits for the next frame and returns its time, later than any before. Throws XrLost if the session must
  /// be created again; Failure (ExitCode::runtime_failed) if the runtime ended it or a wait exceeded its
  /// limit; Failure (ExitCode::runtime_blocked) if xrWaitFrame did; Interrupted.
  XrTime next_frame();

  /// The fingertip at a time that next_frame() returned.
  Fingertip locate(Hand hand, XrTime time);

  /// Asks the runtime to end the session, and waits until it has.
  void end();

  XrSession handle() const { return session_; }
  XrSpace local_space() const { return local_space_; }
  /// xrWaitFrame did not return in time: this session makes no more calls.
  bool is_blocked() const { return runtime_.is_abandoned(); }

 private:
  using Clock = std::chrono::steady_clock;

  void create(const XrPosef& plate_pose);
  void destroy();
  void poll_events();
  void change_state(XrSessionState state);
  void wait_until_running();
  std::optional<XrTime> frame_of_runtime();
  XrResult wait_frame(XrFrameState& frame);
  XrTime time_now() const;

  XrRuntime& runtime_;
  std::chrono::milliseconds limit_;
  XrSession session_ = XR_NULL_HANDLE;
  std::optional<FrameWaiter> frame_waiter_;
  XrSpace local_space_ = XR_NULL_HANDLE;
  XrSpace plate_space_ = XR_NULL_HANDLE;
  std::array<XrHandTrackerEXT, 2> trackers_{};
  bool running_ = false;
  bool ending_ = false;            // because we asked for it
  bool frames_have_times_ = true;  // until a frame has none
  XrTime last_frame_ = 0;
  XrEnvironmentBlendMode blend_mode_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;

  PFN_xrCreateHandTrackerEXT create_hand_tracker_ = nullptr;
  PFN_xrDestroyHandTrackerEXT destroy_hand_tracker_ = nullptr;
  PFN_xrLocateHandJointsEXT locate_hand_joints_ = nullptr;
  PFN_xrConvertTimespecTimeToTimeKHR convert_timespec_ = nullptr;  // null if the runtime has none
};

}  // namespace hrt::reach
