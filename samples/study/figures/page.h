// The report's page: Table I as text, and the figures beside it.
#pragma once

#include <string>
#include <vector>

#include "samples/study/figures/figures.h"

namespace hrt::study {

/// HTML that shows `text`, then NAME.svg of each figure in the same folder, with its caption.
std::string html_page(const std::string& text, const std::vector<Figure>& figures);

}  // namespace hrt::study
