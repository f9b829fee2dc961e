#include "samples/mock_runtime/world/servo.h"

#include <algorithm>
#include <cmath>

namespace hrt::mock {
namespace {

// Some minutes at a command a frame: far longer ago than anything asks for.
constexpr std::size_t remembered_turns = 20'000;

}  // namespace

void Servo::command(XrTime time, double orientation_deg_wanted) {
  const XrTime start = time + settings_.latency_ns;
  if (!turns_.empty() && turns_.back().to_deg == orientation_deg_wanted) return;
  turns_.push_back({start, orientation_deg(start), orientation_deg_wanted});
  if (turns_.size() > remembered_turns) turns_.pop_front();
}

double Servo::orientation_deg(XrTime time) const {
  const auto after = std::upper_bound(turns_.begin(), turns_.end(), time,
                                      [](XrTime t, const Turn& turn) { return t < turn.start; });
  if (after == turns_.begin()) return turns_.empty() ? 0.0 : turns_.front().from_deg;
  const Turn& turn = *std::prev(after);
  const double turned_deg = settings_.speed_deg_per_s * (static_cast<double>(time - turn.start) * 1e-9);
  const double gap_deg = turn.to_deg - turn.from_deg;
  // Also where an infinite speed meets a duration of 0.
  if (!(turned_deg < std::abs(gap_deg))) return turn.to_deg;
  return turn.from_deg + std::copysign(turned_deg, gap_deg);
}

}  // namespace hrt::mock
