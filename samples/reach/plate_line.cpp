#include "samples/reach/plate_line.h"

#include <charconv>
#include <cmath>
#include <vector>

namespace hrt::reach {
namespace {

constexpr std::size_t max_number = 12;
constexpr double most_angle_deg = 360.0;
constexpr double most_speed_deg_s = 1e6;
constexpr char hex_digits[] = "0123456789ABCDEF";

unsigned char sum_of(std::string_view body) {
  unsigned char sum = 0;
  for (const char c : body) sum = static_cast<unsigned char>(sum ^ static_cast<unsigned char>(c));
  return sum;
}

std::vector<std::string_view> words_of(std::string_view body) {
  std::vector<std::string_view> words;
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
  const auto [end, error] =
      std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> angle_of(std::string_view word) {
  const std::optional<double> angle_deg = number_of(word);
  return angle_deg && std::abs(*angle_deg) <= most_angle_deg ? angle_deg : std::nullopt;
}

std::optional<PlateMessage> parse_greeting(const std::vector<std::string_view>& words) {
  if (words.size() != 5 || words[1] != "1") return std::nullopt;
  const auto least = angle_of(words[2]), most = angle_of(words[3]), speed = number_of(words[4]);
  if (!least || !most || !speed || *least >= *most || *speed <= 0.0 || *speed > most_speed_deg_s)
    return std::nullopt;
  return PlateGreeting{*least, *most, *speed};
}

std::optional<PlateMessage> parse_stopped(const std::vector<std::string_view>& words) {
  if (words.size() != 2) return std::nullopt;
  if (words[1] == "host") return PlateStopped{StopReason::host};
  if (words[1] == "heartbeat") return PlateStopped{StopReason::heartbeat};
  if (words[1] == "limit") return PlateStopped{StopReason::limit};
  if (words[1] == "fault") return PlateStopped{StopReason::fault};
  return std::nullopt;
}

}  // namespace

std::string encode_line(std::string_view body) {
  const unsigned char sum = sum_of(body);
  std::string line(body);
  line += '*';
  line += hex_digits[sum >> 4];
  line += hex_digits[sum & 15];
  line += '\n';
  return line;
}

std::optional<std::string_view> decode_line(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.size() < 4) return std::nullopt;
  const std::string_view body = line.substr(0, line.size() - 3);
  for (const char c : body)
    if (c < 0x20 || c > 0x7e || c == '*') return std::nullopt;
  const unsigned char sum = sum_of(body);
  const char end[] = {'*', hex_digits[sum >> 4], hex_digits[sum & 15]};
  if (line.substr(body.size()) != std::string_view(end, sizeof end)) return std::nullopt;
  return body;
}

std::optional<PlateMessage> parse_plate_message(std::string_view body) {
  const std::vector<std::string_view> words = words_of(body);
  if (words[0] == "PLATE") return parse_greeting(words);
  if (words[0] == "STOPPED") return parse_stopped(words);
  if (words[0] == "AT" && words.size() == 2)
    if (const std::optional<double> orientation_deg = angle_of(words[1]))
      return PlateReport{*orientation_deg};
  return std::nullopt;
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

}  // namespace hrt::reach
