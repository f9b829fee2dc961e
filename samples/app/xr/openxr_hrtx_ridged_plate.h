/*
** XR_HRTX_ridged_plate: a ridged plate on a servo, over which the user slides a fingertip.
**
** A vendor extension of the mock runtime (samples/mock_runtime). Enable it in
** XrInstanceCreateInfo::enabledExtensionNames and fetch its functions with xrGetInstanceProcAddr. The
** author tag HRTX and the numbers of its structure types are not registered with Khronos.
**
** The plate frame: origin in the plate's centre of rotation, +Y the plate's normal (up), -Z its mid-line
** (straight away from the user), +X to the right. Directions are in degrees from the mid-line,
** counter-clockwise positive seen from above (left is positive); the orientation of the plate is the
** direction of the normal of its ridges. They are doubles, which XrTime-stamped recordings keep exactly.
**
** One plate per session. Every function may be called from any thread, in any state of the session, and
** returns, beside the results named below, XR_ERROR_HANDLE_INVALID, XR_ERROR_INSTANCE_LOST,
** XR_ERROR_SESSION_LOST, and XR_ERROR_VALIDATION_FAILURE for a null pointer, a wrong structure type, a
** number that is not finite or one out of its range. On failure outputs are untouched.
*/
#ifndef OPENXR_HRTX_RIDGED_PLATE_H_
#define OPENXR_HRTX_RIDGED_PLATE_H_

#include <openxr/openxr.h>

#ifdef __cplusplus
extern "C" {
#endif

#define XR_HRTX_ridged_plate 1
#define XR_HRTX_ridged_plate_SPEC_VERSION 2
#define XR_HRTX_RIDGED_PLATE_EXTENSION_NAME "XR_HRTX_ridged_plate"

#ifdef __cplusplus
#define XR_HRTX_STRUCTURE_TYPE(number) static_cast<XrStructureType>(number)
#else
#define XR_HRTX_STRUCTURE_TYPE(number) ((XrStructureType)(number))
#endif
#define XR_TYPE_PLATE_PLACEMENT_HRTX XR_HRTX_STRUCTURE_TYPE(1009990000)
#define XR_TYPE_REACH_INSTRUCTION_HRTX XR_HRTX_STRUCTURE_TYPE(1009990001)
#define XR_TYPE_REACH_TRUTH_HRTX XR_HRTX_STRUCTURE_TYPE(1009990002)

/* Where the plate is. */
typedef struct XrPlatePlacementHRTX {
  XrStructureType type; /* XR_TYPE_PLATE_PLACEMENT_HRTX */
  const void* XR_MAY_ALIAS next;
  XrSpace space;
  XrPosef pose;  /* of the plate frame in `space`, as `space` is located now */
  double radius; /* metres, in (0, 10] */
} XrPlatePlacementHRTX;

/* A reach that a simulated person shall make. */
typedef struct XrReachInstructionHRTX {
  XrStructureType type; /* XR_TYPE_REACH_INSTRUCTION_HRTX */
  const void* XR_MAY_ALIAS next;
  XrHandEXT hand;
  XrVector3f start;     /* of the index tip joint, in plate coordinates, metres; it slides at this height */
  double goalDirection; /* degrees, in [-180, 180]: where the person means to go (the virtual target) */
  double pathLength;    /* metres, in (0, 10] */
} XrReachInstructionHRTX;

/* What only a simulation can know of a reach. */
typedef struct XrReachTruthHRTX {
  XrStructureType type; /* XR_TYPE_REACH_TRUTH_HRTX */
  void* XR_MAY_ALIAS next;
  double trueDirection;      /* degrees: the direction in which the person steers the finger now */
  double perceivedDirection; /* degrees: the direction that the person feels now */
  double peakFeltError;      /* degrees, >= 0: largest difference between felt and goal direction so far, while
                                the finger moves */
  double leftmostDirection;  /* degrees: farther to the left, no plate within 75 degrees of the motion can hold
                                the finger while the person means to go to the goal */
  double rightmostDirection; /* degrees: farther to the right */
  double tactileWeight;      /* the share that touch has in what the person feels */
  XrVector3f indexTip;       /* of the joint, in plate coordinates, metres, without the tracker's errors */
  XrBool32 isDone;           /* the motion has ended */
} XrReachTruthHRTX;

/* Places the plate. XR_ERROR_POSE_INVALID if the pose is not valid. */
typedef XrResult(XRAPI_PTR* PFN_xrPlacePlateHRTX)(XrSession session, const XrPlatePlacementHRTX* placement);

/* The people, and the noise, come from this seed from now on; the next reach counts as number
** `nextReach`, from 0. A run from here on with the same seed, number, calls and times is the same to the
** last bit. At first the seed is 1, or the script's, and the number 0. */
typedef XrResult(XRAPI_PTR* PFN_xrSetSimulationSeedHRTX)(XrSession session, uint64_t seed, uint32_t nextReach);

/* Turns the plate: its servo gets a new target, in degrees within [-360, 360]. */
typedef XrResult(XRAPI_PTR* PFN_xrSetPlateOrientationHRTX)(XrSession session, double orientation);

/* The orientation of the plate at `time`: in the future, if the servo gets no further target; in the past, as
** now. XR_ERROR_TIME_INVALID if `time` is not positive. */
typedef XrResult(XRAPI_PTR* PFN_xrGetPlateOrientationHRTX)(XrSession session, XrTime time, double* orientation);

/* The person puts the fingertip to the start, reacts after 0.3 to 0.7 s and slides at a natural pace, 1 to 2
 *s,
 ** unless a script says otherwise. Every millisecond the person feels the plate as it stands then and steers.
 ** An instruction to a hand replaces the one before.
 ** XR_ERROR_CALL_ORDER_INVALID before the plate is placed. */
typedef XrResult(XRAPI_PTR* PFN_xrInstructReachHRTX)(XrSession session, const XrReachInstructionHRTX* instruction);

/* The truth about the hand's latest reach, now. XR_ERROR_CALL_ORDER_INVALID if there has been none. */
typedef XrResult(XRAPI_PTR* PFN_xrGetReachTruthHRTX)(XrSession session, XrHandEXT hand, XrReachTruthHRTX* truth);

#ifdef __cplusplus
}
#endif

#endif
