#include "samples/experiment/session/session.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "samples/app/text/format.h"
#include "samples/experiment/design/draws.h"
#include "samples/experiment/session/library.h"

namespace hrt::experiment {

using nlohmann::json;

namespace {

constexpr double deg_per_rad = 180.0 / std::numbers::pi;
constexpr std::int64_t ns_per_minute = 60'000'000'000;

// Number of the first reach, for random draws; lower numbers belong to the slides of the set-up.
constexpr unsigned first_reach = 512;

struct Part {
  double real_deg;
  double virtual_deg;
  double distance_m;
  double radius_m;
  Condition condition;
  unsigned condition_index;
};

json outcome_of(const Part& part, const ReachOutcome& outcome, const double (&start_m)[3]) {
  const double right_m = outcome.end_m[0] - start_m[0], away_m = start_m[2] - outcome.end_m[2];
  const double real_rad = part.real_deg / deg_per_rad;
  const double miss_deg = std::remainder(std::atan2(-right_m, away_m) * deg_per_rad - part.real_deg, 360.0);
  const double miss_m =
      std::hypot(right_m + part.distance_m * std::sin(real_rad), away_m - part.distance_m * std::cos(real_rad));
  const hrt_reach_summary& summary = outcome.summary;
  return {{"real_deg", part.real_deg},
          {"virtual_deg", part.virtual_deg},
          {"miss_deg", miss_deg},
          {"miss_mm", 1e3 * miss_m},
          {"peak_felt_error_deg", outcome.peak_felt_error_deg},
          {"is_truth", outcome.is_truth},
          {"duration_s", outcome.duration_s},
          {"samples", summary.counts.samples},
          {"dropped", summary.counts.dropped_samples},
          {"tactile_weight", summary.learnt.tactile_weight},
          {"tracker_noise_m", summary.learnt.tracker_noise_m},
          {"misfit", summary.misfit},
          {"flags", summary.flags}};
}

double bearing_of_end_deg(const json& part) {
  return part.at("real_deg").get<double>() + part.at("miss_deg").get<double>();
}

std::string invalid_reason(const Validity& rules, const ReachOutcome& outcome) {
  if (!outcome.problem.empty()) return outcome.problem;
  if (!outcome.has_ended) return "the reach did not end";
  const auto samples = static_cast<double>(std::max<std::int64_t>(1, outcome.summary.counts.samples));
  if (static_cast<double>(outcome.summary.counts.dropped_samples) > rules.max_dropped_share * samples)
    return "too many samples were dropouts or outliers";
  if (outcome.duration_s < rules.min_s) return "the reach was too fast";
  return outcome.duration_s > rules.max_s ? "the reach was too slow" : "";
}

class SessionRun {
 public:
  SessionRun(const Design& design, const SessionPlace& place, Subject& subject, const Disk& disk)
      : design_(design),
        place_(place),
        subject_(subject),
        disk_(disk),
        schedule_(schedule_of(design, place.participant)),
        folder_(folder_of(place)),
        stem_(format("sub-%02u_ses-%02u", place.participant, place.session)),
        journal_((disk.make_folder(folder_ / "recordings"), folder_ / "journal.jsonl"), disk,
                 [&subject] { return subject.now(); }),
        state_(state_of(design, schedule_, place.participant, journal_.events())) {}

  // Runs the session and returns how it ended. If the experimenter quits, or an exception ends an opened session, the
  // journal gets the event "closed" with the reason.
  std::string run() {
    try {
      const std::string how = run_tasks();
      if (state_.end.empty()) log("closed", {{"reason", "the experimenter quit"}});
      return how;
    } catch (const std::exception& error) {
      close(error.what());
      throw;
    }
  }

 private:
  void close(const std::string& reason) {
    try {
      if (is_open_) log("closed", {{"reason", reason}});
    } catch (const std::exception&) {
      // The journal cannot be written; run() reports the first error.
    }
  }

  std::string run_tasks() {
    open();
    while (state_.end.empty()) try {
        if (handle_keys()) return "left";
        const Task task = state_.next();
        if (task.kind == Task::Kind::end) {
          log("end", {{"how", "done"}, {"reason", ""}});
          break;
        }
        stop_if_due();
        subject_.show(status_of(task));
        if (state_.end.empty()) perform(task);
      } catch (const Ended&) {
        // The experimenter has interrupted the task; the next iteration handles the key.
      }
    subject_.say(state_.end == "done" ? "The session is complete. Thank you." : "The session was stopped.");
    return state_.end;
  }

  void log(const std::string& name, json data) {
    disk_.step("before state");
    state_.apply(journal_.append(name, std::move(data)));
    disk_.step("after state");
  }

  // Starts or resumes the session. A block in which a trial has ended restarts if the interruption was long, or of
  // unknown length.
  void open() {
    const std::vector<Event>& events = journal_.events();
    bool is_long = false;
    if (!events.empty()) {
      const json& first = events.front().data;
      if (first.at("sha256") != design_.sha256)
        throw Refusal(folder_.string() + ": this session was started with another design (SHA-256 " +
                      first.at("sha256").get<std::string>() + "); give the other design, or another folder (--data)");
      if (first.at("subject") != subject_.description())
        throw Refusal(folder_.string() + ": this session was started with \"" + first.at("subject").get<std::string>() +
                      "\", not with \"" + subject_.description() +
                      "\"; give the same participant, seed and tracker, or another folder (--data)");
      if (!state_.end.empty()) return;
      subject_.continue_after(*state_.last);
      is_long = is_long_pause();
    }
    if (!events.empty() && events.front().data.at("library") != library_version())
      subject_.say("The session was started with version " + events.front().data.at("library").get<std::string>() +
                   " of the library. This program has version " + library_version() + ". The journal has both.");
    is_open_ = true;
    log("opened", {{"study", design_.title},
                   {"sha256", design_.sha256},
                   {"participant", state_.participant},
                   {"subject", subject_.description()},
                   {"plate", subject_.plate()},
                   {"library", library_version()},
                   {"registers", subject_.marks().has_value()},
                   {"boot", subject_.boot()}});
    if (!place_.plate.empty()) store("plate", place_.plate);
    const std::string& given = place_.registration;
    if (!given.empty() && !state_.registrations.contains(given)) store_registration(given, {{"touched", false}});
    const auto& records =
        state_.block < state_.trials.size() ? state_.trials[state_.block] : std::vector<TrialRecord>{};
    const bool is_in_block =
        std::any_of(records.begin(), records.end(), [](const TrialRecord& record) { return record.presented > 0; });
    if (is_long && is_in_block) log("block_again", {{"block", state_.block}});
  }

  bool is_long_pause() const {
    const std::int64_t pause_ns = state_.since_last_ns(subject_.now(), subject_.boot());
    return pause_ns < 0 || static_cast<double>(pause_ns) > design_.max_pause_minutes * ns_per_minute;
  }

  // Returns true if the experimenter quits.
  bool handle_keys() {
    for (Key key = subject_.key(); key != Key::none; key = subject_.key()) {
      if (key == Key::leave) return true;
      if (key == Key::unblind) log("unblinded", json::object());
      if (key == Key::note) log("note", {{"text", subject_.note()}});
      if (key == Key::rest) log("rest", {{"minutes", 0}, {"asked", true}});
      if (key == Key::stop_plate) log("plate_stopped", json::object());
    }
    return false;
  }

  void stop_if_due() {
    const std::int64_t passed_ns = state_.passed_ns + state_.since_last_ns(subject_.now(), state_.boot);
    const double minutes = static_cast<double>(passed_ns) / static_cast<double>(ns_per_minute);
    if (state_.refused_in_a_row >= design_.max_invalid_in_a_row)
      log("end", {{"how", "stopped"}, {"reason", "too many invalid reaches in a row"}});
    else if (state_.has_consent && minutes > design_.max_minutes)
      log("end", {{"how", "stopped"}, {"reason", "the session took too long"}});
  }

  void perform(const Task& task) {
    switch (task.kind) {
      case Task::Kind::consent:
        log("consent", {{"given", subject_.consents()}});
        if (state_.has_consent && !design_.start_text.empty()) subject_.say(design_.start_text);
        return;
      case Task::Kind::registration:
        return register_plate();
      case Task::Kind::check:
        return check_plate();
      case Task::Kind::set_up:
        return set_up();
      case Task::Kind::questionnaire: {
        const Questionnaire& paper = design_.questionnaires[task.trial];
        return log("questionnaire", {{"name", paper.name}, {"when", task.when}, {"answers", subject_.fill_in(paper)}});
      }
      case Task::Kind::rest:
        subject_.rest(design_.break_minutes);
        return log("rest", {{"minutes", design_.break_minutes}});
      case Task::Kind::trial:
        return attempt(task);
      case Task::Kind::answer:
        return ask(task);
      case Task::Kind::end:
        return;
    }
  }

  void register_plate() {
    const LibrarySession session({"", Controller::none, 0.0}, "", subject_);
    const std::optional<hrt_setup_config> marks = subject_.marks();
    const hrt_setup_result found =
        run_set_up(session, HRT_SETUP_REGISTRATION, marks ? &*marks : nullptr, "touch", state_.touches);
    store_registration(subject_.registered(session.config()), {{"touched", true},
                                                               {"residual_mm", 1e3 * found.registration_residual_m},
                                                               {"turn_sd_deg", found.registration_turn_sd_deg}});
  }

  void store_registration(const std::string& registration, json about) {
    store("registration", registration);
    about["registration"] = registration;
    log("registered", std::move(about));
  }

  void check_plate() {
    const std::optional<double> off_m = subject_.verify(state_.registration);
    json found{{"is_there", off_m.has_value()}};
    if (off_m) found["off_mm"] = 1e3 * *off_m;
    log("checked", std::move(found));
  }

  // Writes NAME.json. If it exists with other content, writes NAME-2.json, and so on.
  void store(const std::string& name, const std::string& content) const {
    for (unsigned number = 1;; ++number) {
      const std::filesystem::path file = folder_ / (name + (number == 1 ? "" : format("-%u", number)) + ".json");
      if (disk_.create(file, content) || content_of(file) == content) return;
    }
  }

  void set_up() {
    const LibrarySession session({"", Controller::people, 0.0}, "", subject_);
    store_set_up(session, run_set_up(session, HRT_SETUP_CALIBRATION, nullptr, "slide", state_.slides));
  }

  // Passes the slides or touches of the journal to the plugin again, then records the missing ones.
  hrt_setup_result run_set_up(const LibrarySession& session, std::uint32_t what, const hrt_setup_config* config,
                              const char* event, const std::vector<json>& made) {
    check(hrt_setup_begin(session.handle(), what, config));
    hrt_setup_step step = hrt_setup_step_init();
    step.part = what;
    hrt_setup_result result = hrt_setup_result_init();
    hrt_sample last = hrt_sample_init();
    const auto use = [&](const hrt_sample& sample) {
      last = sample;
      check(hrt_setup_update(session.handle(), &sample, &step));
    };
    for (std::size_t done = 0;; ++done) {
      if (done < made.size()) {
        for (const json& row : made[done].at("samples")) use(sample_of(row));
      } else {
        json samples = json::array();
        unsigned before = step.done;
        subject_.slide(session.handle(), step, static_cast<unsigned>(done), last.time_ns,
                       [&](const hrt_sample& sample) {
                         samples.push_back(row_of(sample));
                         use(sample);
                         const bool ends = step.done > before || step.instruction == HRT_STEP_FINISH;
                         before = std::min(before, step.done);  // a rejected fit of touches restarts them
                         return ends ? std::nullopt : std::optional(step);
                       });
        log(event, {{"number", done}, {"samples", std::move(samples)}});
      }
      // Each call of hrt_setup_finish() continues the fit by a few milliseconds at most.
      for (; step.instruction == HRT_STEP_FINISH; use(last)) {
        check(hrt_setup_finish(session.handle(), &result));
        if (result.left == 0) return result;
      }
    }
  }

  void store_set_up(const LibrarySession& session, const hrt_setup_result& result) {
    const std::string profile = session.profile();
    store("profile", profile);
    show_noise(session.config().tracker.noise_m);
    log("set_up", {{"is_known", result.done != 0},
                   {"slides", result.slides},
                   {"tactile_weight", result.tactile_weight.value},
                   {"tactile_weight_low", result.tactile_weight.lower},
                   {"tactile_weight_high", result.tactile_weight.upper},
                   {"max_gap_deg", result.max_gap_deg.value},
                   {"profile", profile}});
  }

  void show_noise(double noise_m) const {
    if (noise_m > 0.0) subject_.show({{"noise_mm", 1e3 * noise_m}});
  }

  std::string blinded(const Task& task) const {
    const Block& block = schedule_.blocks[task.block];
    return blinded_name(design_, state_.participant, block.kind, block.trials[task.trial].condition);
  }

  // Returns the reaches of a trial. For noticeability, draws which of two reaches is bent, and selects the gap: 0 in a
  // catch trial, otherwise by QUEST+, at most the largest feasible gap (or min_gap_deg, if that is larger).
  std::vector<Part> parts_of(const Task& task, json& about) const {
    const Block& block = schedule_.blocks[task.block];
    const PlannedTrial& planned = block.trials[task.trial];
    const Condition& condition = design_.conditions[planned.condition];
    const Condition at_rest{"", Controller::none, 0.0};
    if (block.kind != BlockKind::noticeability) {
      const Pair& pair = design_.pairs[planned.pair];
      about["pair"] = pair.name;
      if (planned.is_catch)
        return {{pair.real_deg, pair.real_deg, pair.distance_m, pair.radius_m, at_rest, planned.condition}};
      const double real_deg = pair.virtual_deg + condition.gap_share * (pair.real_deg - pair.virtual_deg);
      return {{real_deg, pair.virtual_deg, pair.distance_m, pair.radius_m, condition, planned.condition}};
    }
    const Noticeability& notice = *design_.noticeability;
    Stream draw(Use::intervals, {design_.seed, state_.participant, task.block, planned.number, record(task).refused});
    const unsigned bent = draw.below(2);
    const double gap_deg = planned.is_catch ? 0.0 : state_.quest_runs[planned.pair].next_gap_deg(state_.max_gap_deg());
    const double sign = draw.below(2) == 0 ? 1.0 : -1.0;
    about["gap_deg"] = gap_deg;
    about["bent"] = bent;
    if (!planned.is_catch) about["run"] = planned.pair + 1;
    const Condition& control = design_.conditions[notice.control];
    std::vector<Part> parts(
        2, Part{notice.virtual_deg, notice.virtual_deg, notice.distance_m, 0.0, control, notice.control});
    parts[bent].condition = condition;
    parts[bent].condition_index = notice.condition;
    parts[bent].real_deg -= sign * gap_deg;
    return parts;
  }

  // Describes the task for the live page, with the blinded name of the condition.
  json status_of(const Task& task) const {
    constexpr const char* tasks[] = {"consent", "registration", "check",  "set-up", "questionnaire",
                                     "break",   "reach",        "answer", "end"};
    std::string text = format("Participant %u: ", state_.participant) + tasks[static_cast<int>(task.kind)];
    double done = task.block;
    if (task.kind == Task::Kind::trial || task.kind == Task::Kind::answer) {
      const std::vector<PlannedTrial>& trials = schedule_.blocks[task.block].trials;
      const std::size_t left = state_.pending.size(), all = trials.size();
      text += format(", block %u of %zu, condition ", task.block, schedule_.blocks.size() - 1) + blinded(task) +
              format(", %zu of %zu trials left", left, all);
      done += 1.0 - static_cast<double>(left) / static_cast<double>(all);
    }
    done /= static_cast<double>(schedule_.blocks.size());
    return {{"study", design_.title}, {"doing", text}, {"done", done}};
  }

  const TrialRecord& record(const Task& task) const { return state_.trials[task.block][task.trial]; }

  // Returns a file name, without extension, that does not exist yet (a crash may have left the file of an attempt), and
  // the number of the attempt.
  std::string new_stem(const Task& task, unsigned* number) const {
    const PlannedTrial& planned = schedule_.blocks[task.block].trials[task.trial];
    for (*number = record(task).attempts + 1;; ++*number) {
      const std::string stem =
          stem_ + format("_block-%02u_trial-%03u_attempt-%02u_cond-", task.block, planned.number, *number) +
          blinded(task);
      if (!std::filesystem::exists(folder_ / "recordings" / (stem + ".json"))) return stem;
    }
  }

  void attempt(const Task& task) {
    const PlannedTrial& planned = schedule_.blocks[task.block].trials[task.trial];
    json about{{"block", task.block},
               {"kind", name_of(schedule_.blocks[task.block].kind)},
               {"pass", state_.passes[task.block]},
               {"trial", planned.number},
               {"condition", blinded(task)},
               {"is_catch", planned.is_catch}};
    const std::vector<Part> parts = parts_of(task, about);
    if (!design_.block_text.empty() && std::exchange(instructed_block_, task.block) != task.block)
      subject_.say(design_.block_text);
    unsigned number = 0;
    const std::string stem = new_stem(task, &number);
    about["attempt"] = number;
    about["recording"] = stem;
    log("attempt", about);
    describe(stem, about);
    json reach{{"parts", json::array()}, {"counts", true}, {"reason", ""}};
    for (std::size_t i = 0; i < parts.size() && reach["counts"]; ++i) {
      const std::string file = stem + (parts.size() > 1 ? format("_part-%zu", i + 1) : "") + ".csv";
      run_reach(parts[i], planned.condition, static_cast<unsigned>(i), folder_ / "recordings" / file, reach);
    }
    if (about.contains("bent") && reach["counts"]) {
      const json &bent = reach["parts"][about["bent"].get<std::size_t>()],
                 &other = reach["parts"][1 - about["bent"].get<std::size_t>()];
      reach["bend_deg"] = std::abs(bearing_of_end_deg(bent) - bearing_of_end_deg(other));
    }
    log("reach", std::move(reach));
  }

  // Writes the file STEM.json of an attempt: study, participant, attempt, library version, hashes of the files in use.
  void describe(const std::string& stem, json about) const {
    about["study"] = design_.title;
    about["study_sha256"] = design_.sha256;
    about["participant"] = state_.participant;
    about["subject"] = subject_.description();
    about["library"] = library_version();
    about["utc"] = utc_text(subject_.now().utc_ms);
    const std::map<std::string, std::string> in_use{
        {"profile", state_.set_up ? state_.set_up->at("profile").get<std::string>() : ""},
        {"registration", state_.registration},
        {"plate", place_.plate}};
    for (const auto& [name, content] : in_use)
      if (!content.empty()) about["sha256"][name + ".json"] = sha256_of(content);
    disk_.create(folder_ / "recordings" / (stem + ".json"), about.dump(1) + "\n");
  }

  void run_reach(const Part& part, unsigned condition, unsigned index, const std::filesystem::path& file, json& reach) {
    const std::string& learnt = state_.profiles[part.condition_index];
    const std::string first = state_.set_up ? state_.set_up->at("profile").get<std::string>() : "";
    const LibrarySession session(part.condition, learnt.empty() ? first : learnt, subject_);
    const auto [real, seen] = session.add_targets(part.real_deg, part.virtual_deg, part.distance_m, part.radius_m);
    session.record(file);
    const ReachOutcome outcome = subject_.reach({session.handle(), real, seen, part.real_deg, part.virtual_deg,
                                                 part.distance_m, part.radius_m, first_reach + state_.reaches + index});
    const std::int64_t ended_ns = subject_.now().monotonic_ns;
    session.finish_recording(file);
    disk_.sync(file);
    json& found = reach["parts"].emplace_back(outcome_of(part, outcome, session.config().start_position_m));
    found["ended_ns"] = ended_ns;
    reach["reason"] = invalid_reason(design_.validity, outcome);
    reach["counts"] = reach["reason"] == "";
    show_noise(outcome.summary.learnt.tracker_noise_m);
    const std::string validity = reach["counts"] ? "valid" : "invalid: " + reach["reason"].get<std::string>();
    const auto& reason = reach["reason"].get_ref<const std::string&>();
    if (!reach["counts"]) subject_.say("This reach is not counted: " + reason + (reason.ends_with('.') ? "" : "."));
    subject_.show({{"measured",
                    {format("miss %.1f mm", found["miss_mm"].get<double>()),
                     format("largest perceived-direction error %.1f°", outcome.peak_felt_error_deg),
                     format("misfit %.1f (limit 6)", outcome.summary.misfit), validity}}});
    if (part.condition.controller == Controller::people && part.condition_index == condition && reach["counts"])
      reach["profile"] = session.profile();
  }

  void ask(const Task& task) {
    const unsigned number = first_reach + state_.reaches;
    unsigned answer = 0;
    std::vector<double> felt_deg;
    for (const json& part : record(task).reach.at("parts")) felt_deg.push_back(part.at("peak_felt_error_deg"));
    if (felt_deg.size() > 1)
      answer = subject_.answer("Which reach was bent?", {"the first", "the second"}, felt_deg, number);
    else
      answer = subject_.answer(design_.question, design_.answers, felt_deg, number);
    log("answer", {{"answer", answer}});
  }

  const Design& design_;
  const SessionPlace& place_;
  Subject& subject_;
  const Disk& disk_;
  Schedule schedule_;
  std::filesystem::path folder_;
  std::string stem_;
  Journal journal_;
  State state_;
  bool is_open_ = false;
  std::optional<unsigned> instructed_block_;
};

}  // namespace

std::filesystem::path folder_of(const SessionPlace& place) {
  return place.study / format("sub-%02u", place.participant) / format("ses-%02u", place.session);
}

void freeze(const Design& design, const std::filesystem::path& study, const Disk& disk) {
  disk.make_folder(study);
  const std::filesystem::path frozen = study / "study.json";
  if (disk.create(frozen, design.text)) return;
  const std::string before = sha256_of(content_of(frozen));
  if (before != design.sha256)
    throw Refusal(frozen.string() + ": the data in this folder have another design (SHA-256 " + before +
                  ") than the given one (SHA-256 " + design.sha256 +
                  "); give the other design, or another folder (--data)");
}

std::string run_session(const Design& design, const SessionPlace& place, Subject& subject, const Disk& disk) {
  if (place.participant < 1 || place.participant > 2 * design.participants)
    throw Refusal(
        format("--participant: %u is not allowed; allowed: 1 to %u, or %u to %u for the replacements of these",
               place.participant, design.participants, design.participants + 1, 2 * design.participants));
  freeze(design, place.study, disk);
  return SessionRun(design, place, subject, disk).run();
}

}  // namespace hrt::experiment
