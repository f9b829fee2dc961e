#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "plugin/include/plate_driver/line.h"
#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {
namespace {

constexpr std::size_t max_unsent = 1024;
constexpr int max_reads = 16;  // per receive(), so that it returns if a device sends without pause

std::string reason() { return std::strerror(errno); }

bool must_wait() { return errno == EAGAIN || errno == EWOULDBLOCK; }

speed_t speed_of(int baud) {
  switch (baud) {
    case 57600:
      return B57600;
    case 115200:
      return B115200;
#if defined(B1000000)
    case 1000000:
      return B1000000;
#endif
    default:
      throw PlateFailure(Fault::line, "cannot run at " + std::to_string(baud) +
                                          " baud on this system; set the servo and the option baud to 57600 or 115200");
  }
}

// Descriptors that the child of a fork closes. Otherwise the child would keep their locks after its parent closed them.
std::array<std::atomic<int>, 64> open_lines;  // descriptor plus 1; 0: free

void replace(int before, int after) {
  [[maybe_unused]] static const int registered = pthread_atfork(nullptr, nullptr, [] {
    for (auto& number : open_lines)
      if (const int open = number.exchange(0); open != 0) close(open - 1);
  });
  for (auto& number : open_lines)
    if (int expected = before; number.compare_exchange_strong(expected, after)) return;
}

class SerialLine : public Line {
 public:
  SerialLine(const std::string& device, int baud)
      : line_(open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    if (line_ < 0)
      throw PlateFailure(Fault::line, "cannot be opened: " + reason() + ". Check its name, cable and permissions");
    try {
      set_up(speed_of(baud));
    } catch (...) {
      close(line_);
      throw;
    }
    replace(0, line_ + 1);
  }

  // Waits up to 0.1 s until the bytes are sent, then drops the rest: close() on Linux would wait up to half a minute.
  ~SerialLine() override {
    int unsent = 0;
    for (int i = 0; i < 10 && ioctl(line_, TIOCOUTQ, &unsent) == 0 && unsent > 0; ++i) poll(nullptr, 0, 10);
    if (unsent > 0) tcflush(line_, TCOFLUSH);
    ioctl(line_, TIOCNXCL);
    tcsetattr(line_, TCSANOW, &before_);
    replace(line_ + 1, 0);
    close(line_);
  }
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  void receive(std::string& bytes) override {
    std::array<char, 256> some{};
    for (int i = 0; i < max_reads; ++i) {
      const ssize_t count = read(line_, some.data(), some.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && must_wait()) return;
      if (count <= 0) throw PlateFailure(Fault::unplugged, "is unplugged; connect and open the plate again");
      bytes.append(some.data(), static_cast<std::size_t>(count));
    }
  }

  void send(std::string_view bytes) override {
    unsent_ += bytes;
    if (unsent_.size() > max_unsent) throw PlateFailure(Fault::unplugged, "accepts no data; check its cable");
    flush();
  }

  void flush() override {
    while (!unsent_.empty()) {
      const ssize_t count = write(line_, unsent_.data(), unsent_.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && must_wait()) return;
      if (count <= 0) throw PlateFailure(Fault::unplugged, "is unplugged; connect and open the plate again");
      unsent_.erase(0, static_cast<std::size_t>(count));
    }
  }

  bool has_unsent() const override { return !unsent_.empty(); }

  void wait(std::chrono::milliseconds limit) override {
    pollfd wanted{line_, static_cast<short>(unsent_.empty() ? POLLIN : POLLIN | POLLOUT), 0};
    poll(&wanted, 1, static_cast<int>(limit.count()));
  }

 private:
  void set_up(speed_t speed) {
    if (tcgetattr(line_, &before_) != 0)
      throw PlateFailure(Fault::line, "is not a serial line; name a serial device, such as /dev/ttyACM0");
    // TIOCEXCL does not exclude root, or a program that has opened the line before. flock() excludes both if they also
    // call flock().
    if (flock(line_, LOCK_EX | LOCK_NB) != 0 || ioctl(line_, TIOCEXCL) != 0)
      throw PlateFailure(Fault::line, "is in use by another program. End that program");
    termios settings = before_;
    cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
    if (cfsetspeed(&settings, speed) != 0 || tcsetattr(line_, TCSANOW, &settings) != 0)
      throw PlateFailure(Fault::line, "cannot be set to its baud rate, 8 data bits and no parity: " + reason() +
                                          ". Check that this is the serial device of the plate");
    tcflush(line_, TCIOFLUSH);
  }

  int line_;
  termios before_{};
  std::string unsent_;
};

}  // namespace

std::unique_ptr<Line> open_serial_line(const std::string& device, int baud) {
  return std::make_unique<SerialLine>(device, baud);
}

}  // namespace hrt::plate
