#include "samples/experiment/session/library.h"

#include <cstring>

#include "samples/app/text/format.h"

namespace hrt::experiment {

using nlohmann::json;

namespace {

hrt_target added(hrt_session session, std::uint32_t role, double direction_deg, double distance_m, double radius_m) {
  hrt_target_config config = hrt_target_config_init();
  config.role = role;
  config.direction_deg = direction_deg;
  config.distance_m = distance_m;
  config.radius_m = radius_m;
  hrt_target target{};
  check(hrt_target_add(session, &config, &target));
  return target;
}

}  // namespace

void check(hrt_result result) {
  if (result != HRT_OK) throw Refusal(std::string("the plugin returned an error: ") + hrt_last_error());
}

std::string library_version() {
  std::uint32_t major = 0, minor = 0, patch = 0;
  hrt_get_version(&major, &minor, &patch);
  return format("%u.%u.%u", major, minor, patch);
}

json row_of(const hrt_sample& sample) {
  return {sample.time_ns,
          sample.flags,
          sample.finger_position_m[0],
          sample.finger_position_m[1],
          sample.finger_position_m[2],
          sample.plate_orientation_deg};
}

hrt_sample sample_of(const json& row) {
  hrt_sample sample = hrt_sample_init();
  sample.time_ns = row.at(0);
  sample.flags = row.at(1);
  for (std::size_t i = 0; i < 3; ++i) sample.finger_position_m[i] = row.at(2 + i);
  sample.plate_orientation_deg = row.at(5);
  return sample;
}

LibrarySession::LibrarySession(const Condition& condition, const std::string& profile, const Subject& subject) {
  hrt_session_config config = config_of(condition);
  subject.plan(config);
  check(hrt_session_create(HRT_VERSION, &config, &session_));
  if (profile.empty()) return;
  const hrt_result loaded = hrt_profile_load(session_, profile.data(), profile.size());
  if (loaded != HRT_OK) hrt_session_destroy(session_);
  check(loaded);
}

LibrarySession::~LibrarySession() { hrt_session_destroy(session_); }

std::pair<hrt_target, hrt_target> LibrarySession::add_targets(double real_deg, double virtual_deg, double distance_m,
                                                              double radius_m) const {
  const hrt_target real = added(session_, HRT_TARGET_REAL, real_deg, distance_m, radius_m);
  return {real, added(session_, HRT_TARGET_VIRTUAL, virtual_deg, distance_m, 0.0)};
}

hrt_session_config LibrarySession::config() const {
  hrt_session_config config = hrt_session_config_init();
  check(hrt_session_get(session_, &config, nullptr));
  return config;
}

std::string LibrarySession::profile() const {
  std::uint64_t length = 0;
  check(hrt_profile_save(session_, 0, nullptr, &length));
  std::string text(length + 1, '\0');
  check(hrt_profile_save(session_, text.size(), text.data(), &length));
  text.resize(length);
  return text;
}

void LibrarySession::record(const std::filesystem::path& file) const {
  if (std::filesystem::exists(file))
    throw Refusal(file.string() + ": the recording exists already and is not overwritten; move it away and run again");
  check(hrt_recording_start(session_, file.c_str()));
}

void LibrarySession::finish_recording(const std::filesystem::path& file) const {
  hrt_recording_status status = hrt_recording_status_init();
  check(hrt_recording_stop(session_, &status));
  if (status.system_error == 0 && status.rows_lost == 0) return;
  const char* why = status.system_error != 0 ? std::strerror(status.system_error) : "the disk was too slow";
  throw Refusal(file.string() + format(": %llu rows were lost: ", static_cast<unsigned long long>(status.rows_lost)) +
                why + "; free space, or move the data to a faster disk (--data), and run again");
}

}  // namespace hrt::experiment
