#include "core/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/simulation/random.h"

namespace hrt {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Quality {
  std::size_t served = 0;
  double max = 0.0;
  bool operator==(const Quality&) const = default;
};

Quality quality(const std::vector<double>& costs, std::size_t columns, const std::vector<std::size_t>& column_of) {
  Quality found;
  std::vector<bool> taken(columns, false);
  for (std::size_t row = 0; row < column_of.size(); ++row) {
    const std::size_t column = column_of[row];
    if (column == unserved) continue;
    EXPECT_LT(column, columns);
    EXPECT_FALSE(taken[column]) << "column " << column << " is assigned to two rows";
    taken[column] = true;
    EXPECT_NE(costs[row * columns + column], never);
    ++found.served;
    found.max = std::max(found.max, costs[row * columns + column]);
  }
  return found;
}

// Brute-force reference: tries each unassigned column, and no column, for every row. `best` is the result with the most
// assigned rows and, among these, the smallest maximum.
void try_all(const std::vector<double>& costs, std::size_t columns, std::size_t row, std::vector<bool>& taken,
             const Quality& so_far, Quality& best) {
  if (row * columns == costs.size()) {
    if (so_far.served > best.served || (so_far.served == best.served && so_far.max < best.max)) best = so_far;
    return;
  }
  try_all(costs, columns, row + 1, taken, so_far, best);
  for (std::size_t column = 0; column < columns; ++column) {
    const double cost = costs[row * columns + column];
    if (taken[column] || cost == never) continue;
    taken[column] = true;
    try_all(costs, columns, row + 1, taken, {so_far.served + 1, std::max(so_far.max, cost)}, best);
    taken[column] = false;
  }
}

Quality best_of_all(const std::vector<double>& costs, std::size_t columns) {
  Quality best;
  std::vector<bool> taken(columns, false);
  try_all(costs, columns, 0, taken, {}, best);
  return best;
}

// The cheapest pair (cost 1) would force a pair with cost 9; without the cheapest pair, the maximum is 4.
TEST(Assignment, CostsWithADearPair_GiveTheSmallestMaximum) {
  EXPECT_EQ(assign_exclusively(std::vector<double>{1.0, 3.0, 4.0, 9.0}, 2), (std::vector<std::size_t>{1, 0}));
}

TEST(Assignment, AForbiddenPair_DoesNotReduceTheNumberOfAssignedRows) {
  EXPECT_EQ(assign_exclusively(std::vector<double>{1.0, 100.0, 2.0, never}, 2), (std::vector<std::size_t>{1, 0}));
}

TEST(Assignment, OnlyForbiddenPairs_GiveNoAssignment) {
  EXPECT_EQ(assign_exclusively(std::vector<double>{never, never}, 1), (std::vector<std::size_t>{unserved, unserved}));
  EXPECT_TRUE(assign_exclusively({}, 3).empty());
}

TEST(Assignment, RandomCosts_GiveTheResultOfAnExhaustiveSearch) {
  Draws draws(1, 0, 0, 0);
  const auto up_to = [&](int max) { return 1 + static_cast<std::size_t>(draws.uniform() * max); };
  for (int i = 0; i < 3000; ++i) {
    const std::size_t rows = up_to(6), columns = up_to(6);
    const double impossible = draws.uniform();
    const bool ties = draws.uniform() < 0.5;
    std::vector<double> costs(rows * columns);
    for (double& cost : costs) {
      const double drawn = draws.uniform();
      cost = draws.uniform() < impossible ? never : ties ? static_cast<double>(static_cast<int>(4.0 * drawn)) : drawn;
    }
    const std::vector<std::size_t> column_of = assign_exclusively(costs, columns);
    ASSERT_EQ(column_of.size(), rows);
    const Quality found = quality(costs, columns, column_of), best = best_of_all(costs, columns);
    ASSERT_EQ(found.served, best.served);
    ASSERT_EQ(found.max, best.max);
  }
}

// A chain in which each row can have its own or the next column: an augmenting path may contain all rows.
TEST(Assignment, AChainOf1000Rows_IsAssignedCompletely) {
  constexpr std::size_t size = 1000;
  std::vector<double> costs(size * size, never);
  for (std::size_t row = 0; row < size; ++row) {
    costs[row * size + row] = 1.0;
    if (row + 1 < size) costs[row * size + row + 1] = 1.0;
  }
  costs[(size - 1) * size] = 1.0;
  EXPECT_EQ(quality(costs, size, assign_exclusively(costs, size)), (Quality{size, 1.0}));
}

}  // namespace
}  // namespace hrt
