// What applications pass: structures chained with `next`, and the two-call idiom, by which they ask for the
// count, then for the elements.
#pragma once

#include <openxr/openxr.h>

#include <algorithm>
#include <cstdint>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {

/// Specification, "Buffer Size Parameters": the count output is always set to the number of elements;
/// a capacity of 0 asks for nothing else; a smaller one than needed is XR_ERROR_SIZE_INSUFFICIENT and
/// leaves the buffer unwritten. `copy(element, source)` fills one element.
template <typename Source, typename Element, typename Copy>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Element* elements, Copy copy) {
  require_pointer(count, "the count output");
  if (capacity > 0) require_pointer(elements, "the buffer of a capacity above 0");
  const auto needed = static_cast<std::uint32_t>(source.size());
  *count = needed;
  if (capacity == 0) return;
  require(capacity >= needed, XR_ERROR_SIZE_INSUFFICIENT, "the buffer is too small");
  std::size_t i = 0;
  for (const auto& value : source) copy(elements[i++], value);
}

/// The same for structures, whose type the application sets.
template <typename Source, typename Struct, typename Copy>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Struct* structs, XrStructureType type,
              const char* name, Copy copy) {
  for (std::uint32_t i = 0; i < capacity && structs != nullptr; ++i) require_struct(&structs[i], type, name);
  two_call(source, capacity, count, structs, copy);
}

template <typename Source, typename Element>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Element* elements) {
  two_call(source, capacity, count, elements, [](Element& to, const auto& from) { to = from; });
}

/// The first structure of a chain that has this type; null if there is none.
template <typename Struct>
Struct* chained(void* chain, XrStructureType type) {
  for (auto* next = static_cast<XrBaseOutStructure*>(chain); next != nullptr; next = next->next)
    if (next->type == type) return reinterpret_cast<Struct*>(next);
  return nullptr;
}
template <typename Struct>
const Struct* chained(const void* chain, XrStructureType type) {
  for (auto* next = static_cast<const XrBaseInStructure*>(chain); next != nullptr; next = next->next)
    if (next->type == type) return reinterpret_cast<const Struct*>(next);
  return nullptr;
}

}  // namespace hrt::mock
