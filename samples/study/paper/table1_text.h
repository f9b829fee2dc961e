// Table I and the paper's claims as text, and as rows of numbers.
#pragma once

#include <string>

#include "samples/study/numbers/results.h"
#include "samples/study/paper/table1.h"

namespace hrt::study {

std::string table1_text(const Table1& table);
/// A row a cell; groups of cells are in `about`.
Results table1_results(const Table1& table);

}  // namespace hrt::study
