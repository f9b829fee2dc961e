// Passes arbitrary bytes to the firmware and to the host as lines of the plate's protocol: unchanged, and with correct
// checksums. Then answers each device of the driver with these bytes, from its opening on, and parses the bytes as the
// name of a device.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/dynamixel_packet.h"
#include "plugin/include/plate_driver/plate_failure.h"
#include "plugin/src/plate/plate_line.h"
#include "samples/app/firmware/plate.h"

namespace {

using namespace hrt::plate;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_message(const PlateMessage& message) {
  if (const auto* greeting = std::get_if<PlateGreeting>(&message)) {
    require(greeting->min_deg < greeting->max_deg);
    require(greeting->min_deg >= -360.0 && greeting->max_deg <= 360.0);
    require(greeting->speed_deg_s > 0.0 && greeting->speed_deg_s <= 1e6);
    require(greeting->latency_ms >= 0.0 && greeting->latency_ms <= 1000.0);
  }
  if (const auto* report = std::get_if<PlateReport>(&message))
    require(std::abs(report->orientation_deg.value_or(0.0)) <= 360.0);
  if (const auto* setting = std::get_if<PlateSetting>(&message)) require(std::isfinite(setting->value));
}

void read_as_host(std::string_view bytes) {
  LineBuffer buffer{};
  LineError error = LINE_OK;
  for (const char byte : bytes) {
    if (!line_receive(&buffer, byte, &error) || error != LINE_OK) continue;
    if (const auto message = parse_plate_message(buffer.text)) check_message(*message);
  }
}

// Checks that the host understands every line of the firmware.
bool send(const char* line, std::uint8_t length) {
  require(length > 0 && length <= LINE_SIZE && line[length - 1] == '\n');
  LineBuffer buffer{};
  LineError error = LINE_BAD_SUM;
  for (std::uint8_t i = 0; i < length; ++i) line_receive(&buffer, line[i], &error);
  require(error == LINE_OK && parse_plate_message(buffer.text));
  return true;
}

void save(const std::uint8_t* bytes) {
  Settings settings = settings_default();
  require(settings_unpack(&settings, bytes));
}

constexpr PlateBoard board{send, save};

void run_as_plate(std::string_view bytes) {
  Plate plate{};
  plate_start(&plate, &board, nullptr);
  for (const char byte : bytes) {
    plate_receive(&plate, byte);
    const PlateInputs inputs{byte == '!', static_cast<std::int16_t>(static_cast<unsigned char>(byte) * 4),
                             static_cast<std::int16_t>(byte * 4)};
    if (byte == '\n' || byte == '!') plate_tick(&plate, &inputs);
    require(settings_valid(&plate.settings));
    require(std::abs(plate.position_microdeg) <= 180'000'000);
    const std::uint16_t ticks = plate_pulse_ticks(&plate);
    require(ticks == 0 || (ticks >= 2 * PULSE_MIN_US && ticks <= 2 * PULSE_MAX_US));
    require(ticks == 0 || plate.greeted);
  }
}

std::string with_sums(std::string_view bytes) {
  std::string lines;
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    lines += encode_line(std::string(bytes.substr(0, end)));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  return lines;
}

// Returns a DYNAMIXEL status packet for each line. Its error is the first byte of the line, its parameters are the
// rest.
std::string with_crcs(std::string_view bytes) {
  std::string packets;
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    const std::string_view line = bytes.substr(0, end);
    dynamixel::Packet packet{.id = 1, .instruction = dynamixel::status};
    if (!line.empty()) packet.error = static_cast<std::uint8_t>(line[0]);
    if (line.size() > 1) packet.parameters = line.substr(1, 200);
    packets += dynamixel::encode(packet);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  return packets;
}

void read_packets(std::string_view bytes) {
  dynamixel::PacketReader reader;
  reader.append(bytes);
  while (const auto packet = reader.next()) {
    dynamixel::PacketReader again;
    again.append(dynamixel::encode(*packet));
    const auto same = again.next();
    require(same && same->id == packet->id && same->parameters == packet->parameters);
  }
}

// A line that answers each message of the host with the next bytes. The time advances while the devices wait.
class AnsweringLine : public Line {
 public:
  explicit AnsweringLine(std::string bytes) : bytes_(std::move(bytes)) {}
  Time now() const override { return Time(now_); }
  void receive(std::string& bytes) override {
    bytes += coming_;
    coming_.clear();
  }
  void send(std::string_view) override {
    coming_ += bytes_.substr(0, 32);
    bytes_.erase(0, 32);
  }
  void flush() override {}
  bool has_unsent() const override { return false; }
  void wait(std::chrono::milliseconds limit) override { now_ += limit; }

 private:
  std::string bytes_, coming_;
  std::chrono::nanoseconds now_{0};
};

void drive(const char* name, const std::string& bytes) {
  try {
    const auto open = [&](const std::string&, int) -> std::unique_ptr<Line> {
      return std::make_unique<AnsweringLine>(bytes);
    };
    const auto device = device_named(name)(open, Start::hold);
    for (int i = 0; i < 100; ++i) {
      const DeviceLimits limits = device->limits();
      require(limits.min_deg < limits.max_deg && limits.speed_deg_s > 0.0);
      require(std::isfinite(device->orientation_deg().value_or(0.0)));
      if (i % 10 == 0) device->turn_to(i % 20 == 0 ? limits.min_deg : limits.max_deg);
      if (i % 10 == 5) device->stop();
      device->wait(std::chrono::milliseconds(5));
    }
    for (const std::string& line : device->details()) require(!line.empty());
    require(std::isfinite(device->zero_deg()));
    device->set_zero(1.0);
    device->begin_measurement();
    require(device->sensor_filter().count() >= 0);
  } catch (const PlateFailure& failure) {
    require(failure.what()[0] != '\0');
  }
}

void read_name(std::string_view bytes) {
  try {
    device_named(bytes);
  } catch (const std::invalid_argument& wrong) {
    require(wrong.what()[0] != '\0');
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const std::string& lines : {std::string(bytes), with_sums(bytes)}) {
    read_as_host(lines);
    run_as_plate(lines);
    drive("serial:line", lines);
  }
  const std::string packets = with_crcs(bytes);
  read_packets(bytes);
  read_packets(packets);
  drive("dynamixel:line", packets);
  read_name(bytes);
  return 0;
}
