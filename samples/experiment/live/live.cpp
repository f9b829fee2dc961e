#include "samples/experiment/live/live.h"

#include <httplib.h>
#include <sys/random.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "samples/app/text/format.h"
#include "samples/app/text/json_file.h"
#include "samples/experiment/live_page.h"

namespace hrt::experiment {
namespace {

using httplib::Request, httplib::Response, nlohmann::json;

constexpr int max_streams = 4, threads = 2 * max_streams;  // each stream occupies a thread
constexpr double max_noise_mm = 2.0, max_period_s = 1.0 / 60.0, share_of_new = 0.02;
constexpr auto fresh = std::chrono::hours(1);
constexpr int refused = 403, not_found = 404, not_now = 409, too_many = 503;

std::string random_token() {
  unsigned char bytes[16];
  if (getrandom(bytes, sizeof bytes, 0) != sizeof bytes)
    throw Refusal("--live: the system returned no random numbers for a token; run without --live");
  std::string text;
  for (const unsigned char byte : bytes) text += format("%02x", unsigned{byte});
  return text;
}

bool equal_in_constant_time(const std::string& a, const std::string& b) {
  int difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) difference |= a[i] ^ b[i];
  return difference == 0;
}

}  // namespace

Live::Live(bool takes_keys)
    : look_token_(random_token()),
      keys_token_(takes_keys ? random_token() : ""),
      server_(std::make_unique<httplib::Server>()) {
  server_->new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server_->set_keep_alive_max_count(1);  // an idle connection would occupy a thread
  server_->set_payload_max_length(1000);
  route();
  port_ = server_->bind_to_any_port("127.0.0.1");
  if (port_ < 0) throw Refusal("--live: no port could be opened on 127.0.0.1; run without --live");
  thread_ = std::thread([this] { server_->listen_after_bind(); });
}

Live::~Live() {
  is_ending_ = true;
  while (!server_->is_running()) std::this_thread::yield();  // stop() has no effect before the server runs
  server_->stop();
  thread_.join();
}

std::string Live::addresses() const {
  const std::string host = format(": http://127.0.0.1:%d/", port_);
  const std::string keys = keys_token_.empty() ? "" : "Live view with keys" + host + keys_token_ + "/\n";
  return "Live view" + host + look_token_ + "/\n" + keys;
}

void Live::route() {
  // Against DNS rebinding: the name of a foreign site can resolve to 127.0.0.1, but is then in the Host header.
  server_->set_pre_routing_handler([this](const Request& request, Response& response) {
    const std::string host = request.get_header_value("Host");
    if (host == format("127.0.0.1:%d", port_) || host == format("localhost:%d", port_))
      return httplib::Server::HandlerResponse::Unhandled;
    response.status = refused;
    return httplib::Server::HandlerResponse::Handled;
  });
  // The token in the address decides whether the page has keys.
  const auto handler = [this](auto handle) {
    return [this, handle](const Request& request, Response& response) {
      const std::string token = request.matches[1];
      const bool has_keys = equal_in_constant_time(token, keys_token_);
      const bool looks = equal_in_constant_time(token, look_token_);
      if (!has_keys && !looks) return void(response.status = not_found);
      response.set_header("Cache-Control", "no-store");
      handle(request, response, has_keys);
    };
  };
  server_->Get("/([0-9a-f]+)/", handler([](const Request&, Response& response, bool) {
                 const std::string nonce = random_token();
                 std::string page = live_page;
                 for (std::size_t at = 0; (at = page.find("NONCE", at)) != std::string::npos;)
                   page.replace(at, 5, nonce);
                 response.set_content(page, "text/html; charset=utf-8");
                 response.set_header("Referrer-Policy", "no-referrer");
                 response.set_header("Content-Security-Policy",
                                     "default-src 'none'; connect-src 'self'; img-src data:; script-src 'nonce-" +
                                         nonce + "'; style-src 'nonce-" + nonce +
                                         "'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
               }));
  server_->Get("/([0-9a-f]+)/events", handler([this](const Request&, Response& response, bool has_keys) {
                 const auto stream = std::shared_ptr<void>(nullptr, [this](void*) { --streams_; });
                 if (++streams_ > max_streams) return void(response.status = too_many);
                 const auto send = [this, has_keys, stream](std::size_t, httplib::DataSink& sink) {
                   json data = *shown_.load();
                   if (!has_keys) data.erase("keys");
                   const std::string text =
                       "data: " + data.dump(-1, ' ', false, json::error_handler_t::replace) + "\n\n";
                   if (is_ending_ || !sink.write(text.data(), text.size())) return false;
                   std::this_thread::sleep_for(show_period);
                   return true;
                 };
                 response.set_chunked_content_provider("text/event-stream", send);
               }));
  server_->Post("/([0-9a-f]+)/keys", handler([this](const Request& request, Response& response, bool has_keys) {
                  if (!has_keys) return void(response.status = refused);
                  // While no text is requested, each character of a text would act as a key: 's' stops the plate.
                  if (request.body.size() > 1 && !shown_.load()->value("is_typing", false))
                    return void(response.status = not_now);
                  const std::scoped_lock lock(mutex_);
                  pressed_ += request.body;
                }));
}

std::optional<char> Live::key() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || pressed_.empty()) return std::nullopt;
  const char key = pressed_.front();
  pressed_.erase(0, 1);
  return key;
}

void Live::frame(app::RunContext& context, XrTime time, std::optional<Clock::time_point> registered) {
  const double passed_s = 1e-9 * static_cast<double>(time - std::exchange(last_frame_, time));
  period_s_ += share_of_new * (std::min(passed_s, 1.0) - period_s_);
  if (Clock::now() - shown_at_ < show_period) return;
  shown_at_ = Clock::now();
  const std::optional<double> at_deg = context.plate.orientation_deg(time);
  facts["plate"] = nlohmann::json::array();
  facts["plate"].push_back(at_deg ? format("orientation %.1f°", *at_deg) : "orientation unknown");
  if (const hrt_plate_report* report = context.plate.report())
    for (const std::string& text : {format("command %.1f°", report->command_deg),
                                    format("latency %.1f ms", 1e-6 * static_cast<double>(report->latency_ns)),
                                    format("maximum speed %.0f°/s", report->max_speed_deg_s),
                                    format("last message %.0f ms ago", 1e-6 * static_cast<double>(report->age_ns)),
                                    format("%.0f rejected messages", static_cast<double>(report->refused_messages)),
                                    std::string(report->description)})
      facts["plate"].push_back(text);
  check(context, registered);
  show();
}

void Live::check(app::RunContext& context, std::optional<Clock::time_point> registered) {
  facts["checks"] = nlohmann::json::array();
  const auto add = [&](bool is_good, const std::string& text) {
    facts["checks"].push_back((is_good ? "✓ " : "! ") + text);
  };
  const hrt_plate_report* report = context.plate.report();
  if (report == nullptr || report->state == 0)
    add(true, "Plate: simulated");
  else if ((report->flags & HRT_PLATE_REPORT_COMMISSIONED) == 0)
    add(false, "Plate: opened without a plate file; hrt-plate commission writes one, for --plate");
  else if ((report->flags & HRT_PLATE_REPORT_DEVIATES) != 0)
    add(false, "Plate: the rotation differs from the plate file; commission the plate again (hrt-plate commission)");
  else
    add(true, "Plate: commissioned, and the rotation agrees with the plate file");
  if (context.simulation != nullptr)
    add(true, "Registration: simulated");
  else if (!registered)
    add(false, "Registration: not made or checked since the start of this run");
  else
    add(Clock::now() - *registered < fresh,
        format("Registration: made or checked %lld min ago",
               static_cast<long long>((Clock::now() - *registered) / std::chrono::minutes(1))));
  const double noise_mm = facts.value("noise_mm", 0.0);
  add(noise_mm > 0.0 && noise_mm <= max_noise_mm, noise_mm > 0.0 ? format("Tracker: noise of %.2f mm", noise_mm)
                                                                 : "Tracker: noise unknown before a set-up or a reach");
  add(period_s_ <= max_period_s, format("Frames: %.0f per second", 1.0 / period_s_));
}

void Live::moment(const app::RunContext& context, const app::TargetPair& pair, const app::Moment& moment,
                  bool is_first) {
  const auto point_of = [&](const app::Point& at) {
    const app::Point& start = context.targets.start_m;
    return format("%.1f,%.1f ", 1e3 * (at[0] - start[0]), 1e3 * (at[2] - start[2]));
  };
  if (is_first) {
    facts["real"] = point_of(pair.real_position_m);
    facts["virtual"] = point_of(pair.virtual_position_m);
    facts["path"] = facts["felt"] = "";
    finger_m_ = felt_m_ = moment.position_m;
  }
  // Each step of at least 2 mm extends the perceived path by an equal length in the perceived direction.
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
