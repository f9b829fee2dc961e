#include "samples/reach/measure_tracker.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/format.h"

namespace hrt::reach {
namespace {

constexpr std::size_t reaches = 20;
constexpr double still_m = 0.003, apart_m = 0.03;
constexpr XrDuration rest_ns = 700'000'000;

// Waits until the finger has stayed within 3 mm for 0.7 s, at least 30 mm from `last`, and returns its mean position.
// If `last` is null, the finger may rest anywhere.
Point next_rest(RunContext& context, const Point* last) {
  Point first{}, sum{};
  int count = 0;
  const XrTime began = next_frame(context);
  XrTime since = began;
  for (XrTime time = began; time - began <= context.time_limit_ns; time = next_frame(context)) {
    const Fingertip tip = locate(context, context.hands.front(), time);
    if (!tip.tracked || count == 0 || distance_along_plate_m(tip.position_m, first) > still_m) {
      first = tip.position_m;
      sum = {};
      count = 0;
      since = time;
      if (!tip.tracked || (last != nullptr && distance_along_plate_m(first, *last) < apart_m)) continue;
    }
    for (std::size_t i = 0; i < 3; ++i) sum[i] += tip.position_m[i];
    ++count;
    if (time - since >= rest_ns) return {sum[0] / count, sum[1] / count, sum[2] / count};
  }
  throw Failure(ExitCode::no_hand, "No finger rested in the dimple " + within_s(context.time_limit_ns) +
                                       ". Start again, and keep the finger still in each dimple for a second");
}

double share_within(double sd_deg) { return 100.0 * std::erf(1.5 / (sd_deg * std::numbers::sqrt2)); }

}  // namespace

std::string bearing_sd_text(std::span<const double> bearings_deg, double mean_distance_m) {
  // sqrt(19 / q), where q is the 97.5 or 2.5 % quantile of chi squared with 19 degrees of freedom.
  constexpr double low = 0.7605, high = 1.4606;
  const auto count = static_cast<double>(bearings_deg.size());
  double sum = 0.0, squares = 0.0;
  for (const double bearing_deg : bearings_deg) {
    // Differences from the first bearing do not wrap around.
    const double difference_deg = std::remainder(bearing_deg - bearings_deg.front(), 360.0);
    sum += difference_deg;
    squares += difference_deg * difference_deg;
  }
  const double sd_deg = std::sqrt(std::max(1e-9, (squares - sum * sum / count) / (count - 1.0)));
  return format("Standard deviation of the bearing over %.0f mm: %.2f degrees, 95 %% interval %.2f to %.2f.\n",
                1e3 * mean_distance_m, sd_deg, low * sd_deg, high * sd_deg) +
         format("So at most %.0f %% of reaches end within 1.5 degrees of the target, 95 %% interval %.0f to %.0f %%.\n",
                share_within(sd_deg), share_within(high * sd_deg), share_within(low * sd_deg)) +
         format("Set tracker.bearing_sd_deg of the session, or bearing_sd_deg of --finger, to %.2f.\n", sd_deg);
}

std::string measure_tracker(RunContext& context) {
  std::vector<double> bearings_deg;
  double distance_m = 0.0;
  Point last{};
  while (bearings_deg.size() < reaches) {
    const bool is_first = bearings_deg.empty();
    context.tell_user(
        format("Slide %zu of %zu: rest the finger in the first dimple.", bearings_deg.size() + 1, reaches));
    const Point from = next_rest(context, is_first ? nullptr : &last);
    context.tell_user("Slide the finger to the second dimple, and rest it there.");
    last = next_rest(context, &from);
    distance_m += distance_along_plate_m(from, last) / static_cast<double>(reaches);
    bearings_deg.push_back(std::atan2(from[0] - last[0], from[2] - last[2]) * 180.0 / std::numbers::pi);
  }
  return bearing_sd_text(bearings_deg, distance_m);
}

}  // namespace hrt::reach
