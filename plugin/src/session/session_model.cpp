#include "plugin/src/session/session_model.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt::plugin {
namespace {

bool has(const Range& range, const Vec3& v) { return range.has(v.x) && range.has(v.y) && range.has(v.z); }

bool are_same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

// Factors that convert a covariance of rotation (radians) and position (metres) to millimetres.
Eigen::Matrix3d mm_by_m() {
  const Eigen::Vector3d units{1.0, mm_per_m, mm_per_m};
  return units * units.transpose();
}

}  // namespace

bool have_same_pose(const PlateMount& a, const PlateMount& b) {
  const Quaternion &p = a.pose.orientation, &q = b.pose.orientation;
  return are_same(a.pose.position_m, b.pose.position_m) && p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w &&
         a.scale == b.scale;
}

bool is_valid(const SessionModel& model) {
  const RetargeterConfig& control = model.control;
  const EstimatorConfig& estimator = control.estimator;
  const PlateMount& mount = model.mount;
  return is_valid(control) && weight_range.has(control.participant.tactile_weight) &&
         weight_sd_range.has(estimator.tactile_weight_sd) && bias_range_deg.has(control.participant.bias_deg) &&
         motion_bound_range_deg.has(control.reach.bound_deg) && noise_range_mm.has(estimator.tracker_noise_mm) &&
         noise_range_mm.has(estimator.correlated_noise_mm) && is_unit(mount.pose.orientation) &&
         scale_range.has(mount.scale) && has(position_range_m, mount.pose.position_m) &&
         has(fingertip_range_m, mount.fingertip_offset_m);
}

void forget_person(SessionModel* model) {
  RetargeterConfig& control = model->control;
  const double weight = control.participant.tactile_weight, bias_deg = control.participant.bias_deg;
  model->knows_person = false;
  control.person = model->adaptation == Adaptation::off
                       ? known_person(weight, bias_deg)
                       : unknown_person(weight, control.estimator.tactile_weight_sd, bias_deg);
}

void forget_user(const SessionModel& defaults, SessionModel* model) {
  model->control.participant = defaults.control.participant;
  model->control.estimator.tactile_weight_sd = defaults.control.estimator.tactile_weight_sd;
  model->control.estimator.motor_variance_sd_deg2 = defaults.control.estimator.motor_variance_sd_deg2;
  model->control.reach.bound_deg = defaults.control.reach.bound_deg;
  model->mount.fingertip_offset_m = defaults.mount.fingertip_offset_m;
  forget_person(model);
}

void know_person(const PersonBelief& belief, SessionModel* model) {
  const LinearIllusion linear = linear_illusion(belief, model->control.tuning);
  model->control.person = belief;
  model->knows_person = true;
  model->control.participant.tactile_weight = linear.weight;
  model->control.estimator.tactile_weight_sd = std::clamp(linear.weight_sd, weight_sd_range.low, weight_sd_range.high);
}

Illusion illusion_of(const SessionModel& model, double distance_mm) {
  if (!model.knows_person) return {model.control.participant.tactile_weight, 0.0};
  const PersonBelief::Vector& mean = model.control.person.mean;
  const double speed_mm_s = distance_mm * exponential(mean(PersonState::log_rate));
  return {mean(PersonState::weight), mean(PersonState::curve), mean(PersonState::fading),
          slowness(speed_mm_s, distance_mm, model.control.tuning)};
}

void forget_contacts(SessionModel* model) { model->control.touched = {.home = start_of(*model)}; }

void take_contacts_of_profile(const SessionModel& session, bool has_contacts, SessionModel* profile) {
  TouchedFrame& touched = profile->control.touched;
  if (!has_contacts) {
    touched = session.control.touched;
  } else if (have_same_pose(session.mount, profile->mount)) {
    if (touched.known()) touched = drifted(touched);
  } else {
    forget_contacts(profile);
  }
  profile->mount.set_pose(session.mount.pose);
  profile->mount.scale = session.mount.scale;
}

FrameCovariance frame_of_m(const Eigen::Matrix3d& covariance_m) { return covariance_m.cwiseProduct(mm_by_m()); }

Eigen::Matrix3d frame_in_m(const FrameCovariance& covariance) { return covariance.cwiseQuotient(mm_by_m()); }

}  // namespace hrt::plugin
