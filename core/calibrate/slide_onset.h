// When a recorded slide began, of a tracker whose noise is learnt from the slide itself.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/plate/plate_frame.h"

namespace hrt {

struct SlideOnset {
  std::int64_t time_ns;  ///< the finger rested until then
  PlatePoint place;      ///< where it rested
};

/// None without a motion, or of fewer than eight samples.
std::optional<SlideOnset> find_onset(std::span<const TimedPoint> samples);

}  // namespace hrt
