#include "samples/app/finger/touch_frame.h"

#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>
#include <utility>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

constexpr std::int64_t resampling_ns = 12'000'000;  // period of a touch frame of 100 Hz, plus 2 ms for a late report
constexpr double object_m = 0.012;                  // a contact nearer than this to a known object is this object
constexpr double noise_m = 0.0005;                  // assumed SD of a position that an infrared frame reports
constexpr int max_events = 4096;                    // per locate(), so that it returns if a device sends without pause

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Failure(ExitCode::tracker, "the touch frame " + path + " " + what);
}

void require_opened(int error, const std::string& path) {
  const char* advice = "ls /dev/input/by-id lists the devices";
  if (error == EACCES) advice = "Join the group input (sudo usermod -aG input $USER) and log in again";
  if (error == EBUSY) advice = "End the other program that uses the device";
  if (error != 0) fail(path, std::string("cannot be opened: ") + std::strerror(error) + ". " + advice);
}

}  // namespace

TouchFrame::TouchFrame(const std::string& text)
    : device_(libevdev_new(), [](libevdev* device) {
        close(libevdev_get_fd(device));
        libevdev_free(device);
      }) {
  std::istringstream words(text);
  std::getline(words, path_, '?');
  if (!path_.starts_with("evdev:/"))
    throw Failure(ExitCode::usage,
                  "--finger: \"" + path_ + "\" is not evdev:PATH, such as evdev:/dev/input/by-id/NAME");
  path_.erase(0, path_.find('/'));
  for (std::string word; std::getline(words, word, '&');) {
    const auto known = settings_.find(word.substr(0, word.find('=')));
    const std::optional<double> value = number_in(word.substr(word.find('=') + 1), -5000.0, 5000.0);
    if (known == settings_.end() || !value)
      throw Failure(ExitCode::usage, "--finger: \"" + word +
                                         "\" is not NAME=NUMBER; names: width_mm, height_mm, right_mm, towards_mm, "
                                         "turn_deg, latency_ms, bearing_sd_deg; numbers: -5000 to 5000");
    known->second = *value;
  }

  const int descriptor = open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  const int error = descriptor < 0 ? errno : -libevdev_set_fd(device_.get(), descriptor);
  if (error != 0) close(descriptor);
  require_opened(error, path_);
  contacts_.resize(static_cast<std::size_t>(std::max(0, libevdev_get_num_slots(device_.get()))));
  for (const auto& [code, setting] : {std::pair{ABS_MT_POSITION_X, "width_mm"}, {ABS_MT_POSITION_Y, "height_mm"}}) {
    const input_absinfo* info = libevdev_get_abs_info(device_.get(), code);
    if (contacts_.empty() || info == nullptr || info->maximum <= info->minimum)
      fail(path_, "is not a multitouch device. ls /dev/input/by-id lists the other devices");
    double& size_mm = settings_[setting];
    if (size_mm == 0.0 && info->resolution > 0)
      size_mm = (static_cast<double>(info->maximum) - info->minimum) / info->resolution;
    if (size_mm < 30.0)
      fail(path_, format("has %s %g (0: unknown); allowed: 30 or more. Measure the touch area, and give both sizes: "
                         "--finger 'evdev:PATH?width_mm=W&height_mm=H'",
                         setting, size_mm));
  }
  require_opened(-libevdev_set_clock_id(device_.get(), CLOCK_MONOTONIC), path_);
  require_opened(-libevdev_grab(device_.get(), LIBEVDEV_GRAB), path_);
  take_report(0);
  objects_ = contacts_;
  std::erase_if(objects_, [](const Contact& contact) { return contact.id < 0; });
  history_.clear();
}

std::string TouchFrame::description() const {
  std::string text = format("Finger by %s, %.0f x %.0f mm", libevdev_get_name(device_.get()), settings_.at("width_mm"),
                            settings_.at("height_mm"));
  for (const Contact& object : objects_) {
    const double right_m = object.place_m[0];
    const double nearer_m = object.place_m[2];
    text += format(
        "; ignores the contact that was there at the start, %.0f mm further %s and %.0f mm %s you than the plate's "
        "centre (lift a finger that rested there, and start again)",
        1e3 * std::abs(right_m), right_m < 0.0 ? "left" : "right", 1e3 * std::abs(nearer_m),
        nearer_m < 0.0 ? "further from" : "nearer to");
  }
  return text + ".";
}

void TouchFrame::configure(hrt_session_tracker& tracker) const {
  if (tracker.noise_m == 0.0) tracker.noise_m = noise_m;
  if (tracker.latency_ns == 0) tracker.latency_ns = resampling_ns + std::llround(1e6 * settings_.at("latency_ms"));
  if (tracker.bearing_sd_deg == 0.0) tracker.bearing_sd_deg = settings_.at("bearing_sd_deg");
}

// After events were dropped (SYN_DROPPED) libevdev asks the kernel for the present state and returns the differences.
Fingertip TouchFrame::locate(std::int64_t now_ns) {
  for (int count = 0; count < max_events; ++count) {
    input_event event{};
    const int status =
        libevdev_next_event(device_.get(), is_in_sync_ ? LIBEVDEV_READ_FLAG_NORMAL : LIBEVDEV_READ_FLAG_SYNC, &event);
    if (status == -EAGAIN && is_in_sync_) break;
    if (status < 0 && status != -EAGAIN)
      fail(path_, std::string("is gone (") + std::strerror(-status) + "): plug it in and start again");
    is_in_sync_ = status != LIBEVDEV_READ_STATUS_SYNC;
    if (status == -EAGAIN || event.type != EV_SYN || event.code != SYN_REPORT) continue;
    const std::int64_t time_ns = std::int64_t{1'000'000'000} * event.input_event_sec + 1000 * event.input_event_usec;
    take_report(std::clamp(time_ns, history_.empty() ? 0 : history_.back().time_ns, now_ns));
  }
  const std::int64_t at_ns = now_ns - resampling_ns;
  while (history_.size() > 1 && history_[1].time_ns <= at_ns) history_.pop_front();
  if (history_.empty() || history_[0].time_ns > at_ns || history_[0].id < 0) return {.lifted = true};
  const Contact& from = history_[0];
  const Contact& to = history_.size() > 1 && history_[1].id == from.id ? history_[1] : from;
  const auto span_ns = static_cast<double>(std::max<std::int64_t>(1, to.time_ns - from.time_ns));
  const double fraction = static_cast<double>(at_ns - from.time_ns) / span_ns;
  return {.tracked = true,
          .position_m = {std::lerp(from.place_m[0], to.place_m[0], fraction), 0.0,
                         std::lerp(from.place_m[2], to.place_m[2], fraction)}};
}

// The finger is the first new contact away from known objects, until it lifts.
void TouchFrame::take_report(std::int64_t time_ns) {
  const int former = history_.empty() ? -1 : history_.back().id;
  Contact finger{.time_ns = time_ns};
  for (unsigned slot = 0; slot < contacts_.size(); ++slot) {
    const Contact contact{libevdev_get_slot_value(device_.get(), slot, ABS_MT_TRACKING_ID), place_m(slot), time_ns};
    const bool has_landed = std::exchange(contacts_[slot], contact).id != contact.id;
    const bool is_object = std::any_of(objects_.begin(), objects_.end(), [&](const Contact& object) {
      return std::hypot(object.place_m[0] - contact.place_m[0], object.place_m[2] - contact.place_m[2]) < object_m;
    });
    const bool may_be = finger.id < 0 && has_landed && !is_object;  // a later slot may still have the former finger
    if (contact.id >= 0 && (contact.id == former || may_be)) finger = contact;
  }
  history_.push_back(finger);
}

// With turn_deg 0, the y axis of the device points towards the user.
std::array<double, 3> TouchFrame::place_m(unsigned slot) const {
  const auto from_centre_mm = [&](unsigned code, const char* size) {
    const input_absinfo& info = *libevdev_get_abs_info(device_.get(), code);
    const double low = info.minimum, value = libevdev_get_slot_value(device_.get(), slot, code);
    return settings_.at(size) * (std::clamp((value - low) / (info.maximum - low), 0.0, 1.0) - 0.5);
  };
  const double right_mm = from_centre_mm(ABS_MT_POSITION_X, "width_mm");
  const double down_mm = from_centre_mm(ABS_MT_POSITION_Y, "height_mm");
  const double turn = settings_.at("turn_deg") * std::numbers::pi / 180.0, c = std::cos(turn), s = std::sin(turn);
  return {1e-3 * (settings_.at("right_mm") + c * right_mm + s * down_mm), 0.0,
          1e-3 * (settings_.at("towards_mm") - s * right_mm + c * down_mm)};
}

}  // namespace hrt::app
