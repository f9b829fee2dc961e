// Comparison of the paper's Table I and its other claims with the model.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/paper_simulation/trial.h"
#include "samples/study/numbers/results.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {

struct Table1Options {
  std::uint64_t trials = 20'000;  ///< number of trials in each cell
  std::uint64_t seed = 1;
  std::uint64_t horizon = 3;
  double sensory_variance_deg2 = 0.1;
  double plate_bound_deg = 84.5;  ///< largest angle between plate orientation and virtual direction
  std::uint64_t steps = 30;
  std::uint64_t threads = 1;
};

/// Sums over trials. The miss is the direction after the last step minus that of the real target; the felt error is the
/// perceived direction in the last step minus that of the virtual target.
struct TrialSums {
  std::uint64_t trials = 0;
  std::uint64_t hits = 0;
  double miss_deg = 0.0, miss_deg2 = 0.0, felt_error_deg2 = 0.0;

  void add(const Condition& condition, const TrialOutcome& outcome);
  void add(const TrialSums& other);
  double hit_percent() const { return 100.0 * static_cast<double>(hits) / static_cast<double>(trials); }
  double mean_miss_deg() const { return miss_deg / static_cast<double>(trials); }
  double rms_miss_deg() const { return std::sqrt(miss_deg2 / static_cast<double>(trials)); }
  double rms_felt_error_deg() const { return std::sqrt(felt_error_deg2 / static_cast<double>(trials)); }
};

/// One pair of targets under one condition.
struct Cell {
  Condition condition;
  TrialSums result;
  std::optional<double> paper_percent;  ///< nullopt: the paper has no value for this cell
};

struct CellGroup {
  std::string name;  ///< name in CSV and JSON
  std::string title;
  std::vector<Cell> cells;
  std::optional<double> paper_percent;  ///< the paper's mean over the cells
  std::optional<double> paper_sd;       ///< SD over the cells in the paper
  bool reproduced = false;              ///< the model agrees with the paper
  std::string verdict;                  ///< the result in words; empty in Table1::amplitudes

  double mean_percent() const;
  /// Returns the expected SD over the cells if each has the paper's 50 trials.
  double sd_percent() const;
  /// Returns the 95 % interval of the paper's mean, with 50 trials per cell; nullopt: the paper has no value.
  std::optional<PercentInterval> paper_interval() const;
};

/// Returns the 95 % interval of the paper's percentage of 50 trials. Requires cell.paper_percent.
PercentInterval paper_interval(const Cell& cell);
/// Returns true if the model's percentage lies within paper_interval(). Requires cell.paper_percent.
bool agrees(const Cell& cell);

/// Gaps that are simulated, to find the one with most reaches on target. The paper chose 10 deg (section III-A).
inline constexpr double amplitudes_deg[] = {2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0};
inline constexpr std::size_t paper_amplitude = 4;  // index of 10 degrees in amplitudes_deg

struct Table1 {
  Table1Options options;
  std::vector<CellGroup> conditions;  ///< the four conditions of Table I
  std::vector<CellGroup> claims;      ///< the paper's other claims
  std::vector<CellGroup> amplitudes;  ///< for each condition of Table I, a group for each of amplitudes_deg
  double chi_squared;                 ///< over all cells of `conditions`
  double log_likelihood;              ///< of the paper's trials in `conditions`, without binomial coefficients
  int degrees_of_freedom;
  double p_value;
};

inline constexpr const char* in_sample_words =
    "The p value is biased upwards if the bound on the plate (84.5 deg; the paper has 90) and the sensory variance "
    "(0.1 deg^2; the paper gives none) have their defaults, which were fitted to these same cells. hrt-study table1 "
    "--plate-bound 90 uses the paper's bound; samples/study/paper/README.md compares the possible interpretations of "
    "the paper.";

/// The gap with the highest percentage in a condition, compared with the paper's 10 degrees.
struct BestAmplitude {
  double gap_deg;
  double percent;
  double paper_amplitude_percent;
  bool by_chance;  ///< the difference from the percentage at 10 degrees is not significant
};
BestAmplitude best_amplitude(const Table1& table, std::size_t condition);

Table1 simulate_table1(const Table1Options& options);

/// Returns the upper bound of the percentage for any controller, due to the noise of the last step, which the plate
/// cannot correct.
double limit_percent(const Condition& condition);

std::string table1_text(const Table1& table);
/// Returns one row per cell; `about` has the conditions and the other claims.
Results table1_results(const Table1& table);

}  // namespace hrt::study
