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

  /// Draws the figure; returns the content of its file, which ends with `ending`, "svg" or "png".
  std::string draw(const Figure& figure, const std::string& ending);

  /// Draws all as .svg, which they keep, and as .png.
  void draw(std::vector<Figure>& figures);

  void write(const std::string& name, std::string_view content);

  /// Moves the files to `out`.
  void publish() const;

 private:
  std::string drawn(const std::string& name);

  std::filesystem::path out_;
  std::filesystem::path folder_;  // removed by the destructor
  std::vector<std::string> files_;
  bool was_made_;
};

}  // namespace hrt::study
