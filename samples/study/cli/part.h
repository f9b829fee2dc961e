// A study in parts, for several machines: part i of n has the rows that follow those of part i - 1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hrt::study {

/// Part `number` of `count`, from 1. The first one of any rows has a row.
struct Part {
  std::uint64_t number = 1;
  std::uint64_t count = 1;

  bool whole() const { return count == 1; }
  bool has_header() const { return number == 1; }  ///< so that `cat` of all parts in order is the whole

  /// Rows [begin, end) of `rows` < 2^32.
  std::uint64_t begin(std::uint64_t rows) const { return (rows * (number - 1) + count - 1) / count; }
  std::uint64_t end(std::uint64_t rows) const { return (rows * number + count - 1) / count; }

  template <typename Row>
  std::vector<Row> of(const std::vector<Row>& rows) const {
    const auto at = [&](std::uint64_t i) { return rows.begin() + static_cast<std::ptrdiff_t>(i); };
    return {at(begin(rows.size())), at(end(rows.size()))};
  }
};

/// The paragraph of the help about parts of such rows.
std::string part_words(const std::string& rows);

/// Adds the option --part.
void add_part(CLI::App& command, Part* part);

}  // namespace hrt::study
