#include "samples/app/person/quest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hrt::app {
namespace {

constexpr double prior_threshold_deg = 14.0;
constexpr double prior_sd_log2 = 1.0;
constexpr int threshold_steps = 61;  // number of thresholds, over +-4 SDs of the prior

double entropy(double share) {
  const double other = 1.0 - share;
  return (share > 0.0 ? -share * std::log(share) : 0.0) + (other > 0.0 ? -other * std::log(other) : 0.0);
}

QuestPlus::Grid grid_between(double min_gap_deg, double max_gap_deg) {
  QuestPlus::Grid grid{.slopes = {1.0, 1.5, 2.0, 3.0, 4.5}, .lapses = {0.0, 0.01, 0.02, 0.03, 0.05}};
  constexpr double steps_per_decade = 20.0;
  const int steps = static_cast<int>(std::lround(steps_per_decade * std::log10(max_gap_deg / min_gap_deg)));
  for (int i = 0; i <= steps; ++i)
    grid.gaps.push_back(min_gap_deg * std::pow(max_gap_deg / min_gap_deg, i / (1.0 * steps)));
  for (int i = 0; i < threshold_steps; ++i) {
    const double deviations = 4.0 * (2.0 * i / (threshold_steps - 1) - 1.0);
    grid.thresholds.push_back(prior_threshold_deg * std::exp2(prior_sd_log2 * deviations));
    grid.prior.push_back(std::exp(-0.5 * deviations * deviations));
  }
  return grid;
}

}  // namespace

double right_share(double gap, double threshold, double slope, double lapse) {
  return 1.0 - lapse - (0.5 - lapse) * std::exp(-std::pow(gap / threshold, slope));
}

QuestPlus::QuestPlus(double min_gap_deg, double max_gap_deg) : QuestPlus(grid_between(min_gap_deg, max_gap_deg)) {}

QuestPlus::QuestPlus(const Grid& grid) : gaps_(grid.gaps), threshold_count_(grid.thresholds.size()) {
  for (std::size_t i = 0; i < threshold_count_; ++i)
    for (const double slope : grid.slopes)
      for (const double lapse : grid.lapses) {
        people_.push_back({grid.thresholds[i], slope, lapse});
        posterior_.push_back(grid.prior[i]);
      }
  const double sum = std::accumulate(posterior_.begin(), posterior_.end(), 0.0);
  for (double& probability : posterior_) probability /= sum;
  for (const double gap : gaps_)
    for (const Person& person : people_) {
      right_.push_back(right_share(gap, person.threshold, person.slope, person.lapse));
      uncertainty_.push_back(entropy(right_.back()));
    }
}

// The expected decrease of the posterior's entropy is the mutual information of answer and person: the entropy of the
// answer minus its expected entropy given the person.
double QuestPlus::next_gap_deg(double max_gap_deg) const {
  double best = -1.0, best_gap = gaps_.front();
  for (std::size_t g = 0; g < gaps_.size() && gaps_[g] <= max_gap_deg; ++g) {
    double right = 0.0, left_unknown = 0.0;
    for (std::size_t p = 0; p < people_.size(); ++p) {
      right += posterior_[p] * right_[g * people_.size() + p];
      left_unknown += posterior_[p] * uncertainty_[g * people_.size() + p];
    }
    const double learnt = entropy(right) - left_unknown;
    if (learnt <= best) continue;
    best = learnt;
    best_gap = gaps_[g];
  }
  return best_gap;
}

void QuestPlus::update(double gap_deg, bool is_right) {
  ++answers_;
  double sum = 0.0;
  for (std::size_t p = 0; p < people_.size(); ++p) {
    const double right = right_share(gap_deg, people_[p].threshold, people_[p].slope, people_[p].lapse);
    posterior_[p] *= is_right ? right : 1.0 - right;
    sum += posterior_[p];
  }
  for (double& probability : posterior_) probability /= sum;
}

QuestPlus::Threshold QuestPlus::threshold() const {
  double mean_log = 0.0;
  for (std::size_t p = 0; p < people_.size(); ++p) mean_log += posterior_[p] * std::log(people_[p].threshold);
  const std::size_t each = people_.size() / threshold_count_;
  const double step = std::log(people_[each].threshold / people_.front().threshold);
  const auto quantile = [&](double share) {
    double below = 0.0;
    for (std::size_t p = 0; p < people_.size(); p += each) {
      const auto first = posterior_.begin() + static_cast<std::ptrdiff_t>(p);
      const double here = std::accumulate(first, first + static_cast<std::ptrdiff_t>(each), 0.0);
      below += here;
      if (below < share) continue;
      // Interpolates: the probability of each threshold is spread evenly, in its logarithm, over a cell of the grid.
      return people_[p].threshold * std::exp(step * (0.5 - (below - share) / here));
    }
    return people_.back().threshold;
  };
  constexpr double tail = 0.025;
  return {std::exp(mean_log), quantile(tail), quantile(1.0 - tail)};
}

}  // namespace hrt::app
