// What an application is given, noted as records of a script. README.md in the folder above has the use.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/mock_runtime/capture/record.h"
#include "samples/mock_runtime/capture/script_file.h"
#include "samples/mock_runtime/openxr_all.h"

// The functions that the layer looks into, and the member of Capture that notes what each has given; of
// `failures` only errors.
// clang-format off
#define HRT_CAPTURE_FUNCTIONS(X)                                       \
  X(xrDestroyInstance,              instance_destroyed)                \
  X(xrGetSystem,                    failures)                          \
  X(xrGetSystemProperties,          system_properties)                 \
  X(xrPollEvent,                    event)                             \
  X(xrCreateSession,                session_created)                   \
  X(xrDestroySession,               session_destroyed)                 \
  X(xrBeginSession,                 session_begun)                     \
  X(xrEndSession,                   session_ended)                     \
  X(xrRequestExitSession,           exit_requested)                    \
  X(xrCreateReferenceSpace,         reference_space)                   \
  X(xrDestroySpace,                 space_destroyed)                   \
  X(xrLocateSpace,                  located)                           \
  X(xrLocateViews,                  views)                             \
  X(xrWaitFrame,                    frame)                             \
  X(xrBeginFrame,                   failures)                          \
  X(xrEndFrame,                     frame_ended)                       \
  X(xrCreateHandTrackerEXT,         hand_tracker)                      \
  X(xrDestroyHandTrackerEXT,        failures)                          \
  X(xrLocateHandJointsEXT,          joints)                            \
  X(xrConvertTimespecTimeToTimeKHR, converted)                         \
  X(xrGetPlateOrientationHRTX,      plate_orientation)                 \
  X(xrGetReachTruthHRTX,            reach_truth)
// clang-format on

namespace hrt::capture {

/// What the layer calls; null where the runtime has no such function.
struct Next {
#define HRT_CAPTURE_MEMBER(name, member) PFN_##name name = nullptr;
  HRT_CAPTURE_FUNCTIONS(HRT_CAPTURE_MEMBER)
#undef HRT_CAPTURE_MEMBER
  PFN_xrGetInstanceProcAddr xrGetInstanceProcAddr = nullptr;
  PFN_xrGetInstanceProperties xrGetInstanceProperties = nullptr;
  PFN_xrEnumerateReferenceSpaces xrEnumerateReferenceSpaces = nullptr;
};

/// One for the process: instances after each other, one at a time, go to one file.
class Capture {
 public:
  Next next;  ///< of the present instance

  /// Held while a member is called, except by session_of_call().
  std::mutex mutex;

  bool has_instance() const { return instance_ != XR_NULL_HANDLE; }
  /// Opens the file, unless it is open. Throws std::system_error.
  void open(const std::string& path);
  void instance_created(XrInstance instance, const XrInstanceCreateInfo& info);
  /// The session that a call belongs to, from 1: the one that exists, or else the next.
  std::uint64_t session_of_call();

  /// Counts a call, and notes an error that the application did not cause itself.
  void called(const char* function, std::uint64_t session, XrResult result);

  // One for each row of HRT_CAPTURE_FUNCTIONS, with the call's result, a success, and its arguments.
  template <typename... Args>
  void failures(XrResult, const Args&...) {}
  void instance_destroyed(XrResult, XrInstance);
  void system_properties(XrResult, XrInstance, XrSystemId, const XrSystemProperties*);
  void event(XrResult, XrInstance, const XrEventDataBuffer*);
  void session_created(XrResult, XrInstance, const XrSessionCreateInfo*, const XrSession*);
  void session_destroyed(XrResult, XrSession);
  void session_begun(XrResult, XrSession, const XrSessionBeginInfo*) { stage("begin"); }
  void session_ended(XrResult, XrSession) { stage("end"); }
  void exit_requested(XrResult, XrSession) { stage("exit"); }
  void reference_space(XrResult, XrSession, const XrReferenceSpaceCreateInfo*, const XrSpace*);
  void space_destroyed(XrResult, XrSpace space) { spaces_.erase(space); }
  void located(XrResult, XrSpace, XrSpace base, XrTime, const XrSpaceLocation*);
  void views(XrResult, XrSession, const XrViewLocateInfo*, const XrViewState*, std::uint32_t capacity,
             const std::uint32_t* count, const XrView*);
  void frame(XrResult, XrSession, const XrFrameWaitInfo*, const XrFrameState*);
  void frame_ended(XrResult, XrSession, const XrFrameEndInfo*) { write(); }
  void hand_tracker(XrResult, XrSession, const XrHandTrackerCreateInfoEXT*, const XrHandTrackerEXT*);
  void joints(XrResult, XrHandTrackerEXT, const XrHandJointsLocateInfoEXT*, const XrHandJointLocationsEXT*);
  void converted(XrResult, XrInstance, const timespec*, const XrTime*);
  void plate_orientation(XrResult, XrSession, XrTime, const double*);
  void reach_truth(XrResult, XrSession, XrHandEXT, const XrReachTruthHRTX*);

 private:
  void note(const Json& record) {
    if (file_ != nullptr) file_->append(record.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  template <typename... Values>
  void note_of_session(std::string_view kind, const Values&... values) {
    note(array_of(kind, sessions_, values...));
  }
  // Writes the records so far to the file.
  void write() {
    if (file_ != nullptr) file_->write();
  }
  void stage(const char* call);
  void define_space(XrSpace handle, const Json& description);

  std::string path_;
  std::unique_ptr<ScriptFile> file_;
  XrInstance instance_ = XR_NULL_HANDLE;
  std::uint64_t sessions_ = 0;  // so far
  bool in_session_ = false;
  std::size_t stages_ = 0;  // calls of the session that begin it, ask for its exit or end it
  std::size_t frames_ = 0;  // since the latest of these
  XrTime present_ = 0;      // the latest that the application was given
  std::map<std::pair<std::uint64_t, const char*>, std::uint64_t> calls_;  // of a session, by function
  std::map<std::string, std::size_t> known_spaces_;                       // numbers by description
  std::unordered_map<XrSpace, std::size_t> spaces_;
  std::unordered_map<XrHandTrackerEXT, XrHandEXT> trackers_;
};

}  // namespace hrt::capture
