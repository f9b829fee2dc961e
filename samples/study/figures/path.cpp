#include "samples/study/figures/path.h"

#include "core/math/trigonometry.h"
#include "samples/study/cli/output.h"
#include "samples/study/numbers/statistics.h"

namespace hrt::study {
namespace {

std::string data(const Path& path) {
  std::string lines;
  for (const PathPoint& point : path) lines += number(point.right_mm) + ' ' + number(point.forward_mm) + '\n';
  return lines;
}

}  // namespace

PathPoint ahead(PathPoint from, double direction_deg, double distance_mm) {
  return {from.right_mm - distance_mm * sin_deg(direction_deg), from.forward_mm + distance_mm * cos_deg(direction_deg)};
}

Path path_of(const std::vector<TrialStep>& steps, double TrialStep::* direction_deg) {
  Path path{{0.0, 0.0}};
  for (const TrialStep& step : steps)
    path.push_back(ahead(path.back(), step.*direction_deg, path_length_mm / static_cast<double>(steps.size())));
  return path;
}

Path median_path(const std::vector<Path>& paths) {
  Path result;
  for (std::size_t k = 0; k < paths.front().size(); ++k) {
    std::vector<double> right_mm;
    std::vector<double> forward_mm;
    for (const Path& path : paths) {
      right_mm.push_back(path[k].right_mm);
      forward_mm.push_back(path[k].forward_mm);
    }
    result.push_back({median(right_mm), median(forward_mm)});
  }
  return result;
}

std::string path_block(const std::string& name, const std::vector<Path>& paths) {
  std::string text = '$' + name + " << EOD\n";
  for (const Path& path : paths) text += data(path) + '\n';
  return text + "EOD\n";
}

}  // namespace hrt::study
