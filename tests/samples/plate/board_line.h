// A line straight to the emulated board, in its simulated time.
#pragma once

#include "plugin/src/plate/line.h"
#include "tests/samples/plate/emulated_board.h"

namespace hrt::plate {

/// Time passes in wait() alone.
class BoardLine : public Line {
 public:
  explicit BoardLine(EmulatedBoard& board) : board_(board) {}

  Time now() const override { return Time(board_.now()); }
  void receive(std::string& bytes) override { bytes += board_.take_output(); }
  void send(std::string_view bytes) override { board_.send(bytes); }
  void flush() override {}
  bool has_unsent() const override { return false; }
  void wait(std::chrono::milliseconds limit) override {
    using std::chrono_literals::operator""us;
    for (const auto end = board_.now() + limit; board_.now() < end && !board_.has_output();)
      board_.run_for(100us);
  }

 private:
  EmulatedBoard& board_;
};

}  // namespace hrt::plate
