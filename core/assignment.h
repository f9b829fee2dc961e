// Who serves whom: rows to columns, so that the costliest pair costs as little as possible.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hrt {

/// Of a row that no column serves.
inline constexpr std::size_t unserved = static_cast<std::size_t>(-1);

/// The column that serves each row, each column one row at most. `costs` has a row of `columns` costs for
/// each row; infinite: this column cannot serve this row. As many rows as possible are served, and of all
/// such assignments the largest cost is the smallest. Of several such assignments always the same. Uses the
/// heap; O(E sqrt(V) log E) for E finite costs.
std::vector<std::size_t> assign_exclusively(std::span<const double> costs, std::size_t columns);

}  // namespace hrt
