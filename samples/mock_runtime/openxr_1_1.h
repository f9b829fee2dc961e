// Declarations of OpenXR 1.1 and newer extensions that this runtime uses and Debian 12's header 1.0.20 lacks. Layouts
// and numbers are those of the Khronos registry.
#pragma once

#include <openxr/openxr.h>

// The lists of openxr_reflection.h, extended by OpenXR 1.1.
#define HRT_RESULTS_OF_1_1(X)                               \
  X(XR_ERROR_EXTENSION_DEPENDENCY_NOT_ENABLED, -1000710001) \
  X(XR_ERROR_PERMISSION_INSUFFICIENT, -1000710000)
#define HRT_STRUCTURE_TYPES_OF_1_1(X)       \
  X(XR_TYPE_SPACES_LOCATE_INFO, 1000471000) \
  X(XR_TYPE_SPACE_LOCATIONS, 1000471001)    \
  X(XR_TYPE_SPACE_VELOCITIES, 1000471002)

#ifndef XR_API_VERSION_1_1

#define HRT_DEFINE(name, number) inline constexpr auto name = static_cast<XrResult>(number);
HRT_RESULTS_OF_1_1(HRT_DEFINE)
#undef HRT_DEFINE
#define HRT_DEFINE(name, number) inline constexpr auto name = static_cast<XrStructureType>(number);
HRT_STRUCTURE_TYPES_OF_1_1(HRT_DEFINE)
#undef HRT_DEFINE
inline constexpr auto XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR = static_cast<XrReferenceSpaceType>(1000426000);

struct XrSpacesLocateInfo {
  XrStructureType type;
  const void* XR_MAY_ALIAS next;
  XrSpace baseSpace;
  XrTime time;
  uint32_t spaceCount;
  const XrSpace* spaces;
};

struct XrSpaceLocationData {
  XrSpaceLocationFlags locationFlags;
  XrPosef pose;
};

struct XrSpaceLocations {
  XrStructureType type;
  void* XR_MAY_ALIAS next;
  uint32_t locationCount;
  XrSpaceLocationData* locations;
};

struct XrSpaceVelocityData {
  XrSpaceVelocityFlags velocityFlags;
  XrVector3f linearVelocity;
  XrVector3f angularVelocity;
};

struct XrSpaceVelocities {
  XrStructureType type;
  void* XR_MAY_ALIAS next;
  uint32_t velocityCount;
  XrSpaceVelocityData* velocities;
};

using PFN_xrLocateSpaces = XrResult(XRAPI_PTR*)(XrSession session, const XrSpacesLocateInfo* locateInfo,
                                                XrSpaceLocations* spaceLocations);

#endif  // XR_API_VERSION_1_1

#ifndef XR_EXT_local_floor
#define XR_EXT_local_floor_SPEC_VERSION 1
#define XR_EXT_LOCAL_FLOOR_EXTENSION_NAME "XR_EXT_local_floor"
#endif
