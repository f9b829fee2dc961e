#include "plugin/src/session/session.h"

#include <cmath>
#include <utility>

#include "core/learning.h"
#include "core/math/elementary.h"
#include "core/math/time.h"
#include "plugin/src/abi/error.h"

namespace hrt::plugin {
namespace {

PlatePoint real_point(const Reach& reach) {
  return point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm);
}

hrt_result too_near(const char* target, double far_mm) {
  return fail(HRT_ERROR_OUT_OF_RANGE, target, " is ", far_mm / mm_per_m, " m from the start; allowed: at least ",
              min_distance_m, ". Move the target or the start");
}

}  // namespace

hrt_result Session::check_idle() const {
  if (is_setting_up()) return fail(HRT_ERROR_WRONG_STATE, "a set-up is in progress; finish or cancel it first");
  return is_reaching() ? fail(HRT_ERROR_WRONG_STATE, "a reach is in progress; end or cancel it first") : HRT_OK;
}

hrt_result Session::check_reaching() const {
  return is_reaching() ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no reach is in progress; begin one first");
}

hrt_result Session::check_setting_up() const {
  return is_setting_up() ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no set-up is in progress; begin one first");
}

hrt_result Session::set_model(const SessionModel& model) {
  HRT_RETURN_IF_FAILED(check_idle());
  const TouchedFrame &was = model_.control.touched, &is = model.control.touched;
  const bool contacts_are_of_another_pose =
      !have_same_pose(model_.mount, model.mount) && was.stretch == is.stretch && was.covariance == is.covariance;
  model_ = model;
  if (contacts_are_of_another_pose) forget_contacts(&model_);
  state_ = Idle{};
  return HRT_OK;
}

hrt_result Session::find_pair(std::uint64_t real_target, std::uint64_t virtual_target, Pair* out) const {
  const Target *real = nullptr, *seen = nullptr;
  HRT_RETURN_IF_FAILED(targets.find("real_target", real_target, TargetRole::real, &real));
  HRT_RETURN_IF_FAILED(targets.find("virtual_target", virtual_target, TargetRole::virtual_target, &seen));
  *out = {real->place, seen->place};
  return HRT_OK;
}

// Sets the start of `reach`, and the directions and distance seen from it. Fails if a reach from there is not possible.
hrt_result Session::aim(const Pair& pair, const PlatePoint& start, Reach* reach) const {
  const TargetView real = view_from(start, model_.mount, pair.real);
  const TargetView seen = view_from(start, model_.mount, pair.virtual_target);
  if (!(real.distance_mm >= mm_per_m * min_distance_m)) return too_near("real_target", real.distance_mm);
  if (seen.at_start) return too_near("virtual_target", seen.distance_mm);
  Reach aimed = *reach;
  aimed.start = start;
  aimed.virtual_direction_deg = seen.direction_deg;
  // The equivalent angle that is nearest to the virtual direction.
  aimed.real_direction_deg = seen.direction_deg - wrap_deg(seen.direction_deg - real.direction_deg, 360.0);
  aimed.real_distance_mm = real.distance_mm;
  const double goal_deg = goal_direction_deg(model_.control.participant, aimed.virtual_direction_deg);
  if (!is_valid(aimed, goal_deg))
    return fail(HRT_ERROR_OUT_OF_RANGE, "the real target is at ", aimed.real_direction_deg,
                " degrees, the virtual one at ", goal_deg,
                model_.control.participant.bias_deg != 0.0 ? " with the user's bias" : "",
                "; allowed: less than 90 degrees apart. Choose another pair");
  *reach = aimed;
  return HRT_OK;
}

hrt_result Session::begin(const ReachRequest& request) {
  Pair pair{};
  HRT_RETURN_IF_FAILED(find_pair(request.real_target, request.virtual_target, &pair));
  Reach reach{};
  reach.plate_orientation_deg = request.plate_orientation_deg.value_or(plate_orientation_deg_);
  reach.duration_s = request.duration_s;
  HRT_RETURN_IF_FAILED(aim(pair, start_of(model_), &reach));
  plate_orientation_deg_ = reach.plate_orientation_deg;  // until the first command
  auto& reaching = state_.emplace<Reaching>(pair, reach, model_.control);
  reaching.retargeter.begin(reach);
  reaching.awaits_finger = request.starts_at_finger;
  reaching.assessment = assess_registration(reach);
  reaching.plausibility = plausibility_of(reach);
  implausible_ = {};
  return HRT_OK;
}

// Directions from a start that is found by touch are not checked: the tracker's position of that start is unknown.
Plausibility Session::plausibility_of(const Reach& reach) const {
  Plausibility plausibility(mm_per_m * model_.mount.surface.radius_m, reach, targets.may_be_in_radians());
  if (model_.control.start_is_felt) plausibility.skip_directions();
  return plausibility;
}

// Starts a reach that waited for the first position of the finger.
hrt_result Session::start_at(const PlatePoint& finger, Reaching* reaching) const {
  Reach reach = reaching->reach;
  reach.plate_orientation_deg = plate_orientation_deg_;
  HRT_RETURN_IF_FAILED(aim(reaching->pair, finger, &reach));
  reaching->retargeter.begin_here(reach);
  reaching->start = finger;
  reaching->reach = reach;
  reaching->assessment = assess_registration(reach);
  reaching->plausibility = plausibility_of(reach);
  reaching->awaits_finger = false;
  return HRT_OK;
}

hrt_result Session::update(const FingerSample& sample, PlateCommand* out) {
  auto& reaching = std::get<Reaching>(state_);
  if (reaching.last_time_ns && sample.time_ns < *reaching.last_time_ns)
    return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns, ", earlier than ", *reaching.last_time_ns,
                " of the last sample; times must not decrease");
  if (reaching.awaits_finger && sample.observation == Observation::position)
    HRT_RETURN_IF_FAILED(start_at(sample.position, &reaching));
  reaching.plausibility.observe(sample);
  implausible_ = reaching.plausibility.found();
  FingerSample measured = sample;
  if (sample.observation == Observation::position && reaching.repeated.is_copy(sample.time_ns, sample.position))
    measured.observation = Observation::none;
  *out = reaching.retargeter.update(measured);
  reaching.last_time_ns = sample.time_ns;
  out->lifted = sample.observation == Observation::lifted;
  out->off_plate = sample.off_plate;
  out->implausible = implausible_.kind != Implausible::Kind::none;
  out->contacts_disagree = reaching.assessment.contacts_disagree;
  out->registration_doubtful = reaching.assessment.is_poor || is_too_old(sample.time_ns);
  reaching.registration_doubtful |= out->registration_doubtful;
  out->fault = !std::isfinite(out->plate_orientation_deg);
  if (out->fault) out->plate_orientation_deg = plate_orientation_deg_;
  plate_orientation_deg_ = out->plate_orientation_deg;
  return HRT_OK;
}

void Session::mark_faulty() {
  if (auto* reaching = std::get_if<Reaching>(&state_)) reaching->faulty = true;
}

hrt_result Session::retarget(std::uint64_t real_target, std::uint64_t virtual_target) {
  HRT_RETURN_IF_FAILED(check_reaching());
  auto& reaching = std::get<Reaching>(state_);
  Pair pair{};
  HRT_RETURN_IF_FAILED(find_pair(real_target, virtual_target, &pair));
  Reach from_start = reaching.reach;
  HRT_RETURN_IF_FAILED(aim(pair, reaching.start, &from_start));
  reaching.pair = pair;
  reaching.reach = reaching.retargeter.retarget(view_from(reaching.start, model_.mount, pair.real).point,
                                                view_from(reaching.start, model_.mount, pair.virtual_target).point);
  reaching.assessment = assess_registration(from_start);
  reaching.plausibility.skip_directions();
  return HRT_OK;
}

hrt_result Session::check_contact_due() const {
  const auto* reaching = std::get_if<Reaching>(&state_);
  const auto* idle = std::get_if<Idle>(&state_);
  if (!reaching && !(idle && idle->last))
    return fail(HRT_ERROR_WRONG_STATE,
                "no reach is in progress, and none has ended since the last cancel, set-up or change of the "
                "configuration; begin a reach first");
  if (reaching ? reaching->contact.has_value() : idle->last->was_touched)
    return fail(HRT_ERROR_WRONG_STATE, "this reach already has a contact; report another one in the next reach");
  if (!model_.registration.made)
    return fail(HRT_ERROR_WRONG_STATE,
                "the plate is not registered (HRT_SESSION_REGISTERED); run HRT_SETUP_REGISTRATION first");
  return HRT_OK;
}

// During the reach, only stores the contact: end() applies it after the estimates of the user.
hrt_result Session::touched(const ContactReport& report) {
  auto* reaching = std::get_if<Reaching>(&state_);
  const EndedReach reach = reaching ? EndedReach{reaching->start, reaching->pair.real, reaching->retargeter.finger()}
                                    : *std::get<Idle>(state_).last;
  if (!reach.finger)
    return fail(HRT_ERROR_INSUFFICIENT_DATA,
                "no sample of this reach shows a motion; report the contact after the motion");
  Contact contact{};
  HRT_RETURN_IF_FAILED(check_contact(model_, report, reach.start, reach.real, *reach.finger, &contact));
  if (reaching) {
    reaching->contact = contact;
  } else {
    std::get<Idle>(state_).last->was_touched = true;
    learn_contact(contact, &model_);
  }
  return HRT_OK;
}

hrt_result Session::cancel() {
  HRT_RETURN_IF_FAILED(check_reaching());
  state_ = Idle{};
  return HRT_OK;
}

hrt_result Session::end(ReachSummary* out) {
  HRT_RETURN_IF_FAILED(check_reaching());
  const auto& reaching = std::get<Reaching>(state_);
  if (!reaching.last_time_ns)
    return fail(HRT_ERROR_INSUFFICIENT_DATA, "the reach has had no sample; hrt_reach_cancel() ends it");
  *out = reaching.retargeter.summary();
  out->registration_doubtful = reaching.registration_doubtful;
  out->contacts_disagree = reaching.assessment.contacts_disagree;
  out->implausible = implausible_.kind != Implausible::Kind::none;
  if (model_.adaptation == Adaptation::off || out->person) {
    out->estimate.motor_variance_deg2 = model_.control.participant.motor_variance_deg2;
    out->estimate.motor_variance_sd_deg2 = 0.0;
  }
  Idle idle;
  if (!reaching.faulty) {
    idle.last = {reaching.start, reaching.pair.real, reaching.retargeter.finger(), reaching.contact.has_value()};
    if (model_.adaptation == Adaptation::carried && !out->implausible) learn(reaching.retargeter, *out);
    if (reaching.contact) {
      learn_contact(*reaching.contact, &model_);
      out->contacts_disagree = assess_registration(reaching.reach).contacts_disagree;
    }
  }
  state_ = idle;
  return HRT_OK;
}

// Updates the model by the estimates of a reach. Discards invalid estimates, for example after an impossible motion.
void Session::learn(const Retargeter& retargeter, const ReachSummary& summary) {
  SessionModel next = model_;
  if (!retargeter.has_person_controller()) {
    next.control = carried(model_.control, summary.estimate);
    if (!next.knows_person) forget_person(&next);
  } else if (const auto learnt = retargeter.learnt()) {
    const bool missed = summary.unreachable || summary.off_target;
    know_person(carried(model_.control.person, *learnt, missed, unknown_person()), &next);
  }
  if (is_valid(next)) model_ = next;
}

Session::RegistrationAssessment Session::assess_registration(const Reach& reach) const {
  const RetargeterConfig& control = model_.control;
  const PlateRegistration& required = model_.registration;
  const bool is_missing = (required.max_age_ns > 0 || required.max_sd_deg > 0.0) && !required.made;
  const bool is_vague = required.max_sd_deg > 0.0 && bearing_sd_deg(control.touched, control.frame, reach.start,
                                                                    real_point(reach)) > required.max_sd_deg;
  return {is_missing || is_vague, contradicts(control.touched, control.frame, real_point(reach))};
}

bool Session::is_too_old(std::int64_t time_ns) const {
  const std::int64_t max_ns = model_.registration.max_age_ns;
  return max_ns > 0 && time_ns > later_ns(model_.registration.time_ns, max_ns);
}

hrt_result Session::begin_setup(std::uint32_t parts, const SetupConfig& asked) {
  HRT_RETURN_IF_FAILED(SessionSetup::check(model_, targets, parts, asked));
  auto report = std::make_unique<SetupReport>();
  state_ = std::make_unique<SessionSetup>(model_, targets, parts, asked, plate_orientation_deg_);
  if (report_ && report_->calibration) former_slides_ = std::move(report_->calibration->slides);
  report_ = std::move(report);
  return HRT_OK;
}

hrt_result Session::update_setup(const SetupSample& sample, SetupStep* out) {
  HRT_RETURN_IF_FAILED(std::get<SettingUp>(state_)->update(model_, sample, out));
  plate_orientation_deg_ = out->plate_orientation_deg;
  return HRT_OK;
}

hrt_result Session::finish_setup() {
  HRT_RETURN_IF_FAILED(check_setting_up());
  SessionSetup& setup = *std::get<SettingUp>(state_);
  HRT_RETURN_IF_FAILED(setup.finish(&model_, report_.get()));
  if (setup.is_over()) state_ = Idle{};
  return HRT_OK;
}

hrt_result Session::cancel_setup() {
  HRT_RETURN_IF_FAILED(check_setting_up());
  state_ = Idle{};
  return HRT_OK;
}

}  // namespace hrt::plugin
