#include "core/paper_simulation/trial_table_run.h"

namespace hrt {

double TrialTable::next_offset_deg(int k, double offset_deg) const {
  const double offsets[] = {offset_deg};
  double next[1];
  next_offsets<ScalarLanes>(step(k), offsets, next);
  return next[0];
}

template BatchResult TrialTable::run<ScalarLanes>(std::uint64_t, std::uint32_t, std::uint32_t, std::uint32_t) const;
#if defined(__GNUC__)
template BatchResult TrialTable::run<PairLanes>(std::uint64_t, std::uint32_t, std::uint32_t, std::uint32_t) const;
#endif

}  // namespace hrt
