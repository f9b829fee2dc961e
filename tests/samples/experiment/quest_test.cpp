#include "samples/app/person/quest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "samples/experiment/design/draws.h"

namespace hrt::experiment {
namespace {

using app::QuestPlus;
using app::right_share;

// By hand, for a lapse rate of 0.02: 0.98 - 0.48 / e at the threshold; 0.5 far below it; 0.98 far above it.
TEST(ExperimentQuest, ProbabilityOfACorrectAnswer) {
  EXPECT_NEAR(right_share(10, 10, 3, 0.02), 0.98 - 0.48 * 0.36787944117144233, 1e-15);
  EXPECT_NEAR(right_share(1e-9, 10, 2, 0.02), 0.5, 1e-12);
  EXPECT_NEAR(right_share(1000, 10, 2, 0.02), 0.98, 1e-12);
}

// A sequence of the Python package questplus 2023.1 (Höchenberger; Weibull in dB, min_entropy, mean): indices of the
// selected gaps in the grid, given answers (1: correct), and the mean of the threshold after each `every` answers.
struct Published {
  QuestPlus quest;
  std::vector<std::size_t> chosen;
  std::string answers;
  std::size_t every;
  std::vector<double> means;
};

void expect_as_published(Published run) {
  ASSERT_EQ(run.chosen.size(), run.answers.size());
  ASSERT_EQ(run.means.size(), run.answers.size() / run.every);
  for (std::size_t i = 0; i < run.answers.size(); ++i) {
    const double gap = run.quest.next_gap_deg();
    ASSERT_NEAR(gap, run.quest.gaps_deg()[run.chosen[i]], 1e-9 * gap) << i;
    run.quest.update(gap, run.answers[i] == '1');
    if ((i + 1) % run.every != 0) continue;
    EXPECT_NEAR(run.quest.threshold().deg, run.means[i / run.every], 2e-6) << i;
  }
}

// The grid of hrt-experiment. Observers have thresholds of 8° and 20°, below and above the median of the prior.
TEST(ExperimentQuest, AgreesWithAPublishedImplementation) {
  expect_as_published({QuestPlus(1, 30),
                       {24, 23, 22, 22, 21, 20, 24, 24, 23, 23, 23, 22, 22, 20, 19, 18, 18, 22, 22, 22,
                        21, 21, 18, 18, 17, 17, 17, 21, 23, 23, 23, 23, 23, 18, 18, 17, 17, 17, 23, 18,
                        17, 17, 17, 17, 17, 17, 17, 17, 17, 16, 22, 22, 22, 17, 16, 16, 16, 16, 22, 22},
                       "111110111111111101111111110011111111101111111011101111111011",
                       10,
                       {10.093563, 8.815963, 9.128915, 8.453615, 8.075686, 7.687575}});
  expect_as_published({QuestPlus(1, 30),
                       {24, 23, 28, 27, 30, 30, 30, 29, 29, 28, 28, 26, 26, 25, 29, 29, 29, 28, 28, 25,
                        24, 29, 29, 28, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 25, 25, 25,
                        25, 25, 25, 25, 25, 30, 30, 30, 25, 25, 30, 30, 30, 25, 30, 30, 30, 30, 25, 30},
                       "101011111111101111110110011110111111111110110111101110111101",
                       10,
                       {19.46203, 17.671312, 24.680209, 20.809271, 22.091236, 22.514258}});
}

// The example of Watson (2017) with threshold, slope and lapse rate, from the tests of questplus.
TEST(ExperimentQuest, AgreesWithTheExampleOfThePaper) {
  QuestPlus::Grid grid{.slopes = {2, 3, 4, 5}, .lapses = {0, 0.01, 0.02, 0.03, 0.04}};
  for (int db = -40; db <= 0; ++db) grid.gaps.push_back(std::pow(10.0, db / 20.0));
  grid.thresholds = grid.gaps;
  grid.prior.assign(grid.gaps.size(), 1.0);
  std::vector<std::size_t> chosen;
  for (const int db :
       {-18, -22, -25, -28, -30, -21, -12, -14, -15, -16, -18, -19, -20, -22, -23, -18, -19, -16, -17, -17, -18, -18,
        -18, -19, -19, -17, -17, -18, -18, -18, -18, -19, -19, -20, -18, -18, -18, -18, -18, -19, -19, -19, -19, -20,
        -18, -18, -18, -18, -18, -18, -18, -18, -18, -19, -19, -19, -20, -18, -18, -18, -18, -19, -19, -19, -18, -18,
        -18, -18, -19, -19, -19, -19, -19, -19, -19, -19, -20, -21, -19, -19, -19, -19, -19, -19, -19, -18, -19, -19,
        -16, -16, -16, -16, -16, -16, 0,   0,   -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19,
        -21, -21, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19})
    chosen.push_back(static_cast<std::size_t>(40 + db));
  std::vector<double> means;
  for (const double db : {-20.342574, -19.811471, -19.356445, -19.452162, -19.589517, -19.53091, -19.87428, -19.597275})
    means.push_back(std::pow(10.0, db / 20.0));
  expect_as_published({QuestPlus(grid), chosen,
                       "1111001111111101011111110111111110111111111011101111111101111110"
                       "1111111111111010111101101111111011111111111111101110100111101111",
                       16, means});
}

// 300 observers (or HRT_EXPERIMENT_OBSERVERS) are drawn from the prior, with lapse rates up to 3 %.
TEST(ExperimentQuest, RecoversThresholds) {
  const char* const wanted = std::getenv("HRT_EXPERIMENT_OBSERVERS");
  const unsigned observers = wanted != nullptr ? static_cast<unsigned>(std::stoi(wanted)) : 300;
  double sum = 0.0, squares = 0.0;
  unsigned covered = 0;
  for (unsigned i = 0; i < observers; ++i) {
    Stream draw(Use::answers, {2, i});
    const double radius = std::sqrt(-2.0 * std::log(1.0 - draw.uniform()));
    const double threshold = 14.0 * std::exp2(radius * std::cos(2.0 * std::numbers::pi * draw.uniform()));
    const double slope = std::pow(4.5, draw.uniform()), lapse = 0.03 * draw.uniform();
    QuestPlus quest(1, 30);
    for (int trial = 0; trial < 60; ++trial) {
      const double gap = quest.next_gap_deg();
      quest.update(gap, draw.uniform() < right_share(gap, threshold, slope, lapse));
    }
    const QuestPlus::Threshold found = quest.threshold();
    const double error = std::log10(found.deg / threshold);
    sum += error;
    squares += error * error;
    covered += found.lower_deg <= threshold && threshold <= found.upper_deg ? 1 : 0;
  }
  const double bias = sum / observers, sd = std::sqrt(squares / observers - bias * bias);
  const double coverage = 100.0 * covered / observers;
  std::printf("%u observers: bias %.1f %%, SD of log10 %.3f, coverage %.1f %%\n", observers,
              100.0 * (std::pow(10.0, bias) - 1.0), sd, coverage);
  EXPECT_LT(std::abs(bias), std::log10(1.05) + 2.0 * sd / std::sqrt(observers));
  EXPECT_LT(sd, 0.17);
  EXPECT_GT(coverage, 93.0);
  EXPECT_LT(coverage, 98.0);
}

}  // namespace
}  // namespace hrt::experiment
