#include "plugin/include/plate_driver/plate_file.h"

#include <fcntl.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "plugin/src/abi/hash.h"
#if defined(_WIN32)
#include "plugin/src/abi/file.h"
#endif

namespace hrt::plate {
namespace {

constexpr std::string_view mark = "  \"checksum\": \"";
constexpr std::size_t max_bytes = 1'000'000;

std::string hash_of(std::string_view text) {
  plugin::Hash hash;
  hash.add(text);
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash.value()));
  return digits.data();
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::invalid_argument("plate file " + path + " " + why);
}

// A C stream, because the locale of the host affects C++ streams.
using OpenFile = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

// Opens a file. On POSIX systems, does not wait for a writer if the file is a named pipe.
std::FILE* open_to_read(const std::string& path) {
#if defined(_WIN32)
  return _wfopen(plugin::path_of(path.c_str()).c_str(), L"rb");
#else
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  return descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb");
#endif
}

std::string content_of(const std::string& path) {
  const OpenFile file(open_to_read(path));
  std::string text(max_bytes + 1, '\0');
  if (file) text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (!file || std::ferror(file.get()) != 0)
    throw std::system_error(errno, std::generic_category(), "plate file " + path + " cannot be read");
  if (text.size() > max_bytes)
    refuse(path, "has more than 1000000 bytes; give a file that hrt-plate commission has written");
  return text;
}

}  // namespace

std::string with_checksum(std::string_view text) {
  return std::string(text) + std::string(mark) + hash_of(text) + "\"\n}\n";
}

std::vector<std::string> settings_of(const std::vector<std::string>& details) {
  std::vector<std::string> settings;
  for (const std::string& line : details)
    if (line.starts_with("setting ")) settings.push_back(line);
  return settings;
}

bool is_plate_file(std::string_view name) { return name.ends_with(".json"); }

PlateFile read_plate_file(const std::string& path) {
  const std::string text = content_of(path);
  const std::size_t end = text.rfind(mark);
  if (end == std::string::npos) refuse(path, "has no checksum; give a file that hrt-plate commission has written");
  if (with_checksum(std::string_view(text).substr(0, end)) != text)
    refuse(path, "has a wrong checksum, so it was changed. Commission the plate again");
  const auto json = nlohmann::json::parse(text, nullptr, false);
  try {
    if (json.at("format") != "haptic plate 1")
      refuse(path, "has another format than 'haptic plate 1'; commission the plate again");
    PlateFile file{.device = json.at("device"), .description = json.at("description")};
    file.settings = settings_of(json.at("details"));
    const auto& session = json.at("session");
    file.speed_deg_s = session.at("plate_max_speed_deg_s");
    file.acceleration_deg_s2 = session.at("plate_max_acceleration_deg_s2");
    file.latency_ms = json.at("measured").at("latency_ms").at(0);
    file.error_deg = json.at("max_error_deg");
    const auto check = [&path](const char* name, double value, double low, double high) {
      if (!(value >= low && value <= high))
        refuse(path, std::string("has a number out of range, ") + name + "; commission the plate again");
    };
    check("plate_max_speed_deg_s", file.speed_deg_s, 0.1, 1e5);
    check("plate_max_acceleration_deg_s2", file.acceleration_deg_s2, 1.0, 1e8);
    check("latency_ms", file.latency_ms, 0.0, 1000.0);
    check("max_error_deg", file.error_deg, 0.0, 360.0);
    return file;
  } catch (const nlohmann::json::exception&) {
    refuse(path, "lacks a member or has a member of a wrong type; commission the plate again");
  }
}

}  // namespace hrt::plate
