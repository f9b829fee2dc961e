#include "plugin/src/session/session.h"

#include <cmath>

#include "core/math/time.h"
#include "core/math/trigonometry.h"
#include "core/plate/frame_error.h"
#include "core/retargeter.h"
#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/session/contact.h"
#include "plugin/src/session/finger_sample.h"

namespace hrt::plugin {
namespace {

// The last line of defence: false, and 0 in its place, if a value is no finite number.
template <class Struct>
bool zero_what_is_not_finite(Struct& values) {
  const auto for_each_number = [&](const auto& visit) {
    for_each_field<Struct>([&](const auto& field) {
      if constexpr (std::is_same_v<decltype(field.of(values)), double&>) visit(field.of(values));
    });
  };
  double sum = 0.0;
  for_each_number([&](double value) { sum += value; });
  if (std::isfinite(sum)) return true;  // and so is every term
  bool finite = true;
  for_each_number([&](double& value) {
    if (std::isfinite(value)) return;
    value = 0.0;
    finite = false;
  });
  return finite;
}

PlatePoint real_place(const Reach& reach) {
  return point_ahead(reach.start, reach.real_direction_deg, reach.real_distance_mm);
}

// Whether there is no registration where one is asked for, or one that turns the real target by too much.
bool is_registration_poor(const hrt_session_config& config, const Reach& reach) {
  const bool checked = config.registration.max_age_ns > 0 || config.registration.max_sd_deg > 0.0;
  if (checked && (config.flags & HRT_SESSION_REGISTERED) == 0) return true;
  if (config.registration.max_sd_deg == 0.0) return false;
  return bearing_sd_deg(touched_of(config), frame_covariance_of(config), reach.start, real_place(reach)) >
         config.registration.max_sd_deg;
}

bool make_finite(hrt_command& command, double held_orientation_deg) {
  const bool plate_finite = std::isfinite(command.plate_orientation_deg);
  if (!plate_finite) command.plate_orientation_deg = held_orientation_deg;
  if (zero_what_is_not_finite(command) && plate_finite) return true;
  command.flags |= HRT_COMMAND_FAULT | HRT_COMMAND_HELD;
  return false;
}

bool make_finite(hrt_reach_summary& summary) {
  if (zero_what_is_not_finite(summary)) return true;
  summary.flags |= HRT_COMMAND_FAULT;
  return false;
}

}  // namespace

Session::Session(const hrt_session_config& checked_config)
    : config_(checked_config), retargeter_(std::make_unique<Retargeter>(to_core(checked_config))) {}

Session::~Session() = default;

hrt_result Session::check_no_reach() const {
  if (setup_) return fail(HRT_ERROR_WRONG_STATE, "a set-up is under way; finish or cancel it first");
  return reaching_ ? fail(HRT_ERROR_WRONG_STATE, "a reach is under way; end it first") : HRT_OK;
}

hrt_result Session::check_reach() const {
  return reaching_ ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no reach is under way; begin one first");
}

hrt_result Session::set_config(const hrt_session_config& checked_config) {
  HRT_RETURN_IF_FAILED(check_no_reach());
  hrt_session_config next = checked_config;
  forget_contacts_elsewhere(config_, &next);
  config_ = next;
  ended_ = false;
  registration_doubted_ = false;
  *retargeter_ = Retargeter(to_core(config_));
  return HRT_OK;
}

// Directions and distance of the pair as seen from the start; fails unless a reach from there can go to it.
hrt_result Session::aim(const Pair& pair, const PlatePoint& start, Reach* out) const {
  const TargetView real = view_from(start, config_, pair.real);
  const TargetView seen = view_from(start, config_, pair.virtual_target);
  if (!(real.distance_mm >= mm_per_m * min_distance_m))
    return fail(HRT_ERROR_OUT_OF_RANGE, "real_target is ", real.distance_mm / mm_per_m, " m from the start; at least ",
                min_distance_m, " is needed");
  if (seen.at_start)
    return fail(HRT_ERROR_OUT_OF_RANGE, "virtual_target is ", seen.distance_mm / mm_per_m,
                " m from the start; at least ", min_distance_m, " is needed");
  Reach reach = *out;
  reach.start = start;
  reach.virtual_direction_deg = seen.direction_deg;
  // The short way round from the virtual direction.
  reach.real_direction_deg = seen.direction_deg - wrap_deg(seen.direction_deg - real.direction_deg, 360.0);
  reach.real_distance_mm = real.distance_mm;
  const double goal_deg = goal_direction_deg(to_core(config_).participant, reach.virtual_direction_deg);
  if (!is_valid(reach, goal_deg))
    return fail(HRT_ERROR_OUT_OF_RANGE, "the real target is at ", reach.real_direction_deg, " degrees, the virtual at ",
                goal_deg, config_.paper.bias_deg != 0.0 ? " with the user's bias" : "",
                "; allowed: less than 90 degrees apart");
  *out = reach;
  return HRT_OK;
}

hrt_result Session::begin(const hrt_reach_config& config) {
  HRT_RETURN_IF_FAILED(check_no_reach());
  using F = Fields<hrt_reach_config>;
  HRT_RETURN_IF_FAILED(check_field(config, F::flags));
  const bool orientation_given = (config.flags & HRT_REACH_PLATE_ORIENTATION) != 0;
  if (orientation_given) HRT_RETURN_IF_FAILED(check_field(config, F::plate_orientation_deg));
  HRT_RETURN_IF_FAILED(check_field(config, F::duration_s));
  Pair pair{};
  HRT_RETURN_IF_FAILED(find_pair(targets, config.real_target, config.virtual_target, &pair));
  Reach reach{};
  reach.plate_orientation_deg = orientation_given ? config.plate_orientation_deg : plate_orientation_deg_;
  reach.duration_s = config.duration_s;
  HRT_RETURN_IF_FAILED(aim(pair, start_of(config_), &reach));
  retargeter_->begin(reach);
  plate_orientation_deg_ = reach.plate_orientation_deg;  // no command has been returned yet
  pair_ = pair;
  start_ = reach.start;
  reach_ = reach;
  reaching_ = true;
  awaits_finger_ = (config.flags & HRT_REACH_START_AT_FINGER) != 0;
  sampled_ = faulty_ = registration_flagged_ = ended_ = touched_ = false;
  contact_.reset();
  judge_registration(reach_);
  return HRT_OK;
}

// The finger is seen for the first time, and the reach starts there.
hrt_result Session::start_at(const PlatePoint& finger) {
  Reach reach = reach_;
  reach.plate_orientation_deg = plate_orientation_deg_;
  HRT_RETURN_IF_FAILED(aim(pair_, finger, &reach));
  retargeter_->begin_here(reach);
  start_ = finger;
  reach_ = reach;
  judge_registration(reach_);
  awaits_finger_ = false;
  started_ = true;
  return HRT_OK;
}

hrt_result Session::retarget(hrt_target real_target, hrt_target virtual_target) {
  HRT_RETURN_IF_FAILED(check_reach());
  Pair pair{};
  HRT_RETURN_IF_FAILED(find_pair(targets, real_target, virtual_target, &pair));
  Reach from_start = reach_;
  HRT_RETURN_IF_FAILED(aim(pair, start_, &from_start));
  const auto place = [&](const hrt_target_config& target) {
    const TargetView seen = view_from(start_, config_, target);
    return point_ahead(start_, seen.direction_deg, seen.distance_mm);
  };
  pair_ = pair;
  reach_ = retargeter_->retarget(place(pair.real), place(pair.virtual_target));
  judge_registration(from_start);
  return HRT_OK;
}

// Of the reach, under way or ended: what its end teaches of the person comes before the contact.
hrt_result Session::touched(const hrt_contact& given) {
  if (!reaching_ && !ended_)
    return fail(HRT_ERROR_WRONG_STATE, "no reach is under way, or has ended since the configuration was set");
  if (touched_) return fail(HRT_ERROR_WRONG_STATE, "the contact of this reach is known already");
  if ((config_.flags & HRT_SESSION_REGISTERED) == 0)
    return fail(HRT_ERROR_WRONG_STATE,
                "the plate is not registered (HRT_SESSION_REGISTERED), and contacts are about its registration");
  TouchedPlace place{};
  HRT_RETURN_IF_FAILED(read_contact(config_, given, start_, pair_.real, &place));
  const std::optional<SeenFinger> seen = reaching_ ? retargeter_->finger() : finger_;
  if (!seen) return fail(HRT_ERROR_INSUFFICIENT_DATA, "the finger was not seen to move in this reach");
  Contact contact{};
  HRT_RETURN_IF_FAILED(check_contact(config_, place, *seen, &contact));
  touched_ = true;
  if (reaching_)
    contact_ = contact;
  else
    learn_from(contact);
  return HRT_OK;
}

void Session::learn_from(const Contact& contact) {
  config_ = after_contact(config_, contact);
  *retargeter_ = Retargeter(to_core(config_));
}

hrt_result Session::cancel() {
  HRT_RETURN_IF_FAILED(check_reach());
  reaching_ = false;
  return HRT_OK;
}

hrt_result Session::update(const hrt_sample& sample, hrt_command* out_command) {
  started_ = false;
  HRT_RETURN_IF_FAILED(check_reach());
  HRT_RETURN_IF_FAILED(check_sample(sample));
  if (sampled_ && sample.time_ns < last_time_ns_)
    return fail(HRT_ERROR_TIME_REVERSED, "time_ns is ", sample.time_ns, "; allowed: from the last sample's, ",
                last_time_ns_);
  std::uint32_t flags = 0;
  const FingerSample finger = observe(config_, sample, &flags);
  if (awaits_finger_ && finger.observation == Observation::position) HRT_RETURN_IF_FAILED(start_at(finger.position));
  const PlateCommand& planned = retargeter_->update(finger);
  sampled_ = true;
  last_time_ns_ = sample.time_ns;
  if (is_registration_doubtful(sample.time_ns)) {
    flags |= HRT_COMMAND_REGISTRATION;
    registration_flagged_ = registration_doubted_ = true;
  }
  write_command(planned, flags, out_command);
  if (!make_finite(*out_command, plate_orientation_deg_)) faulty_ = failed_ = true;
  plate_orientation_deg_ = out_command->plate_orientation_deg;
  return HRT_OK;
}

void Session::judge_registration(const Reach& reach) {
  registration_poor_ = is_registration_poor(config_, reach);
  contradicted_ = contradicts(touched_of(config_), frame_covariance_of(config_), real_place(reach));
}

bool Session::is_registration_doubtful(std::int64_t time_ns) const {
  if (registration_poor_) return true;
  const std::int64_t max_ns = config_.registration.max_age_ns;
  return max_ns > 0 && time_ns > later_ns(config_.registration.time_ns, max_ns);
}

void Session::write_command(const PlateCommand& command, std::uint32_t flags, hrt_command* out) const {
  if (command.held) flags |= HRT_COMMAND_HELD;
  if (command.predicted) flags |= HRT_COMMAND_PREDICTED;
  if (command.unreachable) flags |= HRT_COMMAND_UNREACHABLE;
  if (command.active == ActiveBound::lower || command.active == ActiveBound::upper) flags |= HRT_COMMAND_SATURATED;
  if (command.active == ActiveBound::rate_down || command.active == ActiveBound::rate_up)
    flags |= HRT_COMMAND_RATE_LIMITED;
  if (!command.optimal) flags |= HRT_COMMAND_APPROXIMATE;
  if (command.misfit) flags |= HRT_COMMAND_MISFIT;
  if (command.off_target) flags |= HRT_COMMAND_OFF_TARGET;
  if (command.resting) flags |= HRT_COMMAND_RESTING;
  if (command.arrived) flags |= HRT_COMMAND_ARRIVED;
  if (contradicted_) flags |= HRT_COMMAND_CONTACTS;
  *out = {
      .struct_size = sizeof(hrt_command),
      .flags = flags,
      .step = command.step,
      .plate_orientation_deg = command.plate_orientation_deg,
      .finger_direction_deg = command.finger_direction_deg,
      .perceived_direction_deg = command.perceived_direction_deg,
      .aimed_direction_deg = command.aimed_direction_deg,
      .distance_to_go_m = command.distance_to_go_mm / mm_per_m,
      .tactile_weight = command.tactile_weight,
      .tactile_weight_sd = command.tactile_weight_sd,
      .time_to_go_s = retargeter_->leads_person() ? command.time_to_go_s : HRT_NOT_MOVING,
      .felt_error_deg = command.felt_error_deg,
      .predicted_miss_deg = command.predicted_miss_deg,
      .misfit = command.nis,
      .miss_sd_deg = command.bearing_error_sd_deg,
  };
}

hrt_result Session::check_setup() const {
  return setup_ ? HRT_OK : fail(HRT_ERROR_WRONG_STATE, "no set-up is under way; begin one first");
}

hrt_result Session::begin_setup(std::uint32_t what, const hrt_setup_config& config) {
  HRT_RETURN_IF_FAILED(check_no_reach());
  HRT_RETURN_IF_FAILED(check_setup_config(config));
  HRT_RETURN_IF_FAILED(SessionSetup::check(config_, targets, what));
  setup_ = std::make_unique<SessionSetup>(config_, targets, what, config, plate_orientation_deg_);
  return HRT_OK;
}

hrt_result Session::update_setup(const hrt_sample& sample, hrt_setup_step* step) {
  HRT_RETURN_IF_FAILED(check_setup());
  HRT_RETURN_IF_FAILED(setup_->update(config_, sample, step));
  plate_orientation_deg_ = step->plate_orientation_deg;
  return HRT_OK;
}

hrt_result Session::finish_setup(hrt_setup_result* result) {
  HRT_RETURN_IF_FAILED(check_setup());
  HRT_RETURN_IF_FAILED(setup_->finish(&config_, &residuals_, result));
  registration_doubted_ = ended_ = false;
  *retargeter_ = Retargeter(to_core(config_));
  if (setup_->is_over()) setup_.reset();
  return HRT_OK;
}

hrt_result Session::cancel_setup() {
  HRT_RETURN_IF_FAILED(check_setup());
  setup_.reset();
  return HRT_OK;
}

hrt_result Session::get_residual(std::uint32_t slide, hrt_setup_residual* out) const {
  if (residuals_.empty()) return fail(HRT_ERROR_WRONG_STATE, "no set-up of this session has calibrated yet");
  HRT_RETURN_IF_FAILED(check_range("slide", slide, 0u, static_cast<std::uint32_t>(residuals_.size()) - 1));
  *out = residuals_[slide];
  return HRT_OK;
}

hrt_result Session::end(hrt_reach_summary* out_summary) {
  HRT_RETURN_IF_FAILED(check_reach());
  if (!sampled_) return fail(HRT_ERROR_INSUFFICIENT_DATA, "the reach has had no sample; hrt_reach_cancel() ends it");
  reaching_ = false;
  const ReachSummary summary = retargeter_->summary();
  *out_summary = to_c(summary);
  if (!make_finite(*out_summary)) faulty_ = failed_ = true;
  if (faulty_) return HRT_OK;  // it teaches nothing
  ended_ = true;
  finger_ = retargeter_->finger();
  if (config_.adaptation == HRT_ADAPTATION_CARRIED) carry(summary.estimate);
  if (!contact_) return HRT_OK;
  learn_from(*contact_);
  judge_registration(reach_);
  if (contradicted_) out_summary->flags |= HRT_COMMAND_CONTACTS;
  return HRT_OK;
}

hrt_reach_summary Session::to_c(const ReachSummary& summary) const {
  const FingerEstimate& estimate = summary.estimate;
  const bool learns_variance = config_.adaptation != HRT_ADAPTATION_OFF && !summary.person;
  const PersonEstimate person = summary.person.value_or(PersonEstimate{});
  std::uint32_t flags = 0;
  if (summary.unreachable) flags |= HRT_COMMAND_UNREACHABLE;
  if (summary.misfit) flags |= HRT_COMMAND_MISFIT;
  if (summary.off_target) flags |= HRT_COMMAND_OFF_TARGET;
  if (registration_flagged_) flags |= HRT_COMMAND_REGISTRATION;
  if (contradicted_) flags |= HRT_COMMAND_CONTACTS;
  return {
      .struct_size = sizeof(hrt_reach_summary),
      .flags = flags,
      .final_direction_deg = summary.final_direction_deg,
      .paper_miss_deg = summary.final_miss_deg,
      .perceived_direction_deg = summary.perceived_direction_deg,
      .perceived_error_deg = summary.perceived_error_deg,
      .distance_to_target_m = summary.distance_to_target_mm / mm_per_m,
      .miss_deg = summary.person ? summary.bearing_error_deg : summary.final_miss_deg,
      .miss_sd_deg = summary.bearing_error_sd_deg,
      .peak_felt_error_deg = summary.peak_felt_error_deg,
      .rms_felt_error_deg = summary.rms_felt_error_deg,
      .misfit = summary.nis,
      .duration_s = person.duration_s,
      .counts = {.samples = summary.samples,
                 .dropped_samples = summary.dropped_samples,
                 .steps = summary.steps,
                 .predicted_steps = summary.predicted_steps,
                 .saturated_steps = summary.saturated_steps,
                 .rate_limited_steps = summary.rate_limited_steps},
      .learnt = {.tactile_weight = estimate.tactile_weight,
                 .tactile_weight_sd = estimate.tactile_weight_sd,
                 .illusion_curve = person.curve,
                 .illusion_curve_sd = person.curve_sd,
                 .gain_per_s = person.gain_s,
                 .gain_sd_per_s = person.gain_sd_s,
                 .bias_deg = person.bias_deg,
                 .bias_sd_deg = person.bias_sd_deg,
                 .habit_deg = person.habit_deg,
                 .habit_sd_deg = person.habit_sd_deg,
                 .tracker_noise_m = estimate.tracker_noise_mm / mm_per_m,
                 .motor_variance_deg2 =
                     learns_variance ? estimate.motor_variance_deg2 : config_.paper.motor_variance_deg2,
                 .motor_variance_sd_deg2 = learns_variance ? estimate.motor_variance_sd_deg2 : 0.0},
  };
}

void Session::carry(const FingerEstimate& estimate) {
  if (retargeter_->leads_person()) {
    const auto learnt = retargeter_->learnt();
    if (!learnt) return;
    hrt_session_config next = config_;
    const ReachSummary summary = retargeter_->summary();
    const bool missed = summary.unreachable || summary.off_target;
    write_person(carried(to_core(config_).person, *learnt, missed, unknown_person()), &next);
    // Impossible motions can give invalid beliefs: these are discarded.
    if (holds_belief(next)) config_ = next;
  } else {
    const RetargeterConfig next = carried(to_core(config_), estimate);
    config_.paper.tactile_weight = next.participant.tactile_weight;
    config_.paper.tactile_weight_sd = next.estimator.tactile_weight_sd;
    config_.paper.motor_variance_deg2 = next.participant.motor_variance_deg2;
    config_.paper.motor_variance_sd_deg2 = next.estimator.motor_variance_sd_deg2;
  }
  *retargeter_ = Retargeter(to_core(config_));
}

}  // namespace hrt::plugin
