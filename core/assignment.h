// Bottleneck assignment of rows to columns: the largest cost of an assigned pair is minimal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hrt {

/// Value in the result for a row without a column.
inline constexpr std::size_t unserved = static_cast<std::size_t>(-1);

/// Assigns a column to each row; each column has at most one row. `costs` has a row of `columns` costs for each row; an
/// infinite cost forbids the pair. As many rows as possible are assigned, and of all such assignments the largest cost
/// is the smallest. The choice among several such assignments is deterministic. Uses the heap; O(E sqrt(V) log E) for E
/// finite costs.
std::vector<std::size_t> assign_exclusively(std::span<const double> costs, std::size_t columns);

}  // namespace hrt
