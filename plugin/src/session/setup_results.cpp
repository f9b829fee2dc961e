#include "plugin/src/session/setup_results.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/calibrate/retest.h"
#include "core/learning.h"

namespace hrt::plugin {
namespace {

// Converts to metres and back: recordings and profiles contain metres, and a replay must use the same value.
double as_read_from_m(double mm) { return mm_per_m * (mm / mm_per_m); }

void apply_noise(const RestNoise& rest, EstimatorConfig* config) {
  const auto noise = known_noise(rest);
  if (!noise) return;
  config->tracker_noise_mm = as_read_from_m(noise->white_mm);
  config->correlated_noise_mm = as_read_from_m(noise->correlated_mm);
  if (noise->correlated_mm > 0.0) config->correlation_s = noise->correlation_s;
}

Interval interval_about(double value, double sd) {
  return {value, value - normal_975 * sd, value + normal_975 * sd, true};
}

Interval believed(const SessionModel& model, PersonState::Index trait) {
  if (!model.knows_person) return {.known = false};
  const PersonBelief& person = model.control.person;
  return interval_about(person.mean(trait), trait_sd(person, trait));
}

void apply_registration(const Registration& found, std::int64_t time_ns, SessionModel* model) {
  Eigen::Quaterniond q(found.rotation);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const Eigen::Vector3d position_m = found.position_mm / mm_per_m;
  model->mount.set_pose(
      {.position_m = {position_m.x(), position_m.y(), position_m.z()}, .orientation = {q.x(), q.y(), q.z(), q.w()}});
  model->mount.scale = found.scale;
  model->control.frame = frame_of_m(frame_in_m(frame_covariance(found)));
  forget_contacts(model);
  model->registration.made = true;
  model->registration.time_ns = time_ns;
}

// Writes the determined parameters of the user and of the tracker's noise into the model. A determined weight or bias
// replaces the estimates from reaches by a prior with this value; if slope, curve, bias and habit are determined, the
// calibration replaces all estimates.
void apply_calibration(const Calibration& calibration, SessionModel* model) {
  const Interval& weight = calibration.tactile_weight;
  Participant& participant = model->control.participant;
  EstimatorConfig& estimator = model->control.estimator;
  const auto apply_weight = [&] {
    if (!weight.known) return;
    participant.tactile_weight = weight.value;
    estimator.tactile_weight_sd =
        std::max(deviation_of_interval(weight.lower, weight.upper), model->control.tuning.min_carried_weight_sd);
  };
  apply_weight();
  if (calibration.bias_deg.known) participant.bias_deg = calibration.bias_deg.value;
  apply_noise(calibration.noise, &estimator);
  if (weight.known || calibration.bias_deg.known) forget_person(model);
  if (!calibration.slope.known || !calibration.curve.known || !calibration.bias_deg.known ||
      !calibration.habit_deg.known)
    return;
  know_person(calibrated_person({.weight = calibration.slope,
                                 .curve = calibration.curve,
                                 .weight_curve_correlation = calibration.slope_curve_correlation,
                                 .bias_deg = calibration.bias_deg,
                                 .habit_deg = calibration.habit_deg}),
              model);
  apply_weight();  // replaces the weight that know_person() has derived
  model->control.reach.bound_deg = calibration.peak_offset_deg;
}

// Writes the correction of the registration. Changes the estimated bias by the mean angle by which the correction
// rotates the bearings of the guides, because reaches had estimated this angle as a bias of the user.
void apply_guides(const TouchedFrame& found, const SetupConfig& config, SessionModel* model) {
  TouchedFrame& touched = model->control.touched;
  double turned = 0.0;
  for (int i = 0; i < config.guide_count; ++i)
    turned += turned_deg(touched, found, config.guides[static_cast<std::size_t>(i)]) / config.guide_count;
  const StateVariable& bias = person_state[PersonState::bias];
  double& believed_deg = model->control.person.mean(PersonState::bias);
  if (model->knows_person) believed_deg = std::clamp(believed_deg + turned, bias.min, bias.max);
  touched = found;
  model->control.start_is_felt = true;
}

void apply_check(const RegistrationCheck& check, std::int64_t time_ns, SessionModel* model) {
  if (check.holds) {
    model->registration.time_ns = time_ns;
  } else {
    model->registration.made = false;
    forget_contacts(model);
  }
}

}  // namespace

Registration registration_of(const SessionModel& model, double touch_sd_mm) {
  const Quaternion& q = model.mount.pose.orientation;
  const Vec3& position_m = model.mount.pose.position_m;
  Registration registration{.verdict = RegistrationVerdict::accepted,
                            .rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix(),
                            .position_mm = mm_per_m * Eigen::Vector3d(position_m.x, position_m.y, position_m.z),
                            .scale = model.mount.scale,
                            .touch_sd_mm = touch_sd_mm};
  const FrameCovariance& plane = model.control.frame;
  const double height_mm2 = 0.5 * (plane(1, 1) + plane(2, 2));
  // Covariance of the position in the plate's axes. `plane` has rotation, right (x) and away (-z).
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

RetestDifference difference(const SessionModel& model, const Calibration& calibration) {
  Interval weight = interval_about(model.control.participant.tactile_weight, model.control.estimator.tactile_weight_sd);
  weight.known = model.knows_person;
  const RepeatedValue values[] = {{weight, calibration.tactile_weight},
                                  {believed(model, PersonState::bias), calibration.bias_deg},
                                  {believed(model, PersonState::habit), calibration.habit_deg}};
  const auto differences = compare(values);
  return {differences[0].differs, differences[1].differs, differences[2].differs};
}

bool apply(const SetupFit& fit, const SetupConfig& config, SessionModel* model) {
  if (fit.fingertip) {
    const Eigen::Vector3d offset_m = fit.fingertip->offset_mm / mm_per_m;
    model->mount.fingertip_offset_m = {offset_m.x(), offset_m.y(), offset_m.z()};
  } else if (fit.registration) {
    apply_registration(*fit.registration, fit.touched_ns, model);
  } else if (fit.check) {
    apply_check(*fit.check, fit.touched_ns, model);
    return fit.check->holds;
  } else if (fit.guided) {
    apply_guides(*fit.guided, config, model);
  } else if (fit.calibration) {
    apply_calibration(*fit.calibration, model);
    return fit.calibration->tactile_weight.known;
  } else {
    return false;
  }
  return true;
}

}  // namespace hrt::plugin
