// Fit of a person to slides, without the slides that are outliers or too close to the ridges.
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
  outlying,      ///< the path is an outlier among the slides
  along_ridges,  ///< the person came to move within 5 to 12 degrees of along the ridges, where the illusion
                 ///< flips
};

struct PersonFit {
  std::vector<SlideVerdict> verdicts;  ///< verdict on each slide
  std::vector<std::size_t> used;       ///< slides that are fitted
  SlideScatter scatter;                ///< scatter of the slides used, and of the outliers
  CurveFit fit;
  LackOfFit lack_of_fit;
  double max_left_deg = 0.0;  ///< settled offset from motion to ridge normal, over the slides used
  double max_right_deg = 0.0;

  /// A number that depends on the person, and its 95 % interval.
  Interval value(const std::function<double(const SlidingPersonModel&)>& number) const;
};

/// Beyond this offset from motion to ridge normal a slide does not count: a person who overshoots crosses 90.
/// If that leaves fewer than 10 slides or 5 angles, the second limit holds.
inline constexpr double max_offset_deg = 78.0;
inline constexpr double max_needed_offset_deg = 85.0;

/// The peak of the curve on the side where it is lower.
CurvePeak weaker_peak(const IllusionCurve& curve);

/// Slides that count for `track`: the settled motion stays away from the ridges' own direction.
std::vector<SlideVerdict> slide_verdicts(std::span<const SlideTrack> slides);

/// Fewest slides that count of which a person is fitted.
inline constexpr int min_fitted_slides = 8;

/// The fit in steps of bounded time.
class PersonFitting {
 public:
  /// Selects the slides to fit. `order`: as in LackOfFitTests.
  PersonFitting(std::span<const SlideTrack> slides, std::span<const double> order);
  PersonFitting(const PersonFitting&) = delete;
  PersonFitting& operator=(const PersonFitting&) = delete;
  ~PersonFitting() = default;
  /// Requires min_fitted_slides that are used. Returns true at the end; no calls after that.
  bool step();
  /// Before the end, only the slides used and their scatter are valid.
  const PersonFit& result() const { return person_; }

 private:
  PersonFit person_;
  std::vector<SlideTrack> fitted_;
  std::vector<double> fitted_order_;
  std::optional<CurveFitting> curve_;
  std::optional<LackOfFitTests> lack_of_fit_;
};

}  // namespace hrt
