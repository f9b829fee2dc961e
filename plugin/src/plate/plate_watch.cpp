#include "plugin/src/plate/plate_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto report_limit = 500ms;
constexpr double limit_slack_deg = 3.0;  // tolerance of a sensor
constexpr double moving_deg = 10.0;      // a plate that is farther from its command has to move
constexpr auto stuck_limit = 1000ms;
// A plate that has to move is stuck if it moves by less than this within stuck_limit. If its maximum speed is below
// 4 deg/s, the limit is the distance that it moves in 0.25 s at that speed.
constexpr double moved_deg = 1.0;
constexpr auto max_pause = 250ms;  // motion between two reports further apart is not evaluated
// A speed is measured over at least min_run_deg and min_motion of a motion, or over max_motion.
constexpr double min_run_deg = 20.0;
constexpr auto min_motion = 60ms, max_motion = 1000ms;

std::string degrees(double angle_deg) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", angle_deg);
  return text.data();
}

}  // namespace

void PlateWatch::note_command(double orientation_deg) {
  if (command_deg_ == orientation_deg) return;
  const bool turns_back =
      command_deg_ && !motion_.empty() &&
      (orientation_deg - motion_.back().orientation_deg) * (*command_deg_ - motion_.back().orientation_deg) <= 0.0;
  if (turns_back) motion_.clear();
  command_deg_ = orientation_deg;
}

void PlateWatch::note_stop() {
  command_deg_.reset();
  motion_.clear();
  moved_.reset();
}

void PlateWatch::note_report(Time time, std::optional<double> known_deg) {
  // The reports that the plate sent during a pause of this process are received together: their times are unknown.
  if (time - reported_ > max_pause) {
    motion_.clear();
    moved_.reset();
  }
  has_reported_ = true;
  reported_ = time;
  if (!known_deg) return;
  const double orientation_deg = *known_deg;
  if (orientation_deg < greeting_.min_deg - limit_slack_deg || orientation_deg > greeting_.max_deg + limit_slack_deg)
    throw PlateFailure(Fault::limits, "reports " + degrees(orientation_deg) + " deg, outside its limits of " +
                                          degrees(greeting_.min_deg) + " to " + degrees(greeting_.max_deg) +
                                          " deg. Check its sensor and settings");
  const bool far = command_deg_ && std::abs(*command_deg_ - orientation_deg) > moving_deg;
  if (!far) {
    motion_.clear();
    moved_.reset();
    return;
  }
  measure_speed({time, orientation_deg});
  expect_motion({time, orientation_deg});
}

void PlateWatch::check(Time now) const {
  if (now - reported_ <= report_limit) return;
  throw PlateFailure(
      Fault::no_report,
      has_reported_ ? "has not reported its orientation for half a second; check its cable, and open the plate again"
                    : "never reports its orientation; check its firmware");
}

void PlateWatch::measure_speed(const Position& now) {
  const auto travelled_deg = [&](const Position& from) { return std::abs(now.orientation_deg - from.orientation_deg); };
  const auto is_long_enough = [&](const Position& from) {
    const auto time = now.time - from.time;
    return (time >= min_motion && travelled_deg(from) >= min_run_deg) || time >= max_motion;
  };
  motion_.push_back(now);
  while (motion_.size() > 1 && is_long_enough(motion_[1])) motion_.pop_front();
  const Position& from = motion_.front();
  if (!is_long_enough(from) || travelled_deg(from) <= moved_deg) return;
  const double speed_deg_s = travelled_deg(from) / std::chrono::duration<double>(now.time - from.time).count();
  speed_deg_s_ = std::max(speed_deg_s_.value_or(0.0), speed_deg_s);
}

void PlateWatch::expect_motion(const Position& now) {
  const double min_deg = std::min(moved_deg, 0.25 * greeting_.speed_deg_s);
  if (!moved_ || std::abs(now.orientation_deg - moved_->orientation_deg) >= min_deg) moved_ = now;
  if (now.time - moved_->time > stuck_limit)
    throw PlateFailure(Fault::stuck, "is stuck at " + degrees(now.orientation_deg) + " deg; it must turn to " +
                                         degrees(*command_deg_) +
                                         " deg. Remove the obstacle, and open the plate again");
}

void RoundTrips::sent(Time time, std::uint16_t sequence) {
  constexpr std::size_t max = 64;
  sent_.push_back({time, sequence});
  if (sent_.size() > max) sent_.pop_front();
}

bool RoundTrips::echoed(Time time, std::uint16_t sequence) {
  if (sequence == last_echo_) return true;
  const auto found =
      std::find_if(sent_.begin(), sent_.end(), [&](const Sent& line) { return line.sequence == sequence; });
  if (found == sent_.end()) return false;
  last_echo_ = sequence;
  constexpr std::size_t max = 1000;
  const Time found_time = found->time;
  sent_.erase(sent_.begin(), found + 1);
  if (times_.size() == max) return true;
  times_.push_back(time - found_time);
  auto sorted = times_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  median_ = *middle;
  return true;
}

}  // namespace hrt::plate
