#include "plugin/src/api/recorded_session.h"

#include <utility>
#include <vector>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/write.h"

namespace hrt::plugin {
hrt_result RecordedSession::set_model(const SessionModel& valid_model) {
  HRT_RETURN_IF_FAILED(session_.set_model(valid_model));
  forget_findings();
  record([&] { return Record{.call = ConfigSet{to_c(valid_model)}}; });
  return HRT_OK;
}

hrt_result RecordedSession::add_target(const Target& checked_target, std::uint64_t* out_id) {
  HRT_RETURN_IF_FAILED(session_.targets.add(checked_target, out_id));
  record([&] { return Record{.call = changed(TargetChanged::Change::added, *out_id)}; });
  return HRT_OK;
}

hrt_result RecordedSession::set_target(std::uint64_t id, const Target& checked_target) {
  HRT_RETURN_IF_FAILED(session_.targets.set(id, checked_target));
  record([&] { return Record{.call = changed(TargetChanged::Change::set, id)}; });
  return HRT_OK;
}

hrt_result RecordedSession::remove_target(std::uint64_t id) {
  const std::uint64_t number = session_.targets.number(id);
  HRT_RETURN_IF_FAILED(session_.targets.remove(id));
  record([&] { return Record{.call = TargetChanged{TargetChanged::Change::removed, number, {}}}; });
  return HRT_OK;
}

hrt_result RecordedSession::add_scene(const SessionModel& valid_model, std::span<const Target> checked_targets,
                                      hrt_target* out_targets) {
  Targets targets = session_.targets;  // a copy, so that a failure changes nothing
  std::vector<std::uint64_t> ids;
  for (const Target& target : checked_targets) HRT_RETURN_IF_FAILED(targets.add(target, &ids.emplace_back()));
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (const std::uint64_t real = checked_targets[i].served_by; real != 0)
      targets.set_served_by(ids[i], ids[static_cast<std::size_t>(real) - 1]);
  HRT_RETURN_IF_FAILED(set_model(valid_model));
  session_.targets = std::move(targets);
  for (const std::uint64_t id : ids) {
    record([&] { return Record{.call = changed(TargetChanged::Change::added, id)}; });
    if (out_targets) (out_targets++)->value = id;
  }
  return HRT_OK;
}

hrt_result RecordedSession::begin(const hrt_reach_config* given) {
  hrt_reach_config config = defaults<hrt_reach_config>;
  HRT_RETURN_IF_FAILED(read_struct("config", given, &config));
  ReachRequest request;
  hrt_result result = session_.check_idle();
  if (result == HRT_OK) result = read(config, &request);
  if (result == HRT_OK) result = session_.begin(request);
  record([&] {
    return Record{result, ReachBegun{.flags = config.flags,
                                     .plate_orientation_deg = config.plate_orientation_deg,
                                     .real_number = session_.targets.number(config.real_target.value),
                                     .virtual_number = session_.targets.number(config.virtual_target.value),
                                     .duration_s = config.duration_s,
                                     .reach = reach_geometry()}};
  });
  return result;
}

hrt_result RecordedSession::update(const hrt_sample* given, hrt_command* out) {
  hrt_sample sample;
  HRT_RETURN_IF_FAILED(check_output("out_command", out));
  HRT_RETURN_IF_FAILED(read_struct("sample", given, &sample));
  const std::uint32_t size = out->struct_size;
  const bool awaited_finger = session_.awaits_finger();
  const SessionModel& model = session_.model();
  FingerSample finger;
  PlateCommand command;
  hrt_result result = session_.check_reaching();
  if (result == HRT_OK) result = read(model.mount, model.control.touched, sample, &finger);
  if (result == HRT_OK) result = session_.update(finger, &command);
  if (result == HRT_OK) {
    *out = to_c(command);
    end_struct(size, out);
    registration_was_poor_ |= command.registration_doubtful;
    if (command.implausible && implausible_.kind == Implausible::Kind::none) implausible_ = session_.implausible();
    if ((out->flags & HRT_COMMAND_FAULT) != 0) {
      had_fault_ = true;
      session_.mark_faulty();
    }
  }
  record([&] {
    Updated updated{sample, result == HRT_OK ? *out : hrt_command{}, {}};
    if (awaited_finger && !session_.awaits_finger()) updated.reach = reach_geometry();
    return Record{result, updated};
  });
  return result;
}

hrt_result RecordedSession::retarget(hrt_target real_target, hrt_target virtual_target) {
  const hrt_result result = session_.retarget(real_target.value, virtual_target.value);
  record([&] {
    return Record{result, Retargeted{.real_number = session_.targets.number(real_target.value),
                                     .virtual_number = session_.targets.number(virtual_target.value),
                                     .reach = reach_geometry()}};
  });
  return result;
}

hrt_result RecordedSession::touched(const hrt_contact* given) {
  hrt_contact contact{.struct_size = sizeof contact};
  if (given) HRT_RETURN_IF_FAILED(read_struct("contact", given, &contact));
  ContactReport report;
  hrt_result result = session_.check_contact_due();
  if (result == HRT_OK) result = read(contact, &report);
  if (result == HRT_OK) result = session_.touched(report);
  record([&] { return Record{result, Touched{contact}}; });
  return result;
}

hrt_result RecordedSession::cancel() {
  const hrt_result result = session_.cancel();
  record([&] { return Record{result, ReachCancelled{}}; });
  return result;
}

hrt_result RecordedSession::end(hrt_reach_summary* out) {
  HRT_RETURN_IF_FAILED(check_output("out_summary", out));
  ReachSummary summary;
  hrt_reach_summary written{};
  const hrt_result result = session_.end(&summary);
  if (result == HRT_OK) {
    written = to_c(summary);
    had_fault_ |= (written.flags & HRT_COMMAND_FAULT) != 0;
    write_struct(written, out);
  }
  record([&] { return Record{result, ReachEnded{written}}; });
  return result;
}

hrt_result RecordedSession::begin_setup(std::uint32_t what, const hrt_setup_config& config) {
  SetupConfig asked;
  HRT_RETURN_IF_FAILED(session_.check_idle());
  HRT_RETURN_IF_FAILED(read(config, &asked));
  HRT_RETURN_IF_FAILED(session_.begin_setup(what, asked));
  record([&] { return Record{.call = SetupBegun{what, config}}; });
  return HRT_OK;
}

hrt_result RecordedSession::update_setup(const hrt_sample& sample, hrt_setup_step* out) {
  SetupSample shown;
  SetupStep step{};
  hrt_result result = session_.check_setting_up();
  if (result == HRT_OK) result = read(session_.model(), session_.setup_part(), sample, &shown);
  if (result == HRT_OK) result = session_.update_setup(shown, &step);
  if (result == HRT_OK) *out = to_c(step);
  record([&] { return Record{result, SetupUpdated{sample, *out}}; });
  return result;
}

hrt_result RecordedSession::finish_setup(hrt_setup_result* out) {
  const hrt_result result = session_.finish_setup();
  if (result == HRT_OK) *out = to_c(session_.setup_report());
  record([&] { return Record{result, SetupFinished{*out}}; });
  if (result != HRT_OK) return result;
  forget_findings();
  if (out->done & (HRT_SETUP_CALIBRATION | HRT_SETUP_RETEST)) conditions.set_measured_to_now();
  return HRT_OK;
}

hrt_result RecordedSession::cancel_setup() {
  const hrt_result result = session_.cancel_setup();
  record([&] { return Record{result, SetupCancelled{}}; });
  return result;
}

hrt_result RecordedSession::set_plate_orientation_deg(double orientation_deg) {
  HRT_RETURN_IF_FAILED(session_.check_idle());
  session_.set_plate_orientation_deg(orientation_deg);
  return HRT_OK;
}

ReachGeometry RecordedSession::reach_geometry() const {
  if (!session_.is_reaching()) return {};
  const Reach& reach = session_.reach();
  return {.real_direction_deg = reach.real_direction_deg,
          .virtual_direction_deg = reach.virtual_direction_deg,
          .real_distance_m = reach.real_distance_mm / mm_per_m,
          .start_right_m = reach.start.right_mm / mm_per_m,
          .start_away_m = reach.start.away_mm / mm_per_m,
          .plate_orientation_deg = reach.plate_orientation_deg};
}

void RecordedSession::forget_findings() {
  registration_was_poor_ = logged_registration_ = logged_implausible_ = false;
  implausible_ = {};
}

void RecordedSession::log_findings(std::uint64_t handle) {
  if (registration_was_poor_ && !logged_registration_) {
    Text<240> text;
    text << "session " << handle
         << ": in a reach, the registration of the plate was missing, or older or less accurate than the configuration "
            "allows; run HRT_SETUP_REGISTRATION, or HRT_SETUP_CHECK if it is only too old";
    write_log(HRT_LOG_WARNING, text.c_str(), log_);
    logged_registration_ = true;
  }
  if (implausible_.kind != Implausible::Kind::none && !logged_implausible_) {
    Text<320> text;
    text << "session " << handle << ": ";
    write_implausible(implausible_, text);
    write_log(HRT_LOG_WARNING, text.c_str(), log_);
    logged_implausible_ = true;
  }
  if (!had_fault_ || logged_fault_) return;
  Text<240> text;
  text << "session " << handle
       << ": a value of a command or summary was not a finite number; this is a defect of the library: report it";
  write_log(HRT_LOG_ERROR, text.c_str(), log_);
  logged_fault_ = true;
}

void RecordedSession::log_conditions(std::uint64_t handle) const {
  const hrt_conditions measured = conditions.measured();
  if (measured.differing == 0) return;
  Text<400> text;
  text << "session " << handle << ": the profile was measured with another";
  if (measured.differing & HRT_CONDITION_PLATE) text << " plate, \"" << measured.plate << "\"";
  if (measured.differing == (HRT_CONDITION_PLATE | HRT_CONDITION_TRACKER)) text << ", and";
  if (measured.differing & HRT_CONDITION_TRACKER) text << " tracker, \"" << measured.tracker << "\"";
  text << "; calibrate again, or expect the first reaches to be less accurate";
  write_log(HRT_LOG_WARNING, text.c_str(), log_);
}

std::uint32_t RecordedSession::state() const {
  const std::uint32_t recording = recorder_ ? HRT_STATE_RECORDING : 0;
  if (session_.is_reaching()) return recording | HRT_STATE_REACHING;
  if (session_.is_setting_up()) return recording | HRT_STATE_SETTING_UP;
  return recording | (session_.targets.has_both_roles() ? HRT_STATE_READY : 0);
}

hrt_result RecordedSession::start_recording(const char* path, std::uint64_t handle) {
  HRT_RETURN_IF_FAILED(session_.check_idle());
  if (recorder_ && !recorder_->belongs_to_parent_process())
    return fail(HRT_ERROR_WRONG_STATE, "a recording of this session is in progress; stop it first");
  File file;
  HRT_RETURN_IF_FAILED(File::create(path, &file));
  Text<128> name;
  name << "session " << handle << ", " << Shown{path};
  std::vector<TargetChanged> targets;
  for (const auto& [id, target] : session_.targets.all()) targets.push_back(changed(TargetChanged::Change::added, id));
  recorder_ = std::make_unique<Recorder>(std::move(file), name.view(), log_, to_c(session_.model()), targets,
                                         session_.plate_orientation_deg());
  return HRT_OK;
}

hrt_result RecordedSession::check_recording() const {
  if (!recorder_) return fail(HRT_ERROR_WRONG_STATE, "no recording of this session is in progress; start one first");
  if (!recorder_->belongs_to_parent_process()) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE, "the recording belongs to the parent process; start another one in this process");
}

hrt_recording_status RecordedSession::stop_recording() {
  const hrt_recording_status status = recorder_->stop();
  recorder_.reset();
  return status;
}

TargetChanged RecordedSession::changed(TargetChanged::Change change, std::uint64_t id) const {
  const Targets& targets = session_.targets;
  TargetChanged target{change, targets.number(id), to_c(*targets.find(id))};
  target.config.served_by = {targets.number(target.config.served_by.value)};
  return target;
}

}  // namespace hrt::plugin
