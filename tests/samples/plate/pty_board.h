// The emulated board at the other end of a pseudo-terminal, in real time.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "tests/samples/plate/emulated_board.h"

namespace hrt::plate {

class PtyBoard {
 public:
  /// `prepare` may change the board before it starts.
  explicit PtyBoard(const std::function<void(EmulatedBoard&)>& prepare = {},
                    const std::vector<std::uint8_t>& eeprom = {});
  ~PtyBoard();
  PtyBoard(const PtyBoard&) = delete;
  PtyBoard& operator=(const PtyBoard&) = delete;

  /// The line's name, to be opened by the host.
  const std::string& device() const { return device_; }
  /// Descriptor of the host's end, for a look at its settings.
  int host_end() const { return slave_; }

  /// Calls `action` with the board between two of its instructions.
  void with(const std::function<void(EmulatedBoard&)>& action);
  std::vector<Pulse> pulses();

 private:
  void live();

  EmulatedBoard board_;
  std::mutex mutex_;  // of board_
  int master_ = -1;
  int slave_ = -1;
  std::string device_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace hrt::plate
