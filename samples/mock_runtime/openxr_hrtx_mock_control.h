/*
** XR_HRTX_mock_control: a test's control of the mock runtime, unknown to the application.
**
** A vendor extension of the mock runtime beside this header; README.md there has the script's format.
** Enable it in XrInstanceCreateInfo::enabledExtensionNames and fetch its functions with
** xrGetInstanceProcAddr. The author tag HRTX and the number of its structure type are not registered
** with Khronos. Every function may be called from any thread and returns, beside the results named below,
** XR_ERROR_HANDLE_INVALID, XR_ERROR_INSTANCE_LOST (except xrGetCallLogHRTX), and
** XR_ERROR_VALIDATION_FAILURE for null pointers and wrong structure types.
*/
#ifndef OPENXR_HRTX_MOCK_CONTROL_H_
#define OPENXR_HRTX_MOCK_CONTROL_H_

#include <openxr/openxr.h>

#ifdef __cplusplus
extern "C" {
#endif

#define XR_HRTX_mock_control 1
#define XR_HRTX_mock_control_SPEC_VERSION 3
#define XR_HRTX_MOCK_CONTROL_EXTENSION_NAME "XR_HRTX_mock_control"

#define XR_MAX_CALL_NAME_SIZE_HRTX 64
#define XR_MAX_CALL_REASON_SIZE_HRTX 256

#ifdef __cplusplus
#define XR_TYPE_CALL_RECORD_HRTX static_cast<XrStructureType>(1009991000)
#else
#define XR_TYPE_CALL_RECORD_HRTX ((XrStructureType)1009991000)
#endif

/* One call of the application. */
typedef struct XrCallRecordHRTX {
  XrStructureType type; /* XR_TYPE_CALL_RECORD_HRTX */
  void* XR_MAY_ALIAS next;
  XrTime time; /* of the runtime's clock when the call returned; 0 without an instance */
  XrResult result;
  char function[XR_MAX_CALL_NAME_SIZE_HRTX]; /* "xrCreateSession" */
  char reason[XR_MAX_CALL_REASON_SIZE_HRTX]; /* why it was refused; empty otherwise */
  uint32_t thread;                           /* that called, numbered from 1 in order of their first calls */
} XrCallRecordHRTX;

/* Replaces the script, from the next session on; calls and sessions are counted from here.
** XR_ERROR_CALL_ORDER_INVALID while there is a session. XR_ERROR_VALIDATION_FAILURE for a script that is
** not valid: the call log says what is wrong in it and what is allowed; the script before stays. */
typedef XrResult(XRAPI_PTR* PFN_xrApplyScriptHRTX)(XrInstance instance, const char* json);

/* Advances a manual clock by `duration`, 0 to one hour; events in between happen.
** XR_ERROR_CALL_ORDER_INVALID with the real-time clock. */
typedef XrResult(XRAPI_PTR* PFN_xrAdvanceTimeHRTX)(XrInstance instance, XrDuration duration);

/* The calls so far, oldest first, in the two-call idiom; xrGetInstanceProcAddr and this function are left
** out. The log holds the latest 100,000. */
typedef XrResult(XRAPI_PTR* PFN_xrGetCallLogHRTX)(XrInstance instance, uint32_t capacity, uint32_t* count,
                                                  XrCallRecordHRTX* records);

#ifdef __cplusplus
}
#endif

#endif
