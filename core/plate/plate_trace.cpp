#include "core/plate/plate_trace.h"

namespace hrt {

void PlateTrace::add(double time_s, double orientation_deg) {
  const bool crowded = count_ >= 2 && time_s - entry(count_ - 2).time_s < min_spacing_s;
  if (crowded) {
    --count_;
  } else if (count_ == capacity) {
    first_ = (first_ + 1) % capacity;
    --count_;
  }
  entries_[static_cast<std::size_t>((first_ + count_++) % capacity)] = {time_s, orientation_deg};
}

double PlateTrace::at(double time_s) const {
  int i = count_ - 1;
  while (i > 0 && entry(i).time_s > time_s) --i;
  const Entry& before = entry(i);
  if (i == count_ - 1 || time_s <= before.time_s) return before.orientation_deg;
  const Entry& after = entry(i + 1);
  const double share = (time_s - before.time_s) / (after.time_s - before.time_s);
  return before.orientation_deg + share * (after.orientation_deg - before.orientation_deg);
}

}  // namespace hrt
