#include "tests/samples/plate/pty_board.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace hrt::plate {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

PtyBoard::PtyBoard(const std::function<void(EmulatedBoard&)>& prepare,
                   const std::vector<std::uint8_t>& eeprom)
    : board_(eeprom) {
  std::array<char, 128> name{};
  termios raw{};
  cfmakeraw(&raw);
  if (openpty(&master_, &slave_, name.data(), &raw, nullptr) != 0)
    throw std::runtime_error("no pseudo-terminal");
  fcntl(master_, F_SETFL, O_NONBLOCK);
  // A program that the test starts must not keep the line up.
  fcntl(master_, F_SETFD, FD_CLOEXEC);
  fcntl(slave_, F_SETFD, FD_CLOEXEC);
  device_ = name.data();
  if (prepare) prepare(board_);
  thread_ = std::thread([this] { live(); });
}

PtyBoard::~PtyBoard() {
  ending_ = true;
  thread_.join();
  close(master_);
  close(slave_);
}

void PtyBoard::with(const std::function<void(EmulatedBoard&)>& action) {
  const std::lock_guard lock(mutex_);
  action(board_);
}

std::vector<Pulse> PtyBoard::pulses() {
  const std::lock_guard lock(mutex_);
  return board_.pulses();
}

// Real time passes in slices, and the board follows. If this machine was busy for longer than a slice may be,
// the board misses that time: it would be deaf while it caught up.
void PtyBoard::live() {
  constexpr auto max_slice = 20ms;
  Clock::time_point began = Clock::now();
  while (!ending_) {
    pollfd readable{master_, POLLIN, 0};
    poll(&readable, 1, 1);
    std::array<char, 256> bytes{};
    const ssize_t count = read(master_, bytes.data(), bytes.size());
    const std::lock_guard lock(mutex_);
    if (count > 0) board_.send({bytes.data(), static_cast<std::size_t>(count)});
    const auto behind = Clock::now() - began - board_.now();
    if (behind > max_slice) began += behind - max_slice;
    board_.run_until(std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - began));
    const std::string output = board_.take_output();
    if (!output.empty()) [[maybe_unused]]
      const ssize_t ignored = write(master_, output.data(), output.size());
  }
}

}  // namespace hrt::plate
