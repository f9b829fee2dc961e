// Single keys of the terminal on the standard input, without Enter.
#pragma once

#include <optional>

namespace hrt::app {

/// One at a time. Without a terminal, or in the background, there are no keys.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool is_there() const { return is_there_; }
  /// The next key that has been pressed, if any. Returns at once.
  std::optional<char> key();

 private:
  bool is_there_ = false;
};

/// Lines and echo as they were before the Keyboard; nothing without one. Safe in a signal handler.
void restore_terminal();

}  // namespace hrt::app
