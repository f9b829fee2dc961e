// The report as one page of HTML that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "samples/study/figures/figures.h"
#include "samples/study/table1.h"

namespace hrt::study {

/// `drawings` are the figures as gnuplot's SVG files, in their order.
std::string html_page(const Table1& table, const std::vector<Figure>& figures,
                      const std::vector<std::string>& drawings);

}  // namespace hrt::study
