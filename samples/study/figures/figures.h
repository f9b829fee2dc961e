// Figures: words, and a gnuplot script that contains the data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/study/paper/table1.h"
#include "samples/study/people/trace.h"

namespace hrt::study {

struct Figure {
  std::string name;     ///< of its files, without ending
  std::string title;    ///< plain text, escaped on output
  std::string caption;  ///< plain text, escaped on output
  int width_px;
  int height_px;
  std::string script;  ///< without terminal and output
};

/// Figs. 4 to 8 of the paper: true paths, perceived paths, plate orientation of one trial.
std::vector<Figure> path_figures(std::uint64_t seed);

/// Table I, paper and model side by side.
Figure table1_figure(const Table1& table);

/// Returns a label with minus signs in place of hyphens before numbers.
std::string with_minus_signs(std::string text);

/// The whole script, which writes NAME.svg.
std::string drawing(const Figure& figure);

/// HTML that shows `text`, then NAME.svg of each figure in the same folder, with its caption.
std::string html_page(const std::string& text, const std::vector<Figure>& figures);

/// Every state of a traced reach over time, with two deviations to both sides.
Figure trace_figure(const Trace& trace);

/// The reach from above, moving, as one SVG: plate and ridges, the finger and its path, and where it is felt.
std::string moving_picture(const Trace& trace);

}  // namespace hrt::study
