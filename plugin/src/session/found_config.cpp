#include "plugin/src/session/found_config.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/calibrate/retest.h"
#include "core/learning.h"
#include "core/person/person_belief.h"
#include "core/plate/frame_error.h"
#include "plugin/src/session/contact.h"
#include "plugin/src/session/session_config.h"
#include "plugin/src/session/triangle.h"

namespace hrt::plugin {
namespace {

void write_noise(const RestNoise& rest, hrt_session_config* config) {
  const auto noise = known_noise(rest);
  if (!noise) return;
  config->tracker.noise_m = noise->white_mm / mm_per_m;
  config->tracker.correlated_noise_m = noise->correlated_mm / mm_per_m;
  if (noise->correlated_mm > 0.0) config->tracker.correlation_s = noise->correlation_s;
}

Interval interval_about(double value, double sd) {
  return {value, value - normal_975 * sd, value + normal_975 * sd, true};
}

Interval believed_trait(const hrt_session_config& config, int trait) {
  if (!knows_person(config)) return {.known = false};
  const Square<HRT_PERSON_TRAITS> covariance = from_triangle<HRT_PERSON_TRAITS>(config.person.covariance);
  return interval_about(config.person.mean[trait], std::sqrt(covariance(trait, trait)));
}

}  // namespace

void write_registration(const Registration& registration, std::int64_t time_ns, hrt_session_config* config) {
  Eigen::Quaterniond q(registration.rotation);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  for (int i = 0; i < 3; ++i) config->plate.position_m[i] = registration.position_mm(i) / mm_per_m;
  for (int i = 0; i < 4; ++i) config->plate.rotation[i] = q.coeffs()(i);
  config->plate.scale = registration.scale;
  write_frame_covariance(frame_covariance(registration), config);
  forget_contacts(config);
  config->registration.time_ns = time_ns;
  config->flags |= HRT_SESSION_REGISTERED;
}

Registration registration_of(const hrt_session_config& config, double touch_sd_mm) {
  const double(&q)[4] = config.plate.rotation;
  Registration registration{.verdict = RegistrationVerdict::holds,
                            .rotation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix(),
                            .position_mm = mm_per_m * Eigen::Vector3d::Map(config.plate.position_m),
                            .scale = config.plate.scale,
                            .touch_sd_mm = touch_sd_mm};
  const FrameCovariance plane = frame_covariance_of(config);
  const double height_mm2 = 0.5 * (plane(1, 1) + plane(2, 2));
  // The turn, and the place to the right and away (-z), in the plate's axes.
  Eigen::Matrix3d place_mm2 = height_mm2 * Eigen::Matrix3d::Identity();
  place_mm2(0, 0) = plane(1, 1);
  place_mm2(2, 2) = plane(2, 2);
  place_mm2(0, 2) = place_mm2(2, 0) = -plane(1, 2);
  const Eigen::Matrix3d& turned = registration.rotation;
  registration.covariance.diagonal().head<3>().setConstant(plane(0, 0));
  registration.covariance.block<3, 3>(3, 3) = turned * place_mm2 * turned.transpose();
  const Eigen::Vector3d turn_by_place = turned * Eigen::Vector3d(plane(0, 1), 0.0, -plane(0, 2));
  registration.covariance.block<1, 3>(1, 3) = turn_by_place.transpose();
  registration.covariance.block<3, 1>(3, 1) = turn_by_place;
  return registration;
}

void write_calibration(const Calibration& calibration, hrt_session_config* config) {
  const Interval& weight = calibration.tactile_weight;
  const auto write_weight = [&] {
    if (!weight.known) return;
    config->paper.tactile_weight = weight.value;
    config->paper.tactile_weight_sd =
        std::max(deviation_of_interval(weight.lower, weight.upper), min_carried_weight_sd);
  };
  write_weight();
  if (calibration.bias_deg.known) config->paper.bias_deg = calibration.bias_deg.value;
  write_noise(calibration.noise, config);
  // What reaches have learnt would override the weight and the bias.
  if (weight.known || calibration.bias_deg.known) forget_person(config);
  if (!calibration.slope.known || !calibration.curve.known || !calibration.bias_deg.known ||
      !calibration.habit_deg.known)
    return;
  write_person(calibrated_person({.weight = calibration.slope,
                                  .curve = calibration.curve,
                                  .weight_curve_correlation = calibration.slope_curve_correlation,
                                  .bias_deg = calibration.bias_deg,
                                  .habit_deg = calibration.habit_deg}),
               config);
  write_weight();  // at 60 degrees, of whatever curve
  config->motion_bound_deg = calibration.peak_offset_deg;
}

std::uint32_t differing_from(const hrt_session_config& believed, const Calibration& calibration) {
  Interval weight = interval_about(believed.paper.tactile_weight, believed.paper.tactile_weight_sd);
  weight.known = knows_person(believed);
  const RepeatedValue values[] = {{weight, calibration.tactile_weight},
                                  {believed_trait(believed, HRT_PERSON_BIAS), calibration.bias_deg},
                                  {believed_trait(believed, HRT_PERSON_HABIT), calibration.habit_deg}};
  const auto differences = compare(values);
  return (differences[0].differs ? HRT_RETEST_TACTILE_WEIGHT : 0) | (differences[1].differs ? HRT_RETEST_BIAS : 0) |
         (differences[2].differs ? HRT_RETEST_HABIT : 0);
}

}  // namespace hrt::plugin
