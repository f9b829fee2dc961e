#include "samples/app/finger/touch_frame.h"

#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>
#include <utility>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

constexpr std::int64_t resampling_ns = 12'000'000;  // a period of 100 Hz, and how much later a report may come
constexpr std::int64_t moving_ns = 20'000'000;      // a contact that is not reported for longer was at rest
constexpr double object_mm = 12.0;                  // an object that is lost comes back within this
constexpr double noise_m = 0.0005;                  // assumed of infrared frames
constexpr int max_events = 4096;                    // of one frame, however many a device sends

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Failure(ExitCode::tracker, "the touch frame " + path + " " + what);
}

void require_opened(int error, const std::string& path) {
  std::string why = std::strerror(error);
  if (error == EACCES) why = "you may not read it. Join the group input (sudo usermod -aG input $USER), log in again";
  if (error == ENOENT || error == ENOTTY) why = "it is no input device. ls /dev/input/by-id lists those plugged in";
  if (error == EBUSY) why = "another program uses it alone. End that program";
  if (error != 0) fail(path, "cannot be opened: " + why);
}

void close_device(libevdev* device) {
  close(libevdev_get_fd(device));
  libevdev_free(device);
}

}  // namespace

TouchFrame::TouchFrame(const std::string& text) : device_(libevdev_new(), close_device) {
  std::istringstream words(text);
  std::getline(words, path_, '?');
  if (!path_.starts_with("evdev:/"))
    throw Failure(ExitCode::usage, "--finger: \"" + path_ + "\" is not evdev:/dev/input/by-id/NAME");
  path_.erase(0, path_.find('/'));
  for (std::string word; std::getline(words, word, '&');) {
    const auto known = settings_.find(word.substr(0, word.find('=')));
    const std::optional<double> value = number_in(word.substr(word.find('=') + 1), -5000.0, 5000.0);
    if (known == settings_.end() || !value)
      throw Failure(ExitCode::usage, "--finger: \"" + word +
                                         "\" is not NAME=NUMBER within 5000: width_mm, height_mm, right_mm, "
                                         "towards_mm, turn_deg, latency_ms or bearing_sd_deg");
    known->second = *value;
  }

  const int descriptor = open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  const int error = descriptor < 0 ? errno : -libevdev_set_fd(device_.get(), descriptor);
  if (error != 0) close(descriptor);
  require_opened(error, path_);
  const int slots = libevdev_get_num_slots(device_.get());
  if (slots < 1) fail(path_, "is not a multitouch device (it has no slots). ls /dev/input/by-id lists the others");
  for (const auto& [code, setting] : {std::pair{ABS_MT_POSITION_X, "width_mm"}, {ABS_MT_POSITION_Y, "height_mm"}}) {
    const input_absinfo* info = libevdev_get_abs_info(device_.get(), code);
    double& size_mm = settings_[setting];
    if (info != nullptr && size_mm == 0.0 && info->resolution > 0)
      size_mm = (static_cast<double>(info->maximum) - info->minimum) / info->resolution;
    if (info == nullptr || info->maximum <= info->minimum || size_mm < 30.0)
      fail(path_,
           format("has a size of %g mm. Measure its touch area, and add ?%s=... (30 or more)", size_mm, setting));
  }
  require_opened(-libevdev_set_clock_id(device_.get(), CLOCK_MONOTONIC), path_);
  require_opened(-libevdev_grab(device_.get(), LIBEVDEV_GRAB), path_);
  contacts_.resize(static_cast<std::size_t>(slots));
  take_report(0);
  objects_ = contacts_;
  std::erase_if(objects_, [](const Contact& contact) { return contact.id < 0; });
  finger_ = -1;
  history_.clear();
}

std::string TouchFrame::name() const { return libevdev_get_name(device_.get()); }

std::string TouchFrame::description() const {
  std::string text = format("Finger by %s, %.0f x %.0f mm", libevdev_get_name(device_.get()), settings_.at("width_mm"),
                            settings_.at("height_mm"));
  for (const Contact& object : objects_) {
    const std::array<double, 3> at_m = on_plate_m(object.right_mm, object.down_mm);
    text += format("; an object %.0f mm right of the centre and %.0f mm beyond it", 1e3 * at_m[0], -1e3 * at_m[2]);
  }
  return text + ".";
}

void TouchFrame::configure(hrt_session_tracker& tracker) const {
  if (tracker.noise_m == 0.0) tracker.noise_m = noise_m;
  if (tracker.latency_ns == 0) tracker.latency_ns = resampling_ns + std::llround(1e6 * settings_.at("latency_ms"));
  if (tracker.bearing_sd_deg == 0.0) tracker.bearing_sd_deg = settings_.at("bearing_sd_deg");
}

Fingertip TouchFrame::locate(XrTime time) {
  if (std::exchange(last_, time) == time) return tip_;
  return tip_ = at(std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1));
}

// After events were dropped (SYN_DROPPED) libevdev asks the kernel for the present state and returns the differences.
Fingertip TouchFrame::at(std::int64_t now_ns) {
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
  const std::int64_t from_ns = std::max(from.time_ns, to.time_ns - moving_ns);
  const std::int64_t span_ns = std::max<std::int64_t>(1, to.time_ns - from_ns);
  const double share = std::max(0.0, static_cast<double>(at_ns - from_ns) / static_cast<double>(span_ns));
  const auto place_mm = [&](double Contact::* mm) { return std::lerp(from.*mm, to.*mm, share); };
  return {.tracked = true, .position_m = on_plate_m(place_mm(&Contact::right_mm), place_mm(&Contact::down_mm))};
}

// The finger is the first contact that lands where no object was, until it lifts.
void TouchFrame::take_report(std::int64_t time_ns) {
  const auto value = [this](std::size_t slot, unsigned code) {
    return libevdev_get_slot_value(device_.get(), static_cast<unsigned>(slot), code);
  };
  const auto from_centre_mm = [&](std::size_t slot, unsigned code, const char* size) {
    const input_absinfo& info = *libevdev_get_abs_info(device_.get(), code);
    const double low = info.minimum, share = (value(slot, code) - low) / (info.maximum - low);
    return settings_.at(size) * (std::clamp(share, 0.0, 1.0) - 0.5);
  };
  Contact finger{.time_ns = time_ns};
  for (std::size_t slot = 0; slot < contacts_.size(); ++slot) {
    const Contact contact{value(slot, ABS_MT_TRACKING_ID), from_centre_mm(slot, ABS_MT_POSITION_X, "width_mm"),
                          from_centre_mm(slot, ABS_MT_POSITION_Y, "height_mm"), time_ns};
    const bool has_landed = std::exchange(contacts_[slot], contact).id != contact.id;
    const bool is_object = std::any_of(objects_.begin(), objects_.end(), [&](const Contact& object) {
      return std::hypot(object.right_mm - contact.right_mm, object.down_mm - contact.down_mm) < object_mm;
    });
    const bool may_be = finger.id < 0 && has_landed && !is_object;  // unless the finger is in a later slot
    if (contact.id >= 0 && (contact.id == finger_ || may_be)) finger = contact;
  }
  finger_ = finger.id;
  history_.push_back(finger);
}

// The touch area's down is towards the user.
std::array<double, 3> TouchFrame::on_plate_m(double right_mm, double down_mm) const {
  const double turn = settings_.at("turn_deg") * std::numbers::pi / 180.0, c = std::cos(turn), s = std::sin(turn);
  return {1e-3 * (settings_.at("right_mm") + c * right_mm + s * down_mm), 0.0,
          1e-3 * (settings_.at("towards_mm") - s * right_mm + c * down_mm)};
}

}  // namespace hrt::app
