#pragma once

#include <openxr/openxr.h>

#include "samples/mock_runtime/instance.h"
#include "samples/mock_runtime/world.h"

namespace hrt::mock {

/// Where the frame loop is. xrBeginSession starts it anew.
struct FrameLoop {
  bool waited = false;      ///< a frame has been waited for and not begun
  bool begun = false;       ///< a frame has been begun and not ended
  XrTime next_start = 0;    ///< of the next frame interval
  XrTime last_display = 0;  ///< predicted for the latest frame
};

/// A session, always headless; an instance can have one at a time.
class Session : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_SESSION;

  Session(Instance* instance, const WorldSettings& settings)
      : Object(object_type, instance), world_(settings) {}

  Instance& instance() const { return static_cast<Instance&>(*parent()); }

  /// The simulated world as it is now.
  World& world();

  /// Enters a state and tells the application. A state is never told twice in a row.
  void enter(XrSessionState state);
  XrSessionState state() const { return state_; }

  bool running = false;
  bool exit_requested = false;
  FrameLoop frames;
  Input input{*this};

 private:
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  World world_;
};

}  // namespace hrt::mock
