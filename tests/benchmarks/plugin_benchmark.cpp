// One hrt_reach_update through the C ABI: between steps, on a step, with positions, with everything on, and
// refused. Then the median, the 99th percentile and the worst of single updates of the paper's controller, at
// each horizon, for fingers and plates that are hard on its solver.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

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
    return direction(elapsed_ns, static_cast<double>(((sample_.time_ns + elapsed_ns) / 7) % 10) - 8.0);
  }

  hrt_result direction(std::int64_t elapsed_ns, double direction_deg) {
    sample_.flags = HRT_SAMPLE_DIRECTION;
    sample_.time_ns += elapsed_ns;
    sample_.finger_direction_deg = direction_deg;
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

// Positions, learning and a servo's limits, each frame a step.
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

constexpr int reaches = 200;
constexpr int updates = 30;
constexpr int runs = 5;

// Fingers that go anywhere within 30 degrees at each step, now and then after a gap of several; plates that
// turn by half a degree to 90 degrees a step. The same in each run.
void time_reach(int horizon, unsigned seed, double* min_us) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  hrt_session_config config = defaults();
  config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  config.horizon = horizon;
  config.adaptation = HRT_ADAPTATION_REACH;
  config.tactile_weight = uniform(0.05, 0.3);
  config.plate_max_speed_deg_s = std::exp(uniform(std::log(5.0), std::log(900.0)));
  config.plate_latency_ns = 30'000'000;
  Frames frames(config);
  for (int i = 0; i < updates; ++i) {
    const std::int64_t elapsed_ns = uniform(0.0, 1.0) < 0.1 ? 7 * step_ns : step_ns;
    const double direction_deg = uniform(-30.0, 30.0);
    const auto begun = std::chrono::steady_clock::now();
    require(frames.direction(elapsed_ns, direction_deg));
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begun;
    min_us[i] = std::min(min_us[i], time.count());
  }
}

// Each update's least time over several runs counts, so that other work on the machine does not.
void print_single_updates() {
  std::printf("\nsingle updates  horizon  median us  p99 us  worst us\n");
  for (const int horizon : {3, 10, 20, 50}) {
    std::vector<double> min_us(std::size_t{reaches} * updates, 1e9);
    for (int run = 0; run < runs; ++run)
      for (unsigned i = 0; i < reaches; ++i) time_reach(horizon, i, &min_us[std::size_t{i} * updates]);
    std::sort(min_us.begin(), min_us.end());
    std::printf("                %7d  %9.2f  %6.2f  %8.2f\n", horizon, min_us[min_us.size() / 2],
                min_us[min_us.size() * 99 / 100], min_us.back());
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  print_single_updates();
}
