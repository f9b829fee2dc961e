// Where the plate stood in the last second: a finger feels it later than it stands there, and is seen later
// still.
#pragma once

#include <array>

namespace hrt {

/// No heap, no lock, no exception. One thread at a time.
class PlateTrace {
 public:
  void clear() { count_ = 0; }

  /// The plate stands at `orientation_deg` at `time_s`, not before the last entry's.
  void add(double time_s, double orientation_deg);

  /// Where it stood then: linear between entries, constant beyond. Requires one add().
  double at(double time_s) const;

 private:
  struct Entry {
    double time_s;
    double orientation_deg;
  };
  const Entry& entry(int i) const { return entries_[static_cast<unsigned>(first_ + i) % capacity]; }

  static constexpr int capacity = 128;
  // Of every other entry: together they span a second.
  static constexpr double min_spacing_s = 0.016;
  std::array<Entry, capacity> entries_{};
  int first_ = 0;
  int count_ = 0;
};

}  // namespace hrt
