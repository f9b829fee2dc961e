// The power study as one self-contained HTML page.
#pragma once

#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/paper/power_study.h"

namespace hrt::study {

/// A figure for each number of reaches.
std::vector<Figure> power_figures(const PowerStudy& study);

/// `drawings`: gnuplot's SVG of each figure.
std::string power_page(const PowerStudy& study, const std::vector<Figure>& figures);

}  // namespace hrt::study
