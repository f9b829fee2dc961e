#include "core/assignment.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

/// Maximum matching of the pairs whose cost is within a limit, by the algorithm of Hopcroft and Karp: each round
/// augments along several disjoint paths, which a breadth-first search has found.
class Matching {
 public:
  Matching(std::span<const double> costs, std::size_t columns, double limit)
      : costs_(costs),
        columns_(columns),
        limit_(limit),
        column_of_(costs.size() / columns, unserved),
        row_of_(columns, unserved),
        depth_(column_of_.size()),
        next_(column_of_.size()) {
    while (find_depths()) {
      std::fill(next_.begin(), next_.end(), 0);
      for (std::size_t row = 0; row < column_of_.size(); ++row)
        if (column_of_[row] == unserved && augment(row)) ++size_;
    }
  }

  std::size_t size() const { return size_; }
  const std::vector<std::size_t>& column_of() const { return column_of_; }

 private:
  bool joins(std::size_t row, std::size_t column) const { return costs_[row * columns_ + column] <= limit_; }

  // Breadth-first search from all unassigned rows: sets the depth of each row to the number of assigned pairs on the
  // shortest path to it, or to `unserved` if no path leads to it. Returns true if a path reaches an unassigned column.
  bool find_depths() {
    queue_.clear();
    for (std::size_t row = 0; row < column_of_.size(); ++row) {
      depth_[row] = column_of_[row] == unserved ? 0 : unserved;
      if (column_of_[row] == unserved) queue_.push_back(row);
    }
    bool leads = false;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const std::size_t row = queue_[head];
      for (std::size_t column = 0; column < columns_; ++column) {
        if (!joins(row, column)) continue;
        const std::size_t other = row_of_[column];
        if (other == unserved) {
          leads = true;
        } else if (depth_[other] == unserved) {
          depth_[other] = depth_[row] + 1;
          queue_.push_back(other);
        }
      }
    }
    return leads;
  }

  // Depth-first search from row `from` along increasing depths. If it reaches an unassigned column, assigns along the
  // path and returns true. Not recursive: a path may contain all rows, which could overflow the call stack.
  bool augment(std::size_t from) {
    path_.assign(1, from);
    while (!path_.empty()) {
      const std::size_t row = path_.back();
      bool deeper = false;
      for (; next_[row] < columns_ && !deeper; ++next_[row]) {
        const std::size_t column = next_[row];
        if (!joins(row, column)) continue;
        const std::size_t other = row_of_[column];
        if (other == unserved) {
          take(column);
          return true;
        }
        if (depth_[other] != depth_[row] + 1) continue;
        path_.push_back(other);
        deeper = true;
      }
      if (!deeper) path_.pop_back();
    }
    return false;
  }

  // Assigns to each row of the path the column of the row after it, and the free column to the last row.
  void take(std::size_t free_column) {
    for (std::size_t i = path_.size(); i-- > 0;) {
      const std::size_t row = path_[i];
      const std::size_t former = column_of_[row];
      column_of_[row] = free_column;
      row_of_[free_column] = row;
      free_column = former;
    }
  }

  std::span<const double> costs_;
  std::size_t columns_;
  double limit_;
  std::vector<std::size_t> column_of_;
  std::vector<std::size_t> row_of_;
  std::vector<std::size_t> depth_;
  std::vector<std::size_t> next_;  // for each row, the next column that augment() tries
  std::vector<std::size_t> queue_;
  std::vector<std::size_t> path_;
  std::size_t size_ = 0;
};

}  // namespace

std::vector<std::size_t> assign_exclusively(std::span<const double> costs, std::size_t columns) {
  std::vector<double> limits;
  for (const double cost : costs)
    if (std::isfinite(cost)) limits.push_back(cost);
  if (limits.empty()) return std::vector<std::size_t>(columns == 0 ? 0 : costs.size() / columns, unserved);
  std::sort(limits.begin(), limits.end());
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  const std::size_t max = Matching(costs, columns, limits.back()).size();
  const auto min = std::partition_point(limits.begin(), limits.end() - 1,
                                        [&](double limit) { return Matching(costs, columns, limit).size() < max; });
  return Matching(costs, columns, *min).column_of();
}

}  // namespace hrt
