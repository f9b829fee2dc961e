// The points of a sweep: every combination of the lists given, numbered, each with the CSV row it becomes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/paper_simulation/batch.h"
#include "samples/study/cli/parameters.h"

namespace hrt::study {

class Grid {
 public:
  std::vector<double> virtual_directions_deg{5.0};
  std::vector<double> gaps_deg{10.0};
  std::array<std::vector<double>, std::tuple_size_v<ParameterValues>> values;  ///< as `parameters`

  /// Every list at its default.
  Grid();

  /// The number of points. Throws UsageError if there are more than 2^32 - 1.
  std::uint64_t size() const;

  /// Point `index` < size(); the last list varies fastest.
  Condition at(std::uint64_t index) const;
};

/// The header of the CSV, with its line end.
std::string grid_header();

/// A row, with its line end.
std::string grid_row(std::uint64_t index, const Condition& condition, std::uint64_t seed, const BatchResult& result);

}  // namespace hrt::study
