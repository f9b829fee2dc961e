#include "samples/study/numbers/results.h"

#include <cmath>

#include "samples/app/text/text.h"
#include "samples/study/cli/arguments.h"

namespace hrt::study {
namespace {

std::string field_of(const Row& value) {
  if (value.is_null()) return "";
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_number_float()) return std::isnan(value.get<double>()) ? "" : fmt::format("{}", value.get<double>());
  return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

}  // namespace

void put(Row& row, const std::string& name, const Share& share) {
  const PercentInterval interval = share.interval();
  row[name + "_percent"] = share.percent();
  row[name + "_low_percent"] = interval.low;
  row[name + "_high_percent"] = interval.high;
}

void put(Row& row, const std::string& name, const std::string& unit, const Quantile& quantile) {
  row[name + unit] = quantile.value;
  row[name + "_low" + unit] = quantile.low;
  row[name + "_high" + unit] = quantile.high;
}

std::string csv_of(const Results& results) {
  std::string page;
  const auto add = [&](const Row& row, const auto& text) {
    for (auto item = row.begin(); item != row.end(); ++item) page += (item == row.begin() ? "" : ",") + text(item);
    page += '\n';
  };
  if (!results.rows.empty()) add(results.rows.front(), [](const auto& item) { return item.key(); });
  for (const Row& row : results.rows) add(row, [](const auto& item) { return field_of(item.value()); });
  return page;
}

Row page_of(const Results& results) {
  Row page = results.about;
  page["rows"] = results.rows;
  return page;
}

std::string json_of(const Results& results) {
  return page_of(results).dump(2, ' ', false, Row::error_handler_t::replace) + '\n';
}

void Writing::add_options(CLI::App& command) {
  add_choice(command, "--format", format, {"text", "csv", "json"}, "Format of the output.");
  add_out(command, out);
}

}  // namespace hrt::study
