#include "samples/reach/scene/marks.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "samples/format.h"
#include "samples/reach/base/exit_code.h"

namespace hrt::reach {
namespace {

constexpr std::size_t min_marks = 3;
constexpr std::size_t max_marks = HRT_MARKS_MAX;
constexpr std::size_t max_line = 200;
constexpr double farthest_m = 1.0;

[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& what) {
  throw Failure(ExitCode::registration, file.string() + ", line " + std::to_string(line) + ": " + what);
}

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= 0x20 && c != 0x7f; });
}

}  // namespace

std::vector<Mark> marks_of(const TargetSet& targets) {
  // At a third of a right angle from the line across: away from each other, and none opposite the start.
  const double r = targets.plate_radius_m;
  const double right_m = r * std::sqrt(0.75);
  return {{"start", targets.start_m},
          {"rim nearest to you", {0.0, 0.0, r}},
          {"rim near right", {right_m, 0.0, 0.5 * r}},
          {"rim far right", {right_m, 0.0, -0.5 * r}},
          {"rim far left", {-right_m, 0.0, -0.5 * r}},
          {"rim near left", {-right_m, 0.0, 0.5 * r}}};
}

std::vector<Mark> read_marks(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw Failure(ExitCode::registration, file.string() + " cannot be read");
  std::vector<Mark> marks;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.size() > max_line || !is_printable(line)) refuse(file, number, "this is not a line of marks");
    if (number == 1) {
      if (line != "name,x_m,y_m,z_m" && !line.starts_with("name,x_m,y_m,z_m,"))
        refuse(file, number, "the columns are to begin with name,x_m,y_m,z_m");
      continue;
    }
    if (line.empty()) continue;
    std::istringstream cells(line);
    Mark mark;
    std::getline(cells, mark.name, ',');
    if (mark.name.empty()) refuse(file, number, "the mark has no name");
    for (double& coordinate_m : mark.position_m) {
      std::string cell;
      std::getline(cells, cell, ',');
      const std::optional<double> value_m = number_in(cell, -farthest_m, farthest_m);
      if (!value_m) refuse(file, number, "\"" + cell + "\" is not a number of metres within 1");
      coordinate_m = *value_m;
    }
    marks.push_back(mark);
    if (marks.size() > max_marks) refuse(file, number, "there are more than 8 marks");
  }
  if (marks.size() < min_marks) refuse(file, number, "there are fewer than 3 marks");
  return marks;
}

}  // namespace hrt::reach
