// Output of the subcommands: atomic files, progress bar.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hrt::study {

/// An invalid argument or input file: one line that names it and what is allowed. Exit code 2.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns "NAME: 'TEXT' is not allowed; it must be WHAT".
inline std::string not_allowed(const std::string& name, std::string_view text, const std::string& what) {
  return fmt::format("{}: '{}' is not allowed; it must be {}", name, text, what);
}

/// Returns `value` with `decimals` digits after the point; "-" for NaN.
std::string cell(double value, int decimals);

/// Returns for example "0.38-0.47"; "?" for a bound that is NaN.
std::string between(double low, double high, int decimals, const std::string& dash = "-");

/// Writes a file like write_whole_file() (samples/app/text/whole_file.h). Throws std::runtime_error on failure.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Destination of a result: a file, or standard output for an empty path. Construct it before the computation, so that
/// an unwritable destination is reported first.
class Output {
 public:
  /// Throws UsageError naming `argument` if `path` cannot be written, or if another argument names the same file.
  Output(const std::string& argument, const std::string& path);

  /// Throws std::runtime_error on failure.
  void write(std::string_view content) const;

 private:
  std::filesystem::path path_;
};

/// A progress bar on standard error, shown after one second if standard error is a terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `total` must be above 0.
  void update(std::uint64_t done, std::uint64_t total);

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point last_drawn_;
};

/// Returns the content of the file at `path`. Throws UsageError naming `argument` if the file cannot be read, exceeds
/// `max_bytes`, or is the destination of an Output.
std::string read_input(const std::string& argument, const std::string& path, std::size_t max_bytes);

}  // namespace hrt::study
