#include "plugin/src/recording/recorded_session.h"

#include <cstring>
#include <utility>

#include "plugin/src/abi/error.h"
#include "plugin/src/abi/host.h"

namespace hrt::plugin {
namespace {

// Removes the added targets on destruction, unless keep() was called.
class TargetRollback {
 public:
  explicit TargetRollback(Targets& targets) : targets_(targets) {}
  ~TargetRollback() {
    for (const std::uint64_t id : ids_) targets_.remove(id);
  }
  TargetRollback(const TargetRollback&) = delete;
  TargetRollback& operator=(const TargetRollback&) = delete;

  hrt_result add(const hrt_target_config& checked_config) {
    ids_.push_back(0);
    const hrt_result result = targets_.add(checked_config, &ids_.back());
    if (result != HRT_OK) ids_.pop_back();
    return result;
  }
  std::vector<std::uint64_t> keep() { return std::move(ids_); }

 private:
  Targets& targets_;
  std::vector<std::uint64_t> ids_;
};

}  // namespace

hrt_result RecordedSession::set_config(const hrt_session_config& checked_config) {
  HRT_RETURN_IF_FAILED(session_.set_config(checked_config));
  registration_logged_ = false;
  record([&] { return Record{.call = ConfigSet{checked_config}}; });
  return HRT_OK;
}

hrt_result RecordedSession::add_target(const hrt_target_config& checked_config, std::uint64_t* out_id) {
  HRT_RETURN_IF_FAILED(session_.targets.add(checked_config, out_id));
  record_target(TargetChanged::Change::added, *out_id);
  return HRT_OK;
}

hrt_result RecordedSession::set_target(std::uint64_t id, const hrt_target_config& checked_config) {
  HRT_RETURN_IF_FAILED(session_.targets.set(id, checked_config));
  record_target(TargetChanged::Change::set, id);
  return HRT_OK;
}

hrt_result RecordedSession::remove_target(std::uint64_t id) {
  HRT_RETURN_IF_FAILED(session_.targets.remove(id));
  record_target(TargetChanged::Change::removed, id);
  return HRT_OK;
}

hrt_result RecordedSession::add_scene(const hrt_session_config& checked_config,
                                      std::span<const hrt_target_config> checked_targets,
                                      std::span<const std::optional<std::size_t>> served_by,
                                      std::vector<std::uint64_t>* out_ids) {
  TargetRollback addition(session_.targets);
  for (const hrt_target_config& target : checked_targets) HRT_RETURN_IF_FAILED(addition.add(target));
  HRT_RETURN_IF_FAILED(set_config(checked_config));
  *out_ids = addition.keep();
  for (std::size_t i = 0; i < served_by.size(); ++i)
    if (served_by[i]) session_.targets.set_served_by((*out_ids)[i], (*out_ids)[*served_by[i]]);
  for (const std::uint64_t id : *out_ids) record_target(TargetChanged::Change::added, id);
  return HRT_OK;
}

hrt_result RecordedSession::begin(const hrt_reach_config& config) {
  const hrt_result result = session_.begin(config);
  record([&] {
    return Record{result, ReachBegun{.flags = config.flags,
                                     .plate_orientation_deg = config.plate_orientation_deg,
                                     .real_number = session_.targets.number_or_zero(config.real_target),
                                     .virtual_number = session_.targets.number_or_zero(config.virtual_target),
                                     .duration_s = config.duration_s,
                                     .reach = session_.reach()}};
  });
  return result;
}

hrt_result RecordedSession::retarget(hrt_target real_target, hrt_target virtual_target) {
  const hrt_result result = session_.retarget(real_target, virtual_target);
  record([&] {
    return Record{result, Retargeted{.real_number = session_.targets.number_or_zero(real_target),
                                     .virtual_number = session_.targets.number_or_zero(virtual_target),
                                     .reach = session_.reach()}};
  });
  return result;
}

hrt_result RecordedSession::touched(const hrt_contact& contact) {
  const hrt_result result = session_.touched(contact);
  record([&] { return Record{result, Touched{contact}}; });
  return result;
}

hrt_result RecordedSession::cancel() {
  const hrt_result result = session_.cancel();
  record([&] { return Record{result, ReachCancelled{}}; });
  return result;
}

hrt_result RecordedSession::end(hrt_reach_summary* summary) {
  const hrt_result result = session_.end(summary);
  record([&] { return Record{result, ReachEnded{*summary}}; });
  return result;
}

hrt_result RecordedSession::begin_setup(std::uint32_t what, const hrt_setup_config& config) {
  HRT_RETURN_IF_FAILED(session_.begin_setup(what, config));
  record([&] { return Record{.call = SetupBegun{what, config}}; });
  return HRT_OK;
}

hrt_result RecordedSession::update_setup(const hrt_sample& sample, hrt_setup_step* step) {
  const hrt_result result = session_.update_setup(sample, step);
  record([&] { return Record{result, SetupUpdated{sample, *step}}; });
  return result;
}

hrt_result RecordedSession::finish_setup(hrt_setup_result* out) {
  const hrt_result result = session_.finish_setup(out);
  record([&] { return Record{result, SetupFinished{*out}}; });
  if (result != HRT_OK) return result;
  registration_logged_ = false;
  if (out->done & (HRT_SETUP_CALIBRATION | HRT_SETUP_RETEST)) conditions.measured_now();
  return HRT_OK;
}

hrt_result RecordedSession::cancel_setup() {
  const hrt_result result = session_.cancel_setup();
  record([&] { return Record{result, SetupCancelled{}}; });
  return result;
}

hrt_result RecordedSession::refuse(hrt_result result, Refused::Argument argument, const void* given) {
  record([&] {
    Refused refused{argument, 0};
    if (given) std::memcpy(&refused.struct_size, given, sizeof refused.struct_size);
    return Record{result, refused};
  });
  return result;
}

void RecordedSession::log_findings(std::uint64_t handle) {
  if (session_.has_doubted_registration() && !registration_logged_) {
    Text<240> text;
    text << "session " << handle
         << ": the registration of the plate was older or worse than allowed in a reach, or missing";
    write_log(HRT_LOG_WARNING, text.c_str());
    registration_logged_ = true;
  }
  if (!session_.has_failed() || failure_logged_) return;
  Text<240> text;
  text << "session " << handle
       << ": a defect of the library made a value of a command or summary not finite; the plate was held, and "
          "the reach taught nothing";
  write_log(HRT_LOG_ERROR, text.c_str());
  failure_logged_ = true;
}

void RecordedSession::log_conditions(std::uint64_t handle) const {
  const hrt_conditions measured = conditions.measured();
  if (measured.differing == 0) return;
  Text<400> text;
  text << "session " << handle << ": the person was measured with another";
  if (measured.differing & HRT_CONDITION_PLATE) text << " plate, \"" << measured.plate << "\"";
  if (measured.differing == (HRT_CONDITION_PLATE | HRT_CONDITION_TRACKER)) text << ", and";
  if (measured.differing & HRT_CONDITION_TRACKER) text << " tracker, \"" << measured.tracker << "\"";
  text << "; calibrate again, or expect first reaches to be less accurate";
  write_log(HRT_LOG_WARNING, text.c_str());
}

std::uint32_t RecordedSession::state() const {
  const Targets& targets = session_.targets;
  const bool ready = targets.real_count() > 0 && targets.virtual_count() > 0;
  return (session_.reaching()               ? HRT_STATE_REACHING
          : ready && !session_.setting_up() ? HRT_STATE_READY
                                            : 0) |
         (session_.setting_up() ? HRT_STATE_SETTING_UP : 0) | (recorder_ ? HRT_STATE_RECORDING : 0);
}

hrt_result RecordedSession::start_recording(const char* path, std::uint64_t handle) {
  HRT_RETURN_IF_FAILED(session_.check_no_reach());
  if (recorder_ && !recorder_->is_of_parent())
    return fail(HRT_ERROR_WRONG_STATE, "the session is being recorded already; stop that first");
  File file;
  HRT_RETURN_IF_FAILED(File::create(path, &file));
  Text<128> name;
  name << "session " << handle << ", " << Shown{path};
  recorder_ = std::make_unique<Recorder>(std::move(file), name.view(), session_.config(), session_.targets,
                                         session_.plate_orientation_deg());
  return HRT_OK;
}

hrt_result RecordedSession::check_recording() const {
  if (!recorder_) return fail(HRT_ERROR_WRONG_STATE, "nothing is being recorded");
  if (!recorder_->is_of_parent()) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE,
              "the recording is of the process that this one was forked from; calls here are not recorded");
}

RecorderStatus RecordedSession::stop_recording() {
  const RecorderStatus status = recorder_->stop();
  recorder_.reset();
  return status;
}

void RecordedSession::record_update(hrt_result result, const hrt_sample& sample, const hrt_command& command) const {
  recorder_->push({result, Updated{sample, result == HRT_OK ? command : hrt_command{}, session_.started()}});
}

void RecordedSession::record_target(TargetChanged::Change change, std::uint64_t id) const {
  record([&] {
    const hrt_target_config* config = session_.targets.find(id);
    TargetChanged changed{change, session_.targets.number(id), config ? *config : hrt_target_config{}};
    changed.config.served_by = {session_.targets.number_or_zero(changed.config.served_by)};
    return Record{.call = changed};
  });
}

}  // namespace hrt::plugin
