#include "samples/plate/tool/report.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "samples/format.h"
#include "samples/whole_file.h"

namespace hrt::plate {
namespace {

double milliseconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

// What to plan with: measured if that is possible, else what the plate says of itself.
double plan_speed_deg_s(const Measurements& found) {
  return std::min(found.limits.speed_deg_s, found.speed_deg_s.value_or(found.limits.speed_deg_s));
}
double plan_latency_ms(const Measurements& found) {
  return found.latency_ms ? *found.latency_ms + milliseconds(found.round_trip) / 2.0
                          : milliseconds(found.limits.latency);
}

std::string line_of(const char* name, const std::optional<double>& value, const char* pattern) {
  return format("%-14s", name) +
         (value ? format(pattern, *value) : "not measurable: the plate has no sensor") + "\n";
}

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

std::string polyline(const Measurements& found, bool upwards, double scale) {
  const double min_deg = found.limits.min_deg, width_deg = found.limits.max_deg - min_deg;
  std::string points;
  for (const SweepPoint& point : found.sweep)
    if (point.upwards == upwards)
      points += format("%.1f,%.1f ", 60.0 + 520.0 * (point.commanded_deg - min_deg) / width_deg,
                       150.0 - scale * (point.reported_deg - point.commanded_deg));
  return std::string(R"(<polyline fill="none" stroke-width="2" stroke=")") +
         (upwards ? "#0072b2" : "#d55e00") + R"(" points=")" + points + "\"/>\n";
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
  return format(R"(<text x="%.1f" y="%.1f" text-anchor="%s">)", x, y, anchor) + text + "</text>\n";
}

}  // namespace

std::string text_of(const Measurements& found) {
  std::string text = "device        " + found.device + "\n";
  text += format("range         %g to %g deg\n", found.limits.min_deg, found.limits.max_deg);
  text += std::string("orientation   ") +
          (found.is_measured ? "measured by a sensor\n" : "assumed: the plate reports its own commands\n");
  text += format("line          %.1f ms there and back\n", milliseconds(found.round_trip));
  text += format("largest error %.2f deg\n", found.max_error_deg);
  text += line_of("backlash", found.backlash_deg, "%+.2f deg");
  text += line_of("repeatability", found.repeatability_deg, "%.2f deg (standard deviation)");
  text += line_of("speed", found.speed_deg_s, "%.0f deg/s");
  text += line_of("latency", found.latency_ms, "%.0f ms, with up to 20 ms of the reports' period");
  return text;
}

std::string json_of(const Measurements& found) {
  nlohmann::ordered_json sweep = nlohmann::ordered_json::array();
  for (const SweepPoint& point : found.sweep)
    sweep.push_back({{"commanded_deg", point.commanded_deg},
                     {"reported_deg", point.reported_deg},
                     {"from", point.upwards ? "below" : "above"}});
  const bool has_stops = found.limits.max_deg - found.limits.min_deg >= 180.0;
  nlohmann::ordered_json file;
  file["device"] = found.device;
  file["orientation"] = found.is_measured ? "measured" : "assumed";
  file["round_trip_ms"] = milliseconds(found.round_trip);
  file["max_error_deg"] = found.max_error_deg;
  file["backlash_deg"] = or_null(found.backlash_deg);
  file["repeatability_deg"] = or_null(found.repeatability_deg);
  file["speed_deg_s"] = or_null(found.speed_deg_s);
  file["latency_ms"] = or_null(found.latency_ms);
  file["session"] = {{"plate_max_speed_deg_s", plan_speed_deg_s(found)},
                     {"plate_latency_ns", std::llround(plan_latency_ms(found) * 1e6)},
                     {"plate_lower_stop_deg", has_stops ? found.limits.min_deg : 0.0},
                     {"plate_upper_stop_deg", has_stops ? found.limits.max_deg : 0.0}};
  file["scene"] = {{"haptic", {{"role", "plate"}, {"max_speed_deg_s", plan_speed_deg_s(found)}}}};
  file["sweep"] = sweep;
  return file.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string svg_of(const Measurements& found) {
  const double range_deg = std::max(1.0, std::ceil(found.max_error_deg));
  const double scale = 110.0 / range_deg;
  std::string svg =
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 330" font-family="sans-serif" font-size="12">)"
      "\n<rect width=\"600\" height=\"330\" fill=\"white\"/>\n"
      "<path d=\"M60 40V260M60 150H580\" stroke=\"#888\" fill=\"none\"/>\n";
  svg += label(52.0, 44.0, "end", format("%+g", range_deg)) + label(52.0, 154.0, "end", "0") +
         label(52.0, 264.0, "end", format("%+g", -range_deg));
  svg += label(60.0, 280.0, "start", format("%g", found.limits.min_deg)) +
         label(580.0, 280.0, "end", format("%g", found.limits.max_deg)) +
         label(320.0, 300.0, "middle", "commanded orientation, deg");
  svg += label(60.0, 24.0, "start",
               "reported less commanded orientation, deg: from below (blue), from above (red)");
  svg += polyline(found, true, scale) + polyline(found, false, scale);
  if (!found.is_measured)
    svg += label(320.0, 320.0, "middle", "The plate has no sensor: it reports its own commands.");
  return svg + "</svg>\n";
}

void write_file(const std::filesystem::path& file, const std::string& content) {
  if (const int error = write_whole_file(file, content); error != 0)
    throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(error));
}

}  // namespace hrt::plate
