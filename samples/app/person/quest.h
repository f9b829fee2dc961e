// QUEST+ (Watson 2017), implemented from the published equations: measures the gap (the angle between real and virtual
// target) that a person can detect. Selects the gap whose answer is expected to reduce the entropy of the posterior
// over threshold, slope and lapse rate the most.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace hrt::app {

/// Probability of a correct answer in a task with two intervals:
/// 1 - lapse - (1/2 - lapse) exp(-(gap / threshold)^slope).
double right_share(double gap, double threshold, double slope, double lapse);

class QuestPlus {
 public:
  /// Values of gap, threshold, slope and lapse rate. `prior` has the unnormalised probability of each threshold; slopes
  /// and lapse rates have uniform priors. Thresholds must rise, and be spaced equally in their logarithm.
  struct Grid {
    std::vector<double> gaps, thresholds, prior, slopes, lapses;
  };
  explicit QuestPlus(const Grid& grid);
  /// Gaps from `min_gap_deg` to `max_gap_deg` in steps of about 1 dB (20 log10). The prior of the threshold is
  /// log-normal: median 14 degrees (threshold of touch, Keyson 1995), SD a factor of 2, so that 4.5 degrees (threshold
  /// of vision) is 1.6 SDs below the median.
  QuestPlus(double min_gap_deg, double max_gap_deg);

  /// Returns the most informative of the gaps up to `max_gap_deg`; the smallest gap if all are larger.
  double next_gap_deg(double max_gap_deg = std::numeric_limits<double>::infinity()) const;
  void update(double gap_deg, bool is_right);

  /// Estimate (posterior mean in the logarithm) and the quantiles that bound its 95 % interval.
  struct Threshold {
    double deg;
    double lower_deg;
    double upper_deg;
  };
  Threshold threshold() const;
  unsigned answers() const { return answers_; }
  const std::vector<double>& gaps_deg() const { return gaps_; }

 private:
  struct Person {
    double threshold;
    double slope;
    double lapse;
  };

  unsigned answers_ = 0;
  std::vector<double> gaps_;
  std::size_t threshold_count_;
  std::vector<Person> people_;       // points of the grid, sorted by threshold
  std::vector<double> posterior_;    // posterior probability of each of people_
  std::vector<double> right_;        // right_share() for each gap and person
  std::vector<double> uncertainty_;  // entropy of the answer, in nats, for each gap and person
};

}  // namespace hrt::app
