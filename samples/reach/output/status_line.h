// Progress of a reach on the terminal.
#pragma once

#include <chrono>

#include "samples/reach/run/reach.h"

namespace hrt::reach {

/// On a terminal, one line that is rewritten; with `verbose`, a line a frame instead.
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

}  // namespace hrt::reach
