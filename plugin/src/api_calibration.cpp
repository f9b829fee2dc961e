#include "haptic_retargeting/calibration.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "core/calibration.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/finger_sample.h"
#include "plugin/src/sessions.h"

namespace hrt::plugin {
namespace {

constexpr std::uint32_t least_max_trials = 10;
constexpr std::uint32_t most_max_trials = 10'000;
constexpr std::uint32_t least_max_samples = 100;
constexpr std::uint32_t most_max_samples = 1'000'000;

constexpr hrt_calibration_config default_calibration_config{
    .struct_size = sizeof(hrt_calibration_config),
    .max_trials = 200,
    .max_samples = 100'000,
    .reserved = 0,
    .goal_direction_deg = 0.0,
};

hrt_result check_calibration_config(const hrt_calibration_config& config) {
  HRT_RETURN_IF_FAILED(check_range("max_trials", config.max_trials, least_max_trials, most_max_trials));
  HRT_RETURN_IF_FAILED(check_range("max_samples", config.max_samples, least_max_samples, most_max_samples));
  HRT_RETURN_IF_FAILED(check_zero("reserved", config.reserved));
  return check_range("goal_direction_deg", config.goal_direction_deg, -180.0, 180.0);
}

/// Trials as they are streamed in. Its memory is taken at construction; only solve() takes more.
class StreamedCalibration {
 public:
  /// `under_way` counts the trials under way of all calibrations of the session.
  StreamedCalibration(const hrt_session_config& session_config, const hrt_calibration_config& checked_config,
                      std::shared_ptr<std::atomic<int>> under_way)
      : session_config_(session_config), config_(checked_config), under_way_(std::move(under_way)) {
    trials_.reserve(checked_config.max_trials);
    samples_.reserve(checked_config.max_samples);
  }
  ~StreamedCalibration() {
    if (in_trial_) --*under_way_;
  }
  StreamedCalibration(const StreamedCalibration&) = delete;
  StreamedCalibration& operator=(const StreamedCalibration&) = delete;
  StreamedCalibration(StreamedCalibration&&) = delete;
  StreamedCalibration& operator=(StreamedCalibration&&) = delete;

  hrt_result begin_trial(double plate_orientation_deg) {
    HRT_RETURN_IF_FAILED(check_no_trial());
    HRT_RETURN_IF_FAILED(check_plate_orientation(plate_orientation_deg));
    if (trials_.size() == config_.max_trials)
      return fail(HRT_ERROR_LIMIT_REACHED, "the calibration holds max_trials trials, ", config_.max_trials);
    trials_.push_back({plate_orientation_deg, samples_.size()});
    in_trial_ = true;
    ++*under_way_;
    sampled_ = false;
    return HRT_OK;
  }

  hrt_result add_sample(const hrt_sample& sample) {
    HRT_RETURN_IF_FAILED(check_trial());
    HRT_RETURN_IF_FAILED(check_sample(sample));
    if (sample.flags & HRT_SAMPLE_DIRECTION)
      return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags,
                  "; allowed: PLATE_POSITION or WORLD_POSITION, or none");
    if (sampled_ && sample.time_ns < last_time_ns_)
      return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns,
                  "; allowed: from the last sample's, ", last_time_ns_);
    std::uint32_t command_flags = 0;
    const FingerSample observed = observe(session_config_, sample, &command_flags);
    const bool seen =
        samples_.size() > trials_.back().first_sample && samples_.back().time_ns == sample.time_ns;
    if (observed.observation == Observation::position && !seen) {
      if (samples_.size() == config_.max_samples)
        return fail(HRT_ERROR_LIMIT_REACHED, "the calibration holds max_samples samples, ",
                    config_.max_samples);
      samples_.push_back({observed.time_ns, observed.position});
    }
    sampled_ = true;
    last_time_ns_ = sample.time_ns;
    return HRT_OK;
  }

  hrt_result end_trial() {
    HRT_RETURN_IF_FAILED(check_trial());
    leave_trial();
    return HRT_OK;
  }

  hrt_result cancel_trial() {
    HRT_RETURN_IF_FAILED(check_trial());
    samples_.resize(trials_.back().first_sample);
    trials_.pop_back();
    leave_trial();
    return HRT_OK;
  }

  hrt_result solve(hrt_calibration_result* out) const {
    HRT_RETURN_IF_FAILED(check_no_trial());
    const auto found = calibrate(whole_trials(), {.goal_direction_deg = config_.goal_direction_deg,
                                                  .step_period_ns = session_config_.step_period_ns});
    if (const auto* refusal = std::get_if<CalibrationRefusal>(&found))
      return fail(HRT_ERROR_INSUFFICIENT_DATA, refusal->reason);
    const auto& calibration = std::get<Calibration>(found);
    *out = {
        .struct_size = sizeof *out,
        .reserved = 0,
        .trials = static_cast<std::uint32_t>(trials_.size()),
        .trials_used = static_cast<std::uint32_t>(calibration.chords.size()),
        .tactile_weight = to_abi(calibration.tactile_weight),
        .bias_deg = to_abi(calibration.bias_deg),
        .motor_variance_deg2 = to_abi(calibration.motor_variance_deg2),
        .sensory_variance_deg2 = to_abi(calibration.sensory_variance_deg2),
        .tracker_noise_m = to_abi(calibration.tracker_noise_m),
    };
    return HRT_OK;
  }

 private:
  void leave_trial() {
    in_trial_ = false;
    --*under_way_;
  }

  struct Trial {
    double plate_orientation_deg;
    std::size_t first_sample;
  };

  hrt_result check_trial() const {
    return in_trial_ ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no trial is under way; begin one first");
  }
  hrt_result check_no_trial() const {
    return in_trial_ ? fail(HRT_ERROR_WRONG_STATE, "a trial is under way; end it first") : HRT_OK;
  }

  static hrt_interval to_abi(const Interval& interval) {
    return {interval.value, interval.lower, interval.upper, interval.known ? 1u : 0u, 0};
  }

  std::vector<CalibrationTrial> whole_trials() const {
    std::vector<CalibrationTrial> whole;
    whole.reserve(trials_.size());
    for (std::size_t i = 0; i < trials_.size(); ++i) {
      const std::size_t end = i + 1 < trials_.size() ? trials_[i + 1].first_sample : samples_.size();
      whole.push_back({trials_[i].plate_orientation_deg,
                       {samples_.begin() + static_cast<std::ptrdiff_t>(trials_[i].first_sample),
                        samples_.begin() + static_cast<std::ptrdiff_t>(end)}});
    }
    return whole;
  }

  hrt_session_config session_config_;
  hrt_calibration_config config_;
  std::shared_ptr<std::atomic<int>> under_way_;
  std::vector<Trial> trials_;
  std::vector<TimedPoint> samples_;  // of all trials, one after another
  bool in_trial_ = false;
  bool sampled_ = false;  // the trial has had a sample
  std::int64_t last_time_ns_ = 0;
};

using Calibrations = HandleTable<StreamedCalibration, HRT_CALIBRATIONS_MAX, 0xca>;
constinit Calibrations calibrations;

template <class Body>
hrt_result with_calibration(const char* call, hrt_calibration handle, Body&& body) noexcept {
  return with_lease(call, "calibration", calibrations, handle.value, body);
}

hrt_result check_interval(const char* field, const hrt_interval& interval) {
  if (interval.known > 1)
    return fail(HRT_ERROR_OUT_OF_RANGE, field, ".known is ", interval.known, "; allowed: 0 and 1");
  HRT_RETURN_IF_FAILED(check_zero("an interval's reserved", interval.reserved));
  if (interval.known == 0 || (interval.lower <= interval.value && interval.value <= interval.upper))
    return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, field, " is ", interval.value, " in an interval from ", interval.lower,
              " to ", interval.upper, "; allowed: a value within its interval");
}

double sd_of(const hrt_interval& interval) {
  return deviation_of_interval(interval.lower, interval.upper);
}

// What a checked result makes of a configuration.
hrt_session_config calibrated(hrt_session_config config, const hrt_calibration_result& result) {
  if (result.tactile_weight.known) {
    config.tactile_weight = result.tactile_weight.value;
    config.tactile_weight_sd = std::max(sd_of(result.tactile_weight), least_carried_weight_sd);
  }
  if (result.bias_deg.known) config.bias_deg = result.bias_deg.value;
  if (result.motor_variance_deg2.known) {
    config.motor_variance_deg2 = result.motor_variance_deg2.value;
    config.motor_variance_sd_deg2 =
        std::max(sd_of(result.motor_variance_deg2), least_carried_motor_variance_sd_deg2);
  }
  if (result.sensory_variance_deg2.known) config.sensory_variance_deg2 = result.sensory_variance_deg2.value;
  if (result.tracker_noise_m.known) config.tracker_noise_m = result.tracker_noise_m.value;
  // What reaches have learnt would override the weight and the bias.
  if (result.tactile_weight.known || result.bias_deg.known) forget_person(&config);
  return config;
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_calibration_config_default(hrt_calibration_config* out_config, uint32_t struct_size) noexcept {
  return guarded("hrt_calibration_config_default", [&] {
    return write_default("out_config", default_calibration_config, out_config, struct_size);
  });
}

hrt_result hrt_calibration_create(hrt_session session, const hrt_calibration_config* config,
                                  hrt_calibration* out_calibration) noexcept {
  return with_session("hrt_calibration_create", session, [&](RecordedSession& s) -> hrt_result {
    if (!out_calibration) return fail(HRT_ERROR_NULL_ARGUMENT, "out_calibration is null");
    hrt_calibration_config checked = default_calibration_config;
    HRT_RETURN_IF_FAILED(read_struct("config", config, &checked));
    HRT_RETURN_IF_FAILED(check_calibration_config(checked));
    const std::uint64_t handle =
        calibrations.insert(std::make_unique<StreamedCalibration>(s.session().config(), checked, s.trials()));
    if (handle == 0)
      return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_CALIBRATIONS_MAX,
                  " calibrations; destroy one first");
    out_calibration->value = handle;
    return HRT_OK;
  });
}

hrt_result hrt_calibration_destroy(hrt_calibration calibration) noexcept {
  return destroy("hrt_calibration_destroy", "calibration", calibrations, calibration.value);
}

hrt_result hrt_calibration_begin_trial(hrt_calibration calibration, double plate_orientation_deg) noexcept {
  return with_calibration("hrt_calibration_begin_trial", calibration,
                          [&](StreamedCalibration& c) { return c.begin_trial(plate_orientation_deg); });
}

hrt_result hrt_calibration_add_sample(hrt_calibration calibration, const hrt_sample* sample) noexcept {
  return with_calibration("hrt_calibration_add_sample", calibration,
                          [&](StreamedCalibration& c) -> hrt_result {
                            hrt_sample known{};
                            HRT_RETURN_IF_FAILED(read_struct("sample", sample, &known));
                            return c.add_sample(known);
                          });
}

hrt_result hrt_calibration_end_trial(hrt_calibration calibration) noexcept {
  return with_calibration("hrt_calibration_end_trial", calibration,
                          [](StreamedCalibration& c) { return c.end_trial(); });
}

hrt_result hrt_calibration_cancel_trial(hrt_calibration calibration) noexcept {
  return with_calibration("hrt_calibration_cancel_trial", calibration,
                          [](StreamedCalibration& c) { return c.cancel_trial(); });
}

hrt_result hrt_calibration_solve(hrt_calibration calibration, hrt_calibration_result* out_result) noexcept {
  return with_calibration("hrt_calibration_solve", calibration, [&](StreamedCalibration& c) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_result", out_result));
    hrt_calibration_result result{};
    HRT_RETURN_IF_FAILED(c.solve(&result));
    write_struct(result, out_result);
    return HRT_OK;
  });
}

hrt_result hrt_calibration_apply(hrt_session session, const hrt_calibration_result* result) noexcept {
  return with_session("hrt_calibration_apply", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_no_reach());
    hrt_calibration_result known{};
    HRT_RETURN_IF_FAILED(read_struct("result", result, &known));
    HRT_RETURN_IF_FAILED(check_interval("tactile_weight", known.tactile_weight));
    HRT_RETURN_IF_FAILED(check_interval("bias_deg", known.bias_deg));
    HRT_RETURN_IF_FAILED(check_interval("motor_variance_deg2", known.motor_variance_deg2));
    HRT_RETURN_IF_FAILED(check_interval("sensory_variance_deg2", known.sensory_variance_deg2));
    HRT_RETURN_IF_FAILED(check_interval("tracker_noise_m", known.tracker_noise_m));
    const hrt_session_config config = calibrated(s.session().config(), known);
    HRT_RETURN_IF_FAILED(check_session_config(config));
    return s.set_config(config);
  });
}
