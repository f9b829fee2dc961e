// hrt-plate: finds, sets up and measures a plate.
#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
#endif

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <queue>
#include <thread>

#include "samples/plate/tool/commands.h"

namespace {

using namespace hrt::plate;

// Returns the names of serial adapters and boards (Linux, macOS), or the COM ports (Windows).
std::vector<std::string> serial_devices() {
  std::vector<std::string> found;
#if defined(_WIN32)
  for (int port = 1; port <= 256; ++port) {
    const std::string name = "COM" + std::to_string(port);
    std::array<char, 1024> target{};
    if (QueryDosDeviceA(name.c_str(), target.data(), target.size()) != 0) found.push_back(name);
  }
#else
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", none))
    for (const char* begin : {"ttyACM", "ttyUSB", "cu.usb"})
      if (entry.path().filename().string().starts_with(begin)) found.push_back(entry.path().string());
  std::sort(found.begin(), found.end());
#endif
  return found;
}

// Lines of standard input, read by a thread, because reading blocks.
class StandardInput {
 public:
  Input read() {
    if (!is_reading_) std::thread([this] { run(); }).detach();
    is_reading_ = true;
    const std::lock_guard lock(mutex_);
    if (entries_.empty()) return {};
    Input entry = entries_.front();
    if (!entry.ended) entries_.pop();
    return entry;
  }

 private:
  void run() {
    for (std::string line; std::getline(std::cin, line);) push({.line = line});
    push({.ended = true});
  }
  void push(const Input& entry) {
    const std::lock_guard lock(mutex_);
    entries_.push(entry);
  }

  std::mutex mutex_;
  std::queue<Input> entries_;
  bool is_reading_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  constexpr int output_failed = 10;
  static StandardInput& input = *new StandardInput;  // never deleted: its thread may outlive main()
  try {
    Environment env{serial_devices, open_serial_line, [] { return input.read(); }, std::cout, std::cerr};
#if defined(__linux__)
    env.emulate = emulate;
#endif
    return run_tool(argc, argv, env);
  } catch (const std::exception& error) {
    std::cerr << "hrt-plate: " << error.what() << "\n";
    return output_failed;
  }
}
