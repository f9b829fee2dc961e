// Keys of the terminal on standard input, each available immediately, without Enter.
#pragma once

#include <optional>

namespace hrt::app {

/// At most one object may exist. key() returns nothing without a terminal, or if the object was created while the
/// program was in the background.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool has_terminal() const { return has_terminal_; }
  /// Returns the next key that has been pressed, if any, without waiting.
  std::optional<char> key();

 private:
  bool has_terminal_ = false;
};

/// Restores the terminal mode that a Keyboard changed, if it has not been restored. Async-signal-safe.
void restore_terminal();

}  // namespace hrt::app
