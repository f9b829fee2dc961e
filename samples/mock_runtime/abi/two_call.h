// The two-call idiom: an application requests the count first, then the elements.
#pragma once

#include <cstdint>

#include "samples/mock_runtime/abi/structure.h"

namespace hrt::mock {

/// Specification, "Buffer Size Parameters": the count output is always set to the number of elements;
/// a capacity of 0 requests nothing else; one that is too small gives XR_ERROR_SIZE_INSUFFICIENT and
/// leaves the buffer unchanged. `copy(element, source)` fills one element. The application sets the types of
/// elements that are structures.
template <typename Source, typename Element, typename Copy>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Element* elements, Copy copy) {
  if constexpr (Typed<Element>)
    for (std::uint32_t i = 0; i < capacity && elements != nullptr; ++i) require_struct(&elements[i]);
  require_pointer(count, "the count output");
  if (capacity > 0) require_pointer(elements, "the buffer of a capacity above 0");
  const auto needed = static_cast<std::uint32_t>(source.size());
  *count = needed;
  if (capacity == 0) return;
  require(capacity >= needed, XR_ERROR_SIZE_INSUFFICIENT, "the buffer is too small");
  std::size_t i = 0;
  for (const auto& value : source) copy(elements[i++], value);
}

template <typename Source, typename Element>
void two_call(const Source& source, std::uint32_t capacity, std::uint32_t* count, Element* elements) {
  two_call(source, capacity, count, elements, [](Element& to, const auto& from) { to = from; });
}

}  // namespace hrt::mock
