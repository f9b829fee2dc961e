// The report as one self-contained HTML page.
#pragma once

#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/paper/table1.h"

namespace hrt::study {

/// `drawings`: gnuplot's SVG of each figure.
std::string html_page(const Table1& table, const std::vector<Figure>& figures);

}  // namespace hrt::study
