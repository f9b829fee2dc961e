// Stores the slides of a calibration.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/calibrate/slide_track.h"
#include "core/reach/finger_sample.h"

namespace hrt {

/// Allocates at construction and in trials() only. Stores positions that are at least 3.9 ms apart.
class SlideStore {
 public:
  SlideStore(int max_slides, std::size_t max_samples);

  void begin(double plate_orientation_deg);
  /// Adds a sample. Returns false if the store is full.
  bool add(const FingerSample& sample);
  /// Discards the samples of the current slide.
  void drop();
  /// If more than 500 positions of the current slide are stored, discards all but the last 250.
  void shorten_rest();
  void end() { under_way_ = false; }

  /// Number of completed slides.
  int count() const { return static_cast<int>(slides_.size()) - (under_way_ ? 1 : 0); }
  bool full() const { return samples_.size() == samples_.capacity(); }
  /// Returns the completed slides.
  std::vector<CalibrationTrial> trials() const;

 private:
  struct Slide {
    double plate_orientation_deg;
    std::size_t first_sample;
  };
  std::vector<Slide> slides_;
  std::vector<TimedPoint> samples_;
  std::optional<std::int64_t> first_ns_;  // origin of the samples' times
  std::vector<double> plate_deg_;
  bool under_way_ = false;
  double now_plate_deg_ = 0.0;
};

}  // namespace hrt
