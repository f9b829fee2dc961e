// One hrt_reach_update through the C ABI: between steps, on a step, with positions, with everything on, and
// refused.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "haptic_retargeting/haptic_retargeting.h"

namespace {

void require(hrt_result result) {
  if (result != HRT_OK) std::abort();
}

/// A reach under way; each call of update() is one frame.
class Frames {
 public:
  explicit Frames(hrt_session_config config) {
    require(hrt_session_create(&config, &session_));
    hrt_target_config target;
    require(hrt_target_config_default(&target, sizeof target));
    require(hrt_reach_config_default(&reach_, sizeof reach_));
    target.role = HRT_TARGET_REAL;
    target.direction_deg = -5.0;
    require(hrt_target_add(session_, &target, &reach_.real_target));
    target.role = HRT_TARGET_VIRTUAL;
    target.direction_deg = 5.0;
    require(hrt_target_add(session_, &target, &reach_.virtual_target));
    command_.struct_size = sizeof command_;
    sample_.struct_size = sizeof sample_;
    require(hrt_reach_begin(session_, &reach_));
  }
  ~Frames() { hrt_session_destroy(session_); }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;
  Frames(Frames&&) = delete;
  Frames& operator=(Frames&&) = delete;

  hrt_result direction(std::int64_t elapsed_ns) {
    sample_.flags = HRT_SAMPLE_DIRECTION;
    sample_.time_ns += elapsed_ns;
    sample_.finger_direction_deg = static_cast<double>((sample_.time_ns / 7) % 10) - 8.0;
    return hrt_reach_update(session_, &sample_, &command_);
  }

  /// To and fro over the plate at a speed of 3 cm/s.
  hrt_result position(std::int64_t elapsed_ns) {
    sample_.flags = HRT_SAMPLE_PLATE_POSITION;
    sample_.time_ns += elapsed_ns;
    const double travel_m = std::fmod(static_cast<double>(sample_.time_ns) * 3e-11, 0.2);
    sample_.finger_position_m[0] = 0.0005 * static_cast<double>((sample_.time_ns / 7) % 3);
    sample_.finger_position_m[2] = 0.05 - (travel_m < 0.1 ? travel_m : 0.2 - travel_m);
    return hrt_reach_update(session_, &sample_, &command_);
  }

  hrt_result refused() {
    sample_.flags = HRT_SAMPLE_DIRECTION;
    sample_.finger_direction_deg = std::nan("");
    return hrt_reach_update(session_, &sample_, &command_);
  }

 private:
  hrt_session session_{};
  hrt_reach_config reach_{};
  hrt_sample sample_{};
  hrt_command command_{};
};

hrt_session_config defaults() {
  hrt_session_config config;
  require(hrt_session_config_default(&config, sizeof config));
  return config;
}

constexpr std::int64_t frame_ns = 11'111'111;
constexpr std::int64_t step_ns = 100'000'000;

void between_steps(benchmark::State& state) {
  Frames frames(defaults());
  require(frames.direction(1));
  for (auto _ : state) benchmark::DoNotOptimize(frames.direction(0));
}
BENCHMARK(between_steps);

void on_a_step(benchmark::State& state) {
  Frames frames(defaults());
  for (auto _ : state) benchmark::DoNotOptimize(frames.direction(step_ns));
}
BENCHMARK(on_a_step);

void position_frame(benchmark::State& state) {
  Frames frames(defaults());
  for (auto _ : state) benchmark::DoNotOptimize(frames.position(frame_ns));
}
BENCHMARK(position_frame);

// Positions, adaptation, line of sight and a servo's limits, each frame a step.
void position_step_with_everything(benchmark::State& state) {
  hrt_session_config config = defaults();
  config.adaptation = HRT_ADAPTATION_REACH;
  config.guidance = HRT_GUIDANCE_ARRIVAL;
  config.plate_max_speed_deg_s = 400.0;
  config.plate_latency_ns = 30'000'000;
  Frames frames(config);
  for (auto _ : state) benchmark::DoNotOptimize(frames.position(step_ns));
}
BENCHMARK(position_step_with_everything);

void refused(benchmark::State& state) {
  Frames frames(defaults());
  for (auto _ : state) benchmark::DoNotOptimize(frames.refused());
}
BENCHMARK(refused);

}  // namespace

BENCHMARK_MAIN();
