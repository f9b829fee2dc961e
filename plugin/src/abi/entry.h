// Entry points of the C interface: guarded() runs the body of one, and HandleTable::with() that of a call on an object.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

#include "plugin/src/abi/arithmetic.h"
#include "plugin/src/abi/error.h"

namespace hrt::plugin {

/// Runs the body of the entry point `call`, and converts every exception to a result.
template <class Body>
hrt_result guarded(const char* call, Body&& body) noexcept {
  thread_error.call = call;
  const FloatingPointModeGuard arithmetic;
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return fail(HRT_ERROR_OUT_OF_MEMORY, "memory is exhausted; release memory and call again");
  } catch (const std::system_error& error) {
    return fail(HRT_ERROR_SYSTEM, error.what(), "; check the file, the disk and the limits of the process");
  } catch (const std::exception& error) {
    return fail(HRT_ERROR_INTERNAL, error.what(), "; this is a defect of the library: report it");
  } catch (...) {
    return fail(HRT_ERROR_INTERNAL, "an exception of unknown type; this is a defect of the library: report it");
  }
}

/// A table of up to `capacity` objects, which handles identify. A handle contains the index of a slot and the slot's
/// generation, which increases with every object in the slot, so that a stale handle is invalid. Handles of tables with
/// different `kind` differ. All functions may be called on any thread; only one call at a time can use an object.
template <class Object, std::size_t capacity, std::uint8_t kind>
class HandleTable {
  // A handle, from its highest bit: the kind, the slot's generation, the slot's index.
  static constexpr int index_bits = 16;
  static constexpr int kind_shift = 56;
  static_assert(capacity <= std::size_t{1} << index_bits);

 public:
  /// `noun` is the kind of the objects in error texts, such as "session".
  constexpr explicit HandleTable(const char* noun) : noun_(noun) {}

  /// Adds an object and returns its handle. If the table is full, destroys the object and returns 0.
  std::uint64_t insert(std::unique_ptr<Object> object) {
    for (std::size_t index = 0; index < capacity; ++index) {
      Slot& slot = slots_[index];
      std::uint64_t state = slot.state.load(std::memory_order_acquire);
      if ((state & (live | busy)) != 0 || !slot.state.compare_exchange_strong(state, state | busy)) continue;
      slot.object = std::move(object);
      const std::uint64_t generation = (state >> generation_shift) + 1;
      slot.state.store(generation << generation_shift | live, std::memory_order_release);
      return std::uint64_t{kind} << kind_shift | generation << index_bits | index;
    }
    return 0;
  }

  /// Runs `body` on the object of a handle. Fails with BUSY or INVALID_HANDLE. `call`: name of the entry point, for
  /// error texts.
  template <class Body>
  hrt_result with(const char* call, std::uint64_t handle, Body&& body) noexcept {
    return with_slot(call, handle, [&](Slot& slot) -> hrt_result { return body(*slot.object); });
  }

  /// Destroys the object of a handle. Fails with BUSY or INVALID_HANDLE.
  hrt_result destroy(const char* call, std::uint64_t handle) noexcept {
    return with_slot(call, handle, [](Slot& slot) {
      slot.object.reset();
      return HRT_OK;
    });
  }

 private:
  // Bits of a slot's state: `busy` during a call, `live` while the slot has an object; all higher bits: generation.
  static constexpr std::uint64_t busy = 1;
  static constexpr std::uint64_t live = 2;
  static constexpr int generation_shift = 2;

  struct Slot {
    std::atomic<std::uint64_t> state{0};
    std::unique_ptr<Object> object;
  };

  template <class Body>
  hrt_result with_slot(const char* call, std::uint64_t handle, Body&& body) noexcept {
    return guarded(call, [&]() -> hrt_result {
      const std::size_t index = handle & ((std::uint64_t{1} << index_bits) - 1);
      const std::uint64_t generation = (handle & ~(std::uint64_t{0xff} << kind_shift)) >> index_bits;
      const std::uint64_t idle = generation << generation_shift | live;
      std::uint64_t seen = idle;
      if (handle >> kind_shift != kind || index >= capacity ||
          !slots_[index].state.compare_exchange_strong(seen, idle | busy, std::memory_order_acquire)) {
        if (seen == (idle | busy))
          return fail(HRT_ERROR_BUSY, "another thread is in a call on this ", noun_, "; wait until it returns");
        return fail(HRT_ERROR_INVALID_HANDLE, noun_, " ", handle,
                    " does not exist: it was destroyed or never created; create it first");
      }
      const auto release = [idle](Slot* slot) {  // also called if the body throws
        slot->state.store(slot->object ? idle : idle & ~live, std::memory_order_release);
      };
      const std::unique_ptr<Slot, decltype(release)> slot(&slots_[index], release);
      return body(*slot);
    });
  }

  const char* noun_;
  std::array<Slot, capacity> slots_;
};

}  // namespace hrt::plugin
