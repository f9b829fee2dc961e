// Structures of the API, which carry their type and are chained with `next`.
#pragma once

#include <cstring>
#include <string_view>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/openxr_hrtx_mock_control.h"

namespace hrt::mock {

/// Value of the member `type` of a structure of the API, and both names; other types have empty names.
struct StructureType {
  XrStructureType type = XR_TYPE_UNKNOWN;
  const char* name = nullptr;
  const char* type_name = nullptr;
};
template <typename Struct>
inline constexpr StructureType structure_type{};
#define HRT_MOCK_TYPE(Struct, type) \
  template <>                       \
  inline constexpr StructureType structure_type<Struct>{type, #Struct, #type};
XR_LIST_STRUCTURE_TYPES(HRT_MOCK_TYPE)
#ifndef XR_API_VERSION_1_1
HRT_MOCK_TYPE(XrSpacesLocateInfo, XR_TYPE_SPACES_LOCATE_INFO)
HRT_MOCK_TYPE(XrSpaceLocations, XR_TYPE_SPACE_LOCATIONS)
HRT_MOCK_TYPE(XrSpaceVelocities, XR_TYPE_SPACE_VELOCITIES)
#endif
HRT_MOCK_TYPE(XrPlatePlacementHRTX, XR_TYPE_PLATE_PLACEMENT_HRTX)
HRT_MOCK_TYPE(XrReachInstructionHRTX, XR_TYPE_REACH_INSTRUCTION_HRTX)
HRT_MOCK_TYPE(XrReachTruthHRTX, XR_TYPE_REACH_TRUTH_HRTX)
HRT_MOCK_TYPE(XrCallRecordHRTX, XR_TYPE_CALL_RECORD_HRTX)
#undef HRT_MOCK_TYPE

template <typename Struct>
concept Typed = structure_type<std::remove_cv_t<Struct>>.name != nullptr;

/// Valid usage: "pointer must be a pointer to a valid structure", of which only the type can be checked.
template <Typed Struct>
void require_struct(const Struct* pointer) {
  constexpr StructureType expected = structure_type<Struct>;
  require_pointer(pointer, expected.name);
  if (pointer->type != expected.type)
    throw Error{XR_ERROR_VALIDATION_FAILURE,
                std::string(expected.name) + " has a type other than " + expected.type_name};
}

/// First structure of this type in a chain; null if the chain has no such structure.
template <Typed Struct, typename Chain>
Struct* chained(Chain* chain) {
  using Base = std::conditional_t<std::is_const_v<Chain>, const XrBaseInStructure, XrBaseOutStructure>;
  for (auto* next = static_cast<Base*>(chain); next != nullptr; next = next->next)
    if (next->type == structure_type<std::remove_cv_t<Struct>>.type) return reinterpret_cast<Struct*>(next);
  return nullptr;
}

/// Text in a character array of the API, which may lack its terminator.
template <std::size_t size>
std::string_view text_in(const char (&array)[size]) {
  return {array, strnlen(array, size)};
}

}  // namespace hrt::mock
