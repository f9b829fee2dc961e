/* The vendor extensions' headers are C11, like OpenXR's own, and their structures have the same layout
** with every compiler. */
#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/mock_runtime/openxr_hrtx_mock_control.h"

#include <assert.h>
#include <stddef.h>

static_assert(sizeof(XrPlatePlacementHRTX) == 64, "three pointers' worth, a pose and a double");
static_assert(offsetof(XrPlatePlacementHRTX, radius) == 56, "after 28 bytes of pose and 4 of padding");
static_assert(sizeof(XrReachInstructionHRTX) == 48, "no room left");
static_assert(offsetof(XrReachInstructionHRTX, goalDirection) == 32, "after hand and start");
static_assert(sizeof(XrReachTruthHRTX) == 80, "no room left");
static_assert(offsetof(XrCallRecordHRTX, reason) == 92, "after the function");
static_assert(sizeof(XrCallRecordHRTX) == 352, "no room left");

XrStructureType hrt_structure_types[] = {XR_TYPE_PLATE_PLACEMENT_HRTX, XR_TYPE_REACH_INSTRUCTION_HRTX,
                                         XR_TYPE_REACH_TRUTH_HRTX, XR_TYPE_CALL_RECORD_HRTX};
