// Parser of CSV files. Errors name the place and the allowed values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "samples/study/cli/arguments.h"

namespace hrt::study {

/// Reads a text line by line. Accepts CRLF, quoted fields and a byte order mark.
class CsvReader {
 public:
  /// `name` is the file's name in errors. `columns`: names that the header must have once each, as "a,b,c". The header
  /// is the first line that is neither blank nor a comment.
  CsvReader(std::string name, std::string_view text, const char* columns);

  /// Advances to the next row; skips blank lines and comments (#). Returns false after the last row. Throws UsageError
  /// if the header does not name each column once, or if the row has another number of fields than the header.
  bool next();

  /// Returns the field of the current row in a column. number() throws UsageError if it is not a number in `range`.
  std::string_view text(std::string_view column) const;
  double number(std::string_view column, const NumberRange& range) const;

  /// Returns an error: the value of `what` or `column` in this line is not `allowed`.
  UsageError wrong(const std::string& what, std::string_view text, const std::string& allowed) const;
  UsageError wrong(std::string_view column, const std::string& allowed) const;

 private:
  bool next_line();
  std::string where() const;  // for example "FILE, line 3"
  void take_header();

  std::string name_;
  const char* columns_;
  std::string_view rest_;
  std::size_t number_ = 0;
  std::string_view line_;
  std::vector<std::string> fields_;
  std::size_t width_ = 0;                                         // number of fields of the header
  std::vector<std::pair<std::string_view, std::size_t>> places_;  // index of each column
};

/// Shortens a text of more than 40 bytes, for quotes in errors.
std::string shown(std::string_view text);

}  // namespace hrt::study
