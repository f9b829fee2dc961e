// A local socket that answers lines.
#pragma once

#include <functional>
#include <string>

#include "samples/mock_runtime/live/descriptor.h"

namespace hrt::mock {

/// Listens at a path; one program at a time is served, the next when it hangs up.
class LineSocket {
 public:
  /// A socket that nobody listens at any more is replaced. Throws an Error if it cannot be made.
  explicit LineSocket(std::string path);
  ~LineSocket();
  LineSocket(const LineSocket&) = delete;
  LineSocket& operator=(const LineSocket&) = delete;

  /// Answers what has come since, without waiting. A line of more than 64 KiB ends the connection.
  void serve(const std::function<std::string(const std::string& line)>& answer);

 private:
  std::string path_;
  Descriptor listener_;
  Descriptor client_;
  std::string received_;
};

}  // namespace hrt::mock
