// A temporary folder: results appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "samples/study/figures/figures.h"

namespace hrt::study {

/// Draws figures, and collects the files of one result until all are made.
class Workshop {
 public:
  /// Makes `out` if it is missing. Throws UsageError naming `argument` if it can't be written, and
  /// std::runtime_error if gnuplot is missing.
  Workshop(const std::string& argument, const std::string& out);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Draws the figure; returns the content of its file, NAME.svg.
  std::string draw(const Figure& figure);

  void write(const std::string& name, std::string_view content);

  /// Moves the files to `out`.
  void publish() const;

 private:
  std::filesystem::path out_;
  std::filesystem::path folder_;  // removed by the destructor
  std::vector<std::string> files_;
  bool was_made_;
};

/// The picture for a file at `path`, drawn in its folder. Throws as Workshop.
std::string draw_beside(const std::string& argument, const std::string& path, const Figure& figure);

}  // namespace hrt::study
