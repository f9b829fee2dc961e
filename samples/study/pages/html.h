// Parts of HTML pages, with style and pictures inline.
#pragma once

#include <initializer_list>
#include <string>

#include "samples/study/figures/figures.h"

namespace hrt::study {

/// The page's head, heading, and the note that all of it is simulation.
std::string page_start(const std::string& title);

/// `text` with ° for "deg", as pages have it and terminals need not.
std::string with_symbols(std::string text);

/// Every `from` in `text` becomes `to`.
void replace_all(std::string& text, const std::string& from, const std::string& to);

/// Cells of a table's row.
std::string table_cells(std::initializer_list<std::string> values);

/// `html` behind `words`, on which a reader clicks; printed only where it is open.
std::string folded(const std::string& words, const std::string& html);

/// A <figure>, which has been drawn, with its caption.
std::string figure_element(const Figure& figure);

}  // namespace hrt::study
