// Output of the subcommands: numbers that read back to the same bits in any locale, files that are whole or
// absent, a progress bar.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hrt::study {

/// A mistake of the caller's: one line that names the argument and its allowed values. Exit code 2.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "NAME: 'TEXT' is not allowed; it must be WHAT".
inline std::string not_allowed(const std::string& name, std::string_view text, const std::string& what) {
  return name + ": '" + std::string(text) + "' is not allowed; it must be " + what;
}

/// The shortest decimal that reads back to the same double: "0.1", "1e+20", "inf".
std::string number(double value);

/// `value` with `decimals` digits after the point.
std::string fixed(double value, int decimals);

/// fixed(), with spaces before it to `width` characters; "-" for NaN.
std::string cell(double value, int decimals, std::size_t width);

/// "0.38-0.47", with `dash` in between; "?" for NaN, a bound that is unknown.
std::string between(double low, double high, int decimals, const std::string& dash = "-");

/// "cannot write `path`: ..." with the text of an errno.
std::runtime_error cannot_write(const std::filesystem::path& path, int error);

/// write_whole_file() (samples/app/text/whole_file.h). Throws std::runtime_error if that fails.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Destination of a subcommand's result: a file, or standard output for an empty path. Made before the work, so
/// that a place that can't be written is known at once.
class Output {
 public:
  /// Throws UsageError naming `argument` if `path` can't be written.
  Output(const std::string& argument, const std::string& path);

  /// Writes everything. Throws std::runtime_error if that fails.
  void write(std::string_view content) const;

 private:
  std::filesystem::path path_;
};

/// A bar on standard error, drawn once the work has taken a second and only on a terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` > 0 is done.
  void update(std::uint64_t done, std::uint64_t total);

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point last_drawn_;
};

/// The content of the file at `path`. Throws UsageError naming `argument` if it cannot be read or is larger
/// than `max_bytes`.
std::string read_input(const std::string& argument, const std::string& path, std::size_t max_bytes);

}  // namespace hrt::study
