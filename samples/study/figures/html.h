// What the pages of HTML share: one style, and pictures that stand in the page itself.
#pragma once

#include <initializer_list>
#include <string>

#include "samples/study/figures/figures.h"

namespace hrt::study {

/// `text` as HTML.
std::string escaped(const std::string& text);

/// From the first byte of a page to below its heading, where it says that all of it is simulation.
std::string page_start(const std::string& title);

/// Cells of a table's row.
std::string table_cells(std::initializer_list<std::string> values);

/// A <figure> with its caption; `drawing` is gnuplot's SVG file.
std::string figure_element(const Figure& figure, const std::string& drawing);

}  // namespace hrt::study
