// Handles: numbers that identify objects, and are checked at every use.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "plugin/src/abi/error.h"

namespace hrt::plugin {

/// Up to `capacity` objects. A handle contains the index of a slot and the slot's generation, which increases with
/// every object in the slot, so that a stale handle is invalid. Handles of tables with different `kind` differ. Any
/// member may be called from any thread; an object is leased to one caller at a time.
template <class Object, std::size_t capacity, std::uint8_t kind>
class HandleTable {
  // A handle, from its highest bit: the kind, the slot's generation, the slot's index.
  static constexpr int index_bits = 16;
  static constexpr int kind_shift = 56;
  static_assert(capacity <= std::size_t{1} << index_bits);

 public:
  constexpr HandleTable() = default;

  /// Access to an object for the lifetime of the lease. If result() is not HRT_OK, there is no object.
  class Lease {
   public:
    explicit Lease(hrt_result failure) : result_(failure) {}
    Lease(Object& object, std::atomic<std::uint64_t>& state, std::uint64_t idle)
        : object_(&object), state_(&state), idle_(idle) {}
    ~Lease() {
      if (state_) state_->store(idle_, std::memory_order_release);
    }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    hrt_result result() const { return result_; }
    Object& operator*() const { return *object_; }

   private:
    hrt_result result_ = HRT_OK;
    Object* object_ = nullptr;
    std::atomic<std::uint64_t>* state_ = nullptr;
    std::uint64_t idle_ = 0;
  };

  /// Adds an object and returns its handle. If the table is full, destroys the object and returns 0.
  std::uint64_t insert(std::unique_ptr<Object> object) {
    for (std::size_t index = 0; index < capacity; ++index) {
      Slot& slot = slots_[index];
      std::uint64_t state = slot.state.load(std::memory_order_acquire);
      if ((state & (live | busy)) != 0 || !slot.state.compare_exchange_strong(state, state | busy)) continue;
      slot.object = std::move(object);
      const std::uint64_t generation = (state >> generation_shift) + 1;
      slot.state.store(generation << generation_shift | live, std::memory_order_release);
      count_.fetch_add(1);
      return std::uint64_t{kind} << kind_shift | generation << index_bits | index;
    }
    return 0;
  }

  /// Leases an object. Fails with BUSY or INVALID_HANDLE.
  Lease lease(std::uint64_t handle) {
    Slot* slot = find(handle);
    if (!slot) return Lease(HRT_ERROR_INVALID_HANDLE);
    const std::uint64_t idle = idle_state(handle);
    if (const hrt_result result = take(*slot, idle); result != HRT_OK) return Lease(result);
    return Lease(*slot->object, slot->state, idle);
  }

  hrt_result destroy(std::uint64_t handle) {
    Slot* slot = find(handle);
    if (!slot) return HRT_ERROR_INVALID_HANDLE;
    const std::uint64_t idle = idle_state(handle);
    if (const hrt_result result = take(*slot, idle); result != HRT_OK) return result;
    slot->object.reset();
    slot->state.store(idle & ~live, std::memory_order_release);
    count_.fetch_sub(1);
    return HRT_OK;
  }

  std::size_t count() const { return count_.load(); }

 private:
  // Bits of a slot's state: a call has leased its object; it has an object; from generation_shift, its generation.
  static constexpr std::uint64_t busy = 1;
  static constexpr std::uint64_t live = 2;
  static constexpr int generation_shift = 2;

  struct Slot {
    std::atomic<std::uint64_t> state{0};
    std::unique_ptr<Object> object;
  };

  Slot* find(std::uint64_t handle) {
    const std::size_t index = handle & ((std::uint64_t{1} << index_bits) - 1);
    return handle >> kind_shift == kind && index < capacity ? &slots_[index] : nullptr;
  }

  static std::uint64_t idle_state(std::uint64_t handle) {
    const std::uint64_t generation = (handle & ~(std::uint64_t{0xff} << kind_shift)) >> index_bits;
    return generation << generation_shift | live;
  }

  static hrt_result take(Slot& slot, std::uint64_t idle) {
    std::uint64_t seen = idle;
    if (slot.state.compare_exchange_strong(seen, idle | busy, std::memory_order_acquire)) return HRT_OK;
    return seen == (idle | busy) ? HRT_ERROR_BUSY : HRT_ERROR_INVALID_HANDLE;
  }

  std::array<Slot, capacity> slots_;
  std::atomic<std::size_t> count_{0};
};

/// Sets the error of a failed lease or destruction. `what` is the kind of the object, such as "session".
inline hrt_result no_lease(hrt_result reason, const char* what, std::uint64_t handle) {
  if (reason == HRT_ERROR_BUSY)
    return fail(reason, "another thread is in a call on this ", what, "; wait until it returns");
  return fail(reason, what, " ", handle, " does not exist; it was destroyed or never created");
}

/// Runs the body of an entry point on the object of a handle. `what` is the kind of the object, such as "session".
template <class Table, class Body>
hrt_result with_lease(const char* call, const char* what, Table& table, std::uint64_t handle, Body&& body) noexcept {
  return guarded(call, [&]() -> hrt_result {
    const typename Table::Lease lease = table.lease(handle);
    return lease.result() == HRT_OK ? body(*lease) : no_lease(lease.result(), what, handle);
  });
}

/// Destroys the object of a handle. `what` is the kind of the object, such as "session".
template <class Table>
hrt_result destroy(const char* call, const char* what, Table& table, std::uint64_t handle) noexcept {
  return guarded(call, [&]() -> hrt_result {
    const hrt_result result = table.destroy(handle);
    return result == HRT_OK ? HRT_OK : no_lease(result, what, handle);
  });
}

}  // namespace hrt::plugin
