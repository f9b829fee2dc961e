// A plate on a serial line (plate_protocol.md).
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "samples/reach/plate.h"
#include "samples/reach/plate_line.h"

namespace hrt::reach {

class SerialPlate : public Plate {
 public:
  /// Opens the line and greets the plate, for which it has two seconds. Throws Failure (ExitCode::plate).
  explicit SerialPlate(std::filesystem::path device);
  /// Stops the plate, if it still hears.
  ~SerialPlate() override;
  SerialPlate(const SerialPlate&) = delete;
  SerialPlate& operator=(const SerialPlate&) = delete;

  std::optional<PlateLimits> limits() const override {
    return PlateLimits{greeting_.speed_deg_s, greeting_.least_deg, greeting_.most_deg};
  }
  void service(XrTime time) override;
  void command(XrTime time, double orientation_deg) override;
  std::optional<double> orientation_deg(XrTime time) override;
  void stop(XrTime time) override;

 private:
  using Clock = std::chrono::steady_clock;

  void open_line();
  void greet();
  void listen();
  void take(const PlateMessage& message);
  void say(std::string_view body);
  void flush();
  void beat_if_due();
  [[noreturn]] void fail(const std::string& what);

  std::filesystem::path device_;
  int line_ = -1;
  LineReader reader_;
  std::string unsent_;
  PlateGreeting greeting_{};
  bool greeted_ = false;
  std::optional<double> orientation_deg_;
  Clock::time_point heard_;
  Clock::time_point said_;
  std::string last_set_;
};

}  // namespace hrt::reach
