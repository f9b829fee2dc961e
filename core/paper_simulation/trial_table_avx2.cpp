// Compiled for AVX2, which TrialTable::run() looks for. Instantiates templates over QuadLanes only: a
// function that other sources have too could be linked in place of theirs, and fail on another processor.
#include "core/paper_simulation/trial_table_run.h"

namespace hrt {

template BatchResult TrialTable::run<QuadLanes>(std::uint64_t, std::uint32_t, std::uint32_t, std::uint32_t) const;

}  // namespace hrt
