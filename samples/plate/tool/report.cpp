#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "plugin/include/plate_driver/plate_file.h"
#include "samples/app/text/format.h"
#include "samples/app/text/whole_file.h"
#include "samples/plate/tool/measure.h"

namespace hrt::plate {
namespace {

double milliseconds(std::chrono::nanoseconds time) { return std::chrono::duration<double, std::milli>(time).count(); }

// Speed with which the controller plans: the limit of the motion, or the speed of the servo if that is lower.
double plan_speed_deg_s(const Measurements& found) {
  return std::min(found.limits.speed_deg_s, found.speed_deg_s.value);
}

struct Row {
  const char* name;
  Measured Measurements::* value;
};
constexpr Row rows[] = {{"speed_deg_s", &Measurements::speed_deg_s},
                        {"acceleration_deg_s2", &Measurements::acceleration_deg_s2},
                        {"latency_ms", &Measurements::latency_ms},
                        {"backlash_deg", &Measurements::backlash_deg},
                        {"repeatability_deg", &Measurements::repeatability_deg},
                        {"error_deg", &Measurements::error_deg}};

}  // namespace

std::string text_of(const Measurements& found) {
  std::string text = found.device + "\n" +
                     format("range                %g to %g deg\n", found.limits.min_deg, found.limits.max_deg) +
                     format("round trip           %.1f ms\n", milliseconds(found.round_trip));
  for (const Row& row : rows)
    text += format("%-20s %.4g +- %.2g\n", row.name, (found.*row.value).value, (found.*row.value).deviation);
  return text + format("The controller plans with a speed of %.4g deg/s", plan_speed_deg_s(found)) +
         format(" and a latency of %.1f ms.\n", found.latency_ms.value + milliseconds(found.round_trip) / 2.0);
}

std::string file_of(const Measurements& found, const std::string& device, const std::string& date) {
  nlohmann::ordered_json file;
  file["format"] = "haptic plate 1";
  file["date"] = date;
  file["device"] = device;
  file["description"] = found.device;
  file["details"] = found.details;
  file["round_trip_ms"] = milliseconds(found.round_trip);
  for (const Row& row : rows) file["measured"][row.name] = {(found.*row.value).value, (found.*row.value).deviation};
  file["max_error_deg"] = std::abs(found.error_deg.value) + 3.0 * found.error_deg.deviation + 0.5;
  const double latency_ms = found.latency_ms.value + milliseconds(found.round_trip) / 2.0;
  const bool has_stops = found.limits.max_deg - found.limits.min_deg >= 180.0;
  file["session"] = {{"plate_max_speed_deg_s", plan_speed_deg_s(found)},
                     {"plate_max_acceleration_deg_s2", found.acceleration_deg_s2.value},
                     {"plate_latency_ns", std::llround(std::max(0.0, latency_ms) * 1e6)},
                     {"plate_lower_stop_deg", has_stops ? found.limits.min_deg : 0.0},
                     {"plate_upper_stop_deg", has_stops ? found.limits.max_deg : 0.0}};
  for (const SweepPoint& point : found.sweep)
    file["sweep"].push_back({point.commanded_deg, point.reported_deg, point.upwards});
  std::string text = file.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  text.replace(text.size() - 2, 2, ",\n");  // with_checksum() ends the object
  return with_checksum(text);
}

void write_file(const std::filesystem::path& file, const std::string& content) {
  if (const int error = write_whole_file(file, content); error != 0)
    throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(error) +
                             ". Name another file with --out");
}

}  // namespace hrt::plate
