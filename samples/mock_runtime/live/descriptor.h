// A file descriptor with an owner.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <utility>

namespace hrt::mock {

/// Not inherited by programs that the application starts; reads and writes do not wait.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {
    if (number_ < 0) return;
    fcntl(number_, F_SETFD, FD_CLOEXEC);
    fcntl(number_, F_SETFL, O_NONBLOCK);
  }
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  explicit operator bool() const { return number_ >= 0; }
  int get() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

}  // namespace hrt::mock
