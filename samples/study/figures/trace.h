// Pictures of a traced reach.
#pragma once

#include <string>

#include "samples/study/figures/figures.h"
#include "samples/study/people/trace.h"

namespace hrt::study {

/// Every state over time, with two deviations to both sides.
Figure trace_figure(const Trace& trace);

/// The reach from above, moving, as one SVG: plate and ridges, the finger and its path, and where it is felt.
std::string moving_picture(const Trace& trace);

}  // namespace hrt::study
