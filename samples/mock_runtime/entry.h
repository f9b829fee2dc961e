// The barrier around every entry point: takes the lock, and lets no exception out.
#pragma once

#include <mutex>
#include <new>

#include "samples/mock_runtime/functions.h"
#include "samples/mock_runtime/runtime.h"

namespace hrt::mock {

template <FunctionId id, auto implementation>
struct Entry;

template <FunctionId id, typename... Args, XrResult (*implementation)(Args...)>
struct Entry<id, implementation> {
  static XRAPI_ATTR XrResult XRAPI_CALL call(Args... args) noexcept {
    const std::lock_guard lock(runtime().mutex);
    try {
      return implementation(args...);
    } catch (const Error& error) {
      return error.result;
    } catch (const std::bad_alloc&) {
      return XR_ERROR_OUT_OF_MEMORY;
    } catch (...) {
      return XR_ERROR_RUNTIME_FAILURE;
    }
  }
};

}  // namespace hrt::mock
