// Serial line on Windows: a COM port, or a named pipe, which a virtual machine may offer in place of a port.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "plugin/include/plate_driver/line.h"
#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {
namespace {

constexpr std::size_t max_unsent = 1024;

std::string reason() { return "Windows error " + std::to_string(GetLastError()); }

// Returns the name with the prefix \\.\, without which Windows does not open COM10 and higher numbers.
std::wstring full_name(const std::string& device) {
  const int size = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, device.c_str(), -1, nullptr, 0);
  if (size <= 0) throw PlateFailure(Fault::line, "cannot be opened: its name is not valid UTF-8. Pass it as UTF-8");
  std::wstring name(static_cast<std::size_t>(size), L'\0');
  MultiByteToWideChar(CP_UTF8, 0, device.c_str(), -1, name.data(), size);
  name.pop_back();
  return name.starts_with(L"\\\\") ? name : L"\\\\.\\" + name;
}

// One read or write that runs in the background (overlapped I/O).
class Transfer {
 public:
  Transfer() { state_.hEvent = CreateEventW(nullptr, TRUE, FALSE, nullptr); }
  ~Transfer() { CloseHandle(state_.hEvent); }
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;

  HANDLE event() const { return state_.hEvent; }
  bool is_running() const { return running_; }
  void read(HANDLE line) {
    check(ReadFile(line, buffer_.data(), static_cast<DWORD>(buffer_.size()), nullptr, &state_));
  }
  void write(HANDLE line, std::size_t count) {
    check(WriteFile(line, buffer_.data(), static_cast<DWORD>(count), nullptr, &state_));
  }
  /// Returns the number of transferred bytes; -1 while the transfer is running.
  int result(HANDLE line) {
    DWORD count = 0;
    if (GetOverlappedResult(line, &state_, &count, FALSE)) {
      running_ = false;
      return static_cast<int>(count);
    }
    if (GetLastError() == ERROR_IO_INCOMPLETE) return -1;
    running_ = false;
    throw PlateFailure(Fault::unplugged, "is unplugged; connect and open the plate again");
  }
  /// Ends the transfer, so that the buffer may be destroyed.
  void cancel(HANDLE line) {
    if (!running_) return;
    CancelIoEx(line, &state_);
    DWORD count = 0;
    GetOverlappedResult(line, &state_, &count, TRUE);
    running_ = false;
  }
  std::array<char, 256>& buffer() { return buffer_; }

 private:
  void check(BOOL done) {
    running_ = true;
    if (done || GetLastError() == ERROR_IO_PENDING) return;
    running_ = false;
    throw PlateFailure(Fault::unplugged, "is unplugged; connect and open the plate again");
  }

  OVERLAPPED state_{};
  std::array<char, 256> buffer_{};
  bool running_ = false;
};

HANDLE opened(const std::string& device) {
  const HANDLE line = CreateFileW(full_name(device).c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING,
                                  FILE_FLAG_OVERLAPPED, nullptr);
  if (line != INVALID_HANDLE_VALUE) return line;
  const DWORD error = GetLastError();
  if (error == ERROR_ACCESS_DENIED || error == ERROR_PIPE_BUSY)
    throw PlateFailure(Fault::line, "is in use by another program. End that program");
  throw PlateFailure(Fault::line, "cannot be opened: " + reason() + ". Check its name and cable");
}

class SerialLine : public Line {
 public:
  SerialLine(const std::string& device, int baud) : line_(opened(device)) {
    is_port_ = GetFileType(line_) != FILE_TYPE_PIPE;
    try {
      if (is_port_) set_up(static_cast<DWORD>(baud));
      reading_.read(line_);
    } catch (...) {
      CloseHandle(line_);
      throw;
    }
  }

  ~SerialLine() override {
    reading_.cancel(line_);
    writing_.cancel(line_);
    if (is_port_) {
      SetCommTimeouts(line_, &timeouts_before_);
      SetCommState(line_, &before_);
    }
    CloseHandle(line_);
  }
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  void receive(std::string& bytes) override {
    const int count = reading_.result(line_);
    if (count < 0) return;
    bytes.append(reading_.buffer().data(), static_cast<std::size_t>(count));
    reading_.read(line_);
  }

  void send(std::string_view bytes) override {
    unsent_ += bytes;
    if (unsent_.size() > max_unsent) throw PlateFailure(Fault::unplugged, "accepts no data; check its cable");
    flush();
  }

  void flush() override {
    if (writing_.is_running()) {
      const int count = writing_.result(line_);
      if (count < 0) return;
      unsent_.erase(0, static_cast<std::size_t>(count));
    }
    if (unsent_.empty()) return;
    const std::size_t count = std::min(unsent_.size(), writing_.buffer().size());
    std::memcpy(writing_.buffer().data(), unsent_.data(), count);
    writing_.write(line_, count);
  }

  bool has_unsent() const override { return !unsent_.empty(); }

  void wait(std::chrono::milliseconds limit) override {
    const std::array<HANDLE, 2> events = {reading_.event(), writing_.event()};
    WaitForMultipleObjects(writing_.is_running() ? 2 : 1, events.data(), FALSE, static_cast<DWORD>(limit.count()));
  }

 private:
  void set_up(DWORD baud) {
    before_.DCBlength = sizeof before_;
    if (!GetCommState(line_, &before_) || !GetCommTimeouts(line_, &timeouts_before_))
      throw PlateFailure(Fault::line, "is not a serial line; name a serial device, such as COM3");
    DCB settings = before_;
    settings.BaudRate = baud;
    settings.ByteSize = 8;
    settings.Parity = NOPARITY;
    settings.StopBits = ONESTOPBIT;
    settings.fBinary = TRUE;
    settings.fParity = settings.fOutxCtsFlow = settings.fOutxDsrFlow = settings.fDsrSensitivity = FALSE;
    settings.fOutX = settings.fInX = settings.fNull = settings.fErrorChar = settings.fAbortOnError = FALSE;
    settings.fDtrControl = DTR_CONTROL_ENABLE;
    settings.fRtsControl = RTS_CONTROL_ENABLE;
    // A read ends when no further byte has arrived for 1 ms.
    COMMTIMEOUTS timeouts{1, 0, 0, 0, 0};
    if (!SetCommState(line_, &settings) || !SetCommTimeouts(line_, &timeouts))
      throw PlateFailure(Fault::line, "cannot be set to " + std::to_string(baud) +
                                          " baud, 8 data bits and no parity: " + reason() +
                                          ". Check that this is the serial device of the plate");
    PurgeComm(line_, PURGE_RXCLEAR | PURGE_TXCLEAR);
  }

  HANDLE line_;
  bool is_port_ = false;
  DCB before_{};
  COMMTIMEOUTS timeouts_before_{};
  Transfer reading_, writing_;
  std::string unsent_;
};

}  // namespace

std::unique_ptr<Line> open_serial_line(const std::string& device, int baud) {
  return std::make_unique<SerialLine>(device, baud);
}

}  // namespace hrt::plate
