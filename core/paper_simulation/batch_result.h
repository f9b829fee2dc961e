// Results of many trials, which can be added exactly in any order.
#pragma once

#include <cstdint>

namespace hrt {

/// Sum and sum of squares of angles, as integers, so that the order of addition has no effect.
class AngleSums {
 public:
  /// Adds one angle, rounded to 2^-20 degrees and clamped to +-1000.
  void add(double angle_deg);
  void add(AngleSums other);

  /// Mean over `count` angles. Requires count > 0.
  double mean_deg(std::uint64_t count) const;
  /// Root of the mean square over `count` angles. Requires count > 0.
  double rms_deg(std::uint64_t count) const;

  bool operator==(const AngleSums&) const = default;

 private:
  std::int64_t sum_ = 0;           // sum in units of 2^-20 degrees
  std::uint64_t squares_low_ = 0;  // sum of squares of these units, 128 bits in two halves
  std::uint64_t squares_high_ = 0;
};

/// Result of a range of trials of one condition. Adding results of disjoint ranges gives exactly that of their union.
struct BatchResult {
  std::uint64_t trials = 0;
  std::uint64_t hits = 0;
  std::uint64_t steps = 0;            ///< model steps of all trials
  std::uint64_t saturated_steps = 0;  ///< steps in which a bound limited the plate
  AngleSums miss;                     ///< direction after the last step of each trial minus P_R
  AngleSums felt_error;               ///< theta_hat - theta_V in the last step of each trial

  double hit_percent() const { return 100.0 * static_cast<double>(hits) / static_cast<double>(trials); }
  double mean_miss_deg() const { return miss.mean_deg(trials); }
  double rms_miss_deg() const { return miss.rms_deg(trials); }
  /// Root mean square of theta_hat - theta_V in the last step.
  double rms_felt_error_deg() const { return felt_error.rms_deg(trials); }

  BatchResult& operator+=(const BatchResult& other);
  bool operator==(const BatchResult&) const = default;
};

}  // namespace hrt
