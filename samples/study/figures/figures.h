// Figures, which figures.py draws by matplotlib, and the folder in which a result is made.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/person/person_filter.h"
#include "core/simulation/people.h"
#include "samples/study/numbers/results.h"

namespace hrt::study {

struct Figure {
  std::string name;     ///< of its file, without ending: selects the drawing
  std::string title;    ///< plain text, escaped on output
  std::string caption;  ///< plain text, escaped on output
  Row data;
};

/// Fig. 1c of the paper: paths straight ahead over a plate at rest.
Figure ridges_figure(std::uint64_t seed);

/// Figs. 4 to 8 of the paper: true paths, perceived paths, plate orientation of one trial.
std::vector<Figure> path_figures(std::uint64_t seed);

/// HTML that shows `text`, then NAME.svg of each figure in the same folder, with its caption.
std::string html_page(const std::string& text, const std::vector<Figure>& figures);

struct TracedSample {
  double time_s;
  PlatePoint finger, felt;
  double plate_deg;
  double commanded_deg;
  double felt_error_deg;                                   ///< as the controller has it
  std::array<double, PersonState::count> mean, deviation;  ///< in the order of PersonState
};

struct Trace {
  PersonCondition condition;
  std::vector<TracedSample> samples;
};

/// Reach `reach`, from 1 on, of a person led by our controller, which has learnt from those before.
Trace trace_reach(const PersonCondition& condition, int reach, std::uint64_t seed, std::uint32_t index);

/// A row a sample; a column a state, beside it its deviation.
std::string trace_csv(const Trace& trace);

/// "reach", the reach from above as one moving picture: plate and ridges, the finger and its path, and where it is
/// felt; and "trace", every state of the filter over time, with two deviations to both sides.
std::vector<Figure> trace_figures(const Trace& trace);

/// A temporary folder that collects the files of one result until all are made: they appear whole or not at all.
class Workshop {
 public:
  /// Makes `out` if it is missing. Throws UsageError naming `argument` if it can't be written, and std::runtime_error
  /// if python3 has no matplotlib.
  Workshop(const std::string& argument, const std::string& out);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Draws each figure as NAME.svg.
  void draw(const std::vector<Figure>& figures);

  void write(const std::string& name, std::string_view content);

  /// The content of a file that was drawn or written.
  std::string read(const std::string& name) const;

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
