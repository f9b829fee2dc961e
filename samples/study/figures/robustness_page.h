// The robustness study in words and pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/robustness.h"

namespace hrt::study {

/// One sentence: the middle case, of which each factor changes one thing.
std::string middle_case_words();

/// Why some people of this row can't be led to the target by any controller; empty if all can.
std::string limit_words(const RobustnessRow& row);

/// A figure for each factor with several values.
std::vector<Figure> robustness_figures(const std::vector<RobustnessRow>& rows);

/// `drawings` are the figures as gnuplot's SVG files, in their order.
std::string robustness_page(const RobustnessOptions& options, const std::vector<RobustnessRow>& rows,
                            const std::vector<Figure>& figures, const std::vector<std::string>& drawings);

}  // namespace hrt::study
