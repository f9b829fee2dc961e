#include "plugin/src/session/streamed_calibration.h"

#include <algorithm>
#include <utility>

#include "core/calibrate/slide_plan.h"
#include "core/math/trigonometry.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/finger_sample.h"

namespace hrt::plugin {
namespace {

constexpr double min_plate_range_deg = 40.0;

std::uint32_t illusion_of(const Calibration& calibration) {
  return calibration.lack_of_fit.angle_p < min_fit_p
             ? HRT_ILLUSION_NONE
             : static_cast<std::uint32_t>(calibration.illusion.family);
}

std::uint32_t lack_of_fit_flags(const LackOfFit& lack) {
  return (lack.angle_p < min_fit_p ? HRT_LACK_OF_FIT_ANGLE : 0) |
         (lack.order_p < min_fit_p ? HRT_LACK_OF_FIT_ORDER : 0) |
         (lack.path_p < min_fit_p ? HRT_LACK_OF_FIT_PATH : 0);
}

double scale_of(const IllusionCurve& curve) {
  const bool scaled = curve.family == CurveFamily::saturating || curve.family == CurveFamily::tanh ||
                      curve.family == CurveFamily::dead_band;
  return scaled ? curve.second : 0.0;
}

hrt_interval to_abi(const Interval& interval) {
  return {interval.value, interval.lower, interval.upper, interval.known ? 1u : 0u, 0};
}

}  // namespace

hrt_result check_calibration_config(const hrt_calibration_config& config) {
  HRT_RETURN_IF_FAILED(check_fields(config));
  if (config.upper_plate_deg - config.lower_plate_deg >= min_plate_range_deg) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "upper_plate_deg is ", config.upper_plate_deg,
              "; allowed: at least 40 above lower_plate_deg, ", config.lower_plate_deg);
}

StreamedCalibration::StreamedCalibration(const hrt_session_config& session_config,
                                         const hrt_calibration_config& checked_config,
                                         std::shared_ptr<std::atomic<int>> under_way)
    : session_config_(session_config), config_(checked_config), under_way_(std::move(under_way)) {
  trials_.reserve(checked_config.max_trials);
  samples_.reserve(checked_config.max_samples);
  plate_deg_.reserve(checked_config.max_samples);
}

StreamedCalibration::~StreamedCalibration() {
  if (in_trial_) --*under_way_;
}

hrt_result StreamedCalibration::begin_trial(double plate_orientation_deg) {
  HRT_RETURN_IF_FAILED(check_no_trial());
  HRT_RETURN_IF_FAILED(
      check_value("plate_orientation_deg", Fields<hrt_sample>::plate_orientation_deg, plate_orientation_deg));
  if (trials_.size() == config_.max_trials)
    return fail(HRT_ERROR_LIMIT_REACHED, "the calibration holds max_trials trials, ", config_.max_trials);
  trials_.push_back({plate_orientation_deg, samples_.size()});
  in_trial_ = true;
  ++*under_way_;
  sampled_ = false;
  now_plate_deg_ = plate_orientation_deg;
  return HRT_OK;
}

hrt_result StreamedCalibration::add_sample(const hrt_sample& sample) {
  HRT_RETURN_IF_FAILED(check_trial());
  HRT_RETURN_IF_FAILED(check_sample(sample));
  if (sample.flags & HRT_SAMPLE_DIRECTION)
    return fail(HRT_ERROR_OUT_OF_RANGE, "flags is ", sample.flags,
                "; allowed: PLATE_POSITION or WORLD_POSITION, or none");
  if (sampled_ && sample.time_ns < last_time_ns_)
    return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns, "; allowed: from the last sample's, ",
                last_time_ns_);
  std::uint32_t command_flags = 0;
  const FingerSample observed = observe(session_config_, sample, &command_flags);
  const bool seen =
      samples_.size() > trials_.back().first_sample && samples_.back().time_ns == sample.time_ns;
  if (observed.observation == Observation::position && !seen) {
    if (samples_.size() == config_.max_samples)
      return fail(HRT_ERROR_LIMIT_REACHED, "the calibration holds max_samples samples, ",
                  config_.max_samples);
    // Ridges are the same after half a turn, and a plate does not jump.
    if (observed.plate_orientation_deg)
      now_plate_deg_ += wrap_deg(*observed.plate_orientation_deg - now_plate_deg_, 180.0);
    samples_.push_back({observed.time_ns, observed.position});
    plate_deg_.push_back(now_plate_deg_);
  }
  sampled_ = true;
  last_time_ns_ = sample.time_ns;
  return HRT_OK;
}

hrt_result StreamedCalibration::end_trial() {
  HRT_RETURN_IF_FAILED(check_trial());
  leave_trial();
  return HRT_OK;
}

hrt_result StreamedCalibration::cancel_trial() {
  HRT_RETURN_IF_FAILED(check_trial());
  samples_.resize(trials_.back().first_sample);
  plate_deg_.resize(trials_.back().first_sample);
  trials_.pop_back();
  leave_trial();
  return HRT_OK;
}

hrt_result StreamedCalibration::next_angle(double* out_plate_orientation_deg,
                                           std::uint32_t* out_enough) const {
  HRT_RETURN_IF_FAILED(check_no_trial());
  const NextSlide next =
      next_slide(whole_trials(), config_.goal_direction_deg,
                 {config_.lower_plate_deg, config_.upper_plate_deg, config_.enough_weight_width});
  *out_plate_orientation_deg = config_.goal_direction_deg + next.plate_deg;
  *out_enough = next.enough ? 1 : 0;
  return HRT_OK;
}

hrt_result StreamedCalibration::solve(hrt_calibration_result* out) {
  HRT_RETURN_IF_FAILED(check_no_trial());
  auto found = calibrate(whole_trials(), config_.goal_direction_deg);
  if (const auto* refusal = std::get_if<CalibrationRefusal>(&found))
    return fail(HRT_ERROR_INSUFFICIENT_DATA, refusal->reason);
  auto& calibration = std::get<Calibration>(found);
  *out = {
      .struct_size = sizeof *out,
      .slides_turning = static_cast<std::uint32_t>(calibration.slides_turned),
      .trials = static_cast<std::uint32_t>(trials_.size()),
      .trials_used = static_cast<std::uint32_t>(calibration.slides.size()),
      .tactile_weight = to_abi(calibration.tactile_weight),
      .bias_deg = to_abi(calibration.bias_deg),
      .tracker_noise_m = to_abi(calibration.noise.white_m),
      .illusion = illusion_of(calibration),
      .lack_of_fit = lack_of_fit_flags(calibration.lack_of_fit),
      .slides_outlying = static_cast<std::uint32_t>(calibration.count(SlideVerdict::outlying)),
      .slides_along_ridges = static_cast<std::uint32_t>(calibration.count(SlideVerdict::along_ridges)),
      .illusion_scale_deg = scale_of(calibration.illusion),
      .peak_offset_deg = calibration.peak_offset_deg,
      .person_weight = to_abi(calibration.slope),
      .person_curve = to_abi(calibration.curve),
      .weight_curve_correlation = calibration.slope_curve_correlation,
      .max_gap_deg = to_abi(calibration.max_gap_deg),
      .habit_deg = to_abi(calibration.habit_deg),
      .correlated_noise_m = to_abi(calibration.noise.correlated_m),
      .noise_correlation_s = to_abi(calibration.noise.correlation_s),
      .angle_p = calibration.lack_of_fit.angle_p,
      .order_p = calibration.lack_of_fit.order_p,
      .path_p = calibration.lack_of_fit.path_p,
  };
  solved_ = std::move(calibration.slides);
  return HRT_OK;
}

hrt_result StreamedCalibration::get_residual(std::uint32_t slide, hrt_calibration_slide* out) const {
  if (solved_.empty())
    return fail(HRT_ERROR_WRONG_STATE, "the calibration has no solution; call hrt_calibration_solve() first");
  if (slide >= solved_.size())
    return fail(HRT_ERROR_OUT_OF_RANGE, "slide is ", slide, "; allowed: 0 to ", solved_.size() - 1);
  const CalibratedSlide& solved = solved_[slide];
  const double direction_deg = settled_direction_deg(solved.parts_deg);
  const double fitted_deg = settled_direction_deg(solved.fitted_deg);
  *out = {.struct_size = sizeof *out,
          .verdict = static_cast<std::uint32_t>(solved.verdict),
          .trial = static_cast<std::uint32_t>(solved.trial),
          .reserved = 0,
          .plate_deg = solved.plate_deg,
          .direction_deg = direction_deg,
          .fitted_deg = fitted_deg,
          .residual_deg = direction_deg - fitted_deg};
  return HRT_OK;
}

void StreamedCalibration::leave_trial() {
  in_trial_ = false;
  --*under_way_;
}

hrt_result StreamedCalibration::check_trial() const {
  return in_trial_ ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no trial is under way; begin one first");
}

hrt_result StreamedCalibration::check_no_trial() const {
  return in_trial_ ? fail(HRT_ERROR_WRONG_STATE, "a trial is under way; end it first") : HRT_OK;
}

std::vector<CalibrationTrial> StreamedCalibration::whole_trials() const {
  std::vector<CalibrationTrial> whole;
  whole.reserve(trials_.size());
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    const auto first = static_cast<std::ptrdiff_t>(trials_[i].first_sample);
    const auto end =
        static_cast<std::ptrdiff_t>(i + 1 < trials_.size() ? trials_[i + 1].first_sample : samples_.size());
    whole.push_back({.plate_orientation_deg = trials_[i].plate_orientation_deg,
                     .samples = {samples_.begin() + first, samples_.begin() + end},
                     .plate_deg = {plate_deg_.begin() + first, plate_deg_.begin() + end}});
  }
  return whole;
}

}  // namespace hrt::plugin
