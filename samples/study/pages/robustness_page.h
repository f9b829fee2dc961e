// The robustness study as one self-contained HTML page.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/pages/robustness_text.h"

namespace hrt::study {

/// A figure for each duration.
std::vector<Figure> robustness_figures(const RobustnessStudy& study);

/// `drawings`: gnuplot's SVG of each figure.
std::string robustness_page(const RobustnessStudy& study, const std::vector<Figure>& figures);

}  // namespace hrt::study
