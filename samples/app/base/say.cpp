#include "samples/app/base/say.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>

namespace hrt::app {
namespace {

constexpr auto say_limit = std::chrono::milliseconds(100);

// Opens a separate non-blocking descriptor of standard error. Returns standard error itself for a socket, if opening
// fails, and for a regular file, which a new descriptor would overwrite from its start.
int open_without_blocking() {
  struct stat status{};
  if (fstat(STDERR_FILENO, &status) != 0 || S_ISREG(status.st_mode) || S_ISSOCK(status.st_mode)) return STDERR_FILENO;
  const int own = open("/proc/self/fd/2", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  return own >= 0 ? own : STDERR_FILENO;
}

ssize_t write_some(int file, std::string_view text) {
  const ssize_t sent = send(file, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (sent >= 0 || errno != ENOTSOCK) return sent;
  return write(file, text.data(), text.size());
}

}  // namespace

void say(std::string_view text) {
  using Clock = std::chrono::steady_clock;
  const int file = open_without_blocking();
  const auto give_up = Clock::now() + say_limit;
  while (!text.empty()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(give_up - Clock::now());
    pollfd output{file, POLLOUT, 0};
    if (left.count() <= 0 || poll(&output, 1, static_cast<int>(left.count())) <= 0) break;
    const ssize_t written = write_some(file, text);
    if (written > 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EAGAIN && errno != EINTR)
      break;
  }
  if (file != STDERR_FILENO) close(file);
}

std::size_t columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace hrt::app
