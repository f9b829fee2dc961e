// CSV that a caller names: its lines, the columns of its header, its numbers. What is wrong is refused with
// file, line, column and the allowed values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "samples/study/cli/arguments.h"

namespace hrt::study {

/// Goes through a text line by line. Lines may end with CRLF, fields may be in quotes, and a byte order mark may
/// come first.
class CsvReader {
 public:
  /// `name` is the file's name in errors.
  CsvReader(std::string name, std::string_view text);

  /// Goes to the next line that is not blank; false after the last one.
  bool next();

  /// The line, without the blanks around it.
  std::string_view line() const { return line_; }

  /// "FILE, line 3".
  std::string where() const;

  /// This line is the header: it must have each of `columns`, "a,b,c", once. `allowed` says what it must be.
  void take_header(std::string_view columns, const std::string& allowed);
  bool has_header() const { return !places_.empty(); }

  /// This line is a row: it must have as many fields as the header.
  void take_row() const;

  /// In this row, under a column of take_header().
  std::string_view text(std::string_view column) const;
  double number(std::string_view column, const NumberRange& range) const;

  /// `text`, of `what` in this line, is not allowed.
  UsageError wrong(const std::string& what, std::string_view text, const std::string& allowed) const;
  /// The error that this row's value in a column is not allowed.
  UsageError wrong(std::string_view column, const std::string& allowed) const;

 private:
  std::string name_;
  std::string_view rest_;
  std::size_t number_ = 0;
  std::string_view line_;
  std::vector<std::string> fields_;
  std::size_t width_ = 0;                                         // fields of the header
  std::vector<std::pair<std::string_view, std::size_t>> places_;  // of the columns
};

/// The first 40 characters of a text, as an error quotes them.
std::string shown(std::string_view text);

}  // namespace hrt::study
