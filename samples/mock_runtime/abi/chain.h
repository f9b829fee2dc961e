// Structures that an application chains to another with `next`.
#pragma once

#include <openxr/openxr.h>

namespace hrt::mock {

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
