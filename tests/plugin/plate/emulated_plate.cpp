#include "tests/plugin/plate/emulated_plate.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto report_period = 20ms;
constexpr auto heartbeat_limit = 300ms;

}  // namespace

EmulatedPlate::EmulatedPlate(Behaviour behaviour) : behaviour_(std::move(behaviour)) {}

bool EmulatedPlate::is_first_version() const {
  return behaviour_.greeting.starts_with("PLATE 1");
}

std::string EmulatedPlate::sealed(const std::string& body) const {
  return encode_line(body, is_first_version() ? Version::one : Version::two);
}

std::string EmulatedPlate::place() const {
  std::array<char, 32> text{};
  const bool first = is_first_version();
  std::snprintf(text.data(), text.size(), first ? "AT %.2f" : "AT %+07.2f", orientation_deg_);
  return sealed(first ? text.data() : text.data() + sequence_);
}

std::string EmulatedPlate::take_output() {
  return std::exchange(output_, {});
}

void EmulatedPlate::send(const std::string& body) {
  if (!is_silent_) output_ += sealed(body);
}

void EmulatedPlate::restart() {
  is_greeted_ = false;
  is_allowed_ = false;
  send("BOOT");
}

void EmulatedPlate::hear(std::string_view bytes, Time now) {
  if (now < behaviour_.boot) return;
  for (const char byte : bytes) {
    const auto line = reader_.take(byte);
    const auto decoded = line ? decode_line(*line) : std::nullopt;
    if (!decoded) continue;
    last_heard_ = now;
    hear_body(std::string(decoded->body));
  }
}

void EmulatedPlate::hear_body(std::string body) {
  const bool first = is_first_version();
  if (body.starts_with("HELLO")) {
    if (body != (first ? "HELLO 1" : "HELLO 2") || !behaviour_.answers || is_silent_) return;
    is_greeted_ = true;
    output_ += behaviour_.noise + sealed(behaviour_.greeting);
    return;
  }
  if (!is_greeted_) return;
  if (body == "INFO") {
    send("INFO 0.1 000007");
  } else if (!first) {
    sequence_ = body.substr(body.rfind(' '));
    body.resize(body.rfind(' '));
  }
  heard_.push_back(body);
  if (body.starts_with("SET ")) {
    target_deg_ = std::stod(body.substr(4));
    if (target_deg_ != orientation_deg_) is_allowed_ = true;
  }
  if (body == "STOP") is_allowed_ = false;
  if (!first && behaviour_.reports && !is_silent_ && body != "INFO") output_ += place();
}

void EmulatedPlate::run_until(Time now) {
  const double max_deg = behaviour_.speed_deg_s * std::chrono::duration<double>(now - now_).count();
  now_ = now;
  if (behaviour_.turns && is_allowed_)
    orientation_deg_ += std::clamp(target_deg_ - orientation_deg_, -max_deg, max_deg);
  if (is_allowed_ && now - last_heard_ > heartbeat_limit) {
    is_allowed_ = false;
    ++heartbeat_stops_;
    send("STOPPED heartbeat");
  }
  if (!is_greeted_ || is_silent_ || !behaviour_.reports || now - last_report_ < report_period) return;
  last_report_ = now;
  output_ += behaviour_.noise + place();
}

}  // namespace hrt::plate
