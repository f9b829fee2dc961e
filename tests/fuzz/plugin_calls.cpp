// Makes calls in any order with any arguments. Checks that results have names, that numbers of outputs are finite, and
// for some calls that a failure does not change the output.
#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include "haptic_retargeting/gap.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/host.h"
#include "haptic_retargeting/person.h"
#include "haptic_retargeting/profile.h"
#include "haptic_retargeting/recording.h"
#include "haptic_retargeting/scene.h"
#include "haptic_retargeting/setup.h"

namespace {

void require(bool holds, int line = __builtin_LINE()) {
  if (holds) return;
  std::fprintf(stderr, "plugin_calls.cpp:%d: a requirement does not hold; last error: %s\n", line, hrt_last_error());
  std::abort();
}

// Requires that all fields from `offset` on, which must be doubles, are finite.
template <class Struct>
void require_finite(const Struct& value, size_t offset) {
  for (; offset < sizeof value; offset += sizeof(double)) {
    double number = 0.0;
    std::memcpy(&number, reinterpret_cast<const char*>(&value) + offset, sizeof number);
    require(std::isfinite(number));
  }
}

void require_command(hrt_command command) {
  require((command.flags & HRT_COMMAND_FAULT) == 0);
  command.paper.step = 0;  // the only field from plate_orientation_deg on that is not a double
  require_finite(command, offsetof(hrt_command, plate_orientation_deg));
}

void check(hrt_result result) {
  require(result <= HRT_OK && std::strcmp(hrt_result_string(result), "unknown result") != 0);
}

/// Makes calls with arguments from the fuzzer's bytes. Handles are often those of existing sessions and targets.
class Caller {
 public:
  explicit Caller(FuzzedDataProvider& bytes) : bytes_(bytes) {}
  ~Caller() {
    for (const hrt_session session : sessions_) hrt_session_destroy(session);
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void call() {
    constexpr void (Caller::* calls[])() = {
        &Caller::create, &Caller::destroy, &Caller::set_config, &Caller::add_target, &Caller::remove,
        &Caller::list,   &Caller::gap,     &Caller::begin,      &Caller::end,        &Caller::retarget,
        &Caller::cancel, &Caller::state,   &Caller::assign,     &Caller::residual,   &Caller::set_up};
    const auto chosen = bytes_.ConsumeIntegralInRange<size_t>(0, 20);
    chosen < std::size(calls) ? (this->*calls[chosen])() : update();  // the most frequent call
  }

 private:
  hrt_session session() {
    return bytes_.ConsumeBool() ? sessions_[bytes_.ConsumeIntegralInRange<size_t>(0, sessions_.size() - 1)]
                                : hrt_session{bytes_.ConsumeIntegral<uint64_t>()};
  }

  hrt_target target() {
    return bytes_.ConsumeIntegralInRange(0, 7) ? targets_[bytes_.ConsumeIntegralInRange<size_t>(0, targets_.size() - 1)]
                                               : hrt_target{bytes_.ConsumeIntegral<uint64_t>()};
  }

  // Overwrites up to three numbers of a struct.
  template <class Struct>
  void disturb(Struct& value) {
    for (int n = bytes_.ConsumeIntegralInRange(0, 3); n > 0; --n) {
      const auto at = bytes_.ConsumeIntegralInRange<size_t>(0, sizeof value / 8 - 1);
      const double number = bytes_.ConsumeBool() ? bytes_.ConsumeFloatingPointInRange(-100.0, 100.0)
                                                 : bytes_.ConsumeFloatingPoint<double>();
      std::memcpy(reinterpret_cast<char*>(&value) + 8 * at, &number, sizeof number);
    }
    // By contract the library may read `struct_size` bytes, so the size must not exceed the object.
    uint32_t size;
    std::memcpy(&size, &value, sizeof size);
    if (size > sizeof value) size = static_cast<uint32_t>(sizeof value);
    std::memcpy(&value, &size, sizeof size);
  }

  void create() {
    hrt_session_config config = hrt_session_config_init();
    disturb(config);
    hrt_session created{};
    const hrt_result result = hrt_session_create(HRT_VERSION, &config, &created);
    check(result);
    require((result == HRT_OK) == (created.value != 0));
    if (result != HRT_OK) return;
    hrt_session& slot = sessions_[bytes_.ConsumeIntegralInRange<size_t>(0, sessions_.size() - 1)];
    hrt_session_destroy(slot);
    slot = created;
  }

  void destroy() { check(hrt_session_destroy(session())); }
  void remove() { check(hrt_target_remove(session(), target())); }
  void cancel() { check(hrt_reach_cancel(session())); }
  void retarget() { check(hrt_reach_retarget(session(), target(), target())); }

  void set_config() {
    hrt_session_config config = hrt_session_config_init();
    disturb(config);
    check(hrt_session_set(session(), &config));
    if (bytes_.ConsumeBool()) check(hrt_profile_reset(session()));
  }

  void add_target() {
    hrt_target_config config = hrt_target_config_init();
    config.role = bytes_.ConsumeIntegralInRange(0u, 3u);
    config.place = bytes_.ConsumeIntegralInRange(0u, 4u);
    config.direction_deg = bytes_.ConsumeFloatingPointInRange(-200.0, 200.0);
    disturb(config);
    hrt_target& slot = targets_[bytes_.ConsumeIntegralInRange<size_t>(0, targets_.size() - 1)];
    const hrt_target before = slot;
    const hrt_result result = hrt_target_add(session(), &config, &slot);
    check(result);
    require(result == HRT_OK || slot.value == before.value);
  }

  void list() {
    hrt_target out[8];
    uint64_t count = 0;
    check(hrt_target_list(session(), bytes_.ConsumeIntegralInRange(0u, 3u), bytes_.ConsumeIntegralInRange(0u, 8u), out,
                          &count));
  }

  void gap() {
    hrt_gap out = hrt_gap_init();
    const hrt_result result = hrt_gap_query(session(), target(), target(), &out);
    check(result);
    if (result == HRT_OK) require_finite(out, offsetof(hrt_gap, gap_deg));
  }

  void begin() {
    hrt_reach_config config = hrt_reach_config_init();
    config.real_target = target();
    config.virtual_target = target();
    config.flags = bytes_.ConsumeIntegralInRange(0u, 4u);
    if (bytes_.ConsumeBool()) disturb(config);
    check(hrt_reach_begin(session(), &config));
  }

  void assign() {
    hrt_target virtuals[3] = {target(), target(), target()}, reals[3] = {target(), target(), target()};
    const uint32_t count = bytes_.ConsumeIntegralInRange(0u, 3u);
    hrt_gap out[3]{hrt_gap_init()};
    const hrt_result result =
        hrt_gap_assign(session(), virtuals, count, reals, bytes_.ConsumeIntegralInRange(0u, 3u),
                       bytes_.ConsumeIntegralInRange(0u, 2u), bytes_.ConsumeIntegralInRange(0u, 3u), out);
    check(result);
    for (uint32_t i = 0; i < 3; ++i) {
      require(result == HRT_OK || out[i].virtual_target.value == 0);
      if (result != HRT_OK || i >= count) continue;
      require_finite(out[i], offsetof(hrt_gap, gap_deg));
      require(out[i].virtual_target.value == virtuals[i].value);
      require((out[i].reachable == 1) == (out[i].real_target.value != 0));
    }
  }

  void state() {
    const hrt_session asked = session();
    uint32_t state = 77;
    const hrt_result result = hrt_session_get(asked, nullptr, &state);
    check(result);
    require(result == HRT_OK ? state < 16 : state == 77);
  }

  void residual() {
    hrt_setup_residual out = hrt_setup_residual_init();
    out.verdict = 77;
    const hrt_result result = hrt_setup_get_residual(session(), bytes_.ConsumeIntegralInRange(0u, 20u), &out);
    check(result);
    require(result == HRT_OK ? out.verdict <= HRT_SLIDE_ALONG_RIDGES : out.verdict == 77);
  }

  // Makes touches and slides at positions from the fuzzer's bytes.
  void set_up() {
    const hrt_session of = session();
    hrt_setup_config config = hrt_setup_config_init();
    disturb(config);
    const uint32_t what = bytes_.ConsumeIntegralInRange(0u, 127u);
    check(hrt_setup_begin(of, what, bytes_.ConsumeBool() ? &config : nullptr));
    hrt_setup_step step = hrt_setup_step_init();
    hrt_setup_result result = hrt_setup_result_init();
    const uint32_t flags = bytes_.ConsumeBool() ? HRT_SAMPLE_PLATE_POSITION : HRT_SAMPLE_WORLD_POSITION;
    for (int place = bytes_.ConsumeIntegralInRange(0, 30); place > 0; --place) {
      hrt_sample sample = hrt_sample_init();
      sample.flags = flags;
      for (double& coordinate_m : sample.finger_position_m)
        coordinate_m = bytes_.ConsumeFloatingPointInRange(-0.1, 0.1);
      disturb(sample);
      for (int i = 0; i < 80; ++i) {
        sample.time_ns = time_ns_ += 11'000'000;
        check(hrt_setup_update(of, &sample, &step));
      }
      require(std::isfinite(step.place_m[0] + step.place_m[2] + step.plate_orientation_deg));
      check(hrt_setup_finish(of, &result));
      require(std::isfinite(result.registration_turn_sd_deg + result.check_distance_m));
      for (const hrt_interval& interval : {result.tactile_weight, result.bias_deg, result.max_gap_deg})
        require(interval.lower <= interval.value && interval.value <= interval.upper);
    }
    if (bytes_.ConsumeBool()) check(hrt_setup_cancel(of));
  }

  void update() {
    hrt_sample sample = hrt_sample_init();
    sample.flags = bytes_.ConsumeBool() ? bytes_.ConsumeIntegralInRange(0u, 128u) : HRT_SAMPLE_PLATE_POSITION;
    time_ns_ += bytes_.ConsumeIntegralInRange(0, 1 << 28);
    sample.time_ns = bytes_.ConsumeIntegralInRange(0, 15) ? time_ns_ : bytes_.ConsumeIntegral<int64_t>();
    sample.finger_direction_deg = bytes_.ConsumeFloatingPointInRange(-181.0, 181.0);
    sample.finger_position_m[0] = bytes_.ConsumeFloatingPointInRange(-0.1, 0.1);
    sample.finger_position_m[2] = bytes_.ConsumeFloatingPointInRange(-0.1, 0.1);
    sample.plate_rotation[3] = 1.0;
    disturb(sample);
    hrt_command command = hrt_command_init();
    command.paper.step = 77;
    const hrt_result result = hrt_reach_update(session(), &sample, &command);
    check(result);
    if (result == HRT_OK)
      require_command(command);
    else
      require(command.paper.step == 77);
  }

  void end() {
    hrt_reach_summary summary = hrt_reach_summary_init();
    const hrt_session ended = session();
    const hrt_result result = hrt_reach_end(ended, &summary);
    check(result);
    if (result != HRT_OK) return;
    require((summary.flags & HRT_COMMAND_FAULT) == 0 && summary.counts.samples >= 0);
    require_finite(summary, offsetof(hrt_reach_summary, bearing_deg));
    // The configuration with the estimates of this reach is valid.
    hrt_session_config config = hrt_session_config_init();
    require(hrt_session_get(ended, &config, nullptr) == HRT_OK);
    require_finite(config.person.mean, 0);
    require_finite(config.person.covariance, 0);
    require(hrt_session_set(ended, &config) == HRT_OK);
  }

  FuzzedDataProvider& bytes_;
  std::array<hrt_session, 2> sessions_{};
  std::array<hrt_target, 4> targets_{};
  int64_t time_ns_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzedDataProvider bytes(data, size);
  Caller caller(bytes);
  for (int calls = 0; calls < 1000 && bytes.remaining_bytes() > 0; ++calls) caller.call();
  return 0;
}
