#include "samples/app/person/keyboard.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>

namespace hrt::app {
namespace {

termios before{};
std::atomic<bool> changed = false;

}  // namespace

Keyboard::Keyboard() {
  if (isatty(STDIN_FILENO) != 1) return;
  // While this program is in the background, the terminal belongs to another program.
  if (const pid_t front = tcgetpgrp(STDIN_FILENO); front >= 0 && front != getpgrp()) return;
  if (tcgetattr(STDIN_FILENO, &before) != 0) return;
  termios keys = before;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // ISIG remains set, so that Ctrl-C sends SIGINT
  keys.c_cc[VMIN] = 0;
  keys.c_cc[VTIME] = 0;
  has_terminal_ = tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
  changed = has_terminal_;
}

Keyboard::~Keyboard() { restore_terminal(); }

std::optional<char> Keyboard::key() {
  if (!has_terminal_) return std::nullopt;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  char key = 0;
  if (poll(&input, 1, 0) <= 0) return std::nullopt;
  if ((input.revents & POLLIN) != 0 && read(STDIN_FILENO, &key, 1) == 1) return key;
  if ((input.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) has_terminal_ = false;
  return std::nullopt;
}

void restore_terminal() {
  if (changed.exchange(false)) tcsetattr(STDIN_FILENO, TCSANOW, &before);
}

}  // namespace hrt::app
