// OpenXR structures: each begins with its type and with `next`, a pointer to the next structure of a chain.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/mock_runtime/error.h"

namespace hrt::mock {

/// Required `type` of an OpenXR structure, and the structure's name, which is null for other C++ types.
struct StructureType {
  XrStructureType type = XR_TYPE_UNKNOWN;
  const char* name = nullptr;
};
template <typename Struct>
inline constexpr StructureType structure_type{};
#define HRT_MOCK_TYPE(Struct, type) \
  template <>                       \
  inline constexpr StructureType structure_type<Struct>{type, #Struct};
XR_LIST_STRUCTURE_TYPES(HRT_MOCK_TYPE)
HRT_MOCK_TYPE(XrPlatePlacementHRTX, XR_TYPE_PLATE_PLACEMENT_HRTX)
HRT_MOCK_TYPE(XrReachInstructionHRTX, XR_TYPE_REACH_INSTRUCTION_HRTX)
HRT_MOCK_TYPE(XrReachTruthHRTX, XR_TYPE_REACH_TRUTH_HRTX)
#undef HRT_MOCK_TYPE

template <typename Struct>
concept Typed = structure_type<std::remove_cv_t<Struct>>.name != nullptr;

/// Throws XR_ERROR_VALIDATION_FAILURE unless `pointer` points to a structure with the right type.
template <Typed Struct>
void require_struct(const Struct* pointer) {
  constexpr StructureType expected = structure_type<Struct>;
  require_pointer(pointer, expected.name);
  if (pointer->type != expected.type)
    require_valid(false, "{}::type is {}; must be {}", expected.name, name_of(pointer->type), name_of(expected.type));
}

/// First structure of this type in a chain; null if the chain has no such structure.
template <Typed Struct, typename Chain>
Struct* chained(Chain* chain) {
  using Base = std::conditional_t<std::is_const_v<Chain>, const XrBaseInStructure, XrBaseOutStructure>;
  for (auto* next = static_cast<Base*>(chain); next != nullptr; next = next->next)
    if (next->type == structure_type<std::remove_cv_t<Struct>>.type) return reinterpret_cast<Struct*>(next);
  return nullptr;
}

/// Text in a character array of an OpenXR structure, which may lack its terminating null character.
template <std::size_t size>
std::string_view text_in(const char (&array)[size]) {
  return {array, strnlen(array, size)};
}

/// Implements "Buffer Size Parameters" of the specification: `count` receives the number of elements; a capacity of 0
/// requests nothing else; with a capacity that is too small the call returns XR_ERROR_SIZE_INSUFFICIENT and leaves the
/// buffer unchanged. `copy(element, source)` fills one element. Elements that are structures must have their types.
template <typename Source, typename Element, typename Copy>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Element* elements, Copy copy) {
  if constexpr (Typed<Element>)
    for (std::uint32_t i = 0; i < capacity && elements != nullptr; ++i) require_struct(&elements[i]);
  require_pointer(count, "the output for the number of elements");
  if (capacity > 0) require_pointer(elements, "the buffer, whose capacity is above 0,");
  const auto needed = static_cast<std::uint32_t>(source.size());
  *count = needed;
  if (capacity == 0) return;
  require(capacity >= needed, XR_ERROR_SIZE_INSUFFICIENT, "the capacity is {}; must be 0 or at least {}", capacity,
          needed);
  std::size_t i = 0;
  for (const auto& value : source) copy(elements[i++], value);
}

template <typename Source, typename Element>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Element* elements) {
  two_call(source, capacity, count, elements, [](Element& to, const auto& from) { to = from; });
}

}  // namespace hrt::mock
