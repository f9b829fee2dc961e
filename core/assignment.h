// Bottleneck assignment of rows to columns: the largest cost of an assigned pair is minimal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hrt {

/// Element of the result of assign_exclusively() for a row to which no column is assigned.
inline constexpr std::size_t unserved = static_cast<std::size_t>(-1);

/// Returns the column of each row, or `unserved`; no column is assigned to two rows. `costs`: row after row, `columns`
/// costs for each, finite or +infinity, which forbids the pair. As many rows as possible are assigned; among these
/// assignments, the largest cost is minimal. Uses the heap. Takes O(E sqrt(V) log E) for E costs and V rows and
/// columns.
std::vector<std::size_t> assign_exclusively(std::span<const double> costs, std::size_t columns);

}  // namespace hrt
