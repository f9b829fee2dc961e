// Fits the model of a person to slides, except outliers and slides that end along the ridges.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/calibrate/lack_of_fit.h"
#include "core/math/distributions.h"

namespace hrt {

enum class SlideVerdict {
  used,
  outlying,  ///< the path differs from those of the other slides
  /// The motion settled within 12 degrees (5 if few slides remain) of the ridges, where the shift changes sign.
  along_ridges,
};

struct PersonFit {
  std::vector<SlideVerdict> verdicts;  ///< for each slide
  std::vector<std::size_t> used;       ///< indices of the fitted slides
  SlideScatter scatter;
  CurveFit fit;
  LackOfFit lack_of_fit;
  /// largest settled offset from motion to ridge normal to each side, over the fitted slides
  double max_left_deg = 0.0;
  double max_right_deg = 0.0;

  /// Returns `number` of the fitted person, with its 95 % interval.
  Interval value(const std::function<double(const SlidingPersonModel&)>& number) const;
};

/// Largest settled offset from motion to ridge normal of a usable slide: at larger ones, a person who overshoots
/// crosses 90 degrees. The second limit applies if fewer than 10 slides or 5 angles are within the first.
inline constexpr double max_offset_deg = 78.0;
inline constexpr double max_needed_offset_deg = 85.0;

/// Returns the lower of the curve's maxima to the left and to the right.
CurvePeak weaker_peak(const IllusionCurve& curve);

/// Returns, for each slide, whether its settled motion is far enough from the direction of the ridges.
std::vector<SlideVerdict> slide_verdicts(std::span<const SlideTrack> slides);

inline constexpr int min_fitted_slides = 8;

/// Runs the fit in short steps.
class PersonFitting {
 public:
  /// Selects the slides to fit. `order`: as in LackOfFitTests.
  PersonFitting(std::span<const SlideTrack> slides, std::span<const double> order);
  PersonFitting(const PersonFitting&) = delete;
  PersonFitting& operator=(const PersonFitting&) = delete;
  ~PersonFitting() = default;
  /// Requires at least min_fitted_slides slides in result().used. Returns true when finished; do not call step() after
  /// that.
  bool step();
  /// Before the end, `fit` and `lack_of_fit` are not valid.
  const PersonFit& result() const { return person_; }

 private:
  PersonFit person_;
  std::vector<SlideTrack> fitted_;
  std::vector<double> fitted_order_;
  std::optional<CurveFitting> curve_;
  std::optional<LackOfFitTests> lack_of_fit_;
};

}  // namespace hrt
