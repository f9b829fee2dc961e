#include "samples/experiment/session/state.h"

#include <algorithm>
#include <limits>

#include "samples/experiment/design/draws.h"

namespace hrt::experiment {

using nlohmann::json;

State::State(const Design& of_design, const Schedule& of_schedule, unsigned of_participant)
    : design(of_design),
      schedule(of_schedule),
      participant(of_participant),
      passes(of_schedule.blocks.size(), 1),
      profiles(of_design.conditions.size()),
      quest(of_design.noticeability ? of_design.noticeability->min_gap_deg : 1.0,
            of_design.noticeability ? of_design.noticeability->max_gap_deg : 2.0),
      quest_runs(of_design.noticeability ? of_design.noticeability->runs : 0, quest) {
  for (const Block& planned : schedule.blocks) trials.emplace_back(planned.trials.size());
  begin_block(0);
}

void State::begin_block(unsigned number) {
  block = number;
  pending.clear();
  if (block == schedule.blocks.size()) return;
  for (unsigned i = 0; i < schedule.blocks[block].trials.size(); ++i) pending.push_back(i);
  if (pending.empty()) begin_block(number + 1);
}

void State::end_trial(TrialRecord::End of_trial) {
  TrialRecord& record = trials[block][pending.front()];
  record.end = of_trial;
  record.presented = ++presented;
  awaits_answer = false;
  pending.erase(pending.begin());
  if (!pending.empty()) return;
  begin_block(block + 1);
  rest_due = block < schedule.blocks.size();
}

// Records a reach. A trial whose reach was invalid moves to a random later position, if there is one; after the last
// attempt it is missing.
void State::apply_reach(const Event& event) {
  TrialRecord& record = trials[block][pending.front()];
  record.reach = event.data;
  reaches += static_cast<unsigned>(event.data.at("parts").size());
  const std::string profile = event.data.value("profile", "");
  if (!profile.empty()) profiles[schedule.blocks[block].trials[pending.front()].condition] = profile;
  if (event.data.at("counts").get<bool>()) {
    refused_in_a_row = 0;
    awaits_answer = schedule.blocks[block].kind == BlockKind::noticeability || !design.question.empty();
    if (!awaits_answer) end_trial(TrialRecord::End::counted);
    return;
  }
  ++record.refused;
  ++refused_in_a_row;
  if (record.refused >= design.validity.max_attempts) return end_trial(TrialRecord::End::missing);
  const unsigned again = pending.front();
  pending.erase(pending.begin());
  Stream draw(Use::returns, {design.seed, participant, block, again, record.refused});
  const auto left = static_cast<unsigned>(pending.size());
  pending.insert(pending.begin() + (left == 0 ? 0 : 1 + draw.below(left)), again);
}

void State::apply_answer(unsigned answer) {
  TrialRecord& record = trials[block][pending.front()];
  record.answer = answer;
  const PlannedTrial& planned = schedule.blocks[block].trials[pending.front()];
  if (schedule.blocks[block].kind == BlockKind::noticeability && !planned.is_catch)
    for (app::QuestPlus* each : {&quest, &quest_runs[planned.pair]})
      each->update(record.reach.value("bend_deg", record.attempt.at("gap_deg").get<double>()),
                   answer == record.attempt.at("bent").get<unsigned>());
  end_trial(TrialRecord::End::counted);
}

std::int64_t State::since_last_ns(const Now& now, const std::string& boot_now) const {
  constexpr std::int64_t ns_per_ms = 1'000'000;
  if (!last) return 0;
  return boot_now == boot ? now.monotonic_ns - last->monotonic_ns : (now.utc_ms - last->utc_ms) * ns_per_ms;
}

void State::apply(const Event& event) {
  const json& data = event.data;
  const Now now{event.utc_ms, event.monotonic_ns};
  const std::string boot_now = event.name == "opened" ? data.at("boot").get<std::string>() : boot;
  if (has_consent) passed_ns += std::max<std::int64_t>(0, since_last_ns(now, boot_now));
  boot = boot_now;
  last = now;
  if (event.name == "opened") {
    is_placed = false;
    registers = data.at("registers");
  } else if (event.name == "consent") {
    has_consent = data.at("given");
    if (!has_consent) end = "stopped";
  } else if (event.name == "touch") {
    touches.push_back(data);
  } else if (event.name == "registered") {
    registration = data.at("registration");
    registrations.insert(registration);
    is_placed = data.at("touched");
    touches.clear();
  } else if (event.name == "checked") {
    is_placed = data.at("is_there");
    if (!is_placed) registration.clear();
  } else if (event.name == "slide") {
    slides.push_back(data);
  } else if (event.name == "set_up") {
    set_up = data;
    slides.clear();
  } else if (event.name == "questionnaire") {
    questionnaires.insert(data.at("when").get<std::string>() + " " + data.at("name").get<std::string>());
  } else if (event.name == "rest") {
    rest_due = false;
  } else if (event.name == "attempt") {
    TrialRecord& record = trials[block][pending.front()];
    ++record.attempts;
    record.attempt = data;
    record.began_utc_ms = event.utc_ms;
  } else if (event.name == "reach") {
    apply_reach(event);
  } else if (event.name == "answer") {
    apply_answer(data.at("answer"));
  } else if (event.name == "block_again") {
    ++passes[block];
    for (TrialRecord& record : trials[block]) record = {.attempts = record.attempts};
    awaits_answer = false;
    rest_due = false;
    begin_block(block);
  } else if (event.name == "end") {
    end = data.at("how");
  }
}

double State::max_gap_deg() const {
  const bool is_known = set_up && set_up->at("is_known").get<bool>();
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  return is_known ? set_up->value("max_gap_deg", unlimited) : unlimited;
}

Task State::next() const {
  if (!end.empty()) return {Task::Kind::end};
  if (!has_consent) return {Task::Kind::consent};
  if (registers && registration.empty()) return {Task::Kind::registration};
  if (registers && !is_placed) return {Task::Kind::check};
  if (design.calibrates && !set_up) return {Task::Kind::set_up};
  const bool after = block == schedule.blocks.size();
  const auto asked = [&](const std::string& when, const std::string& now) -> std::optional<Task> {
    for (unsigned i = 0; i < design.questionnaires.size(); ++i) {
      const Questionnaire& paper = design.questionnaires[i];
      if ((paper.when == when || (paper.when == "both" && when != "block")) &&
          !questionnaires.contains(now + " " + paper.name))
        return Task{Task::Kind::questionnaire, block, i, now};
    }
    return std::nullopt;
  };
  if (block > 0 && schedule.blocks[block - 1].kind == BlockKind::reaches)
    if (const std::optional<Task> task = asked("block", "block " + std::to_string(block - 1))) return *task;
  const std::string when = after ? "after" : "before";
  if (const std::optional<Task> task = asked(when, when)) return *task;
  if (after) return {Task::Kind::end};
  if (awaits_answer) return {Task::Kind::answer, block, pending.front()};
  if (rest_due) return {Task::Kind::rest, block};
  return {Task::Kind::trial, block, pending.front()};
}

State state_of(const Design& design, const Schedule& schedule, unsigned participant, const std::vector<Event>& events) {
  State state(design, schedule, participant);
  for (const Event& event : events) state.apply(event);
  return state;
}

}  // namespace hrt::experiment
