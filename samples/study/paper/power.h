// How many people a first trial needs. Simulated people reach with and without the controller; a trial draws
// from them, and a paired t test compares the two. Results are of simulation.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/simulation/people.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {

/// What the controller is compared with.
enum class Against {
  none,   ///< no controller: the plate stays at 0
  paper,  ///< the paper's controller, which assumes w_T = 0.15
};

/// A person's reaches under both conditions, in their order: sizes of the error of the real target's bearing.
struct PairedReaches {
  std::vector<double> with_deg;  ///< ours, which carries what it learns from reach to reach
  std::vector<double> without_deg;
};

struct PoolOptions {
  std::uint64_t people = 20;   ///< of each family
  std::uint64_t reaches = 20;  ///< of each person under each condition
  Against against = Against::none;
  double scatter_deg = 0.0;  ///< added to each reach's error: independent and normal, standard deviation
  std::uint64_t seed = 1;
  std::uint64_t threads = 1;
};

/// People of the families, each family the same number, at a pace of 1 to 2 s; those who cannot hold the gap
/// too. The same for any number of threads. `progress` is called on this thread.
std::vector<PairedReaches> simulate_pool(
    std::span<const PeopleFamily* const> families, const PoolOptions& options,
    const std::function<void(std::uint64_t done, std::uint64_t total)>& progress = {});

/// By how much the controller lessens each person's error: the mean of the first `reaches` reaches without
/// it, less that with it.
std::vector<double> differences_deg(std::span<const PairedReaches> pool, std::uint64_t reaches);

/// A mean of a sample and a standard deviation, each with a 95 % interval from 1000 resamples of the sample.
struct Spread {
  Quantile mean;
  Quantile sd;
};
Spread spread(std::span<const double> values, std::uint64_t seed);

/// The share of `trials` trials of `people` >= 2 people, drawn with replacement, whose paired t test finds
/// that the controller lessens the error (two-sided, 5 %). The differences are shifted to the mean
/// `effect`: people differ as those of the pool do, whatever the effect.
Share trial_power(std::span<const double> differences, double effect, std::uint64_t people,
                  std::uint64_t trials, std::uint64_t seed);

/// The fewest people, of 2 to `max_people`, with whom `wanted_percent` of trials find the effect;
/// max_people
/// + 1 if there is none. With its 95 % interval over resampled pools.
struct PeopleNeeded {
  std::uint64_t people;
  std::uint64_t low;
  std::uint64_t high;
};
inline constexpr std::uint64_t max_people = 1000;
PeopleNeeded people_needed(std::span<const double> differences, double effect, double wanted_percent,
                           std::uint64_t trials, std::uint64_t seed);

}  // namespace hrt::study
