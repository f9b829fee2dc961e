// Objects behind the application's handles. They form a tree: an instance owns its sessions and action sets, a session
// its spaces, swapchains and hand trackers, an action set its actions. Destroying an object destroys its descendants.
#pragma once

#include <openxr/openxr.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {

class Object {
 public:
  Object(XrObjectType type, Object* parent) : type_(type), parent_(parent) {}
  virtual ~Object() = default;
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  XrObjectType type() const { return type_; }
  Object* parent() const { return parent_; }
  std::uint64_t id() const { return id_; }

  /// XR_SUCCESS, or XR_ERROR_INSTANCE_LOST or XR_ERROR_SESSION_LOST after a loss. Registry::get() throws that error for
  /// this object and its descendants.
  XrResult lost = XR_SUCCESS;

 private:
  friend class Registry;
  XrObjectType type_;
  Object* parent_;
  std::uint64_t id_ = 0;
  std::vector<std::unique_ptr<Object>> children_;
};

template <typename Handle>
std::uint64_t id_of(Handle handle) {
  static_assert(sizeof(Handle) == sizeof(std::uint64_t), "handles must have 64 bits");
  return reinterpret_cast<std::uint64_t>(handle);
}

/// Finds objects by handles, which are numbers: they are never reused or dereferenced, so invalid ones are detected.
class Registry {
 public:
  template <typename T, typename Parent, typename... Args>
  T& create(Parent* parent, Args&&... args) {
    auto object = std::make_unique<T>(parent, std::forward<Args>(args)...);
    T& created = *object;
    created.id_ = next_id_++;
    objects_.emplace(created.id_, &created);
    Object* owner = parent;
    (owner != nullptr ? owner->children_ : roots_).push_back(std::move(object));
    return created;
  }

  /// Returns the object of a handle. Throws XR_ERROR_HANDLE_INVALID, or the error of a lost object or ancestor.
  template <typename T, typename Handle>
  T& get(Handle handle) const {
    T& object = get_even_lost<T>(handle);
    for (const Object* ancestor = &object; ancestor != nullptr; ancestor = ancestor->parent())
      require(ancestor->lost == XR_SUCCESS, ancestor->lost,
              "the session or instance of this handle is lost; destroy the lost object and create a new one");
    return object;
  }

  /// Returns the object of a handle even if it is lost. Throws XR_ERROR_HANDLE_INVALID.
  template <typename T, typename Handle>
  T& get_even_lost(Handle handle) const {
    const auto found = objects_.find(id_of(handle));
    require(found != objects_.end(), XR_ERROR_HANDLE_INVALID,
            "handle {:#x} is null or destroyed, or was never returned by this runtime; pass a valid handle",
            id_of(handle));
    require(found->second->type() == T::object_type, XR_ERROR_HANDLE_INVALID,
            "handle {:#x} has XrObjectType {}; the function needs XrObjectType {}", id_of(handle),
            static_cast<int>(found->second->type()), static_cast<int>(T::object_type));
    return static_cast<T&>(*found->second);
  }

  /// Returns the children of one type, oldest first.
  template <typename T>
  std::vector<T*> children(const Object& parent) const {
    std::vector<T*> found;
    for (const auto& child : parent.children_)
      if (child->type() == T::object_type) found.push_back(static_cast<T*>(child.get()));
    return found;
  }

  bool has_child(const Object& parent, XrObjectType type) const {
    return std::any_of(parent.children_.begin(), parent.children_.end(),
                       [&](const auto& child) { return child->type() == type; });
  }

  template <typename T, typename Handle>
  void destroy(Handle handle) {
    destroy(get_even_lost<T>(handle));
  }
  void destroy(Object& object) {
    forget(object);
    auto& siblings = object.parent_ != nullptr ? object.parent_->children_ : roots_;
    std::erase_if(siblings, [&](const auto& sibling) { return sibling.get() == &object; });
  }

 private:
  void forget(Object& object) {
    for (const auto& child : object.children_) forget(*child);
    objects_.erase(object.id_);
  }

  // The first handle is far from 0 and small integers, which a faulty application is likely to pass.
  std::uint64_t next_id_ = 0x4852'5458'0000'0001;
  std::unordered_map<std::uint64_t, Object*> objects_;
  std::vector<std::unique_ptr<Object>> roots_;
};

template <typename Handle>
Handle handle_of(const Object& object) {
  return reinterpret_cast<Handle>(object.id());
}

}  // namespace hrt::mock
