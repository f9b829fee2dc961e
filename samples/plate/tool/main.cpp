// hrt-plate: puts a plate into operation.
#include <glob.h>
#include <poll.h>
#include <unistd.h>

#include <iostream>

#include "plugin/src/plate/serial_line.h"
#include "samples/plate/tool/commands.h"

namespace {

using namespace hrt::plate;

std::vector<std::string> serial_devices() {
  std::vector<std::string> found;
  for (const char* pattern : {"/dev/ttyACM*", "/dev/ttyUSB*"}) {
    glob_t names{};
    if (glob(pattern, 0, nullptr, &names) == 0)
      found.insert(found.end(), names.gl_pathv, names.gl_pathv + names.gl_pathc);
    globfree(&names);
  }
  return found;
}

// A line of standard input, without waiting for one.
Entry read_entry() {
  static std::string unread;
  for (;;) {
    if (const std::size_t end = unread.find('\n'); end != std::string::npos) {
      Entry entry{.line = unread.substr(0, end)};
      unread.erase(0, end + 1);
      return entry;
    }
    pollfd readable{STDIN_FILENO, POLLIN, 0};
    if (poll(&readable, 1, 0) <= 0) return {};
    char byte = 0;
    if (read(STDIN_FILENO, &byte, 1) != 1) return {.ended = true};
    unread += byte;
    constexpr std::size_t max = 1000;
    if (unread.size() > max) return {.ended = true};
  }
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int output_failed = 10;
  try {
    return run_tool(argc, argv, {serial_devices, open_serial_line, read_entry, std::cout, std::cerr});
  } catch (const std::exception& error) {
    std::cerr << "hrt-plate: " << error.what() << "\n";
    return output_failed;
  }
}
