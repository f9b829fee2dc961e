#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "samples/app/text/format.h"
#include "samples/experiment/live/live.h"

namespace hrt::experiment {
namespace {

constexpr double max_noise_mm = 2.0, max_period_s = 1.0 / 60.0, share_of_new = 0.02;
constexpr auto fresh = std::chrono::hours(1);

}  // namespace

void Live::frame(app::Stage& stage, XrTime time, std::optional<Clock::time_point> registered) {
  const double passed_s = 1e-9 * static_cast<double>(time - std::exchange(last_frame_, time));
  period_s_ += share_of_new * (std::min(passed_s, 1.0) - period_s_);
  if (Clock::now() - shown_at_ < show_period) return;
  shown_at_ = Clock::now();
  const std::optional<double> at_deg = stage.plate.orientation_deg(time);
  facts["plate"] = nlohmann::json::array();
  facts["plate"].push_back(at_deg ? format("orientation %.1f°", *at_deg) : "orientation unknown");
  if (const hrt_plate_report* report = stage.plate.report())
    for (const std::string& text : {format("command %.1f°", report->command_deg),
                                    format("latency %.1f ms", 1e-6 * static_cast<double>(report->latency_ns)),
                                    format("at most %.0f°/s", report->max_speed_deg_s),
                                    format("heard %.0f ms ago", 1e-6 * static_cast<double>(report->age_ns)),
                                    format("%.0f messages refused", static_cast<double>(report->refused_messages)),
                                    std::string(report->description)})
      facts["plate"].push_back(text);
  check(stage, registered);
  show();
}

void Live::check(app::Stage& stage, std::optional<Clock::time_point> registered) {
  facts["checks"] = nlohmann::json::array();
  const auto add = [&](bool is_good, const std::string& text) {
    facts["checks"].push_back((is_good ? "✓ " : "! ") + text);
  };
  const hrt_plate_report* report = stage.plate.report();
  if (report == nullptr || report->state == 0)
    add(true, "Plate: simulated");
  else if ((report->flags & HRT_PLATE_REPORT_COMMISSIONED) == 0)
    add(false, "Plate: not commissioned (hrt-plate commission)");
  else
    add((report->flags & HRT_PLATE_REPORT_DEVIATES) == 0, "Plate: commissioned, and turns as its file says");
  if (stage.simulation != nullptr)
    add(true, "Registration: simulated");
  else if (!registered)
    add(false, "Registration: none");
  else
    add(Clock::now() - *registered < fresh,
        format("Registration: a touch checked it %lld min ago",
               static_cast<long long>((Clock::now() - *registered) / std::chrono::minutes(1))));
  const double noise_mm = facts.value("noise_mm", 0.0);
  add(noise_mm > 0.0 && noise_mm <= max_noise_mm, noise_mm > 0.0 ? format("Tracker: noise of %.2f mm", noise_mm)
                                                                 : "Tracker: noise unknown until a set-up or a reach");
  add(period_s_ <= max_period_s, format("Frames: %.0f a second", 1.0 / period_s_));
}

void Live::moment(const app::Stage& stage, const app::TargetPair& pair, const app::Moment& moment, bool is_first) {
  const auto point_of = [&](const app::Point& at) {
    const app::Point& start = stage.targets.start_m;
    return format("%.1f,%.1f ", 1e3 * (at[0] - start[0]), 1e3 * (at[2] - start[2]));
  };
  if (is_first) {
    facts["real"] = point_of(pair.real_position_m);
    facts["virtual"] = point_of(pair.virtual_position_m);
    facts["path"] = facts["felt"] = "";
    finger_m_ = felt_m_ = moment.position_m;
  }
  // The perceived path has the length of the true one, without the tracker's noise, in the perceived directions.
  constexpr double min_step_m = 0.002;
  const double step_m = app::distance_along_plate_m(moment.position_m, finger_m_);
  if (step_m >= min_step_m) {
    const double felt = moment.felt_direction_deg * std::numbers::pi / 180.0;
    felt_m_[0] -= step_m * std::sin(felt);
    felt_m_[2] -= step_m * std::cos(felt);
    finger_m_ = moment.position_m;
  }
  facts["path"].get_ref<std::string&>() += point_of(finger_m_);
  facts["felt"].get_ref<std::string&>() += point_of(felt_m_);
}

}  // namespace hrt::experiment
