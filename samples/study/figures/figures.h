// Figures, which figures.py draws with matplotlib, and a staging folder for results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/simulation/people.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {

struct Figure {
  std::string name;     ///< file name without extension; selects the drawing in figures.py
  std::string title;    ///< plain text, escaped on output
  std::string caption;  ///< plain text, escaped on output
  Row data;
};

/// Fig. 1c of the paper: paths straight ahead over a plate at rest.
Figure ridges_figure(std::uint64_t seed);

/// Figs. 4 to 8 of the paper, each with true paths, perceived paths, the plate orientation in one trial, and the
/// directions of motion.
std::vector<Figure> path_figures(std::uint64_t seed);

/// Returns an HTML page with `text` and then each figure (NAME.svg in the same folder) with its caption.
std::string html_page(const std::string& text, const std::vector<Figure>& figures);

/// Simulates the first `reach` reaches of a person under the plugin's default controller. Returns one row per sample of
/// the last one, with positions, plate orientation, and the mean and SD of each state of the filter. page_of() of the
/// result is the data of the figures "reach", an animation from above, and "trace", the states over time.
Results trace_reach(const PersonCondition& condition, int reach, std::uint64_t seed, std::uint32_t index);

/// A temporary folder for the files of one result. publish() moves them to their destination.
class StagingFolder {
 public:
  /// Creates `out` if it is missing. Throws UsageError naming `argument` if it cannot be written, and
  /// std::runtime_error if python3 has no matplotlib.
  StagingFolder(const std::string& argument, const std::string& out);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  /// Draws each figure as NAME.svg. Throws std::runtime_error with the output of python3 if that fails.
  void draw(const std::vector<Figure>& figures);

  void write(const std::string& name, std::string_view content);

  std::string read(const std::string& name) const;

  void publish() const;

 private:
  std::filesystem::path out_;
  std::filesystem::path folder_;  // removed by the destructor
  std::vector<std::string> files_;
  bool was_made_;
};

/// Returns the SVG of a figure. Draws it in a temporary folder next to the file `path`. Throws like StagingFolder.
std::string draw_beside(const std::string& argument, const std::string& path, const Figure& figure);

}  // namespace hrt::study
