// Steering answers what was felt a while ago.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace hrt {

/// What a sliding person felt, one value a step, and what of it they answer now.
class SteeringDelay {
 public:
  /// Below it, in the direction of the goal, a finger feels no motion to steer.
  static constexpr double min_felt_speed_m_s = 0.002;
  static constexpr double max_steps = 62.0;

  /// `steps`: from what is felt to its answer, -0.5 to max_steps; between steps what is felt is linear.
  explicit SteeringDelay(double steps)
      : whole_(steps > 0.0 ? static_cast<std::size_t>(steps) : 0), part_(steps - static_cast<double>(whole_)) {}

  struct Answer {
    double felt_deg;
    double share;  ///< of the step, in which there is an answer: less than 1 at the first moment that is felt
  };
  /// The answer in the step in which `felt_deg` is felt; none until the first.
  std::optional<Answer> feel(double felt_deg) {
    felt_deg_[felt_ % felt_deg_.size()] = felt_deg;
    const std::size_t now = felt_++;
    if (now < whole_) return std::nullopt;
    const double late_deg = felt_deg_[(now - whole_) % felt_deg_.size()];
    if (now == whole_) return Answer{late_deg, part_ > 0.0 ? 1.0 - part_ : 1.0};
    const double later_deg = felt_deg_[(now - whole_ - 1) % felt_deg_.size()];
    return Answer{(1.0 - part_) * late_deg + part_ * later_deg, 1.0};
  }

  /// A finger at rest feels no motion, and what was felt before is not answered.
  void rest() { felt_ = 0; }

 private:
  std::size_t whole_;
  double part_;
  std::array<double, 64> felt_deg_{};
  std::size_t felt_ = 0;
};

}  // namespace hrt
