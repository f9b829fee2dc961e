/*
** XR_HRTX_mock_control: lets a test control the simulation and read the calls of the application.
**
** This is a vendor extension of the mock runtime. SCRIPTS.md describes the format of scripts.
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
  XrTime time; /* time of the runtime's clock when the call returned; 0 if there was no instance */
  XrResult result;
  char function[XR_MAX_CALL_NAME_SIZE_HRTX]; /* "xrCreateSession" */
  char reason[XR_MAX_CALL_REASON_SIZE_HRTX]; /* cause of the error and remedy; empty on success */
  uint32_t thread; /* number of the calling thread, from 1 in the order in which threads first called */
} XrCallRecordHRTX;

/* Replaces the script for sessions that are created later, and restarts the counts of calls and sessions.
** XR_ERROR_CALL_ORDER_INVALID while a session exists. XR_ERROR_VALIDATION_FAILURE for an invalid script: the call
** log names the mistake and the allowed values, and the previous script remains in effect. */
typedef XrResult(XRAPI_PTR* PFN_xrApplyScriptHRTX)(XrInstance instance, const char* json);

/* Advances the manual clock by `duration`, from 0 to one hour, and executes the events of the script that are then due.
** XR_ERROR_CALL_ORDER_INVALID with the real-time clock. */
typedef XrResult(XRAPI_PTR* PFN_xrAdvanceTimeHRTX)(XrInstance instance, XrDuration duration);

/* Returns the latest 100,000 calls, oldest first, by the two-call idiom. Calls of xrGetInstanceProcAddr and of this
** function are not included. */
typedef XrResult(XRAPI_PTR* PFN_xrGetCallLogHRTX)(XrInstance instance, uint32_t capacity, uint32_t* count,
                                                  XrCallRecordHRTX* records);

#ifdef __cplusplus
}
#endif

#endif
