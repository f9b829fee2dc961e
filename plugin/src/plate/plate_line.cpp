#include "plugin/src/plate/plate_line.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <vector>

#include "plugin/include/plate_driver/crc16.h"

namespace hrt::plate {
namespace {

constexpr std::size_t max_number = 12;
constexpr double max_angle_deg = 360.0;
constexpr double max_speed_deg_s = 1e6;
constexpr double max_latency_ms = 1000.0;
constexpr char hex_digits[] = "0123456789ABCDEF";

std::string sum_of(std::string_view body) {
  const unsigned sum = crc16_ccitt(body.data(), body.size());
  std::string digits;
  for (int shift = 12; shift >= 0; shift -= 4) digits += hex_digits[(sum >> shift) & 15U];
  return digits;
}

using Words = std::vector<std::string_view>;

Words words_of(std::string_view body) {
  Words words;
  for (;;) {
    const std::size_t end = body.find(' ');
    words.push_back(body.substr(0, end));
    if (end == std::string_view::npos) return words;
    body.remove_prefix(end + 1);
  }
}

std::optional<double> number_of(std::string_view word) {
  double value = 0.0;
  if (word.size() > max_number) return std::nullopt;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> angle_of(std::string_view word) {
  const std::optional<double> angle_deg = number_of(word);
  return angle_deg && std::abs(*angle_deg) <= max_angle_deg ? angle_deg : std::nullopt;
}

bool are_digits(std::string_view text) { return text.find_first_not_of("0123456789") == std::string_view::npos; }

// Format: sign, three digits, point, two digits. The fixed length exposes a lost or doubled character.
std::optional<double> fixed_angle_of(std::string_view word) {
  if (word.size() != 7 || (word[0] != '+' && word[0] != '-') || word[4] != '.' || !are_digits(word.substr(1, 3)) ||
      !are_digits(word.substr(5)))
    return std::nullopt;
  return angle_of(word[0] == '+' ? word.substr(1) : word);
}

std::optional<std::uint16_t> sequence_of(std::string_view word) {
  std::uint16_t value = 0;
  if (word.size() != 5 || !are_digits(word)) return std::nullopt;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<PlateMessage> parse_greeting(const Words& words) {
  if (words.size() != 7 || words[1] != "2") return std::nullopt;
  const auto min = angle_of(words[2]), max = angle_of(words[3]), speed = number_of(words[4]),
             latency = number_of(words[5]);
  if (!min || !max || !speed || *min >= *max || *speed <= 0.0 || *speed > max_speed_deg_s) return std::nullopt;
  if (!latency || *latency < 0.0 || *latency > max_latency_ms) return std::nullopt;
  if (words[6] != "measured" && words[6] != "assumed") return std::nullopt;
  return PlateGreeting{*min, *max, *speed, *latency, words[6] == "measured"};
}

std::optional<PlateMessage> parse_report(const Words& words) {
  if (words.size() != 3) return std::nullopt;
  const auto orientation_deg = fixed_angle_of(words[1]);
  const auto sequence = sequence_of(words[2]);
  if ((!orientation_deg && words[1] != "unknown") || !sequence) return std::nullopt;
  return PlateReport{orientation_deg, *sequence};
}

std::optional<PlateMessage> parse_stopped(const Words& words) {
  static constexpr std::array<std::string_view, 9> reasons = {"host",  "heartbeat", "limit",   "fault", "emergency",
                                                              "stuck", "sensor",    "unhomed", "supply"};
  for (std::size_t i = 0; words.size() == 2 && i < reasons.size(); ++i)
    if (words[1] == reasons[i]) return PlateStopped{static_cast<StopReason>(i)};
  return std::nullopt;
}

std::optional<PlateMessage> parse_service(const Words& words) {
  const std::string_view verb = words[0];
  if (verb == "BOOT" && words.size() == 1) return PlateBooted{};
  if (verb == "SAVED" && words.size() == 1) return PlateSaved{};
  if (verb == "ERROR" && words.size() == 2) return PlateRefusal{std::string(words[1])};
  if (verb == "INFO" && words.size() == 3) return PlateInfo{std::string(words[1]), std::string(words[2])};
  if (verb == "TEST" && words.size() == 3) return PlateTest{std::string(words[1]), std::string(words[2])};
  if (verb == "TEST" && words.size() == 2 && words[1] == "end") return PlateTest{"end", ""};
  if (verb == "CONF" && words.size() == 3)
    if (const auto value = number_of(words[2])) return PlateSetting{std::string(words[1]), *value};
  return std::nullopt;
}

}  // namespace

std::string encode_line(std::string_view body) { return std::string(body) + "*" + sum_of(body) + "\n"; }

std::optional<std::string_view> decode_line(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const std::size_t star = line.find('*');
  if (star == 0 || star == std::string_view::npos) return std::nullopt;
  const std::string_view body = line.substr(0, star), sum = line.substr(star + 1);
  for (const char c : body)
    if (c < 0x20 || c > 0x7e) return std::nullopt;
  return sum == sum_of(body) ? std::optional(body) : std::nullopt;
}

std::optional<PlateMessage> parse_plate_message(std::string_view body) {
  const Words words = words_of(body);
  for (const std::string_view word : words)
    if (word.empty()) return std::nullopt;
  if (words[0] == "PLATE") return parse_greeting(words);
  if (words[0] == "AT") return parse_report(words);
  if (words[0] == "STOPPED") return parse_stopped(words);
  return parse_service(words);
}

std::string set_body(double orientation_deg, std::uint16_t sequence, std::string_view word) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%+07.2f %05u", orientation_deg, static_cast<unsigned>(sequence));
  text[4] = '.';  // in every locale
  return std::string(word) + " " + text.data();
}

std::string beat_body(std::string_view word, std::uint16_t sequence) {
  const std::string digits = std::to_string(sequence);
  return std::string(word) + " " + std::string(5 - digits.size(), '0') + digits;
}

std::optional<std::string_view> LineReader::take(char byte) {
  if (ended_) {
    line_.clear();
    ended_ = too_long_ = false;
  }
  if (byte == '\n') {
    ended_ = true;
    return too_long_ ? std::string_view() : std::string_view(line_);
  }
  if (line_.size() + 1 == max_line) too_long_ = true;
  if (!too_long_) line_ += byte;
  return std::nullopt;
}

}  // namespace hrt::plate
