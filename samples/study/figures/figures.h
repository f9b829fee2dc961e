// Figures: words, and a gnuplot script that contains the data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/study/paper/table1.h"

namespace hrt::study {

struct Figure {
  std::string name;     ///< of its files, without ending
  std::string title;    ///< plain text
  std::string caption;  ///< plain text
  int width_px;
  int height_px;
  std::string script;  ///< without terminal and output
  std::string svg;     ///< gnuplot's file, once it is drawn
};

struct FigureOptions {
  std::uint64_t trials;  ///< of each point of the frontier
  std::uint64_t seed;
  std::uint64_t threads;
};

/// Figs. 4 to 8 of the paper: true paths, perceived paths, plate orientation of one trial.
std::vector<Figure> path_figures(std::uint64_t seed);

/// Table I, paper and model side by side.
Figure table1_figure(const Table1& table);

/// The gaps that can be held over the tactile weight, with the paper's conditions.
Figure authority_figure(const Table1& table);

/// Perceived against actual error as the weights of the cost vary, and the theoretical limit.
Figure frontier_figure(const FigureOptions& options);

/// Of a label: numbers with minus signs for hyphens.
std::string with_minus_signs(std::string text);

/// The whole script, for the file format `ending`, "svg" or "png".
std::string drawing(const Figure& figure, const std::string& ending);

}  // namespace hrt::study
