#include "samples/experiment/output/export.h"

#include <algorithm>
#include <cmath>

#include "samples/experiment/session/session.h"
#include "samples/format.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

// What a row is of.
struct Row {
  const Design& design;
  const State& state;
  unsigned session;
  unsigned block = 0;
  std::size_t trial = 0;
  bool unblinds = false;
  std::string subject;

  const TrialRecord& record() const { return state.trials[block][trial]; }
  const PlannedTrial& planned() const { return state.schedule.blocks[block].trials[trial]; }
  const json& attempt(const char* name) const {
    static const json nothing;
    return record().attempt.contains(name) ? record().attempt[name] : nothing;
  }
  // Of the bent reach of two, else of the only one.
  const json& part(const char* name) const {
    static const json nothing;
    if (!record().reach.contains("parts")) return nothing;
    const json& parts = record().reach["parts"];
    const std::size_t index = attempt("bent").is_null() ? 0 : attempt("bent").get<std::size_t>();
    return index < parts.size() ? parts[index][name] : nothing;
  }
};

std::string text_of(const json& value) {
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

struct Column {
  const char* name;
  const char* what;
  std::string (*value)(const Row&);
};

std::string condition_of(const Row& row) {
  return row.unblinds ? row.design.conditions[row.planned().condition].name
                      : letter_of(row.design, row.planned().condition);
}

std::string end_of(const Row& row) {
  constexpr const char* names[] = {"open", "counted", "missing"};
  return names[static_cast<std::size_t>(row.record().end)];
}

std::string right_of(const Row& row) {
  if (!row.record().answer || row.attempt("bent").is_null() || row.planned().is_catch) return "";
  return *row.record().answer == row.attempt("bent").get<unsigned>() ? "1" : "0";
}

std::string answer_of(const Row& row) {
  if (!row.record().answer) return "";
  return row.attempt("bent").is_null() ? row.design.answers[*row.record().answer]
                                       : format("%u", *row.record().answer + 1);
}

const Column columns[] = {
    {"participant", "number, from 1", [](const Row& r) { return format("%u", r.state.participant); }},
    {"session", "number, from 1", [](const Row& r) { return format("%u", r.session); }},
    {"subject", "who it was; `simulated` is no person", [](const Row& r) { return r.subject; }},
    {"level", "of the factor between people",
     [](const Row& r) { return r.design.levels.empty() ? "" : r.design.levels[r.state.schedule.level]; }},
    {"block", "from 0, which is practice", [](const Row& r) { return format("%u", r.block); }},
    {"kind", "practice, reaches or noticeability",
     [](const Row& r) { return name_of(r.state.schedule.blocks[r.block].kind); }},
    {"pass", "of the block, from 1: after a long pause it starts again",
     [](const Row& r) { return format("%u", r.state.passes[r.block]); }},
    {"trial", "within the block, as planned, from 1",
     [](const Row& r) { return format("%u", r.planned().number); }},
    {"presented", "order in which trials ended in the session, from 1",
     [](const Row& r) { return r.record().presented == 0 ? "" : format("%u", r.record().presented); }},
    {"condition", "a letter, or after unblinding its name", condition_of},
    {"is_catch", "1: no gap, the plate at rest",
     [](const Row& r) { return format("%d", int{r.planned().is_catch}); }},
    {"pair", "of targets; empty for noticeability", [](const Row& r) { return text_of(r.attempt("pair")); }},
    {"virtual_deg", "direction of the virtual target from the start, left positive, degrees",
     [](const Row& r) { return text_of(r.part("virtual_deg")); }},
    {"real_deg", "direction of the real target", [](const Row& r) { return text_of(r.part("real_deg")); }},
    {"end", "counted, missing (too many attempts), or open", end_of},
    {"reason", "why the last attempt did not count",
     [](const Row& r) { return r.record().reach.is_null() ? "" : text_of(r.record().reach["reason"]); }},
    {"attempt", "number of the last attempt, interrupted ones included",
     [](const Row& r) { return r.attempt("attempt").is_null() ? "" : text_of(r.attempt("attempt")); }},
    {"miss_deg", "bearing of the fingertip's end from the start, minus the real target's",
     [](const Row& r) { return text_of(r.part("miss_deg")); }},
    {"abs_miss_deg", "its size",
     [](const Row& r) {
       return r.part("miss_deg").is_null() ? "" : json(std::abs(r.part("miss_deg").get<double>())).dump();
     }},
    {"miss_mm", "distance of the end from the real target",
     [](const Row& r) { return text_of(r.part("miss_mm")); }},
    {"peak_felt_error_deg", "largest felt minus intended direction: the simulation's truth, or the estimate",
     [](const Row& r) { return text_of(r.part("peak_felt_error_deg")); }},
    {"duration_s", "of the motion", [](const Row& r) { return text_of(r.part("duration_s")); }},
    {"samples", "of the finger", [](const Row& r) { return text_of(r.part("samples")); }},
    {"dropped", "samples without a finger", [](const Row& r) { return text_of(r.part("dropped")); }},
    {"tactile_weight", "that the controller assumed at the end",
     [](const Row& r) { return text_of(r.part("tactile_weight")); }},
    {"gap_deg", "of the bent reach of noticeability; 0 in catch trials",
     [](const Row& r) { return text_of(r.attempt("gap_deg")); }},
    {"bent", "which reach of two was bent, from 1",
     [](const Row& r) {
       return r.attempt("bent").is_null() ? "" : format("%u", r.attempt("bent").get<unsigned>() + 1);
     }},
    {"answer", "to the question, or which reach seemed bent", answer_of},
    {"is_right", "1: the bent reach was found; empty in catch trials", right_of},
    {"began_utc", "of the last attempt",
     [](const Row& r) { return r.record().attempts == 0 ? "" : utc_text(r.record().began_utc_ms); }},
    {"recording", "in the session's folder recordings, without ending",
     [](const Row& r) { return text_of(r.attempt("recording")); }},
};

constexpr const char* people_columns =
    "participant,session,subject,end,set_up_known,tactile_weight,tactile_weight_low,tactile_weight_high,"
    "threshold_deg,threshold_low_deg,threshold_high_deg\n";

std::string person_row(const Row& row) {
  const State& state = row.state;
  std::string text = format("%u,%u,", state.participant, row.session) + quoted(row.subject) + "," +
                     (state.end.empty() ? "open" : state.end);
  for (const char* name : {"is_known", "tactile_weight", "tactile_weight_low", "tactile_weight_high"})
    text += "," + (state.set_up ? text_of(state.set_up->at(name)) : "");
  const bool has_threshold = row.design.noticeability.has_value();
  const QuestPlus::Threshold found = state.quest.threshold();
  for (const double value : {found.deg, found.lower_deg, found.upper_deg})
    text += "," + (has_threshold ? json(value).dump() : "");
  return text + "\n";
}

void add_session(Tables& tables, Row row) {
  ++tables.sessions;
  tables.people += person_row(row);
  for (row.block = 0; row.block < row.state.trials.size(); ++row.block)
    for (row.trial = 0; row.trial < row.state.trials[row.block].size(); ++row.trial) {
      std::string line;
      for (const Column& column : columns) line += (line.empty() ? "" : ",") + quoted(column.value(row));
      tables.trials += line + "\n";
    }
}

std::string dictionary_of(const Design& design) {
  std::string text =
      "# Columns of trials.csv\n\nOne row a trial, the last attempt; empty: not known. Study: " +
      design.title + ", SHA-256 " + design.sha256 + "\n\n| column | |\n|---|---|\n";
  for (const Column& column : columns)
    text += std::string("| `") + column.name + "` | " + column.what + " |\n";
  return text +
         "\n# Columns of people.csv\n\nOne row a session. Weights with a 95 % interval, by the set-up; "
         "thresholds of "
         "noticing a gap with a 95 % interval, by QUEST+.\n";
}

}  // namespace

Tables export_study(const Design& design, const std::filesystem::path& study, bool unblinds) {
  Tables tables;
  for (const Column& column : columns)
    tables.trials += (tables.trials.empty() ? "" : ",") + std::string(column.name);
  tables.trials += "\n";
  tables.people = people_columns;
  tables.dictionary = dictionary_of(design);
  constexpr unsigned max_sessions = 99;
  for (unsigned participant = 1; participant <= design.participants; ++participant)
    for (unsigned session = 1; session <= max_sessions; ++session) {
      const auto file = folder_of({study, participant, session}) / "journal.jsonl";
      if (!std::filesystem::exists(file)) break;
      const std::vector<Event> events = read_journal(content_of(file), file.string());
      if (events.empty()) continue;
      if (events.front().data.at("sha256") != design.sha256)
        throw Refusal(file.string() + ": is of another design");
      const Schedule schedule = schedule_of(design, participant);
      const State state = state_of(design, schedule, participant, events);
      add_session(tables, {design, state, session, 0, 0, unblinds, events.front().data.at("subject")});
    }
  return tables;
}

}  // namespace hrt::experiment
