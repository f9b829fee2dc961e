#include "samples/study/cli/input.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "samples/study/cli/arguments.h"

namespace hrt::study {

std::string read_input(const std::string& argument, const std::string& path, std::size_t max_bytes) {
  const auto refuse = [&](const std::string& why) {
    return UsageError(not_allowed(argument, path, "a file that can be read (" + why + ")"));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw refuse("this is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw refuse(std::generic_category().message(errno));
  std::string text;
  std::vector<char> block(1 << 16);
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_bytes)
      throw refuse("this one is larger than " + std::to_string(max_bytes >> 20) + " MiB");
  } while (file);
  if (file.bad()) throw refuse("reading fails");
  return text;
}

}  // namespace hrt::study
