#include "plugin/src/plate/plate_line.h"

#include <array>
#include <cmath>
#include <vector>

#include "plugin/include/plate_driver/plate_text.h"

namespace hrt::plate {
namespace {

constexpr double max_angle_deg = 360.0;
constexpr double max_speed_deg_s = 1e6;
constexpr double max_latency_ms = 1000.0;

using Words = std::vector<std::string>;

Words words_of(std::string_view body) {
  Words words(1);
  for (const char c : body) {
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

std::optional<double> number_of(const std::string& word) {
  std::int32_t hundredths = 0;
  return line_parse_hundredths(word.c_str(), &hundredths) ? std::optional(hundredths / 100.0) : std::nullopt;
}

std::optional<double> angle_of(const std::string& word) {
  const std::optional<double> angle_deg = number_of(word);
  return angle_deg && std::abs(*angle_deg) <= max_angle_deg ? angle_deg : std::nullopt;
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
  std::int32_t hundredths = 0;
  std::uint16_t sequence = 0;
  const bool is_known = line_parse_angle(words[1].c_str(), &hundredths);
  if ((!is_known && words[1] != "unknown") || !line_parse_sequence(words[2].c_str(), &sequence)) return std::nullopt;
  const double orientation_deg = hundredths / 100.0;
  if (std::abs(orientation_deg) > max_angle_deg) return std::nullopt;
  return PlateReport{is_known ? std::optional(orientation_deg) : std::nullopt, sequence};
}

std::optional<PlateMessage> parse_stopped(const Words& words) {
  static constexpr std::array<std::string_view, 9> reasons = {"host",  "heartbeat", "limit",   "fault", "emergency",
                                                              "stuck", "sensor",    "unhomed", "supply"};
  for (std::size_t i = 0; words.size() == 2 && i < reasons.size(); ++i)
    if (words[1] == reasons[i]) return PlateStopped{static_cast<StopReason>(i)};
  return std::nullopt;
}

std::optional<PlateMessage> parse_service(const Words& words) {
  const std::string& verb = words[0];
  if (verb == "BOOT" && words.size() == 1) return PlateBooted{};
  if (verb == "SAVED" && words.size() == 1) return PlateSaved{};
  if (verb == "ERROR" && words.size() == 2) return PlateRefusal{words[1]};
  if (verb == "INFO" && words.size() == 3) return PlateInfo{words[1], words[2]};
  if (verb == "TEST" && words.size() == 3) return PlateTest{words[1], words[2]};
  if (verb == "TEST" && words.size() == 2 && words[1] == "end") return PlateTest{"end", ""};
  if (verb == "CONF" && words.size() == 3)
    if (const auto value = number_of(words[2])) return PlateSetting{words[1], *value};
  return std::nullopt;
}

}  // namespace

std::string encode_line(const std::string& body) {
  std::array<char, LINE_SIZE> line{};
  return {line.data(), line_encode(line.data(), body.c_str())};
}

std::optional<PlateMessage> parse_plate_message(std::string_view body) {
  const Words words = words_of(body);
  for (const std::string& word : words)
    if (word.empty()) return std::nullopt;
  if (words[0] == "PLATE") return parse_greeting(words);
  if (words[0] == "AT") return parse_report(words);
  if (words[0] == "STOPPED") return parse_stopped(words);
  return parse_service(words);
}

std::string with_number(std::string_view body, std::uint16_t number) {
  std::array<char, 8> digits{};
  line_append_digits(digits.data(), number, 5);
  return std::string(body) + " " + digits.data();
}

std::string motion_body(double orientation_deg, std::uint16_t sequence, std::string_view word) {
  std::array<char, 16> angle{};
  line_append_angle(angle.data(), static_cast<std::int32_t>(std::lround(orientation_deg * 100.0)));
  return with_number(std::string(word) + " " + angle.data(), sequence);
}

}  // namespace hrt::plate
