// Results of a command as rows of named values, written as text, CSV or JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "samples/study/cli/output.h"
#include "samples/study/numbers/statistics.h"

namespace CLI {
class App;
}

namespace hrt::study {

/// Ordered named values. NaN becomes null in JSON and an empty field in CSV.
using Row = nlohmann::ordered_json;

struct Results {
  Row about;              ///< values common to all rows; written to JSON only
  std::vector<Row> rows;  ///< numbers, strings, flags and null; each row has the same names
};

/// Adds NAME_percent, NAME_low_percent and NAME_high_percent.
void put(Row& row, const std::string& name, const Share& share);
/// Adds NAME, NAME_low and NAME_high, each followed by `unit`.
void put(Row& row, const std::string& name, const std::string& unit, const Quantile& quantile);

/// Returns CSV: a header and a line per row; flags are 1 and 0.
std::string csv_of(const Results& results);
/// Returns the members of `about`, then "rows".
Row page_of(const Results& results);
/// Returns page_of() as JSON. Invalid UTF-8 is replaced.
std::string json_of(const Results& results);

/// Destination and format of the results of a command: --format and --out.
struct Writing {
  std::string format = "text";
  std::string out;

  void add_options(CLI::App& command);

  /// Calls `make` and writes its result by `results_of` or `text_of`. If --out cannot be written, throws like Output
  /// before `make` is called.
  void write(auto&& make, auto&& results_of, auto&& text_of) const {
    const Output output("--out", out);
    const auto made = make();
    output.write(format == "csv"    ? csv_of(results_of(made))
                 : format == "json" ? json_of(results_of(made))
                                    : text_of(made));
  }
};

}  // namespace hrt::study
