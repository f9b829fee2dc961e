/* The header of the vendor extension compiles as C11, and its structures have this layout with every compiler. */
#include "samples/app/xr/openxr_hrtx_ridged_plate.h"

#include <assert.h>
#include <stddef.h>

static_assert(sizeof(XrPlatePlacementHRTX) == 64, "size");
static_assert(offsetof(XrPlatePlacementHRTX, radius) == 56, "4 bytes of padding after the pose");
static_assert(sizeof(XrReachInstructionHRTX) == 48, "no padding at the end");
static_assert(offsetof(XrReachInstructionHRTX, goalDirection) == 32, "no padding after start");
static_assert(sizeof(XrReachTruthHRTX) == 80, "no padding at the end");

XrStructureType hrt_structure_types[] = {XR_TYPE_PLATE_PLACEMENT_HRTX, XR_TYPE_REACH_INSTRUCTION_HRTX,
                                         XR_TYPE_REACH_TRUTH_HRTX};
