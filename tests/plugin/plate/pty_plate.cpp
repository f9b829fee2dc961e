#include "tests/plugin/plate/pty_plate.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace hrt::plate {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

bool eventually(const std::function<bool()>& condition) {
  const auto give_up = Clock::now() + 20s;
  while (!condition()) {
    if (Clock::now() > give_up) return false;
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

PtyPlate::PtyPlate(EmulatedPlate::Behaviour behaviour) : plate_(std::move(behaviour)) {
  std::array<char, 128> name{};
  termios raw{};
  cfmakeraw(&raw);
  if (openpty(&master_, &slave_, name.data(), &raw, nullptr) != 0)
    throw std::runtime_error("no pseudo-terminal");
  fcntl(master_, F_SETFL, O_NONBLOCK);
  // A program that the test starts must not keep the line up.
  for (const int end : {master_, slave_}) fcntl(end, F_SETFD, FD_CLOEXEC);
  device_ = name.data();
  thread_ = std::thread([this] { live(); });
}

PtyPlate::~PtyPlate() {
  ending_ = true;
  thread_.join();
  if (!unplugged_) close(master_);
  close(slave_);
}

void PtyPlate::unplug() {
  unplugged_ = true;
  eventually([this] { return gone_.load(); });
}

void PtyPlate::send(const std::string& body) {
  const std::lock_guard lock(mutex_);
  plate_.send(body);
}

void PtyPlate::fall_silent() {
  const std::lock_guard lock(mutex_);
  plate_.fall_silent();
}

std::vector<std::string> PtyPlate::heard() const {
  const std::lock_guard lock(mutex_);
  return plate_.heard();
}

bool PtyPlate::moving_allowed() const {
  const std::lock_guard lock(mutex_);
  return plate_.moving_allowed();
}

double PtyPlate::orientation_deg() const {
  const std::lock_guard lock(mutex_);
  return plate_.orientation_deg();
}

void PtyPlate::live() {
  const auto began = Clock::now();
  while (!ending_) {
    if (unplugged_) {
      close(master_);
      gone_ = true;
      return;
    }
    pollfd readable{master_, POLLIN, 0};
    poll(&readable, 1, 2);
    std::array<char, 256> bytes{};
    const ssize_t count = read(master_, bytes.data(), bytes.size());
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now() - began;
    if (count > 0) plate_.hear({bytes.data(), static_cast<std::size_t>(count)}, now);
    plate_.run_until(now);
    const std::string output = plate_.take_output();
    if (!output.empty()) [[maybe_unused]]
      const ssize_t ignored = write(master_, output.data(), output.size());
  }
}

}  // namespace hrt::plate
