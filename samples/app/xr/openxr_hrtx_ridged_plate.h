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
** direction of the normal of its ridges. Angles are doubles.
**
** There is one plate per session. Every function may be called from any thread, in any state of the session.
** In addition to the results named below, each returns XR_ERROR_HANDLE_INVALID, XR_ERROR_INSTANCE_LOST and
** XR_ERROR_SESSION_LOST. XR_ERROR_VALIDATION_FAILURE means an invalid argument, such as a null pointer, a wrong
** structure type, or a number that is not finite or out of range. On failure outputs are unchanged.
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

/* Pose and size of the plate. */
typedef struct XrPlatePlacementHRTX {
  XrStructureType type; /* XR_TYPE_PLATE_PLACEMENT_HRTX */
  const void* XR_MAY_ALIAS next;
  XrSpace space;
  XrPosef pose;  /* pose of the plate frame in `space`, as `space` is located now */
  double radius; /* metres, in (0, 10] */
} XrPlatePlacementHRTX;

/* A reach that the simulated participant is to make. */
typedef struct XrReachInstructionHRTX {
  XrStructureType type; /* XR_TYPE_REACH_INSTRUCTION_HRTX */
  const void* XR_MAY_ALIAS next;
  XrHandEXT hand;
  XrVector3f start;     /* index tip joint, plate coordinates, metres; it slides at this height */
  double goalDirection; /* degrees, in [-180, 180]: intended direction (virtual target) */
  double pathLength;    /* metres, in (0, 10] */
} XrReachInstructionHRTX;

/* Ground truth of a reach, which only a simulation has. */
typedef struct XrReachTruthHRTX {
  XrStructureType type; /* XR_TYPE_REACH_TRUTH_HRTX */
  void* XR_MAY_ALIAS next;
  double trueDirection;      /* degrees: present direction of motion */
  double perceivedDirection; /* degrees: present perceived direction */
  double peakFeltError;      /* degrees, >= 0: largest perceived-direction error so far, while the finger moves */
  double leftmostDirection;  /* degrees: leftmost feasible direction with this goal and a plate
                                orientation within 75 degrees of the motion */
  double rightmostDirection; /* degrees: rightmost feasible direction */
  double tactileWeight;      /* w_T: fraction of touch in the perceived direction */
  XrVector3f indexTip;       /* joint in plate coordinates, metres, without the tracker's errors */
  XrBool32 isDone;           /* the motion has ended */
} XrReachTruthHRTX;

/* Places the plate. XR_ERROR_POSE_INVALID if the pose is not valid. */
typedef XrResult(XRAPI_PTR* PFN_xrPlacePlateHRTX)(XrSession session, const XrPlatePlacementHRTX* placement);

/* Sets the seed from which participants and noise are drawn; the next reach has number `nextReach`, from 0.
** Later results are bit-identical for the same seed, number, calls and times. The initial seed is 1, or the
** script's; the initial number is 0. */
typedef XrResult(XRAPI_PTR* PFN_xrSetSimulationSeedHRTX)(XrSession session, uint64_t seed, uint32_t nextReach);

/* Sets the target of the plate's servo, in degrees within [-360, 360]. */
typedef XrResult(XRAPI_PTR* PFN_xrSetPlateOrientationHRTX)(XrSession session, double orientation);

/* Returns the orientation of the plate at `time`: predicted for a future time, as if no further target were set;
** the present orientation for a past time. XR_ERROR_TIME_INVALID if `time` is not positive. */
typedef XrResult(XRAPI_PTR* PFN_xrGetPlateOrientationHRTX)(XrSession session, XrTime time, double* orientation);

/* Instructs the participant to put the fingertip on the start, react after 0.3 to 0.7 s and slide for 1 to 2 s,
** unless a script sets other values. Every millisecond the participant feels the plate's present orientation and
** steers. An instruction replaces the previous one of the same hand.
** XR_ERROR_CALL_ORDER_INVALID before the plate is placed. */
typedef XrResult(XRAPI_PTR* PFN_xrInstructReachHRTX)(XrSession session, const XrReachInstructionHRTX* instruction);

/* Returns the ground truth of the hand's latest reach. XR_ERROR_CALL_ORDER_INVALID before the first reach. */
typedef XrResult(XRAPI_PTR* PFN_xrGetReachTruthHRTX)(XrSession session, XrHandEXT hand, XrReachTruthHRTX* truth);

#ifdef __cplusplus
}
#endif

#endif
