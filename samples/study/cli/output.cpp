#include "samples/study/cli/output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

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

void check_written(const std::string& path, int error) {
  if (error != 0)
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(error) +
                             "; free space, or name another path");
}

}  // namespace

std::string cell(double value, int decimals) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, decimals);
}

std::string between(double low, double high, int decimals, const std::string& dash) {
  const auto bound = [&](double value) { return std::isnan(value) ? "?" : cell(value, decimals); };
  return bound(low) + dash + bound(high);
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
  check_written(path.string(), write_whole_file(path, content));
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
  check_written("standard output", write_all(STDOUT_FILENO, content));
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
  const double share = static_cast<double>(std::max<std::uint64_t>(1, done)) / static_cast<double>(total);
  const double elapsed_s = std::chrono::duration<double>(now - started_).count();
  const std::string filled(static_cast<std::size_t>(bar_width * share), '#');
  fmt::print(stderr, "\r\033[K[{:-<{}}] {:.0f} %, {:.0f} s left", filled, bar_width, 100.0 * share,
             elapsed_s * (1.0 - share) / share);
  std::fflush(stderr);
  drawn_ = true;
  last_drawn_ = now;
}

std::string read_input(const std::string& argument, const std::string& path, std::size_t max_bytes) {
  const auto refuse = [&](const std::string& allowed) { return UsageError(not_allowed(argument, path, allowed)); };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw refuse("a file, not a folder");
  if (named_files()[std::filesystem::weakly_canonical(path, ignored)]) throw refuse("a file that no option writes");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw refuse("a file that can be read (" + std::generic_category().message(errno) + ")");
  std::string text;
  std::vector<char> block(1 << 16);
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_bytes) throw refuse(fmt::format("a file of at most {} MiB", max_bytes >> 20));
  } while (file);
  if (file.bad()) throw refuse("a file that can be read (reading failed)");
  return text;
}

}  // namespace hrt::study
