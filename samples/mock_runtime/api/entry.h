// Wrapper of each function in functions.h: locks, injects faults, executes due events of the script, resolves handles,
// checks pointers, logs the call.
#pragma once

#include <mutex>
#include <new>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/api/swapchain.h"
#include "samples/mock_runtime/functions.h"

namespace hrt::mock {

// Overloads without definition, which map the type of an argument to the type of the implementation's parameter: a
// handle to a reference to its object, any other type to itself.
#define HRT_MOCK_OBJECT(Handle, Type) \
  class Type;                         \
  std::type_identity<Type&> parameter_for(Handle);
HRT_MOCK_OBJECT(XrInstance, Instance)
HRT_MOCK_OBJECT(XrSession, Session)
HRT_MOCK_OBJECT(XrSpace, Space)
HRT_MOCK_OBJECT(XrActionSet, ActionSet)
HRT_MOCK_OBJECT(XrAction, Action)
HRT_MOCK_OBJECT(XrSwapchain, Swapchain)
HRT_MOCK_OBJECT(XrHandTrackerEXT, HandTracker)
#undef HRT_MOCK_OBJECT
template <typename Argument>
std::type_identity<Argument> parameter_for(const Argument&);

/// True for functions whose implementation receives handles and looks up their objects itself, because it accepts lost
/// or null handles, or must look up again after a wait.
constexpr bool takes_handles(std::string_view name) {
  return name.starts_with("xrDestroy") || name == "xrWaitFrame" || name == "xrGetInstanceProcAddr";
}
template <typename Argument, bool handles>
using Parameter = typename std::conditional_t<handles, std::type_identity<Argument>,
                                              decltype(parameter_for(std::declval<Argument>()))>::type;

/// True for functions that return several success codes here: their implementations return the result, others nothing.
constexpr bool returns_result(std::string_view name) {
  return name == "xrPollEvent" || name == "xrGetReferenceSpaceBoundsRect" || name == "xrBeginFrame" ||
         name == "xrSyncActions" || name.ends_with("HapticFeedback");
}

template <bool returns, typename Function, bool handles>
struct Implementation;
template <bool returns, typename... Args, bool handles>
struct Implementation<returns, XrResult (*)(Args...), handles> {
  using Type = std::conditional_t<returns, XrResult, void>(Parameter<Args, handles>...);
};

#define HRT_MOCK_DECLARE(extension, name) \
  Implementation<returns_result(#name), PFN_##name, takes_handles(#name)>::Type name;
HRT_MOCK_FUNCTIONS(HRT_MOCK_DECLARE)
#undef HRT_MOCK_DECLARE

/// Number of the calling thread. Threads are numbered from 1 in the order in which they first call this function.
inline std::uint32_t thread_number(Runtime& shared) {
  static thread_local const std::uint32_t number = ++shared.threads;
  return number;
}

/// Converts a handle to its object if `Target` is the type of objects; otherwise returns the argument unchanged.
template <typename Target, typename Argument>
Target resolve(Argument& argument) {
  if constexpr (std::is_same_v<Target, Argument>)
    return argument;
  else
    return runtime().registry.get<std::remove_reference_t<Target>>(argument);
}

template <typename T>
concept Complete = requires { sizeof(T); };  // false for the types behind handles, which are declared only

/// True for structures for which an application may pass null.
template <typename Struct>
concept Optional =
    std::same_as<Struct, XrFrameWaitInfo> || std::same_as<Struct, XrFrameBeginInfo> ||
    std::same_as<Struct, XrSwapchainImageAcquireInfo> || std::same_as<Struct, XrSwapchainImageReleaseInfo>;

/// Checks that pointers are not null, unless they are Optional, and that structures have their types. Not checked here:
/// strings, which the implementation checks, and the arguments after a capacity (a uint32_t), which two_call() checks.
template <typename... Args>
void require_arguments(const Args&... args) {
  bool after_capacity = false;
  std::size_t number = 0;
  const auto check = [&]<typename Argument>(const Argument& argument) {
    using Target = std::remove_cv_t<std::remove_pointer_t<Argument>>;
    ++number;
    after_capacity = after_capacity || std::same_as<Argument, std::uint32_t>;
    if constexpr (std::is_pointer_v<Argument> && Complete<Target> && !std::same_as<Argument, const char*>) {
      if (after_capacity || (Optional<Target> && argument == nullptr)) return;
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
    Runtime& shared = runtime();
    std::unique_lock lock(shared.mutex);
    CallRecord record{.function = name_of(id), .result = XR_SUCCESS};
    try {
      if (const auto fault = shared.next_fault(id)) inject(shared, *fault, lock, record);
      fire_due_events();
      const std::tuple<Parameter<Args, handles>...> all{resolve<Parameter<Args, handles>>(args)...};
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
    } catch (const std::exception& error) {
      record.result = XR_ERROR_RUNTIME_FAILURE;
      record.why = error.what();
    }
    const XrResult result = record.result;
    // xrGetInstanceProcAddr is not logged, because a loader looks up every function.
    if constexpr (id != FunctionId::xrGetInstanceProcAddr) log(shared, std::move(record));
    return result;
  }

 private:
  // Blocks the call, or delays it and then throws the error that the script sets, if any. The lock is released
  // meanwhile. A blocked call is logged first, since it never returns.
  static void inject(Runtime& shared, const CallFault& fault, std::unique_lock<std::mutex>& lock, CallRecord record) {
    if (fault.blocks) {
      record.result = XR_TIMEOUT_EXPIRED;
      record.why = "the script blocks this call";
      log(shared, std::move(record));
    }
    lock.unlock();
    if (fault.held != nullptr) flockfile(fault.held);
    do std::this_thread::sleep_for(fault.blocks ? std::chrono::hours(1) : fault.delay);
    while (fault.blocks);
    lock.lock();
    if (fault.result) throw Error{*fault.result, "the script sets this error for this call"};
  }

  static void log(Runtime& shared, CallRecord record) {
    record.thread = thread_number(shared);
    record.time = shared.now();
    shared.log.write(record);
  }
};

}  // namespace hrt::mock
