// The robustness study in words and pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/robustness.h"

namespace hrt::study {

/// What all these reaches have in common.
std::string condition_words(const RobustnessOptions& options);

/// A figure for each duration.
std::vector<Figure> robustness_figures(const RobustnessOptions& options, std::span<const RobustnessRow> rows);

/// `drawings` are the figures as gnuplot's SVG files, in their order.
std::string robustness_page(const RobustnessOptions& options, std::span<const RobustnessRow> rows,
                            const std::vector<Figure>& figures, const std::vector<std::string>& drawings);

}  // namespace hrt::study
