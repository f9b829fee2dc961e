// Single keys of the terminal on the standard input, without Enter.
#pragma once

#include <optional>

namespace hrt::app {

/// At most one object may exist. Without a terminal, or in the background, key() returns nothing.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool is_there() const { return is_there_; }
  /// Returns the next key that has been pressed, if any, without waiting.
  std::optional<char> key();

 private:
  bool is_there_ = false;
};

/// Restores the terminal mode that a Keyboard changed, if it has not been restored. Async-signal-safe.
void restore_terminal();

}  // namespace hrt::app
