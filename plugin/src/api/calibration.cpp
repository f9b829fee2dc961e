#include "haptic_retargeting/calibration.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/calibrate/retest.h"
#include "core/learning.h"
#include "core/person/calibrated_person.h"
#include "core/tracker/tracker_noise.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/sessions.h"
#include "plugin/src/recording/recorded_calibration.h"

namespace hrt::plugin {

namespace {

using Calibrations = HandleTable<RecordedCalibration, HRT_CALIBRATIONS_MAX, 0xca>;
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

bool describes_person(const hrt_calibration_result& result) {
  return result.person_weight.known && result.person_curve.known && result.bias_deg.known &&
         result.habit_deg.known;
}

Interval from_abi(const hrt_interval& interval) {
  return {interval.value, interval.lower, interval.upper, interval.known != 0};
}

void write_noise(const hrt_calibration_result& result, hrt_session_config* config) {
  const auto noise = known_noise({.white_m = from_abi(result.tracker_noise_m),
                                  .correlated_m = from_abi(result.correlated_noise_m),
                                  .correlation_s = from_abi(result.noise_correlation_s)});
  if (!noise) return;
  config->tracker_noise_m = noise->white_m;
  config->tracker_correlated_noise_m = noise->correlated_m;
  if (noise->correlated_m > 0.0) config->tracker_correlation_s = noise->correlation_s;
}

// What a checked result makes of a configuration.
hrt_session_config calibrated(hrt_session_config config, const hrt_calibration_result& result) {
  if (result.tactile_weight.known) {
    config.tactile_weight = result.tactile_weight.value;
    config.tactile_weight_sd = std::max(sd_of(result.tactile_weight), min_carried_weight_sd);
  }
  if (result.bias_deg.known) config.bias_deg = result.bias_deg.value;
  write_noise(result, &config);
  // What reaches have learnt would override the weight and the bias.
  if (result.tactile_weight.known || result.bias_deg.known) forget_person(&config);
  if (describes_person(result)) {
    const double weight = config.tactile_weight;
    const double weight_sd = config.tactile_weight_sd;
    write_person(calibrated_person({.weight = from_abi(result.person_weight),
                                    .curve = from_abi(result.person_curve),
                                    .weight_curve_correlation = result.weight_curve_correlation,
                                    .bias_deg = from_abi(result.bias_deg),
                                    .habit_deg = from_abi(result.habit_deg)}),
                 &config);
    if (result.tactile_weight.known) {
      config.tactile_weight = weight;
      config.tactile_weight_sd = weight_sd;
    }
    config.motion_bound_deg = result.peak_offset_deg;
  }
  return config;
}

hrt_result check_calibration_result(const hrt_calibration_result& result) {
  const std::pair<const char*, const hrt_interval&> intervals[] = {
      {"tactile_weight", result.tactile_weight},
      {"bias_deg", result.bias_deg},
      {"tracker_noise_m", result.tracker_noise_m},
      {"correlated_noise_m", result.correlated_noise_m},
      {"noise_correlation_s", result.noise_correlation_s},
      {"person_weight", result.person_weight},
      {"person_curve", result.person_curve},
      {"habit_deg", result.habit_deg},
  };
  for (const auto& [name, interval] : intervals) HRT_RETURN_IF_FAILED(check_interval(name, interval));
  if (!describes_person(result)) return HRT_OK;
  HRT_RETURN_IF_FAILED(
      check_value("peak_offset_deg", Fields<hrt_session_config>::motion_bound_deg, result.peak_offset_deg));
  return check_range("weight_curve_correlation", result.weight_curve_correlation, -1.0, 1.0);
}

// A value that can be compared, what its difference is called, and its flag.
struct ComparedValue {
  const char* name;
  hrt_interval hrt_calibration_result::* value;
  hrt_interval hrt_calibration_comparison::* difference;
  std::uint32_t flag;
};
using R = hrt_calibration_result;
using D = hrt_calibration_comparison;
constexpr ComparedValue compared_values[] = {
    {"tactile_weight", &R::tactile_weight, &D::tactile_weight, HRT_DIFFERS_TACTILE_WEIGHT},
    {"max_gap_deg", &R::max_gap_deg, &D::max_gap_deg, HRT_DIFFERS_MAX_GAP},
    {"bias_deg", &R::bias_deg, &D::bias_deg, HRT_DIFFERS_BIAS},
    {"habit_deg", &R::habit_deg, &D::habit_deg, HRT_DIFFERS_HABIT},
    {"tracker_noise_m", &R::tracker_noise_m, &D::tracker_noise_m, HRT_DIFFERS_TRACKER_NOISE},
};

// An unknown value may be anything.
hrt_result check_compared(const hrt_calibration_result& result) {
  for (const ComparedValue& value : compared_values) {
    const hrt_interval& interval = result.*value.value;
    HRT_RETURN_IF_FAILED(check_interval(value.name, interval));
    if (interval.known == 0) continue;
    constexpr double max = 1e6;
    HRT_RETURN_IF_FAILED(check_range(value.name, interval.lower, -max, max));
    HRT_RETURN_IF_FAILED(check_range(value.name, interval.upper, -max, max));
  }
  return HRT_OK;
}

hrt_calibration_comparison compared(const hrt_calibration_result& first,
                                    const hrt_calibration_result& second) {
  std::vector<RepeatedValue> values;
  for (const ComparedValue& value : compared_values)
    values.push_back({from_abi(first.*value.value), from_abi(second.*value.value)});
  hrt_calibration_comparison comparison{};
  comparison.struct_size = sizeof comparison;
  const auto differences = compare(values);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const Interval& difference = differences[i].difference;
    if (difference.known)
      comparison.*
          compared_values[i].difference = {difference.value, difference.lower, difference.upper, 1, 0};
    if (differences[i].differs) comparison.differing |= compared_values[i].flag;
  }
  return comparison;
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_calibration_create(hrt_session session, const hrt_calibration_config* config,
                                  hrt_calibration* out_calibration) noexcept {
  return with_session("hrt_calibration_create", session, [&](RecordedSession& s) -> hrt_result {
    if (!out_calibration) return fail(HRT_ERROR_NULL_ARGUMENT, "out_calibration is null");
    hrt_calibration_config checked;
    HRT_RETURN_IF_FAILED(read_configuration("config", config, &checked));
    HRT_RETURN_IF_FAILED(check_calibration_config(checked));
    const std::uint64_t handle = calibrations.insert(s.make_calibration(checked));
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
                          [&](RecordedCalibration& c) { return c.begin_trial(plate_orientation_deg); });
}

hrt_result hrt_calibration_add_sample(hrt_calibration calibration, const hrt_sample* sample) noexcept {
  return with_calibration("hrt_calibration_add_sample", calibration,
                          [&](RecordedCalibration& c) -> hrt_result {
                            hrt_sample known{};
                            HRT_RETURN_IF_FAILED(read_struct("sample", sample, &known));
                            return c.add_sample(known);
                          });
}

hrt_result hrt_calibration_end_trial(hrt_calibration calibration, uint32_t keep) noexcept {
  return with_calibration("hrt_calibration_end_trial", calibration,
                          [&](RecordedCalibration& c) -> hrt_result {
                            HRT_RETURN_IF_FAILED(check_range<std::uint32_t>("keep", keep, 0, 1));
                            return keep == 1 ? c.end_trial() : c.cancel_trial();
                          });
}

hrt_result hrt_calibration_solve(hrt_calibration calibration, hrt_calibration_result* out_result) noexcept {
  return with_calibration("hrt_calibration_solve", calibration, [&](RecordedCalibration& c) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_result", out_result));
    hrt_calibration_result result{};
    HRT_RETURN_IF_FAILED(c.solve(&result));
    write_struct(result, out_result);
    return HRT_OK;
  });
}

hrt_result hrt_calibration_next_angle(hrt_calibration calibration, double* out_plate_orientation_deg,
                                      uint32_t* out_enough) noexcept {
  return with_calibration("hrt_calibration_next_angle", calibration,
                          [&](RecordedCalibration& c) -> hrt_result {
                            if (!out_plate_orientation_deg)
                              return fail(HRT_ERROR_NULL_ARGUMENT, "out_plate_orientation_deg is null");
                            if (!out_enough) return fail(HRT_ERROR_NULL_ARGUMENT, "out_enough is null");
                            return c.next_angle(out_plate_orientation_deg, out_enough);
                          });
}

hrt_result hrt_calibration_get_residual(hrt_calibration calibration, uint32_t slide,
                                        hrt_calibration_slide* out_slide) noexcept {
  return with_calibration("hrt_calibration_get_residual", calibration,
                          [&](RecordedCalibration& c) -> hrt_result {
                            HRT_RETURN_IF_FAILED(check_output("out_slide", out_slide));
                            hrt_calibration_slide known{};
                            HRT_RETURN_IF_FAILED(c.get_residual(slide, &known));
                            write_struct(known, out_slide);
                            return HRT_OK;
                          });
}

hrt_result hrt_calibration_compare(const hrt_calibration_result* first, const hrt_calibration_result* second,
                                   hrt_calibration_comparison* out_comparison) noexcept {
  return guarded("hrt_calibration_compare", [&]() -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_comparison", out_comparison));
    hrt_calibration_result known_first{}, known_second{};
    HRT_RETURN_IF_FAILED(read_struct("first", first, &known_first));
    HRT_RETURN_IF_FAILED(read_struct("second", second, &known_second));
    HRT_RETURN_IF_FAILED(check_compared(known_first));
    HRT_RETURN_IF_FAILED(check_compared(known_second));
    write_struct(compared(known_first, known_second), out_comparison);
    return HRT_OK;
  });
}

hrt_result hrt_calibration_apply(hrt_session session, const hrt_calibration_result* result) noexcept {
  return with_session("hrt_calibration_apply", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.session().check_no_reach());
    hrt_calibration_result known{};
    HRT_RETURN_IF_FAILED(read_struct("result", result, &known));
    HRT_RETURN_IF_FAILED(check_calibration_result(known));
    const hrt_session_config config = calibrated(s.session().config(), known);
    HRT_RETURN_IF_FAILED(check_session_config(config));
    HRT_RETURN_IF_FAILED(s.set_config(config));
    s.conditions.measured_now();
    return HRT_OK;
  });
}
