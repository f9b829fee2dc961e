// The barrier around every entry point: takes the lock, and lets no exception out.
#pragma once

#include <mutex>
#include <new>
#include <thread>
#include <tuple>
#include <type_traits>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/api/swapchain.h"
#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

/// Number of the calling thread, from 1, in order of first calls.
inline std::uint32_t thread_number(Runtime& the) {
  static thread_local const std::uint32_t number = ++the.threads;
  return number;
}

/// Converts a handle to its object; returns any other argument unchanged.
template <typename Given, typename Argument>
Given given(Argument& argument) {
  if constexpr (std::is_same_v<Given, Argument>)
    return argument;
  else
    return runtime().registry.get<std::remove_reference_t<Given>>(argument);
}

template <typename T>
concept Complete = requires { sizeof(T); };

/// Structures that an application may omit (null).
template <typename Struct>
concept Optional =
    std::same_as<Struct, XrFrameWaitInfo> || std::same_as<Struct, XrFrameBeginInfo> ||
    std::same_as<Struct, XrSwapchainImageAcquireInfo> || std::same_as<Struct, XrSwapchainImageReleaseInfo>;

/// Checks that pointers are not null and that structures have their types. The implementation checks texts, and
/// two_call() checks the arguments that follow a capacity.
template <typename... Args>
void require_arguments(const Args&... args) {
  bool counted = false;
  std::size_t number = 0;
  const auto check = [&]<typename Argument>(const Argument& argument) {
    using Target = std::remove_cv_t<std::remove_pointer_t<Argument>>;
    ++number;
    counted = counted || std::same_as<Argument, std::uint32_t>;
    if constexpr (std::is_pointer_v<Argument> && Complete<Target> && !std::same_as<Argument, const char*>) {
      if (counted || (Optional<Target> && argument == nullptr)) return;
      if constexpr (Typed<Target>)
        require_struct(argument);
      else
        require_pointer(argument, ("argument " + std::to_string(number)).c_str());
    }
  };
  (check(args), ...);
}

template <FunctionId id, typename Function, bool handles, auto implementation>
struct Entry;

template <FunctionId id, typename... Args, bool handles, auto implementation>
struct Entry<id, XrResult (*)(Args...), handles, implementation> {
  static XRAPI_ATTR XrResult XRAPI_CALL call(Args... args) noexcept {
    Runtime& the = runtime();
    std::unique_lock lock(the.mutex);
    CallRecord record{.function = name_of(id), .result = XR_SUCCESS};
    try {
      if (const auto fault = the.next_fault(id)) {
        if (fault->blocks) {
          record.result = XR_TIMEOUT_EXPIRED;
          record.why = "the script blocks this call";
          log(the, record);
        }
        lock.unlock();
        if (fault->held != nullptr) flockfile(fault->held);
        do std::this_thread::sleep_for(fault->blocks ? std::chrono::hours(1) : fault->delay);
        while (fault->blocks);
        lock.lock();
        if (fault->result) throw Error{*fault->result, "the script orders this error"};
      }
      fire_due_events();
      const std::tuple<Taken<Args, handles>...> all{given<Taken<Args, handles>>(args)...};
      if constexpr (!handles) require_arguments(args...);
      if constexpr (std::is_void_v<decltype(std::apply(implementation, all))>)
        std::apply(implementation, all);
      else
        record.result = std::apply(implementation, all);
    } catch (const Error& error) {
      record.result = error.result;
      record.why = error.why;
    } catch (const std::bad_alloc&) {
      record.result = XR_ERROR_OUT_OF_MEMORY;
    } catch (...) {
      record.result = XR_ERROR_RUNTIME_FAILURE;
    }
    const XrResult result = record.result;
    // Not logged: a loader looks up every function, and the log must not grow between the two calls that
    // read it.
    if constexpr (id != FunctionId::xrGetInstanceProcAddr && id != FunctionId::xrGetCallLogHRTX)
      log(the, std::move(record));
    return result;
  }

 private:
  static void log(Runtime& the, CallRecord record) noexcept {
    try {
      record.thread = thread_number(the);
      record.time = the.now();
      the.log.append(std::move(record));
    } catch (const std::bad_alloc&) {
      // The call proceeds without a record.
    }
  }
};

}  // namespace hrt::mock
