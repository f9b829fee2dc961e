#include "samples/study/numbers/parallel.h"

#include <gtest/gtest.h>

namespace hrt::study {
namespace {

TEST(StudyParallel, EachIterationRunsOnceAndProgressReachesTheTotal) {
  for (const std::uint64_t threads : {1U, 4U}) {
    std::vector<int> runs(1000);
    std::uint64_t last = 0;
    for_each_part(
        runs.size(), threads, [&](std::uint64_t i) { ++runs[i]; },
        [&](std::uint64_t done, std::uint64_t total) {
          EXPECT_EQ(total, runs.size());
          EXPECT_GT(done, last);
          last = done;
        });
    EXPECT_EQ(runs, std::vector<int>(1000, 1));
    if (threads == 1) {
      EXPECT_EQ(last, runs.size());
    }
  }
}

}  // namespace
}  // namespace hrt::study
