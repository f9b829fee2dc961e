#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "plugin/src/plate/plate_line.h"

namespace hrt::plate {

/// Fixture with a board: HobbyPlate (the firmware compiled for this machine) or EmulatedBoard (its ELF in simavr).
template <class Board>
class BoardFixture : public testing::Test {
 protected:
  template <class... Arguments>
  explicit BoardFixture(Arguments&&... arguments) : board_(std::forward<Arguments>(arguments)...) {}

  /// Sends a command, then heartbeats for this time.
  void set(double orientation_deg, std::chrono::milliseconds time = {}, const char* word = "SET") {
    board_.receive_line(motion_body(orientation_deg, ++sequence_, word));
    run_with_beats(time);
  }
  void beat() { board_.receive_line(with_number("BEAT", ++sequence_)); }
  void run_with_beats(std::chrono::milliseconds time) {
    constexpr std::chrono::milliseconds period(50);
    for (; time.count() > 0; time -= period) {
      beat();
      board_.run_for(std::min(time, period));
    }
  }
  /// True if the board has sent a line with this body since the last call.
  bool has_sent(const std::string& body) {
    const auto lines = board_.take_lines();
    return std::find(lines.begin(), lines.end(), body) != lines.end();
  }

  Board board_;
  std::uint16_t sequence_ = 0;
};

}  // namespace hrt::plate
