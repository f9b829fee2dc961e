#include "samples/study/numbers/csv.h"

#include <algorithm>

#include "samples/app/text/text.h"

namespace hrt::study {
namespace {

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  text.remove_suffix(text.size() - (text.find_last_not_of(" \t") + 1));
  return text;
}

std::string words_for(std::string_view column) { return "column " + std::string(column); }

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t max = 40;
  return std::string(text.substr(0, max)) + (text.size() > max ? "..." : "");
}

CsvReader::CsvReader(std::string name, std::string_view text, const char* columns)
    : name_(std::move(name)), columns_(columns), rest_(text) {
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool CsvReader::next() {
  if (places_.empty()) {
    if (!next_line()) throw UsageError(fmt::format("{}: there is no header; it must name {}", name_, columns_));
    take_header();
  }
  if (!next_line()) return false;
  if (fields_.size() != width_)
    throw wrong("number of columns", fmt::to_string(fields_.size()), fmt::format("{}, as in the header", width_));
  return true;
}

bool CsvReader::next_line() {
  do {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    line_ = trimmed(line_);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
  } while (line_.empty() || line_.starts_with('#'));
  fields_ = csv_fields(line_);
  return true;
}

std::string CsvReader::where() const { return fmt::format("{}, line {}", name_, number_); }

void CsvReader::take_header() {
  const std::string allowed = fmt::format("a header that names {}", columns_);
  for (const std::string_view column : split(columns_, ',')) {
    const auto found = std::find(fields_.begin(), fields_.end(), column);
    if (found == fields_.end())
      throw UsageError(where() + ", " + words_for(column) + ": the column is missing; the line must be " + allowed);
    if (std::find(found + 1, fields_.end(), column) != fields_.end())
      throw UsageError(where() + ", " + words_for(column) + ": the column occurs more than once; the line must be " +
                       allowed + ", each once");
    places_.emplace_back(column, found - fields_.begin());
  }
  width_ = fields_.size();
}

std::string_view CsvReader::text(std::string_view column) const {
  const auto place =
      std::find_if(places_.begin(), places_.end(), [&](const auto& each) { return each.first == column; });
  return fields_[place->second];
}

double CsvReader::number(std::string_view column, const NumberRange& range) const {
  const std::optional<double> value = range.parse(text(column));
  if (!value) throw wrong(column, range.text());
  return *value;
}

UsageError CsvReader::wrong(const std::string& what, std::string_view text, const std::string& allowed) const {
  return UsageError(not_allowed(where() + ", " + what, shown(text), allowed));
}

UsageError CsvReader::wrong(std::string_view column, const std::string& allowed) const {
  return wrong(words_for(column), text(column), allowed);
}

}  // namespace hrt::study
