#include "samples/study/cli/output.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

#include "samples/app/text/text.h"
#include "samples/app/text/whole_file.h"
#include "samples/study/cli/arguments.h"

namespace hrt::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int bar_width = 30;

// Files named by arguments, and whether they are outputs: an output must not overwrite an input or another output.
std::map<std::filesystem::path, bool>& named_files() {
  static std::map<std::filesystem::path, bool> files;
  return files;
}

}  // namespace

std::string number(double value) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string fixed(double value, int decimals) {
  std::array<char, 400> text;  // the largest double has 309 digits
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
  return {text.data(), end};
}

std::string cell(double value, int decimals, std::size_t width) {
  return right(std::isnan(value) ? "-" : fixed(value, decimals), width);
}

std::string between(double low, double high, int decimals, const std::string& dash) {
  const auto bound = [&](double value) { return std::isnan(value) ? "?" : fixed(value, decimals); };
  return bound(low) + dash + bound(high);
}

std::runtime_error cannot_write(const std::filesystem::path& path, int error) {
  return std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
  if (const int error = write_whole_file(path, content); error != 0) throw cannot_write(path, error);
}

Output::Output(const std::string& argument, const std::string& path) {
  if (path.empty()) return;
  if (const std::string why = why_not_writable(path); !why.empty())
    throw UsageError(not_allowed(argument, path, "a file in a folder that can be written (" + why + ")"));
  path_ = std::filesystem::weakly_canonical(path);
  if (named_files().contains(path_)) throw UsageError(not_allowed(argument, path, "a file that no other option names"));
  named_files()[path_] = true;
}

void Output::write(std::string_view content) const {
  if (!path_.empty()) return replace_file(path_, content);
  if (const int error = write_all(STDOUT_FILENO, content); error != 0) throw cannot_write("standard output", error);
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), started_(Clock::now()), last_drawn_(started_) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::uint64_t done, std::uint64_t total) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now - started_ < std::chrono::seconds(1)) return;
  if (drawn_ && now - last_drawn_ < std::chrono::milliseconds(100)) return;
  const double share = static_cast<double>(done) / static_cast<double>(total);
  const double elapsed_s = std::chrono::duration<double>(now - started_).count();
  const auto filled = static_cast<std::size_t>(bar_width * share);
  std::string line = "\r\033[K[" + std::string(filled, '#') + std::string(bar_width - filled, '-') + "] " +
                     fixed(100.0 * share, 0) + " %";
  if (done > 0) line += ", " + fixed(elapsed_s * (1.0 - share) / share, 0) + " s left";
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
  last_drawn_ = now;
}

std::string read_input(const std::string& argument, const std::string& path, std::size_t max_bytes) {
  const auto refuse = [&](const std::string& why) {
    return UsageError(not_allowed(argument, path, "a file that can be read (" + why + ")"));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw refuse("it is a folder");
  if (named_files()[std::filesystem::weakly_canonical(path, ignored)]) throw refuse("another option writes this file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw refuse(std::generic_category().message(errno));
  std::string text;
  std::vector<char> block(1 << 16);
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_bytes) throw refuse("it is larger than " + std::to_string(max_bytes >> 20) + " MiB");
  } while (file);
  if (file.bad()) throw refuse("reading failed");
  return text;
}

}  // namespace hrt::study
