#include "core/calibrate/person_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrt {
namespace {

// slide_verdicts() takes the median direction of the slides whose plate angles differ by at most this.
constexpr double near_angle_deg = 4.0;
// Minimum numbers of slides and angles within max_offset_deg for that limit to apply.
constexpr std::size_t enough_slides = 10;
constexpr int enough_angles = 5;

}  // namespace

Interval PersonFit::value(const std::function<double(const SlidingPersonModel&)>& number) const {
  const FitValue found = fit_value(fit, number);
  const double half = found.deviation * student_975(static_cast<double>(used.size()) - fit.effective);
  return {found.value, found.value - half, found.value + half};
}

CurvePeak weaker_peak(const IllusionCurve& curve) {
  const CurvePeak left = curve_peak(curve, 1.0);
  const CurvePeak right = curve_peak(curve, -1.0);
  return left.shift_deg < right.shift_deg ? left : right;
}

std::vector<SlideVerdict> slide_verdicts(std::span<const SlideTrack> slides) {
  std::vector<double> offsets;
  for (const SlideTrack& slide : slides) {
    // Uses the median over the slides at similar plate angles, for robustness against outliers.
    std::vector<double> directions;
    for (const SlideTrack& other : slides)
      if (std::abs(other.plate_deg - slide.plate_deg) <= near_angle_deg)
        directions.push_back(settled_direction_deg(other.direction_deg));
    offsets.push_back(std::abs(slide.plate_deg - median(std::move(directions))));
  }
  std::vector<SlideTrack> within;
  for (std::size_t i = 0; i < slides.size(); ++i)
    if (offsets[i] <= max_offset_deg) within.push_back(slides[i]);
  const bool enough = within.size() >= enough_slides && different_angles(within) >= enough_angles;
  const double max_deg = enough ? max_offset_deg : max_needed_offset_deg;
  std::vector<SlideVerdict> verdicts;
  for (const double offset_deg : offsets)
    verdicts.push_back(offset_deg > max_deg ? SlideVerdict::along_ridges : SlideVerdict::used);
  return verdicts;
}

PersonFitting::PersonFitting(std::span<const SlideTrack> slides, std::span<const double> order) {
  person_.verdicts = slide_verdicts(slides);
  std::vector<std::size_t> counting;
  std::vector<SlideTrack> tracks;
  for (std::size_t i = 0; i < slides.size(); ++i) {
    if (person_.verdicts[i] != SlideVerdict::used) continue;
    counting.push_back(i);
    tracks.push_back(slides[i]);
  }
  person_.scatter = slide_scatter(tracks);
  for (std::size_t i = 0; i < counting.size(); ++i) {
    if (person_.scatter.outlying[i]) {
      person_.verdicts[counting[i]] = SlideVerdict::outlying;
      continue;
    }
    person_.used.push_back(counting[i]);
    fitted_.push_back(tracks[i]);
    fitted_order_.push_back(order[counting[i]]);
    const double offset_deg = tracks[i].plate_deg - settled_direction_deg(tracks[i].direction_deg);
    person_.max_left_deg = std::max(person_.max_left_deg, offset_deg);
    person_.max_right_deg = std::max(person_.max_right_deg, -offset_deg);
  }
}

bool PersonFitting::step() {
  const PartsMatrix& covariance = person_.scatter.covariance;
  if (!curve_) {
    curve_.emplace(fitted_, covariance);
  } else if (!lack_of_fit_) {
    if (!curve_->step()) return false;
    person_.fit = curve_->fit();
    lack_of_fit_.emplace(person_.fit, fitted_, fitted_order_, covariance, polynomial_degree(fitted_));
  } else if (lack_of_fit_->step()) {
    person_.lack_of_fit = lack_of_fit_->result();
    return true;
  }
  return false;
}

}  // namespace hrt
