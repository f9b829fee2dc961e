// What there is one of: the lock that every entry point holds, the objects, and the instance.
#pragma once

#include <condition_variable>
#include <mutex>

#include "samples/mock_runtime/object.h"

namespace hrt::mock {

class Instance;

struct Runtime {
  /// Held by every entry point for as long as it runs, but for the waits of xrWaitFrame.
  std::mutex mutex;
  /// Notified when a frame begins, and when a session ends or is lost: what xrWaitFrame waits for.
  std::condition_variable_any frame_begun;
  Registry registry;
  Instance* instance = nullptr;
};

Runtime& runtime();

}  // namespace hrt::mock
