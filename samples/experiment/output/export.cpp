#include "samples/experiment/output/export.h"

#include <array>
#include <cmath>

#include "samples/app/text/format.h"
#include "samples/app/text/text.h"
#include "samples/experiment/session/session.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

std::string text_of(const json& value) {
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

struct Column {
  const char* name;
  const char* what;
};

const Column columns[] = {
    {"participant", "number, from 1"},
    {"session", "number, from 1"},
    {"subject", "who it was; `simulated` is no person"},
    {"level", "of the factor between people"},
    {"block", "from 0, which is practice"},
    {"kind", "practice, reaches or noticeability"},
    {"pass", "of the block, from 1: after a long pause it starts again"},
    {"trial", "within the block, as planned, from 1"},
    {"presented", "order in which trials ended in the session, from 1"},
    {"condition", "a letter, or after unblinding its name"},
    {"is_catch", "1: no gap, the plate at rest"},
    {"pair", "of targets; empty for noticeability"},
    {"virtual_deg", "direction of the virtual target from the start, left positive, degrees"},
    {"real_deg", "direction of the real target"},
    {"end", "counted, missing (too many attempts), or open"},
    {"reason", "why the last attempt did not count"},
    {"attempt", "number of the last attempt, interrupted ones included"},
    {"miss_deg", "bearing of the fingertip's end from the start, minus the real target's"},
    {"abs_miss_deg", "its size"},
    {"miss_mm", "distance of the end from the real target"},
    {"peak_felt_error_deg", "largest felt minus intended direction: the simulation's truth, or the estimate"},
    {"duration_s", "of the motion"},
    {"samples", "of the finger"},
    {"dropped", "samples without a finger"},
    {"tactile_weight", "that the controller assumed at the end"},
    {"gap_deg", "of the bent reach of noticeability; 0 in catch trials"},
    {"bent", "which reach of two was bent, from 1"},
    {"answer", "to the question, or which reach seemed bent"},
    {"is_right", "1: the bent reach was found; empty in catch trials"},
    {"began_utc", "of the last attempt"},
    {"recording", "in the session's folder recordings, without ending"},
};

// A trial by the columns' names, and by some of the journal's: what it has not got is not there.
json trial_row(const Design& design, const State& state, unsigned block, std::size_t trial, bool unblinds) {
  const TrialRecord& record = state.trials[block][trial];
  const PlannedTrial& planned = state.schedule.blocks[block].trials[trial];
  json row = record.attempt.is_null() ? json::object() : record.attempt;
  const bool is_choice = row.contains("bent");
  const unsigned bent = row.value("bent", 0U);
  if (!record.reach.is_null()) {
    row["reason"] = record.reach["reason"];
    // Of the bent reach of two, else of the only one.
    if (const json& parts = record.reach["parts"]; bent < parts.size()) {
      row.update(parts[bent]);
      row["abs_miss_deg"] = std::abs(row["miss_deg"].get<double>());
    }
  }
  row["block"] = block;
  row["kind"] = name_of(state.schedule.blocks[block].kind);
  row["pass"] = state.passes[block];
  row["trial"] = planned.number;
  if (record.presented > 0) row["presented"] = record.presented;
  row["condition"] = unblinds ? design.conditions[planned.condition].name : letter_of(design, planned.condition);
  row["is_catch"] = int{planned.is_catch};
  row["end"] = std::array{"open", "counted", "missing"}[static_cast<std::size_t>(record.end)];
  if (is_choice) row["bent"] = bent + 1;
  if (record.answer) row["answer"] = is_choice ? json(*record.answer + 1) : json(design.answers[*record.answer]);
  if (record.answer && is_choice && !planned.is_catch) row["is_right"] = int{*record.answer == bent};
  if (record.attempts > 0) row["began_utc"] = utc_text(record.began_utc_ms);
  return row;
}

constexpr const char* people_columns =
    "participant,session,subject,end,set_up_known,tactile_weight,tactile_weight_low,tactile_weight_high,"
    "threshold_deg,threshold_low_deg,threshold_high_deg,threshold_answers\n";

std::string person_row(const Design& design, const State& state, unsigned session, const std::string& subject) {
  std::string text = format("%u,%u,", state.participant, session) + csv_field(subject) + "," +
                     (state.end.empty() ? "open" : state.end);
  for (const char* name : {"is_known", "tactile_weight", "tactile_weight_low", "tactile_weight_high"})
    text += "," + (state.set_up ? text_of(state.set_up->at(name)) : "");
  // Without an answer it is what is assumed of everybody.
  const app::QuestPlus::Threshold found = state.quest.threshold();
  for (const double value : {found.deg, found.lower_deg, found.upper_deg})
    text += "," + (state.quest.answers() > 0 ? json(value).dump() : "");
  return text + "," + (design.noticeability ? std::to_string(state.quest.answers()) : "") + "\n";
}

std::string dictionary_of(const Design& design) {
  std::string text =
      "# Columns of trials.csv\n\nOne row a trial, the last attempt; empty: not known. Study: " + design.title +
      ", SHA-256 " + design.sha256 + "\n\n| column | |\n|---|---|\n";
  for (const Column& column : columns) text += std::string("| `") + column.name + "` | " + column.what + " |\n";
  return text +
         "\n# Columns of people.csv\n\nOne row a session. Weights with a 95 % interval, by the set-up; "
         "thresholds of "
         "noticing a gap with a 95 % interval, by QUEST+, of so many answers.\n";
}

}  // namespace

Tables export_study(const Design& design, const std::filesystem::path& study, bool unblinds) {
  Tables tables;
  for (const Column& column : columns) tables.trials += (tables.trials.empty() ? "" : ",") + std::string(column.name);
  tables.trials += "\n";
  tables.people = people_columns;
  tables.dictionary = dictionary_of(design);
  constexpr unsigned max_sessions = 99;
  for (unsigned participant = 1; participant <= design.participants; ++participant)
    for (unsigned session = 1; session <= max_sessions; ++session) {
      const auto file = folder_of({study, participant, session}) / "journal.jsonl";
      if (!std::filesystem::exists(file)) continue;
      const std::vector<Event> events = read_journal(content_of(file), file.string());
      if (events.empty()) continue;
      if (events.front().data.at("sha256") != design.sha256) throw Refusal(file.string() + ": is of another design");
      const Schedule schedule = schedule_of(design, participant);
      const State state = state_of(design, schedule, participant, events);
      const std::string subject = events.front().data.at("subject");
      ++tables.sessions;
      tables.people += person_row(design, state, session, subject);
      for (unsigned block = 0; block < state.trials.size(); ++block)
        for (std::size_t trial = 0; trial < state.trials[block].size(); ++trial) {
          json row = trial_row(design, state, block, trial, unblinds);
          row.update({{"participant", participant}, {"session", session}, {"subject", subject}});
          if (!design.levels.empty()) row["level"] = design.levels[schedule.level];
          std::string line;
          for (const Column& column : columns) line += (line.empty() ? "" : ",") + csv_field(text_of(row[column.name]));
          tables.trials += line + "\n";
        }
    }
  if (tables.sessions == 0) throw Refusal(study.string() + ": holds no session; hrt-experiment run makes them");
  return tables;
}

}  // namespace hrt::experiment
