// The paper's Table I and its other claims beside the model's results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/paper_simulation/batch.h"
#include "samples/study/numbers/results.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {

struct Table1Options {
  std::uint64_t trials = 20'000;  ///< of each cell
  std::uint64_t seed = 1;
  std::uint64_t horizon = 3;
  double sensory_variance_deg2 = 0.1;
  double plate_bound_deg = 84.5;  ///< about the virtual direction
  std::uint64_t steps = 30;       ///< of a reach
  std::uint64_t threads = 1;
};

/// One pair of targets under one condition.
struct Cell {
  Condition condition;
  BatchResult result;
  std::optional<double> paper_percent;  ///< if the paper gives one for this very cell
};

/// Several cells and the paper's mean over them.
struct CellGroup {
  std::string name;  ///< a word, for CSV and JSON
  std::string title;
  std::vector<Cell> cells;
  std::optional<double> paper_percent;  ///< the paper's mean over the cells
  std::optional<double> paper_sd;       ///< and their standard deviation
  bool reproduced = false;              ///< ours agrees with the paper's
  std::string verdict;                  ///< the same in words, and why

  double mean_percent() const;
  /// The standard deviation that the cells' percentages have if each is of the paper's 50 trials.
  double sd_percent() const;
  /// The 95 % interval of the paper's mean, each cell having had the paper's 50 trials.
  std::optional<PercentInterval> paper_interval() const;
};

/// The 95 % interval of the paper's percentage of 50 trials.
PercentInterval paper_interval(const Cell& cell);
/// Our percentage lies within it.
bool agrees(const Cell& cell);

/// Section III-A: 10 deg "was chosen because is the one that gives an higher percentage".
inline constexpr double amplitudes_deg[] = {2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0};
inline constexpr std::size_t paper_amplitude = 4;  // its place

struct Table1 {
  Table1Options options;
  std::vector<CellGroup> conditions;  ///< the four of Table I
  std::vector<CellGroup> claims;      ///< the paper's other claims
  std::vector<CellGroup> amplitudes;  ///< of every condition of Table I, one of each of amplitudes_deg
  double chi_squared;                 ///< over all cells of `conditions`
  double log_likelihood;              ///< of the paper's 50 trials in each of them, without the binomial coefficients
  int degrees_of_freedom;
  double p_value;
};

/// The limits of chi-squared here, for reports.
inline constexpr const char* in_sample_words =
    "In-sample: the paper does not give the sensory variance (0.1 deg^2 by default), and the default bound on the "
    "plate "
    "(84.5 deg, where section III has 90) was fitted to these cells, so p is too high. --plate-bound 90 is the paper's "
    "own bound; samples/study/paper/README.md compares the readings.";

/// The amplitude that does best under a condition, and whether the paper's 10 deg does as well within chance.
struct BestAmplitude {
  double gap_deg;
  double percent;
  double paper_amplitude_percent;
  bool by_chance;
};
BestAmplitude best_amplitude(const Table1& table, std::size_t condition);

/// Simulates all of it, with a progress bar.
Table1 simulate_table1(const Table1Options& options);

/// The largest percentage that any controller reaches: the noise of the last step comes after the plate
/// has acted.
double limit_percent(const Condition& condition);

std::string table1_text(const Table1& table);
/// A row a cell; groups of cells are in `about`.
Results table1_results(const Table1& table);

}  // namespace hrt::study
