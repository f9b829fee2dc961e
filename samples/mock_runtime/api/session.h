#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <set>
#include <thread>

#include "samples/app/emulator/pty_device.h"
#include "samples/mock_runtime/api/actions.h"
#include "samples/mock_runtime/graphics/device.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

/// State of the frame loop. Frames are numbered from 1 over the life of the session, in the order of xrWaitFrame.
struct FrameLoop {
  bool waited = false;                     ///< xrWaitFrame has returned a frame that has not begun
  bool begun = false;                      ///< a frame has begun and not ended
  std::int64_t waited_number = 0;          ///< number of the latest frame that xrWaitFrame returned
  std::int64_t begun_number = 0;           ///< number of the latest frame that has begun
  std::int64_t since_begin = 0;            ///< frames that xrWaitFrame returned since xrBeginSession
  XrTime next_start = 0;                   ///< start of the next frame interval; 0 before the first frame
  XrTime last_display = 0;                 ///< display time of the latest frame, unless the script replaces it
  std::optional<XrTime> scripted_display;  ///< display time that the script sets for the next frame
};

/// A change of the origin of a reference space, as when a user recentres the view.
struct Recenter {
  XrReferenceSpaceType space;  ///< LOCAL or STAGE
  XrDuration delay_ns;         ///< time from the event to the change
  Pose pose;                   ///< pose of the new origin in the old space
  bool pose_valid;             ///< the application receives the pose
};

class Session : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SESSION;

  Session(Instance* instance, const Script& script, std::shared_ptr<GraphicsDevice> device);

  Instance& instance() const { return static_cast<Instance&>(*parent()); }

  /// Returns the simulated world, after advancing it to the present time.
  World& world();

  /// Enters a state and queues its event. No effect if the session is in that state already.
  void enter(XrSessionState state);
  XrSessionState state() const { return state_; }
  /// Queues an event with the present state.
  void report_state();
  /// Enters LOSS_PENDING from any state. A running session that is SYNCHRONIZED, VISIBLE or FOCUSED can also go to
  /// another of these states or to STOPPING, by way of the states in between; a running READY session, to STOPPING. No
  /// effect in other cases.
  void go_to(XrSessionState state);
  /// Executes the event session_state of the script. EXITING leads to STOPPING, and after xrEndSession to EXITING.
  void change_state(XrSessionState state);
  void recenter(const Recenter& change);

  void fire_due_events();

  const std::shared_ptr<GraphicsDevice> graphics;  ///< null for a headless session
  bool running = false;                            ///< between xrBeginSession and xrEndSession
  bool exit_requested = false;
  std::int64_t frame_number = 0;  ///< number of frames for which xrWaitFrame has waited
  FrameLoop frames;
  std::int64_t picture_from = 0;  ///< first frame that may be the next picture; 0: no picture is pending
  /// Ids of the attached action sets; unset before xrAttachSessionActionSets.
  std::optional<std::set<std::uint64_t>> action_sets;

 private:
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  XrTime created_;
  std::vector<ScriptEvent> pending_events_;
  World world_;
  std::optional<plate::PtyPlate> board_;  // board of the plate, if the script gives the plate a terminal
  std::optional<plate::PtyLink> board_link_;
  std::jthread board_thread_;
};

/// Returns the graphics device of a new session; null for a headless one. Throws an Error for an invalid binding.
std::shared_ptr<GraphicsDevice> device_of_session(const Instance& instance, const XrSessionCreateInfo& info);

void require_running(const Session& session);

/// Executes the events of the script that are due in the existing session, if any.
void fire_due_events();

}  // namespace hrt::mock
