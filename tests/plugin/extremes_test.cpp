// Outputs are finite for random configurations and samples within the documented ranges.
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>

#include "generated/fields.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {
namespace {

using C = hrt_session_config;
using F = plugin::Fields<C>;
using Range = plugin::Field<C, double>;

// Ranges of all fields of type double except the stops, which depend on each other.
const std::vector<Range> ranges = [] {
  std::vector<Range> found;
  plugin::for_each_field<C>([&](const auto& field) {
    if constexpr (std::is_same_v<const Range&, decltype(field)>)
      if (!std::string_view(field.name).ends_with("stop_deg")) found.push_back(field);
  });
  return found;
}();

// Returns the offset of the first double that is not finite, or nullopt. From `offset`, all members are doubles.
template <class Struct>
std::optional<std::size_t> first_not_finite(const Struct& value, std::size_t offset) {
  for (; offset < sizeof value; offset += sizeof(double)) {
    double number = 0.0;
    std::memcpy(&number, reinterpret_cast<const char*>(&value) + offset, sizeof number);
    if (!std::isfinite(number)) return offset;
  }
  return std::nullopt;
}

class Extremes : public SessionTest {
 protected:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }
  template <class Value, std::size_t n>
  Value one_of(const Value (&values)[n]) {
    return values[below(n)];
  }

  /// Draws a limit of the range, a uniform number or, if the range has no negative numbers, a log-uniform number.
  double within(double low, double high) {
    const std::size_t kind = below(4);
    if (kind < 2) return kind == 0 ? low : high;
    if (kind == 2 && low >= 0.0) return std::pow(10.0, uniform(low > 0.0 ? std::log10(low) : -320.0, std::log10(high)));
    return uniform(low, high);
  }

  /// Draws a configuration: the defaults, with all, half or an eighth of the fields at random.
  hrt_session_config configuration() {
    hrt_session_config config = session_config();
    const auto share = one_of<std::size_t>({1, 2, 8});
    const auto changes = [&] { return below(share) == 0; };
    for (const Range& range : ranges)
      if (changes()) range.of(config) = within(range.low, range.high);
    if (changes()) config.paper.horizon = one_of({1u, 2u, 3u, 10u, 20u});
    if (changes()) config.paper.step_period_ns = one_of<std::int64_t>({1'000'000, 10'000'000, 10'000'000'000});
    if (changes()) config.control = one_of({HRT_CONTROL_MPC, HRT_CONTROL_MPC, HRT_CONTROL_FIXED_PLATE});
    if (changes()) config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
    config.adaptation = one_of({HRT_ADAPTATION_OFF, HRT_ADAPTATION_REACH, HRT_ADAPTATION_CARRIED});
    if (changes()) config.flags = HRT_SESSION_PLATE_WAITS;
    if (changes()) config.tracker.latency_ns = one_of<std::int64_t>({1, 30'000'000, 500'000'000});
    if (changes())
      config.plate.latency_ns =
          std::min<std::int64_t>(8 * config.paper.step_period_ns, one_of({1, 30'000'000, 1'000'000'000}));
    if (changes()) {
      config.plate.lower_stop_deg = one_of({-3600.0, -90.0, 0.0, 3420.0});
      config.plate.upper_stop_deg = std::min(3600.0, config.plate.lower_stop_deg + one_of({180.0, 270.0, 7200.0}));
    }
    for (double& coordinate_m : config.start_position_m)
      if (changes()) coordinate_m = within(-10.0, 10.0);
    for (double& coordinate_m : config.plate.position_m)
      if (changes()) coordinate_m = within(-1000.0, 1000.0);
    if (below(4) == 0) set_random_person(&config);
    return config;
  }

  void set_random_person(hrt_session_config* config) {
    for (int trait = 0; trait < HRT_PERSON_TRAITS; ++trait)
      config->person.mean[trait] = within(F::person_mean_elements[trait].low, F::person_mean_elements[trait].high);
    for (double& covariance : config->person.covariance) covariance = 0.0;
    for (int trait = 0, at = 0; trait < HRT_PERSON_TRAITS; at += ++trait + 1)
      config->person.covariance[at] = within(1e-12, 1e4);
  }

  hrt_target place(std::uint32_t role) {
    hrt_target_config config = target_config(role, 0.0);
    config.place =
        one_of({HRT_PLACE_DIRECTION, HRT_PLACE_DIRECTION, HRT_PLACE_PLATE_POSITION, HRT_PLACE_WORLD_POSITION});
    config.direction_deg = below(2) == 0 ? uniform(-20.0, 20.0) : within(-180.0, 180.0);
    config.distance_m = below(2) == 0 ? 0.1 : within(0.001, 10.0);
    for (double& coordinate_m : config.position_m) coordinate_m = within(-1000.0, 1000.0);
    hrt_target target{};
    const hrt_result result = hrt_target_add(session, &config, &target);
    EXPECT_TRUE(result == HRT_OK || result == HRT_ERROR_OUT_OF_RANGE) << hrt_last_error();
    return target;
  }

  hrt_result begin_anyhow() {
    const hrt_target real = place(HRT_TARGET_REAL), seen = place(HRT_TARGET_VIRTUAL);
    hrt_reach_config reach = reach_config(real, seen, below(2) == 0 ? HRT_REACH_PLATE_ORIENTATION : 0u);
    reach.plate_orientation_deg = within(-3600.0, 3600.0);
    reach.duration_s = one_of({0.0, 0.1, 1.0, 20.0});
    auto gap = output<hrt_gap>();
    if (hrt_gap_query(session, reach.real_target, reach.virtual_target, &gap) == HRT_OK) {
      EXPECT_EQ(first_not_finite(gap, offsetof(hrt_gap, gap_deg)), std::nullopt);
    }
    return hrt_reach_begin(session, &reach);
  }

  void move(hrt_sample* sample) {
    sample->flags = one_of<std::uint32_t>({HRT_SAMPLE_PLATE_POSITION, HRT_SAMPLE_PLATE_POSITION, HRT_SAMPLE_DIRECTION,
                                           HRT_SAMPLE_WORLD_POSITION, HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE,
                                           0, HRT_SAMPLE_LIFTED});
    if (below(3) == 0) sample->flags |= HRT_SAMPLE_PLATE_ORIENTATION;
    sample->plate_orientation_deg = within(-3600.0, 3600.0);
    sample->finger_direction_deg = within(-180.0, 180.0);
    sample->plate_rotation[3] = 1.0;
    const std::size_t kind = below(8);  // 0: jumps, 1: rests, else: slides
    if (kind > 1) {
      sample->finger_position_m[0] += 0.001 * uniform(-1.0, 1.0);
      sample->finger_position_m[2] -= 0.002;
    }
    for (double& coordinate_m : sample->finger_position_m)
      coordinate_m = kind == 0 ? within(-1000.0, 1000.0) : std::clamp(coordinate_m, -1000.0, 1000.0);
    constexpr std::int64_t steps_ns[] = {0, 1, 11'000'000, 11'000'000, 11'000'000, 100'000'000, 20'000'000'000};
    const std::int64_t advance_ns = below(50) == 0 ? std::int64_t{1} << 60 : one_of(steps_ns);
    constexpr std::int64_t last_ns = std::numeric_limits<std::int64_t>::max();
    sample->time_ns = sample->time_ns > last_ns - advance_ns ? last_ns : sample->time_ns + advance_ns;
  }

  /// Checks that the session's configuration is finite, can be set again, and gives a valid profile.
  void check_what_is_kept() {
    hrt_session_config config = config_of(session);
    for (const Range& range : ranges) EXPECT_TRUE(std::isfinite(range.of(config)));
    EXPECT_EQ(first_not_finite(config.person.mean, 0), std::nullopt);
    EXPECT_EQ(first_not_finite(config.person.covariance, 0), std::nullopt);
    EXPECT_OK(hrt_session_set(session, &config));
    EXPECT_OK(load_profile(save_profile()));
  }

  void reach() {
    auto sample = output<hrt_sample>();
    sample.time_ns = one_of<std::int64_t>({0, -1, std::numeric_limits<std::int64_t>::min(), 1'700'000'000'000'000'000});
    std::memcpy(sample.finger_position_m, config_of(session).start_position_m, sizeof sample.finger_position_m);
    for (int i = 0; i < 60; ++i) {
      move(&sample);
      if (below(20) == 0) {
        const hrt_target real = place(HRT_TARGET_REAL), seen = place(HRT_TARGET_VIRTUAL);
        (void)hrt_reach_retarget(session, real, seen);
      }
      hrt_command command = update(sample);
      ASSERT_EQ(command.flags & HRT_COMMAND_FAULT, 0u) << "in sample " << i;
      command.paper.step = 0;  // the only field that is not a double
      ASSERT_EQ(first_not_finite(command, offsetof(hrt_command, plate_orientation_deg)), std::nullopt);
    }
    const hrt_reach_summary summary = end();
    ASSERT_EQ(summary.flags & HRT_COMMAND_FAULT, 0u);
    ASSERT_EQ(first_not_finite(summary, offsetof(hrt_reach_summary, bearing_deg)), std::nullopt);
    check_what_is_kept();
  }

  /// Follows the instructions of a set-up. Slides towards about `weight` times the plate orientation. Returns true if a
  /// fit is due.
  bool set_up(double weight, double noise_m) {
    auto step = output<hrt_setup_step>();
    double side = 0.0;
    int slid = 0;
    for (int i = 0; i < 5000 && step.instruction != HRT_STEP_FINISH; ++i) {
      if (step.instruction != HRT_STEP_SLIDE) slid = 0;
      if (step.instruction == HRT_STEP_SLIDE && slid++ == 0)
        side = std::tan((weight * std::remainder(step.plate_orientation_deg, 180.0) + uniform(-2.0, 2.0)) / 57.3);
      const double away_m = 0.0025 * std::min(slid, 40);
      const hrt_sample sample =
          position_sample(std::int64_t{i} * 33'000'000, side * away_m + noise_m * uniform(-1.0, 1.0),
                          away_m - 0.05 + noise_m * uniform(-1.0, 1.0));
      EXPECT_OK(hrt_setup_update(session, &sample, &step));
    }
    return step.instruction == HRT_STEP_FINISH;
  }

  std::mt19937_64 bits_{1};
};

TEST_F(Extremes, RandomCalibrationsGiveFiniteNumbers) {
  int fitted = 0;
  hrt_setup_config config = hrt_setup_config_init();
  config.max_slides = 16;
  for (int i = 0; i < 16; ++i) {
    SCOPED_TRACE("calibration " + std::to_string(i));
    ASSERT_OK(hrt_setup_begin(session, HRT_SETUP_CALIBRATION, &config));
    const double noise_m = one_of({0.0, 1e-300, 1e-12, 1e-4, 0.002});
    if (!set_up(uniform(-0.5, 0.5), noise_m)) {
      ASSERT_OK(hrt_setup_cancel(session));
      continue;
    }
    auto result = output<hrt_setup_result>();
    do ASSERT_OK(hrt_setup_finish(session, &result));
    while (result.left != 0);
    fitted += result.slides_used > 0;
    for (const hrt_interval& interval : {result.tactile_weight, result.bias_deg, result.max_gap_deg}) {
      EXPECT_TRUE(std::isfinite(interval.lower) && std::isfinite(interval.upper));
      EXPECT_TRUE(interval.lower <= interval.value && interval.value <= interval.upper);
    }
    check_what_is_kept();
  }
  EXPECT_GT(fitted, 4);
}

TEST_F(Extremes, RandomConfigurationsAndSamplesGiveFiniteNumbers) {
  int reached = 0;
  for (int i = 0; i < 6000 && !HasFailure(); ++i) {
    SCOPED_TRACE("configuration " + std::to_string(i));
    const hrt_session_config config = configuration();
    hrt_session other{};
    ASSERT_OK(hrt_session_create(HRT_VERSION, &config, &other));
    ASSERT_OK(hrt_session_destroy(session));
    session = other;
    for (int n = 0; n < 3; ++n) {
      if (begin_anyhow() != HRT_OK) continue;
      ++reached;
      reach();
    }
  }
  EXPECT_GT(reached, 4000);
}

}  // namespace
}  // namespace hrt::test
