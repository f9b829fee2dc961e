#include "samples/experiment/session/quest.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "samples/experiment/design/draws.h"

namespace hrt::experiment {
namespace {

// By hand: at the threshold 1 - l - (1/2 - l) / e; far below it a half; far above it all but the lapses.
TEST(ExperimentQuest, ShareOfRightAnswers) {
  EXPECT_NEAR(right_share(10, 10, 3, 0.02), 0.98 - 0.48 * 0.36787944117144233, 1e-15);
  EXPECT_NEAR(right_share(1e-9, 10, 2, 0.02), 0.5, 1e-12);
  EXPECT_NEAR(right_share(1000, 10, 2, 0.02), 0.98, 1e-12);
}

// The published method (Watson 2017, section 2), slowly: Bayes over a cube, entropies of both possible
// posteriors.
class SlowQuest {
 public:
  SlowQuest() {
    for (int t = 0; t < 61; ++t)
      for (const double slope : {1.0, 1.5, 2.0, 3.0, 4.5})
        for (const double lapse : {0.0, 0.01, 0.02, 0.03, 0.05}) {
          const double z = -4.0 + 8.0 * t / 60.0;
          people_.push_back({14.0 * std::pow(2.0, z), slope, lapse, std::exp(-z * z / 2.0)});
        }
  }

  double expected_entropy(double gap) const {
    double total = 0.0, expected = 0.0;
    for (const auto& p : people_) total += p[3];
    for (const bool is_right : {true, false}) {
      double share = 0.0, entropy = 0.0;
      for (const auto& p : people_) share += p[3] / total * likelihood(p, gap, is_right);
      for (const auto& p : people_) {
        const double posterior = p[3] / total * likelihood(p, gap, is_right) / share;
        if (posterior > 0.0) entropy -= posterior * std::log(posterior);
      }
      expected += share * entropy;
    }
    return expected;
  }
  void update(double gap, bool is_right) {
    for (auto& p : people_) p[3] *= likelihood(p, gap, is_right);
  }
  double mean() const {
    double total = 0.0, sum = 0.0;
    for (const auto& p : people_) {
      total += p[3];
      sum += p[3] * std::log(p[0]);
    }
    return std::exp(sum / total);
  }

 private:
  static double likelihood(const std::array<double, 4>& p, double gap, bool is_right) {
    const double right = 0.5 + (0.5 - p[2]) * (1.0 - std::exp(-std::pow(gap / p[0], p[1])));
    return is_right ? right : 1.0 - right;
  }

  std::vector<std::array<double, 4>> people_;  // threshold, slope, lapse, belief
};

TEST(ExperimentQuest, ChoosesAndLearnsAsTheSlowOne) {
  QuestPlus quest(1, 30);
  SlowQuest slow;
  Stream draw(Use::answers, {1});
  for (int trial = 0; trial < 20; ++trial) {
    double best = 1e9, best_gap = 0.0;
    for (const double gap : quest.gaps_deg()) {
      const double entropy = slow.expected_entropy(gap);
      if (entropy < best - 1e-12) {
        best = entropy;
        best_gap = gap;
      }
    }
    const double gap = quest.next_gap_deg();
    ASSERT_NEAR(slow.expected_entropy(gap), best, 1e-9) << trial;
    EXPECT_NEAR(gap, best_gap, 1e-9) << trial;
    const bool is_right = draw.uniform() < right_share(gap, 8, 2, 0.02);
    quest.update(gap, is_right);
    slow.update(gap, is_right);
    EXPECT_NEAR(quest.threshold().deg, slow.mean(), 1e-9);
  }
}

// Observers as the prior has them, with lapses to 3 %. HRT_EXPERIMENT_OBSERVERS has more than the 300 here.
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
