// The tree of objects behind the application's handles: an instance owns its sessions, a session its
// spaces, and so on. Destroying an object destroys all below it.
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

  /// XR_SUCCESS; after a loss XR_ERROR_INSTANCE_LOST or XR_ERROR_SESSION_LOST, which every call with this object or one
  /// below it returns.
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
  static_assert(sizeof(Handle) == sizeof(std::uint64_t), "handles are 64 bits here");
  return reinterpret_cast<std::uint64_t>(handle);
}

/// Every existing object by its handle. A handle is a number that is never reused and never dereferenced, so null,
/// foreign and destroyed handles are recognised.
class Registry {
 public:
  template <typename T, typename Parent, typename... Args>
  T& create(Parent* parent, Args&&... args) {
    auto object = std::make_unique<T>(parent, std::forward<Args>(args)...);
    T& created = *object;
    created.id_ = next_id_++;
    objects_.emplace(created.id_, &created);
    Object* above = parent;
    (above != nullptr ? above->children_ : roots_).push_back(std::move(object));
    return created;
  }

  /// Object of a handle. Throws XR_ERROR_HANDLE_INVALID, or the error of a lost object or parent.
  template <typename T, typename Handle>
  T& get(Handle handle) const {
    T& object = get_even_lost<T>(handle);
    for (const Object* above = &object; above != nullptr; above = above->parent())
      require(above->lost == XR_SUCCESS, above->lost, "the session or instance of this handle is lost");
    return object;
  }

  /// Same as get(), but accepts lost objects, for functions that destroy them.
  template <typename T, typename Handle>
  T& get_even_lost(Handle handle) const {
    const auto found = objects_.find(id_of(handle));
    require(found != objects_.end(), XR_ERROR_HANDLE_INVALID, "no such handle, or it has been destroyed");
    require(found->second->type() == T::object_type, XR_ERROR_HANDLE_INVALID, "a handle of another type");
    return static_cast<T&>(*found->second);
  }

  /// The children of one type, oldest first.
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

  // Far from 0 and from small integers, which a broken application is likely to pass.
  std::uint64_t next_id_ = 0x4852'5458'0000'0001;
  std::unordered_map<std::uint64_t, Object*> objects_;
  std::vector<std::unique_ptr<Object>> roots_;
};

template <typename Handle>
Handle handle_of(const Object& object) {
  return reinterpret_cast<Handle>(object.id());
}

}  // namespace hrt::mock
