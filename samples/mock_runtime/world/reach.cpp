#include "samples/mock_runtime/world/reach.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/random.h"
#include "core/trigonometry.h"

namespace hrt::mock {
namespace {

Eigen::Vector2d unit_vector(double direction_deg) {
  return {-sin_deg(direction_deg), -cos_deg(direction_deg)};
}

double seconds(XrDuration duration) {
  return static_cast<double>(duration) * 1e-9;
}

}  // namespace

Reach::Reach(const ParticipantSettings& settings, const ReachInstruction& instruction, std::uint64_t seed,
             std::uint32_t number, XrTime start)
    : settings_(settings),
      participant_(settings.parameters, instruction.goal_direction_deg),
      seed_(seed),
      number_(number),
      start_(start),
      duration_(std::llround(instruction.path_length_m / settings.speed_m_per_s * 1e9)),
      total_steps_(
          static_cast<std::uint32_t>((duration_ + settings.model_step_ns - 1) / settings.model_step_ns)),
      legs_{
          {instruction.start_m, settings.speed_m_per_s * unit_vector(participant_.finger_direction_deg())}} {}

XrTime Reach::step_end(std::uint32_t step) const {
  return start_ + std::min<XrDuration>(duration_, (step + XrDuration{1}) * settings_.model_step_ns);
}

void Reach::advance(XrTime time, const PlateModel& plate) {
  for (; !done() && step_end(steps_) <= time; ++steps_) {
    const XrTime end = step_end(steps_);
    participant_.step(plate.orientation_at_deg(end), standard_normal({seed_, 0, number_, steps_}));
    if (steps_ + 1 < total_steps_)
      legs_.push_back(
          {position_m(end), settings_.speed_m_per_s * unit_vector(participant_.finger_direction_deg())});
  }
}

std::size_t Reach::leg_at(XrTime time) const {
  const XrDuration elapsed = std::clamp<XrDuration>(time - start_, 0, duration_);
  return std::min(static_cast<std::size_t>(elapsed / settings_.model_step_ns), legs_.size() - 1);
}

Eigen::Vector2d Reach::position_m(XrTime time) const {
  const std::size_t leg = leg_at(time);
  const XrTime leg_start = start_ + static_cast<XrDuration>(leg) * settings_.model_step_ns;
  const XrTime within = std::clamp(time, leg_start, step_end(static_cast<std::uint32_t>(leg)));
  return legs_[leg].from_m + seconds(within - leg_start) * legs_[leg].velocity_m_per_s;
}

Eigen::Vector2d Reach::velocity_m_per_s(XrTime time) const {
  if (time < start_ || time >= start_ + duration_) return Eigen::Vector2d::Zero();
  return legs_[leg_at(time)].velocity_m_per_s;
}

}  // namespace hrt::mock
