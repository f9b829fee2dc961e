#include "core/plate/plate_model.h"

#include <algorithm>
#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

// With an acceleration limit, motion is integrated in steps of tick_ns, or in max_ticks longer steps.
constexpr std::int64_t tick_ns = 4'000'000;
constexpr std::uint64_t max_ticks = 500;

}  // namespace

bool is_valid(const PlateDynamics& dynamics) {
  return dynamics.max_speed_deg_s > 0.0 && dynamics.max_acceleration_deg_s2 > 0.0 && dynamics.latency_ns >= 0 &&
         dynamics.latency_ns <= 1'000'000'000 && is_valid(dynamics.stops);
}

PlateModel::PlateModel(const PlateDynamics& dynamics, double orientation_deg) : dynamics_(dynamics) {
  put(orientation_deg);
}

void PlateModel::advance_turning(std::int64_t time_ns) {
  if (!timed_) {
    timed_ = true;
    motion_.now_ns = time_ns;
    // A command was given before the time was known.
    if (pending_count_ > 0) pending_[0].effective_ns = later_ns(time_ns, dynamics_.latency_ns);
  }
  if (time_ns <= motion_.now_ns) return;
  const int due = turn_until(time_ns, motion_);
  if (due == 0) return;
  std::move(pending_.begin() + due, pending_.begin() + pending_count_, pending_.begin());
  pending_count_ -= due;
}

// Advances `motion` to `time_ns`, and returns the number of commands that took effect.
int PlateModel::turn_until(std::int64_t time_ns, Motion& motion) const {
  const std::int64_t step_ns =
      std::max(tick_ns, static_cast<std::int64_t>(elapsed_ns(motion.now_ns, time_ns) / max_ticks));
  int due = 0;
  while (motion.now_ns < time_ns) {
    while (due < pending_count_ && pending_[due].effective_ns <= motion.now_ns)
      motion.target_deg = pending_[due++].orientation_deg;
    std::int64_t until_ns = due < pending_count_ ? std::min(time_ns, pending_[due].effective_ns) : time_ns;
    if (motion.orientation_deg == motion.target_deg &&
        (due == pending_count_ || (until_ns == time_ns && motion.speed_deg_s == 0.0)))
      break;
    if (std::isfinite(dynamics_.max_acceleration_deg_s2))
      until_ns = std::min(until_ns, later_ns(motion.now_ns, step_ns));
    turn(elapsed_s(motion.now_ns, until_ns), motion);
    motion.now_ns = until_ns;
  }
  motion.now_ns = time_ns;
  return due;
}

void PlateModel::command(double orientation_deg) {
  if (dynamics_.latency_ns == 0) {
    pending_count_ = 0;
    motion_.target_deg = orientation_deg;
    if (std::isinf(dynamics_.max_speed_deg_s) && std::isinf(dynamics_.max_acceleration_deg_s2)) {
      motion_.orientation_deg = orientation_deg;
    }
    return;
  }
  if (orientation_deg == (pending_count_ > 0 ? pending_[pending_count_ - 1].orientation_deg : motion_.target_deg))
    return;
  const std::int64_t effective_ns = later_ns(motion_.now_ns, dynamics_.latency_ns);
  // With at least this spacing, the array of pending commands spans the latency.
  const auto apart_ns =
      static_cast<std::uint64_t>(dynamics_.latency_ns) / static_cast<std::uint64_t>(pending_.size() - 1);
  if (pending_count_ > 0 && elapsed_ns(pending_[pending_count_ - 1].effective_ns, effective_ns) <= apart_ns) {
    pending_[pending_count_ - 1].orientation_deg = orientation_deg;
    return;
  }
  pending_[pending_count_++] = {effective_ns, orientation_deg};
}

void PlateModel::report(double orientation_deg) {
  motion_.orientation_deg = reported_orientation_deg(orientation_deg, motion_.orientation_deg, dynamics_.stops);
}

double PlateModel::turning_at_deg(std::int64_t time_ns) const {
  Motion ahead = motion_;
  if (time_ns > ahead.now_ns) turn_until(time_ns, ahead);
  return ahead.orientation_deg;
}

// The plate accelerates for half of the time and brakes for the other half, unless it reaches full speed in between.
double PlateModel::reach_deg(double seconds) const {
  if (seconds <= 0.0) return 0.0;
  const double acceleration = dynamics_.max_acceleration_deg_s2;
  const double speed = dynamics_.max_speed_deg_s;
  if (std::isinf(acceleration)) return speed * seconds;
  if (acceleration * seconds <= 2.0 * speed) return 0.25 * acceleration * seconds * seconds;
  return speed * (seconds - speed / acceleration);
}

// Rotates the plate at the highest speed from which it can still stop at the target.
void PlateModel::turn(double seconds, Motion& motion) const {
  const double to_go_deg = motion.target_deg - motion.orientation_deg;
  const double acceleration = dynamics_.max_acceleration_deg_s2;
  double wanted_deg_s = std::min(dynamics_.max_speed_deg_s, std::abs(to_go_deg) / seconds);
  if (std::isfinite(acceleration)) {
    wanted_deg_s = std::min(wanted_deg_s, std::sqrt(2.0 * acceleration * std::abs(to_go_deg)));
    wanted_deg_s = std::copysign(wanted_deg_s, to_go_deg);
    motion.speed_deg_s +=
        std::clamp(wanted_deg_s - motion.speed_deg_s, -acceleration * seconds, acceleration * seconds);
  } else {
    motion.speed_deg_s = std::copysign(wanted_deg_s, to_go_deg);
  }
  const double turned_deg = motion.speed_deg_s * seconds;
  const bool arrives = std::abs(to_go_deg - turned_deg) < 1e-9;
  motion.orientation_deg = arrives ? motion.target_deg : motion.orientation_deg + turned_deg;
  if (arrives) motion.speed_deg_s = 0.0;
}

void PlateTrace::add(double time_s, double orientation_deg) {
  const bool crowded = count_ >= 2 && time_s - entry(count_ - 2).time_s < min_spacing_s;
  if (crowded) {
    --count_;
  } else if (count_ == capacity) {
    first_ = (first_ + 1) % capacity;
    --count_;
  }
  entries_[static_cast<std::size_t>((first_ + count_++) % capacity)] = {time_s, orientation_deg};
}

double PlateTrace::at(double time_s) const {
  int i = count_ - 1;
  while (i > 0 && entry(i).time_s > time_s) --i;
  const Entry& before = entry(i);
  if (i == count_ - 1 || time_s <= before.time_s) return before.orientation_deg;
  const Entry& after = entry(i + 1);
  const double share = (time_s - before.time_s) / (after.time_s - before.time_s);
  return before.orientation_deg + share * (after.orientation_deg - before.orientation_deg);
}

}  // namespace hrt
