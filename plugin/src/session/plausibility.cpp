#include "plugin/src/session/plausibility.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/math/time.h"

namespace hrt::plugin {
namespace {

using Kind = Implausible::Kind;

constexpr double max_speed_mm_s = 5000.0;
constexpr int max_in_a_row = 5;  // more than 2, because one outlier makes the two motions to and from it too fast
constexpr std::uint64_t window_ns = 1'000'000;
constexpr int max_samples_in_window = 50;
constexpr std::uint64_t min_sample_ns = 100'000;
constexpr double max_radii = 3.0;
constexpr double max_target_radii = 2.0;
constexpr double min_checked_fraction = 0.5;  // fraction of the path from which on the bearing is checked
constexpr double max_off_course_deg = 90.0;
constexpr double ended_fraction = 0.85;
// Without steering, the finger ends near the virtual target. If it ends more than min_turned_deg and
// min_turned_fraction of the gap beyond the virtual target, the plate probably turns in the wrong direction. Gaps below
// min_gap_deg are not checked.
constexpr double min_gap_deg = 5.0, min_turned_deg = 4.0, min_turned_fraction = 0.75;

double from_centre_mm(const PlatePoint& place) { return distance_mm({}, place); }

}  // namespace

Plausibility::Plausibility(double plate_radius_mm, const Reach& reach, bool may_be_in_radians)
    : radius_mm_(plate_radius_mm), reach_(reach) {
  if (may_be_in_radians) find(Kind::radians, 0.0, 0.0);
  const PlatePoint target = point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm);
  const double farthest_mm = std::max(from_centre_mm(reach.start), from_centre_mm(target));
  if (farthest_mm > max_target_radii * radius_mm_) find(Kind::target_off_plate, farthest_mm, radius_mm_);
}

void Plausibility::find(Kind kind, double first, double second) {
  if (found_.kind == Kind::none) found_ = {kind, first, second};
}

void Plausibility::observe(const FingerSample& sample) {
  if (!first_ns_ || elapsed_ns(*first_ns_, sample.time_ns) > window_ns) {
    first_ns_ = sample.time_ns;
    samples_ = 0;
  }
  if (++samples_ > max_samples_in_window)
    find(Kind::time_too_slow, samples_, static_cast<double>(elapsed_ns(*first_ns_, sample.time_ns)) / (samples_ - 1));
  if (sample.observation != Observation::position) return;
  ++positions_;
  if (last_) {
    const double moved_mm = distance_mm(last_->position, sample.position);
    const std::uint64_t passed_ns = elapsed_ns(last_->time_ns, sample.time_ns);
    const double speed_mm_s = moved_mm / (1e-9 * std::max(1.0, static_cast<double>(passed_ns)));
    fast_positions_ = speed_mm_s > max_speed_mm_s ? fast_positions_ + 1 : 0;
    // Below min_sample_ns, which is shorter than the period of trackers, the unit of time is wrong, not that of length.
    const bool is_time = passed_ns < min_sample_ns;
    if (fast_positions_ >= max_in_a_row)
      find(is_time ? Kind::time_too_slow : Kind::too_fast, is_time ? fast_positions_ : 1e-3 * speed_mm_s,
           static_cast<double>(passed_ns));
  }
  const bool is_far_away = from_centre_mm(sample.position) > max_radii * radius_mm_;
  if (is_far_away) {
    ++far_positions_;
    far_ = {Kind::far_away, from_centre_mm(sample.position), radius_mm_};
  }
  last_ = sample;
  if (skips_directions_) return;
  const double covered = distance_mm(reach_.start, sample.position) / reach_.real_distance_mm;
  came_from_start_ = came_from_start_ || covered < min_checked_fraction;
  if (!came_from_start_ || covered < min_checked_fraction || is_far_away) {
    wrong_positions_ = turned_positions_ = 0;
    return;
  }
  const double bearing = bearing_deg(reach_.start, sample.position);
  const double off_deg = wrap_deg(bearing - reach_.virtual_direction_deg, 360.0);
  wrong_positions_ = std::abs(off_deg) > max_off_course_deg ? wrong_positions_ + 1 : 0;
  if (wrong_positions_ >= max_in_a_row) find(Kind::wrong_way, bearing, reach_.virtual_direction_deg);
  const double gap_deg = wrap_deg(reach_.real_direction_deg - reach_.virtual_direction_deg, 360.0);
  const double turned_deg = gap_deg > 0.0 ? -off_deg : off_deg;
  const double allowed_deg = std::max(min_turned_deg, min_turned_fraction * std::abs(gap_deg));
  const bool turns = std::abs(gap_deg) >= min_gap_deg && covered >= ended_fraction && turned_deg > allowed_deg &&
                     turned_deg < max_off_course_deg;
  turned_positions_ = turns ? turned_positions_ + 1 : 0;
  if (turned_positions_ >= max_in_a_row) find(Kind::turns_with_plate, turned_deg, std::abs(gap_deg));
}

void write_implausible(const Implausible& found, Text<320>& text) {
  switch (found.kind) {
    case Kind::none:
      break;
    case Kind::radians:
      text << "the directions of all targets are at most 1.6 degrees and probably in radians: set direction_deg in "
              "degrees";
      break;
    case Kind::target_off_plate:
      text << "the start or the real target is " << found.first << " mm from the centre of a plate of radius "
           << found.second << " mm: check that positions are in metres, and the plate's pose";
      break;
    case Kind::time_too_slow:
      text << "times advance by " << found.second << " ns per sample: set time_ns in nanoseconds";
      break;
    case Kind::too_fast:
      text << "the finger moves at " << found.first << " m/s, with " << found.second
           << " ns between samples: set positions in metres and time_ns in nanoseconds";
      break;
    case Kind::far_away:
      text << "the finger is " << found.first << " mm from the centre of a plate of radius " << found.second
           << " mm: set positions in metres, and check the plate's pose in the world";
      break;
    case Kind::wrong_way:
      text << "the finger moves towards " << found.first << " degrees, but the virtual target is at " << found.second
           << ": check for swapped or mirrored axes; x is to the right, y up, z towards the user";
      break;
    case Kind::turns_with_plate:
      text << "the finger ends " << found.first << " degrees beyond the virtual target, on the side away from the real "
           << "target: check that positive plate orientations are counter-clockwise, and that no axis is mirrored";
      break;
  }
}

}  // namespace hrt::plugin
