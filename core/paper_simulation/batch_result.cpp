#include "core/paper_simulation/batch_result.h"

#include <cmath>

namespace hrt {
namespace {

constexpr double units_per_deg = 0x1p20;
// With angles of at most this size, the sum over 2^32 trials fits into 63 bits.
constexpr double max_deg = 1000.0;

}  // namespace

void AngleSums::add(double angle_deg) {
  // The order of the comparisons makes a NaN count as -max_deg.
  const double clamped_deg = angle_deg >= max_deg ? max_deg : (angle_deg > -max_deg ? angle_deg : -max_deg);
  const auto units = static_cast<std::int64_t>(clamped_deg * units_per_deg + (clamped_deg < 0.0 ? -0.5 : 0.5));
  const auto square = static_cast<std::uint64_t>(units * units);
  sum_ += units;
  squares_low_ += square;
  squares_high_ += squares_low_ < square ? 1 : 0;
}

void AngleSums::add(AngleSums other) {
  sum_ += other.sum_;
  squares_low_ += other.squares_low_;
  squares_high_ += other.squares_high_ + (squares_low_ < other.squares_low_ ? 1 : 0);
}

double AngleSums::mean_deg(std::uint64_t count) const {
  return static_cast<double>(sum_) / units_per_deg / static_cast<double>(count);
}

double AngleSums::rms_deg(std::uint64_t count) const {
  const double squares = static_cast<double>(squares_high_) * 0x1p64 + static_cast<double>(squares_low_);
  return std::sqrt(squares / static_cast<double>(count)) / units_per_deg;
}

BatchResult& BatchResult::operator+=(const BatchResult& other) {
  trials += other.trials;
  hits += other.hits;
  steps += other.steps;
  saturated_steps += other.saturated_steps;
  miss.add(other.miss);
  felt_error.add(other.felt_error);
  return *this;
}

}  // namespace hrt
