// Pseudo-terminal, which a program opens as a serial line or uses as its terminal.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace hrt::plate {

class Pty {
 public:
  /// Opens a raw serial line; with `columns`, a terminal of this width.
  explicit Pty(unsigned short columns = 0) {
    std::array<char, 128> name{};
    termios raw{};
    cfmakeraw(&raw);
    const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    if (openpty(&own_, &other_, name.data(), columns == 0 ? &raw : nullptr, columns == 0 ? nullptr : &size) != 0)
      throw std::runtime_error("no pseudo-terminal can be opened: mount /dev/pts");
    fcntl(own_, F_SETFL, O_NONBLOCK);
    // Programs that this process starts must not keep the terminal open.
    for (const int end : {own_, other_}) fcntl(end, F_SETFD, FD_CLOEXEC);
    device_ = name.data();
  }
  ~Pty() {
    unplug();
    close(other_);
  }
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  /// Path that the other program opens.
  const std::string& device() const { return device_; }
  /// Descriptor of the other end, for the input or output of a program.
  int descriptor() const { return other_; }

  /// Returns the received bytes; waits up to `wait_ms` for the first one.
  std::string take(int wait_ms = 0) const {
    std::string text;
    std::array<char, 4096> bytes{};
    for (pollfd readable{own_, POLLIN, 0}; poll(&readable, 1, wait_ms) > 0; wait_ms = 0) {
      const ssize_t count = read(own_, bytes.data(), bytes.size());
      if (count <= 0) break;
      text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text;
  }
  /// Sends bytes to the other end. Returns false if the terminal did not accept all of them.
  bool type(const std::string& bytes) const {
    return write(own_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }
  void unplug() {
    if (own_ >= 0) close(own_);
    own_ = -1;
  }

 private:
  int own_ = -1, other_ = -1;
  std::string device_;
};

/// Symbolic link to a pseudo-terminal, with a path that is known in advance.
class PtyLink {
 public:
  /// Replaces a file at `path` only if it is a link to another pseudo-terminal. An empty path makes no link. Throws
  /// std::invalid_argument, whose text begins with `option`, if the link cannot be created.
  PtyLink(const std::string& option, std::filesystem::path path, const std::string& device) : path_(std::move(path)) {
    if (path_.empty()) return;
    std::error_code error;
    if (std::filesystem::read_symlink(path_, error).parent_path() == "/dev/pts") std::filesystem::remove(path_, error);
    std::filesystem::create_symlink(device, path_, error);
    if (error)
      throw std::invalid_argument(option + " " + path_.string() + " cannot be created: " + error.message() +
                                  ". Choose a path in a writable folder where no file exists");
  }
  ~PtyLink() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
  }
  PtyLink(const PtyLink&) = delete;
  PtyLink& operator=(const PtyLink&) = delete;

 private:
  std::filesystem::path path_;
};

}  // namespace hrt::plate
