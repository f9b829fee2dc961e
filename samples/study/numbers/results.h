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

/// Values in their order. A number that is not finite becomes null, and an empty field of CSV.
using Row = nlohmann::ordered_json;

struct Results {
  Row about;              ///< of all rows: in JSON alone
  std::vector<Row> rows;  ///< numbers, words and flags of the same names
};

/// NAME_percent, NAME_low_percent and NAME_high_percent.
void put(Row& row, const std::string& name, const Share& share);
/// NAME, NAME_low and NAME_high before `unit`.
void put(Row& row, const std::string& name, const std::string& unit, const Quantile& quantile);

/// A header, and a line for each row; flags are 1 and 0.
std::string csv_of(const Results& results);
/// `about`, then "rows". Text that is not UTF-8 is replaced.
std::string json_of(const Results& results);

/// Destination and format of a command's results: --format and --out.
struct Writing {
  std::string format = "text";
  std::string out;

  void add_options(CLI::App& command);

  /// Writes the result of `make`, as `results_of` or `text_of` it. Throws as Output, before the work, if --out cannot
  /// be written.
  void write(auto&& make, auto&& results_of, auto&& text_of) const {
    const Output output("--out", out);
    const auto made = make();
    output.write(format == "csv"    ? csv_of(results_of(made))
                 : format == "json" ? json_of(results_of(made))
                                    : text_of(made));
  }
};

}  // namespace hrt::study
