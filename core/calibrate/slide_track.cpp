#include "core/calibrate/slide_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/math/distributions.h"
#include "core/math/elementary.h"
#include "core/plate/plate_limits.h"
#include "core/tracker/finger_phase.h"
#include "core/tracker/recent_places.h"

namespace hrt {
namespace {

constexpr double min_step_s = 0.01;
constexpr double steps_a_slide = 200.0;
constexpr std::array<double, slide_parts + 1> window_edges{0.15, 0.35, 0.55, 0.75, 1.01};
constexpr std::size_t min_places = 6;
constexpr std::size_t min_line_places = 4;
// Half of the time window of the lines that smooth the pace.
constexpr double smoothing_s = 0.075;
// A longer time without samples ends the slide.
constexpr double max_sample_gap_s = 5.0;
// A position is an outlier if it is more than max_deviations SDs and more than min_outlier_mm from the median of the
// positions that are at most `median_reach` samples away.
constexpr int median_reach = 5;
constexpr double max_deviations = 6.0;
constexpr double min_outlier_mm = 1.0;
// Within this fraction of the path from either end, rotations of the plate do not count: the finger hardly moves.
constexpr double end_fraction = 0.02;
// Minimum length of a part as a fraction of the path.
constexpr double min_part_fraction = 0.02;

// A position relative to the rest position: in the direction of the target, and to the left of this direction.
struct Place {
  double time_s;
  double along_mm;
  double left_mm;
};

// Median of a coordinate over sample `i` and `reach` samples to each side.
double middle_of(const std::vector<TimedPoint>& samples, int i, int reach, double PlatePoint::* coordinate) {
  std::array<double, 2 * median_reach + 1> values;
  for (int k = -reach; k <= reach; ++k)
    values[static_cast<std::size_t>(reach + k)] = samples[static_cast<std::size_t>(i + k)].position.*coordinate;
  const auto middle = values.begin() + reach;
  std::nth_element(values.begin(), middle, middle + reach + 1);
  return *middle;
}

// Returns, for each sample, whether it is not an outlier.
std::vector<bool> plausible(const std::vector<TimedPoint>& samples) {
  const auto count = static_cast<int>(samples.size());
  std::vector<double> off_mm(samples.size());
  for (int i = 0; i < count; ++i) {
    const int reach = std::min({median_reach, i, count - 1 - i});
    const PlatePoint middle{middle_of(samples, i, reach, &PlatePoint::right_mm),
                            middle_of(samples, i, reach, &PlatePoint::away_mm)};
    off_mm[static_cast<std::size_t>(i)] = distance_mm(middle, samples[static_cast<std::size_t>(i)].position);
  }
  const double max_mm = std::max(min_outlier_mm, max_deviations * mad_to_deviation * median(off_mm));
  std::vector<bool> keep;
  for (const double off : off_mm) keep.push_back(off <= max_mm);
  return keep;
}

// Distance in the direction of the target at `time_s`, by a weighted line through the positions around it. `first`:
// index of the first position to use; it is advanced for the next call, whose time must be later.
double smooth_along_mm(const std::vector<Place>& places, double time_s, std::size_t* first) {
  double reach_s = smoothing_s;
  while (*first + 1 < places.size() && places[*first + 1].time_s < time_s - reach_s) ++*first;
  std::size_t from = *first;
  std::size_t until;
  for (;; reach_s *= 2.0) {
    while (from > 0 && places[from - 1].time_s > time_s - reach_s) --from;
    until = from;
    while (until < places.size() && places[until].time_s < time_s + reach_s) ++until;
    if (until - from >= min_line_places || (from == 0 && until == places.size())) break;
  }
  double n = 0.0;
  double t = 0.0;
  double tt = 0.0;
  double a = 0.0;
  double ta = 0.0;
  for (std::size_t i = from; i < until; ++i) {
    const double x = (places[i].time_s - time_s) / reach_s;
    const double weight = std::max(1.0 - std::abs(x), 0.0);
    n += weight;
    t += weight * x;
    tt += weight * x * x;
    a += weight * places[i].along_mm;
    ta += weight * x * places[i].along_mm;
  }
  const double spread = n * tt - t * t;
  if (!(n > 0.0)) return places[*first].along_mm;
  return spread > 1e-6 * n * n ? (a * tt - t * ta) / spread : a / n;
}

// Time of the onset and the rest position before it; nullopt if the finger did not move.
std::optional<TimedPoint> find_onset(const std::vector<TimedPoint>& samples) {
  FingerPhase finger;
  for (const TimedPoint& sample : samples) {
    finger.process(sample.time_s, sample.position);
    if (finger.phase() == Phase::moving) return TimedPoint{finger.left_s(), finger.rest_place()};
  }
  return std::nullopt;
}

// Samples from the onset until a time without samples that is longer than max_sample_gap_s.
std::vector<Place> places_of(const std::vector<TimedPoint>& samples, const TimedPoint& onset,
                             double goal_direction_deg) {
  const double sine = sin_deg(goal_direction_deg);
  const double cosine = cos_deg(goal_direction_deg);
  std::vector<Place> places;
  for (const TimedPoint& sample : samples) {
    if (sample.time_s < onset.time_s) continue;
    const double time_s = sample.time_s - onset.time_s;
    if (!places.empty() && time_s - places.back().time_s > max_sample_gap_s) break;
    const double right_mm = sample.position.right_mm - onset.position.right_mm;
    const double away_mm = sample.position.away_mm - onset.position.away_mm;
    places.push_back({time_s, away_mm * cosine - right_mm * sine, -right_mm * cosine - away_mm * sine});
  }
  return places;
}

// Computes the pace in steps of `step_s`, unless the slide is too short. Returns the length of the path.
double set_pace(const std::vector<Place>& places, SlideTrack* track) {
  const auto count = static_cast<std::size_t>(places.back().time_s / track->step_s);
  std::vector<double> along_mm{0.0};
  std::size_t first = 0;
  for (std::size_t i = 1; i <= count; ++i)
    along_mm.push_back(smooth_along_mm(places, static_cast<double>(i) * track->step_s, &first));
  const double length_mm = *std::max_element(along_mm.begin(), along_mm.end());
  for (std::size_t i = 0; i < count && length_mm >= min_slide_mm; ++i) {
    const double share = 0.5 * (along_mm[i] + along_mm[i + 1]) / length_mm;
    SlideTrack::Step step{.advance_mm = along_mm[i + 1] - along_mm[i], .share = share};
    if (share >= window_edges[0] && share < window_edges[slide_parts])
      step.window =
          static_cast<int>(std::upper_bound(window_edges.begin(), window_edges.end(), share) - window_edges.begin()) -
          1;
    track->steps.push_back(step);
  }
  return length_mm;
}

// Computes the directions of the parts. Returns false if a window has no samples or a part is too short.
bool set_directions(const std::vector<Place>& places, double length_mm, SlideTrack* track) {
  SlideDirections left_mm = SlideDirections::Zero();
  SlideDirections mean_along_mm = SlideDirections::Zero();
  for (const Place& place : places) {
    const auto i = static_cast<std::size_t>(place.time_s / track->step_s);
    if (i >= track->steps.size()) continue;
    SlideTrack::Step& step = track->steps[i];
    if (step.window < 0) continue;
    step.samples += 1.0;
    track->window_samples(step.window) += 1.0;
    left_mm(step.window) += place.left_mm;
    mean_along_mm(step.window) += place.along_mm;
  }
  if (track->window_samples.minCoeff() < 1.0) return false;
  left_mm = left_mm.cwiseQuotient(track->window_samples);
  mean_along_mm = mean_along_mm.cwiseQuotient(track->window_samples);
  for (int part = 0; part < slide_parts; ++part) {
    const double from_left_mm = part > 0 ? left_mm(part - 1) : 0.0;
    const double from_along_mm = part > 0 ? mean_along_mm(part - 1) : 0.0;
    track->advance_mm(part) = mean_along_mm(part) - from_along_mm;
    if (!(track->advance_mm(part) > min_part_fraction * length_mm)) return false;
    track->direction_deg(part) = atan2_deg(left_mm(part) - from_left_mm, track->advance_mm(part));
  }
  return true;
}

}  // namespace

std::vector<TimedPoint> measurements_of(const std::vector<TimedPoint>& samples) {
  RepeatedPosition<PlatePoint> repeated;
  std::vector<TimedPoint> measured;
  for (const TimedPoint& sample : samples)
    if (!repeated.is_copy(std::llround(1e9 * (sample.time_s - samples.front().time_s)), sample.position))
      measured.push_back(sample);
  return measured;
}

std::optional<SlideTrack> track_slide(const CalibrationTrial& trial, double goal_direction_deg) {
  const std::vector<TimedPoint> measured = measurements_of(trial.samples);
  const std::vector<bool> keep = plausible(measured);
  std::vector<TimedPoint> samples;
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (keep[i]) samples.push_back(measured[i]);
  const std::optional<TimedPoint> onset = find_onset(samples);
  if (!onset) return std::nullopt;
  const std::vector<Place> places = places_of(samples, *onset, goal_direction_deg);
  if (places.size() < min_places) return std::nullopt;

  SlideTrack track;
  track.plate_deg = ridge_normal_deg(trial.plate_orientation_deg, goal_direction_deg) - goal_direction_deg;
  track.onset_s = onset->time_s;
  track.step_s = std::max(min_step_s, places.back().time_s / steps_a_slide);
  const double length_mm = set_pace(places, &track);
  if (!(length_mm >= min_slide_mm) || !set_directions(places, length_mm, &track)) return std::nullopt;
  return track;
}

bool plate_turned(const CalibrationTrial& trial, const SlideTrack& track) {
  double min_deg = std::numeric_limits<double>::infinity();
  double max_deg = -min_deg;
  for (std::size_t i = 0; i < trial.plate_deg.size(); ++i) {
    if (trial.samples[i].time_s < track.onset_s) continue;
    const double step = (trial.samples[i].time_s - track.onset_s) / track.step_s;
    if (!(step < static_cast<double>(track.steps.size()))) break;
    const double share = track.steps[static_cast<std::size_t>(step)].share;
    if (share < end_fraction || share > 1.0 - end_fraction) continue;
    min_deg = std::min(min_deg, trial.plate_deg[i]);
    max_deg = std::max(max_deg, trial.plate_deg[i]);
  }
  return max_deg - min_deg > max_turn_deg;
}

}  // namespace hrt
