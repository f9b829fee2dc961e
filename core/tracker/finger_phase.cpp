#include "core/tracker/finger_phase.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/elementary.h"
#include "core/math/time.h"

namespace hrt {
namespace {

// In a rest, neither the distance between first and last position of the window nor the sagitta exceeds this multiple
// of the limit of the displacement.
constexpr double clearly_moving_limits = 4.0;

}  // namespace

template <class Point>
PhaseDetector<Point>::PhaseDetector(const std::optional<Point>& start, const std::optional<TrackerNoise>& noise,
                                    const PhaseTuning& tuning)
    : tuning_(tuning), noise_(noise), start_known_(start.has_value()) {
  if (start) rest_.place = *start;
}

template <class Point>
double PhaseDetector<Point>::sigma_mm() const {
  double variance_mm2 = noise().variance_mm2();
  // At least the SD that the differences of successive positions show, with an allowance for their small number.
  if (noise_.steps() > 0 && !noise_.known())
    variance_mm2 =
        std::max(variance_mm2, noise_.step_variance_mm2() * square(1.0 + tuning_.hidden_share / noise_.steps()));
  return std::sqrt(variance_mm2);
}

template <class Point>
typename PhaseDetector<Point>::Outcome PhaseDetector<Point>::process(double time_s, const Point& position) {
  if (at_rest()) {
    if (is_outlier(time_s, position)) return Outcome::ignored;
    if (std::exchange(successive_outliers_, 0) > tuning_.max_outliers)
      phase_ = Phase::lifted;  // too many successive outliers: the finger rests elsewhere
  }
  const double gap_s = places_.count() > 0 ? time_s - places_[0].time_s : 0.0;
  if (!places_.add(time_s, position)) return Outcome::merged;
  if (gap_s > tuning_.max_gap_s) rest_.since_s = time_s;
  if (phase_ == Phase::lifted) {
    set_down();
    return Outcome::set_down;
  }
  if (at_rest() && has_left()) {
    phase_ = Phase::moving;
    moved_ = true;
    moving_since_s_ = time_s;
  } else if (at_rest()) {
    add_to_rest();
  } else {
    noise_.learn_moving(places_);
  }
  return Outcome::place;
}

template <class Point>
bool PhaseDetector<Point>::is_outlier(double time_s, const Point& position) {
  if (places_.count() == 0) return false;
  const double allowed_mm =
      tuning_.max_start_speed_mm_s * (time_s - places_[0].time_s) + tuning_.outlier_deviations * sigma_mm();
  successive_outliers_ =
      square_distance_mm2(position, places_[0].position) > square(allowed_mm) ? successive_outliers_ + 1 : 0;
  return successive_outliers_ > 0 && successive_outliers_ <= tuning_.max_outliers;
}

template <class Point>
bool PhaseDetector<Point>::has_left() const {
  if (rest_.places == 0 || places_.count() < 3) return false;
  return square_distance_mm2(places_.mean_of_last(3), rest_.place) > square(leaving_mm());
}

template <class Point>
double PhaseDetector<Point>::leaving_mm() const {
  return std::max(tuning_.min_leaving_mm, tuning_.leaving_deviations * sigma_mm());
}

template <class Point>
void PhaseDetector<Point>::add_to_rest() {
  const Timed<Point>& seen = places_[0];
  if (rest_.places == 0) {
    // If the first sample is near the expected start, the rest position is the start: the finger may be moving already.
    if (!start_known_ || square_distance_mm2(seen.position, rest_.place) > square(tuning_.start_tolerance_mm))
      rest_.place = seen.position;
    rest_.places = rest_.seen = 1;
    rest_.since_s = rest_.seen_s = seen.time_s;
    return;
  }
  const double departure_mm2 = square_distance_mm2(seen.position, rest_.place);
  const double near_mm2 = square(tuning_.seen_at_rest_deviations) * noise().variance_mm2();
  if (departure_mm2 < std::max(near_mm2, square(tuning_.min_seen_at_rest_mm))) rest_.seen_s = seen.time_s;
  const bool is_far =
      rest_.places > 3 && departure_mm2 > square(tuning_.rest_place_deviations) * noise().variance_mm2();
  noise_.learn(places_, is_far ? 1 : rest_.seen);
  ++rest_.seen;
  if (is_far) return;
  ++rest_.places;
  const double share = std::max(1.0 / (rest_.places - 1), (seen.time_s - places_[1].time_s) / tuning_.place_memory_s);
  rest_.place = rest_.place + std::min(share, 1.0) * (seen.position - rest_.place);
}

template <class Point>
void PhaseDetector<Point>::set_down() {
  places_.keep_last();
  phase_ = moved_ ? Phase::paused : Phase::waiting;
  rest_ = {
      .place = places_[0].position, .places = 1, .seen = 1, .since_s = places_[0].time_s, .seen_s = places_[0].time_s};
}

template <class Point>
bool PhaseDetector<Point>::find_pause(std::optional<double> expected_mm_s) {
  if (phase_ != Phase::moving) return false;
  const double noise_mm = std::sqrt(noise().variance_mm2());
  const double allowed_mm = tuning_.still_deviations * noise_mm;
  const double min_window_s = tuning_.still_s + (expected_mm_s ? 0.0 : allowed_mm / tuning_.slow_mm_s);
  // The smallest number of positions that span the window, by bisection.
  int count = static_cast<int>(tuning_.still_places);
  int most = places_.count();
  if (most < count) return false;
  while (count < most) {
    const int middle = (count + most) / 2;
    if (places_[0].time_s - places_[middle - 1].time_s < min_window_s) {
      count = middle + 1;
    } else {
      most = middle;
    }
  }
  if (places_[count - 1].time_s < moving_since_s_) return false;
  const double window_s = places_[0].time_s - places_[count - 1].time_s;
  const double limit_mm = expected_mm_s ? std::min(allowed_mm, *expected_mm_s * window_s - noise_mm)
                                        : std::max(allowed_mm, tuning_.max_creep_mm_s * window_s);
  // Rejects most windows of a motion without a fit.
  if (limit_mm <= 0.0 ||
      square_distance_mm2(places_[0].position, places_[count - 1].position) > square(clearly_moving_limits * limit_mm))
    return false;
  // Least-squares parabola over the index of a position, with orthogonal polynomials: each coefficient is a moment
  // divided by a sum of squares.
  const Point zero = 0.0 * places_[0].position;
  Point moment = zero;
  Point bend = zero;
  double spread = 0.0;
  double bend_spread = 0.0;
  const double mean_square = (square(count) - 1.0) / 12.0;
  for (int i = 0; i < count; ++i) {
    const double centred = 0.5 * (count - 1) - i;
    const double curved = square(centred) - mean_square;
    moment = moment + centred * places_[i].position;
    bend = bend + curved * places_[i].position;
    spread += square(centred);
    bend_spread += square(curved);
  }
  const double displacement_mm = (count - 1) / spread * std::sqrt(square_distance_mm2(moment, zero));
  if (displacement_mm > limit_mm) return false;
  const double sagitta_mm = square(0.5 * (count - 1)) / bend_spread * std::sqrt(square_distance_mm2(bend, zero));
  if (sagitta_mm > clearly_moving_limits * limit_mm) return false;
  const Rest before = rest_;
  const double begun_s = places_[count - 1].time_s;
  // In the first half of a long window the finger may still be braking.
  const int counted = expected_mm_s ? count : (count + 1) / 2;
  pause_at(begun_s, places_.mean_of_last(counted));
  rest_.places = counted;
  rest_.seen = count;
  // A finger that soon returns to the former rest position has not left it: the cause was noise or tremor.
  if (begun_s - moving_since_s_ < tuning_.max_departure_s &&
      square_distance_mm2(rest_.place, before.place) < square(leaving_mm()))
    rest_.since_s = before.since_s;
  return true;
}

template <class Point>
void PhaseDetector<Point>::observe(std::int64_t time_ns, const Point& position) {
  if (!origin_ns_) origin_ns_ = time_ns;
  if (process(elapsed_s(*origin_ns_, time_ns), position) == Outcome::place) find_pause();
}

template <class Point>
void PhaseDetector<Point>::pause_at(double time_s, const Point& place) {
  phase_ = Phase::paused;
  rest_ = {.place = place, .places = 1, .seen = 1, .since_s = time_s, .seen_s = time_s};
}

template <class Point>
double PhaseDetector<Point>::rest_place_sd_mm() const {
  return std::max(tuning_.min_place_sd_mm, std::sqrt(noise().variance_mm2() / std::max(1.0, rest_.places / 4.0)));
}

template class PhaseDetector<PlatePoint>;
template class PhaseDetector<Eigen::Vector3d>;

}  // namespace hrt
