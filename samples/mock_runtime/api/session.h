#pragma once

#include <openxr/openxr.h>

#include <optional>
#include <set>
#include <thread>

#include "samples/mock_runtime/api/actions.h"
#include "samples/mock_runtime/graphics/device.h"
#include "samples/mock_runtime/live/plate_terminal.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

/// State of the frame loop.
struct FrameLoop {
  bool waited = false;             ///< a frame has been waited for and not begun
  bool begun = false;              ///< a frame has been begun and not ended
  std::int64_t waited_number = 0;  ///< number of that frame, over all runs
  std::int64_t begun_number = 0;
  std::int64_t since_begin = 0;           ///< frames waited for since xrBeginSession
  XrTime next_start = 0;                  ///< start of the next frame interval
  XrTime last_display = 0;                ///< predicted display time of the latest frame
  std::optional<XrTime> ordered_display;  ///< display time set by the script for the next frame
};

/// A session; at most one exists.
class Session : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SESSION;

  Session(Instance* instance, const Script& script, std::shared_ptr<GraphicsDevice> device);

  Instance& instance() const { return static_cast<Instance&>(*parent()); }

  /// Simulated world, advanced to the present time.
  World& world();

  /// Enters a state and queues its event. A state is never reported twice in a row.
  void enter(XrSessionState state);
  XrSessionState state() const { return state_; }
  /// Enters a state through the states in between. No effect on a session that is not running or whose loss is
  /// pending.
  void go_to(XrSessionState state);

  /// Runs the events of the script that are due in this session.
  void fire_due_events();

  const std::shared_ptr<GraphicsDevice> graphics;  ///< null for a headless session
  bool running = false;
  bool exit_requested = false;
  std::int64_t frame_number = 0;  ///< number of the latest xrWaitFrame, over all runs
  FrameLoop frames;
  std::int64_t picture_from = 0;  ///< first frame that may give the next picture; 0: no picture pending
  /// Ids of the attached action sets; unset before xrAttachSessionActionSets.
  std::optional<std::set<std::uint64_t>> action_sets;

 private:
  void happen(const Happening& what);
  void happen(const Recenter& recenter);
  void happen(const HandEvent& event);
  void serve_plate();
  void report_state();

  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  XrTime created_;
  std::vector<ScriptEvent> events_;  // pending events
  World world_;
  std::optional<PlateTerminal> plate_;
  std::jthread server_;  // runs the plate's firmware
};

/// Graphics device of the session; null for a headless one. Throws an Error for an unusable binding.
std::shared_ptr<GraphicsDevice> device_of_session(const Instance& instance, const XrSessionCreateInfo& info);

/// Runs the events of the script that are due, in every session.
void fire_due_events();

}  // namespace hrt::mock
