// Makes the reach that every host's sample runs (plugin/bindings/README.md): a simulated person, a noisy
// tracker and a slow plate, led by the library, which records it.
//   usage: hrt_record_reach RECORDING_CSV HASH_FILE
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ios>

#include "core/plate/plate_frame.h"
#include "core/plate/plate_model.h"
#include "core/simulation/person.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/setup.h"
#include "haptic_retargeting/study.h"

namespace {

void check(hrt_result result) {
  if (result == HRT_OK) return;
  std::fprintf(stderr, "hrt_record_reach: %s\n", hrt_last_error());
  std::exit(1);
}

constexpr std::int64_t ms = 1'000'000;

// What the samples of all hosts write out in their own words; see the table in plugin/bindings/README.md.
hrt_session_config session_config() {
  hrt_session_config config = hrt_session_config_init();
  config.paper.horizon = 20;
  config.guidance = HRT_GUIDANCE_ARRIVAL;
  config.adaptation = HRT_ADAPTATION_REACH;
  config.plate.max_speed_deg_s = 200.0;
  config.plate.max_acceleration_deg_s2 = 20'000.0;
  config.plate.latency_ns = 30 * ms;
  config.plate.lower_stop_deg = -360.0;
  config.plate.upper_stop_deg = 360.0;
  return config;
}

hrt_target add(hrt_session session, std::uint32_t role, double direction_deg, const char* name) {
  hrt_target_config config = hrt_target_config_init();
  config.role = role;
  config.direction_deg = direction_deg;
  std::snprintf(config.name, sizeof config.name, "%s", name);
  hrt_target target;
  check(hrt_target_add(session, &config, &target));
  return target;
}

/// The apparatus and the person, whom the library does not know as well as they are.
class World {
 public:
  explicit World(const hrt_session_config& config)
      : plate_({.max_speed_deg_s = config.plate.max_speed_deg_s,
                .max_acceleration_deg_s2 = config.plate.max_acceleration_deg_s2,
                .latency_ns = config.plate.latency_ns,
                .stops = {config.plate.lower_stop_deg, config.plate.upper_stop_deg}},
               0.0) {}

  /// Lets 1 ms pass. A lifted finger stays above where it was, and feels nothing.
  void advance(bool resting, bool lifted) {
    now_ns_ += ms;
    plate_.advance(now_ns_);
    if (!resting && !lifted && !person_.done()) person_.advance(plate_.orientation_deg());
  }

  void obey(const hrt_command& command) {
    if ((command.flags & HRT_COMMAND_HELD) == 0) plate_.command(command.plate_orientation_deg);
  }

  /// What a tracker and the plate's encoder report, in decimals that every host reads alike.
  hrt_sample sample(bool lifted) {
    const hrt::PlatePoint finger = person_.position();
    const double height_m = lifted ? 0.03 : 0.002;
    hrt_sample sample{};
    sample.struct_size = sizeof sample;
    sample.flags = HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_PLATE_ORIENTATION | (lifted ? HRT_SAMPLE_LIFTED : 0u);
    sample.time_ns = now_ns_ + static_cast<std::int64_t>(std::clamp(noise_.normal(), -2.0, 2.0) * 0.2 * ms);
    sample.finger_position_m[0] = rounded((finger.right_mm + tracker_noise_mm * noise_.normal()) / hrt::mm_per_m, 1e6);
    sample.finger_position_m[1] = height_m;
    sample.finger_position_m[2] = rounded((-finger.away_mm + tracker_noise_mm * noise_.normal()) / hrt::mm_per_m, 1e6);
    sample.plate_orientation_deg = rounded(plate_.orientation_deg() + 0.1 * noise_.normal(), 100.0);
    return sample;
  }

  const hrt::SlidingPerson& person() const { return person_; }

 private:
  static constexpr double tracker_noise_mm = 0.5;

  /// The double next to a decimal of few digits.
  static double rounded(double value, double per_unit) {
    return static_cast<double>(std::llround(value * per_unit)) / per_unit;
  }

  hrt::PlateModel plate_;
  hrt::SlidingPerson person_{{.illusion = {.tactile_weight = 0.24}, .bias_deg = 1.0, .duration_s = 2.4},
                             {0.0, -50.0},
                             5.0,
                             100.0,
                             hrt::Draws(7, 0, 0, 0)};
  hrt::Draws noise_{7, 1, 0, 0};
  std::int64_t now_ns_ = 0;
};

void run_reach(hrt_session session, const hrt_session_config& config) {
  hrt_reach_config reach = hrt_reach_config_init();
  reach.real_target = add(session, HRT_TARGET_REAL, -5.0, "cylinder");
  reach.virtual_target = add(session, HRT_TARGET_VIRTUAL, 5.0, "cup");
  check(hrt_reach_begin(session, &reach));

  World world(config);
  hrt_command command{};
  command.struct_size = sizeof command;
  std::uint32_t number = 0;
  for (int time_ms = 1; time_ms <= 3400; ++time_ms) {
    const bool resting = time_ms <= 200;
    const bool lifted = time_ms > 1300 && time_ms <= 1500;
    world.advance(resting, lifted);
    if (time_ms % 20 != 0) continue;  // 50 Hz
    ++number;
    if (time_ms > 2100 && time_ms <= 2160) continue;  // frames that the host drops
    hrt_sample sample = world.sample(lifted);
    // The tracker loses the finger now and then, and once for longer.
    if (number % 40 == 7 || (time_ms > 800 && time_ms <= 1050)) sample.flags = HRT_SAMPLE_PLATE_ORIENTATION;
    check(hrt_reach_update(session, &sample, &command));
    world.obey(command);
  }
  hrt_reach_summary summary{};
  summary.struct_size = sizeof summary;
  check(hrt_reach_end(session, &summary));
  const double bearing_deg = hrt::bearing_deg({0.0, -50.0}, world.person().position());
  std::printf("the finger ended at %.2f degrees, feeling %.2f; the real target is at -5, the virtual one at 5\n",
              bearing_deg, 5.0 + world.person().felt_error_deg());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: hrt_record_reach RECORDING_CSV HASH_FILE\n");
    return 2;
  }
  const hrt_session_config config = session_config();
  hrt_session session;
  check(hrt_session_create(HRT_VERSION, &config, &session));
  check(hrt_recording_start(session, argv[1]));
  run_reach(session, config);
  check(hrt_session_destroy(session));

  hrt_replay_report report{};
  report.struct_size = sizeof report;
  check(hrt_replay(argv[1], nullptr, 0, &report));
  std::ofstream hash(argv[2], std::ios::binary);
  hash << "0x" << std::hex;
  hash.width(16);
  hash.fill('0');
  hash << report.hash << '\n';
  return report.complete == 1 && report.first_different_line == 0 && hash.flush() ? 0 : 1;
}
