#include "samples/mock_runtime/live/line_socket.h"

#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "samples/mock_runtime/error.h"

namespace hrt::mock {
namespace {

constexpr std::size_t max_line = 65536;

[[noreturn]] void refuse_socket(const std::string& path, const std::string& why) {
  throw Error{XR_ERROR_RUNTIME_FAILURE, "HRT_MOCK_CONTROL: " + path + " " + why};
}

}  // namespace

LineSocket::LineSocket(std::string path) : path_(std::move(path)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path_.size() >= sizeof(address.sun_path))
    refuse_socket(path_, "is too long: at most " + std::to_string(sizeof(address.sun_path) - 1) + " bytes");
  path_.copy(address.sun_path, path_.size());
  const auto* const place = reinterpret_cast<const sockaddr*>(&address);
  listener_ = Descriptor(socket(AF_UNIX, SOCK_STREAM, 0));
  // Who listens there takes the connection; after a crash nobody does.
  if (connect(Descriptor(socket(AF_UNIX, SOCK_STREAM, 0)).get(), place, sizeof(address)) == 0)
    refuse_socket(path_, "is in use by another application");
  if (errno == ECONNREFUSED && std::filesystem::is_socket(path_)) unlink(path_.c_str());
  if (bind(listener_.get(), place, sizeof(address)) != 0 || listen(listener_.get(), 1) != 0)
    refuse_socket(path_, std::string("cannot be made: ") + std::strerror(errno));
}

LineSocket::~LineSocket() { unlink(path_.c_str()); }

void LineSocket::serve(const std::function<std::string(const std::string&)>& answer) {
  if (!client_) {
    client_ = Descriptor(accept(listener_.get(), nullptr, nullptr));
    received_.clear();
    if (!client_) return;
  }
  std::array<char, 4096> bytes{};
  ssize_t count = 0;
  while ((count = recv(client_.get(), bytes.data(), bytes.size(), 0)) > 0) {
    received_.append(bytes.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = received_.find('\n')) != std::string::npos; received_.erase(0, end + 1)) {
      const std::string reply = answer(received_.substr(0, end)) + "\n";
      // One reply a line fits the socket's buffer for who reads them.
      if (send(client_.get(), reply.data(), reply.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(reply.size()))
        return client_.close();
    }
    if (received_.size() > max_line) return client_.close();
  }
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) client_.close();
}

}  // namespace hrt::mock
