// What hrt-reach shows of a reach while it goes on.
#pragma once

#include <chrono>

#include "samples/reach/reach.h"

namespace hrt::reach {

/// On a terminal, one line that is written over and over; with `verbose` a line a frame instead.
class StatusLine {
 public:
  explicit StatusLine(bool verbose);

  void show(const TargetPair& pair, const Moment& moment);

  /// Wipes the line, so that something else can be printed.
  void clear();

 private:
  bool verbose_;
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace hrt::reach
