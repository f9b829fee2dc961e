#include "samples/experiment/data/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <optional>

#include "samples/app/text/format.h"
#include "samples/app/text/json_file.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

constexpr std::int64_t ms_per_s = 1000;

std::int64_t utc_from(const std::string& text) {
  std::tm time{};
  int ms = 0;
  if (std::sscanf(text.c_str(), "%d-%d-%dT%d:%d:%d.%dZ", &time.tm_year, &time.tm_mon, &time.tm_mday, &time.tm_hour,
                  &time.tm_min, &time.tm_sec,
                  &ms) != 7)  // NOLINT(cert-err34-c): parse() has checked the CRC, so no number is out of range
    return 0;
  time.tm_year -= 1900;
  time.tm_mon -= 1;
  return timegm(&time) * ms_per_s + ms;
}

// Returns nullopt if the line is incomplete or its CRC is wrong.
std::optional<Event> parse(const std::string& line) {
  const std::size_t end = line.rfind(",\"crc\":\"");
  if (end == std::string::npos || line.substr(end) != format(",\"crc\":\"%08x\"}", crc32(line.substr(0, end))))
    return std::nullopt;
  const json value = json::parse(line, nullptr, false);
  if (!value.is_object()) return std::nullopt;
  return Event{value.at("number"), utc_from(value.at("utc")), value.at("monotonic_ns"), value.at("event"),
               value.at("data")};
}

std::string line_of(const Event& event) {
  const std::string text =
      format("{\"number\":%llu,\"utc\":\"%s\",\"monotonic_ns\":%lld,\"event\":\"%s\",\"data\":",
             static_cast<unsigned long long>(event.number), utc_text(event.utc_ms).c_str(),
             static_cast<long long>(event.monotonic_ns), event.name.c_str()) +
      event.data.dump(-1, ' ', false, json::error_handler_t::replace);  // a note may contain invalid UTF-8
  return text + format(",\"crc\":\"%08x\"}\n", crc32(text));
}

}  // namespace

std::uint32_t crc32(std::string_view text) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::string utc_text(std::int64_t utc_ms) {
  const std::time_t seconds = utc_ms / ms_per_s;
  std::tm time{};
  gmtime_r(&seconds, &time);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &time);
  return text + format(".%03dZ", static_cast<int>(utc_ms % ms_per_s));
}

std::vector<Event> read_journal(const std::string& text, const std::string& name) {
  std::vector<Event> events;
  std::size_t damaged = 0, number = 0;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    // A last line that lacks only its newline is valid: the next write adds the newline.
    std::optional<Event> event = parse(text.substr(at, end - at));
    at = end + 1;
    if (!event) {
      if (damaged == 0) damaged = number + 1;
      continue;
    }
    if (damaged != 0 && event->name != "opened" && event->name != "closed")
      throw Refusal(name +
                    format(": line %zu is damaged, which an interrupted write does not explain; restore the file "
                           "from a copy",
                           damaged));
    damaged = 0;
    if (event->number != events.size() + 1)
      throw Refusal(name + format(": line %zu has number %llu, not %zu; restore the file from a copy", number + 1,
                                  static_cast<unsigned long long>(event->number), events.size() + 1));
    events.push_back(std::move(*event));
  }
  return events;
}

Journal::Journal(std::filesystem::path file, const Disk& disk, std::function<Now()> clock)
    : name_(std::move(file)),
      disk_(disk),
      clock_(std::move(clock)),
      file_(open(name_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (file_ < 0)
    throw Refusal(name_.string() + ": cannot be opened: " + std::strerror(errno) +
                  "; check the permissions of the file and its folder");
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw Refusal(name_.string() + ": another process runs this session; wait for its end");
    const std::string text = content_of(name_);
    events_ = read_journal(text, name_.string());
    is_cut_ = !text.empty() && text.back() != '\n';
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() { close(file_); }

const Event& Journal::append(const std::string& name, json data) {
  const Now now = clock_();
  Event event{events_.size() + 1, now.utc_ms, now.monotonic_ns, name, std::move(data)};
  const std::string line = (is_cut_ ? "\n" : "") + line_of(event);
  is_cut_ = true;
  disk_.append(file_, name_, line);
  is_cut_ = false;
  events_.push_back(std::move(event));  // before the sync: the line remains in the file if the sync fails
  disk_.sync(file_, name_);
  return events_.back();
}

}  // namespace hrt::experiment
