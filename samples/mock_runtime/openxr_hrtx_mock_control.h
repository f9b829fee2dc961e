/*
** XR_HRTX_mock_control: lets a test control the mock runtime without the application's knowledge.
**
** A vendor extension of the mock runtime in this folder; SCRIPTS.md has the format of scripts.
** Enable it in XrInstanceCreateInfo::enabledExtensionNames and fetch its functions with
** xrGetInstanceProcAddr. The author tag HRTX and the number of its structure type are not registered
** with Khronos. Every function may be called from any thread. In addition to the results named
** below, each returns XR_ERROR_HANDLE_INVALID, XR_ERROR_INSTANCE_LOST (except xrGetCallLogHRTX), and
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
  XrTime time; /* runtime's clock when the call returned; 0 without an instance */
  XrResult result;
  char function[XR_MAX_CALL_NAME_SIZE_HRTX]; /* "xrCreateSession" */
  char reason[XR_MAX_CALL_REASON_SIZE_HRTX]; /* reason of the error; empty on success */
  uint32_t thread;                           /* calling thread, numbered from 1 in order of first calls */
} XrCallRecordHRTX;

/* Replaces the script from the next session on, and restarts the counts of calls and sessions.
** XR_ERROR_CALL_ORDER_INVALID while a session exists. XR_ERROR_VALIDATION_FAILURE for an invalid script: the call
** log names the mistake and the allowed values, and the previous script remains in effect. */
typedef XrResult(XRAPI_PTR* PFN_xrApplyScriptHRTX)(XrInstance instance, const char* json);

/* Advances a manual clock by `duration`, 0 to one hour; events that become due occur.
** XR_ERROR_CALL_ORDER_INVALID with the real-time clock. */
typedef XrResult(XRAPI_PTR* PFN_xrAdvanceTimeHRTX)(XrInstance instance, XrDuration duration);

/* Returns the calls so far, oldest first, in the two-call idiom, without xrGetInstanceProcAddr and this function.
** The log keeps the latest 100,000. */
typedef XrResult(XRAPI_PTR* PFN_xrGetCallLogHRTX)(XrInstance instance, uint32_t capacity, uint32_t* count,
                                                  XrCallRecordHRTX* records);

#ifdef __cplusplus
}
#endif

#endif
