#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace hrt::plate {

/// Value that one thread writes and any number of threads read without a lock. The writer fills several slots in turn;
/// a reader whose slot was overwritten during the copy copies the latest slot, so that it gets a complete value.
template <class Value>
class Snapshot {
  static_assert(std::is_trivially_copyable_v<Value>);

 public:
  void publish(const Value& value) {
    Words words{};
    std::memcpy(words.data(), &value, sizeof value);
    const std::uint64_t number = latest_.load(std::memory_order_relaxed) + 1;
    Slot& slot = slots_[number % slots];
    slot.number.store(0, std::memory_order_relaxed);
    // A reader that loads one of the new words also sees that the number has changed (release, acquire).
    for (std::size_t i = 0; i < words.size(); ++i) slot.words[i].store(words[i], std::memory_order_release);
    slot.number.store(number, std::memory_order_release);
    latest_.store(number, std::memory_order_release);
  }

  /// Returns the latest value; zeros before the first publish().
  Value read() const {
    Value value{};
    for (;;) {
      const std::uint64_t number = latest_.load(std::memory_order_acquire);
      if (number == 0) return value;
      const Slot& slot = slots_[number % slots];
      if (slot.number.load(std::memory_order_acquire) != number) continue;
      Words words;
      for (std::size_t i = 0; i < words.size(); ++i) words[i] = slot.words[i].load(std::memory_order_acquire);
      if (slot.number.load(std::memory_order_relaxed) != number) continue;
      std::memcpy(&value, words.data(), sizeof value);
      return value;
    }
  }

 private:
  static constexpr std::size_t slots = 4;
  using Words = std::array<std::uint64_t, (sizeof(Value) + 7) / 8>;
  struct Slot {
    std::atomic<std::uint64_t> number{0};
    std::array<std::atomic<std::uint64_t>, std::tuple_size_v<Words>> words{};
  };
  std::array<Slot, slots> slots_;
  std::atomic<std::uint64_t> latest_{0};
};

}  // namespace hrt::plate
