// Bottleneck assignment of rows to columns: the largest cost of an assigned pair is minimal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hrt {

/// Value in the result for a row to which no column is assigned.
inline constexpr std::size_t unserved = static_cast<std::size_t>(-1);

/// Assigns at most one column to each row and at most one row to each column. `costs` has `columns` costs for each row;
/// an infinite cost forbids the pair. The number of assigned rows is maximal, and among such assignments the largest
/// cost is minimal. Deterministic. Uses the heap. Takes O(E sqrt(V) log E) for E costs, V rows and columns.
std::vector<std::size_t> assign_exclusively(std::span<const double> costs, std::size_t columns);

}  // namespace hrt
