// The file of a sweep: grows row by row, and a stopped sweep continues it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace hrt::study {

/// Rows are appended to FILE.partial, which becomes FILE once all are there. A run that was stopped leaves
/// FILE.partial; the next run with the same rows keeps the whole ones and continues after them.
class SweepFile {
 public:
  /// The file's content: `header`, maybe empty, then `rows` rows of `commas` commas each, row r starting
  /// with `row_start(r)`.
  struct Content {
    std::string header;
    std::uint64_t rows;
    std::ptrdiff_t commas;
    std::function<std::string(std::uint64_t)> row_start;
  };

  /// Opens or takes up FILE.partial; does nothing if FILE is complete. Throws UsageError naming `argument` if
  /// it can't be written, if FILE or FILE.partial holds something else, or if another process is at it.
  SweepFile(const std::string& argument, const std::string& path, const Content& content);
  ~SweepFile();
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  /// FILE is there already, with every row.
  bool is_complete() const { return file_ < 0; }
  /// Rows that FILE.partial held.
  std::uint64_t rows() const { return rows_; }

  /// Appends whole rows. Throws std::runtime_error if that fails.
  void append(std::string_view text);

  /// Gives FILE.partial its name. Throws std::runtime_error if that fails.
  void finish();

 private:
  std::filesystem::path path_;
  std::filesystem::path partial_;
  int file_ = -1;
  std::uint64_t rows_ = 0;
};

}  // namespace hrt::study
