#include "core/setup/slide_store.h"

#include "core/math/elementary.h"
#include "core/math/time.h"

namespace hrt {
namespace {

constexpr double min_stored_spacing_s = 0.0039;
constexpr std::ptrdiff_t rest_samples = 250;

}  // namespace

SlideStore::SlideStore(int max_slides, std::size_t max_samples) {
  slides_.reserve(static_cast<std::size_t>(max_slides));
  samples_.reserve(max_samples);
  plate_deg_.reserve(max_samples);
}

void SlideStore::begin(double plate_orientation_deg) {
  slides_.push_back({plate_orientation_deg, samples_.size()});
  under_way_ = true;
  now_plate_deg_ = plate_orientation_deg;
}

bool SlideStore::add(const FingerSample& sample) {
  const bool any = samples_.size() > slides_.back().first_sample;
  if (!first_ns_) first_ns_ = sample.time_ns;
  const double time_s = elapsed_s(*first_ns_, sample.time_ns);
  if (any && time_s - samples_.back().time_s < min_stored_spacing_s) return true;
  if (full()) return false;
  // Reports of orientations with the same ridges are unwrapped, since a plate does not jump by half a turn.
  if (sample.plate_orientation_deg) now_plate_deg_ += wrap_deg(*sample.plate_orientation_deg - now_plate_deg_, 180.0);
  samples_.push_back({time_s, sample.position});
  plate_deg_.push_back(now_plate_deg_);
  return true;
}

void SlideStore::drop() {
  samples_.resize(slides_.back().first_sample);
  plate_deg_.resize(samples_.size());
  now_plate_deg_ = slides_.back().plate_orientation_deg;
}

void SlideStore::shorten_rest() {
  const auto first = static_cast<std::ptrdiff_t>(slides_.back().first_sample);
  const std::ptrdiff_t spare = static_cast<std::ptrdiff_t>(samples_.size()) - first - 2 * rest_samples;
  if (spare <= 0) return;
  samples_.erase(samples_.begin() + first, samples_.end() - rest_samples);
  plate_deg_.erase(plate_deg_.begin() + first, plate_deg_.end() - rest_samples);
}

std::vector<CalibrationTrial> SlideStore::trials() const {
  std::vector<CalibrationTrial> whole;
  const auto ended = static_cast<std::size_t>(count());
  for (std::size_t i = 0; i < ended; ++i) {
    const auto first = static_cast<std::ptrdiff_t>(slides_[i].first_sample);
    const auto end =
        static_cast<std::ptrdiff_t>(i + 1 < slides_.size() ? slides_[i + 1].first_sample : samples_.size());
    whole.push_back({.plate_orientation_deg = slides_[i].plate_orientation_deg,
                     .samples = {samples_.begin() + first, samples_.begin() + end},
                     .plate_deg = {plate_deg_.begin() + first, plate_deg_.begin() + end}});
  }
  return whole;
}

}  // namespace hrt
