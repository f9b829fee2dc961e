// Texts: progress of a reach, results of reaches and of a calibration.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

#include "samples/app/run/reach.h"

namespace hrt::reach {

using namespace app;

/// Largest bearing error within the tolerance.
inline constexpr double tolerance_deg = 1.5;
bool is_within_tolerance(const ReachResult& result);

/// True if the reach ended inside the real target's radius, or within the tolerance if the scene gives no radius.
bool is_reached(const TargetPair& pair, const ReachResult& result);

/// Progress of a reach on standard error: on a terminal, one line that is rewritten; with `verbose`, a line per frame
/// instead.
class StatusLine {
 public:
  explicit StatusLine(bool verbose);

  void show(const TargetPair& pair, const Moment& moment);

  void clear();

 private:
  bool verbose_;
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

class Table {
 public:
  explicit Table(const std::vector<TargetPair>& pairs);

  void print_header(std::ostream& out) const;
  void print_row(std::ostream& out, const TargetPair& pair, const ReachResult& result) const;
  /// Row of a reach that was not made. `what`: its outcome in a word or two.
  void print_row(std::ostream& out, const TargetPair& pair, const std::string& what) const;
  void print_legend(std::ostream& out) const;

 private:
  std::string names(const TargetPair& pair) const;

  std::size_t virtual_width_ = 0;
  std::size_t real_width_ = 0;
};

struct Tally {
  int reaches = 0;
  int feasible = 0;                   ///< reaches without the flag HRT_COMMAND_UNREACHABLE
  int feasible_reached = 0;           ///< reaches of `feasible` that ended at the target
  int feasible_within_tolerance = 0;  ///< reaches of `feasible` with a bearing error of at most tolerance_deg
  int unfinished = 0;                 ///< reaches that did not begin or end in time; not in `reaches`
  int skipped = 0;                    ///< reaches that the person skipped; not in `reaches`

  void add(const TargetPair& pair, const ReachResult& result);
};

void print_summary(std::ostream& out, const Tally& tally);

/// True if the tactile weight is known as precisely as a set-up requires by default.
bool is_enough(const hrt_setup_result& result);

/// Table to be printed. `config`: configuration of the session after the calibration.
std::string calibration_text(const hrt_setup_result& result, const hrt_session_config& config);
/// Sentences to be printed and spoken: whether the model fits, and whether the precision suffices.
std::string verdict_text(const hrt_setup_result& result);

}  // namespace hrt::reach
