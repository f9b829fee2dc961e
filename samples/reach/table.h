// What is printed: the progress of a reach; results of reaches, and of a calibration.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

#include "samples/app/run/reach.h"

namespace hrt::reach {

using namespace app;

/// The bearing of an end is on the real target's within this, in degrees.
inline constexpr double tolerance_deg = 1.5;
bool is_within_tolerance(const ReachResult& result);

/// Ended inside of the real target's radius; if the scene gives it none, within the tolerance.
bool is_reached(const TargetPair& pair, const ReachResult& result);

/// Progress of a reach: on a terminal, one line that is rewritten; with `verbose`, a line a frame instead.
class StatusLine {
 public:
  explicit StatusLine(bool verbose);

  void show(const TargetPair& pair, const Moment& moment);

  /// Clears the line, so that other output can follow.
  void clear();

 private:
  bool verbose_;
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// The table of results, whose columns are as wide as the names of its targets.
class Table {
 public:
  explicit Table(const std::vector<TargetPair>& pairs);

  /// Column titles with units.
  void print_header(std::ostream& out) const;
  void print_row(std::ostream& out, const TargetPair& pair, const ReachResult& result) const;
  /// Of a reach that was not made: what became of it, in a word or two.
  void print_row(std::ostream& out, const TargetPair& pair, const std::string& what) const;
  /// The meaning of the columns.
  void print_legend(std::ostream& out) const;

 private:
  std::string names(const TargetPair& pair) const;

  std::size_t virtual_width_ = 0;
  std::size_t real_width_ = 0;
};

/// Counts over all rows.
struct Tally {
  int reaches = 0;
  int holdable = 0;                   ///< of these, the ones whose gap the plate can hold
  int holdable_reached = 0;           ///< of these, the ones that were reached
  int holdable_within_tolerance = 0;  ///< of the holdable ones
  int unfinished = 0;                 ///< not among the reaches: without a finger at the start, or without an end
  int skipped = 0;                    ///< not among the reaches, by the person's wish

  void add(const TargetPair& pair, const ReachResult& result);
};

void print_summary(std::ostream& out, const Tally& tally);

/// The share of touch is known as well as a set-up asks by default.
bool is_enough(const hrt_setup_result& result);

/// Lines to be printed or spoken. `config`: the session's, with what was found.
std::string calibration_text(const hrt_setup_result& result, const hrt_session_config& config);

}  // namespace hrt::reach
