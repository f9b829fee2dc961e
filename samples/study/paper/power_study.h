// The power study as text, and as rows of numbers.
#pragma once

#include <string>
#include <vector>

#include "samples/study/numbers/results.h"
#include "samples/study/paper/power.h"

namespace hrt::study {

struct PowerOptions {
  PoolOptions pool;
  std::vector<const PeopleFamily*> families;
  std::vector<double> effects_deg{0.5, 1.0, 2.0, 4.0};
  std::vector<double> reaches{1, 5, 20};                    ///< whole; under each condition
  std::vector<double> people{4, 6, 8, 12, 16, 24, 32, 48};  ///< whole; in a trial
  std::uint64_t trials = 4000;                              ///< simulated, of each number
};

/// The power of trials for one effect and number of people.
struct PowerPoint {
  std::uint64_t people;
  Share found;
};

/// One effect with one number of reaches.
struct PowerRow {
  double effect_deg;
  std::uint64_t reaches;
  std::vector<PowerPoint> points;
  PeopleNeeded for_80;
  PeopleNeeded for_90;
};

/// The people of the pool with one number of reaches.
struct PoolSpread {
  std::uint64_t reaches;
  Spread difference_deg;
  Quantile with_deg;  ///< median of a person's mean error
  Quantile without_deg;
};

struct PowerStudy {
  PowerOptions options;
  std::vector<PoolSpread> pool;     ///< one each number of reaches
  std::vector<PowerRow> rows;       ///< by reaches, then effect
  std::vector<PowerRow> no_effect;  ///< how often chance is found, one each number of reaches
};

/// Simulates pool and trials, with a progress bar.
PowerStudy simulate_power(const PowerOptions& options);

std::string power_text(const PowerStudy& study);
/// A row an effect, number of reaches and number of people.
Results power_results(const PowerStudy& study);

}  // namespace hrt::study
