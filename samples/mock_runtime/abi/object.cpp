#include "samples/mock_runtime/abi/object.h"

namespace hrt::mock {

void Registry::forget(Object& object) {
  for (const auto& child : object.children_) forget(*child);
  objects_.erase(object.id_);
}

void Registry::destroy(Object& object) {
  forget(object);
  auto& siblings = object.parent_ != nullptr ? object.parent_->children_ : roots_;
  std::erase_if(siblings, [&](const auto& sibling) { return sibling.get() == &object; });
}

}  // namespace hrt::mock
