#include "samples/experiment/output/export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

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
  const char* type;
  const char* unit;
  const char* what;
};

// First columns of each table: the session to which a row belongs.
const Column session_columns[] = {
    {"participant", "integer", "", "number of the participant, from 1"},
    {"session", "integer", "", "number of the session, from 1"},
    {"subject", "text", "", "`a person` or `simulated` with its seed, then the tracker, if there is one"},
    {"level", "text", "", "level of the between-participants factor"},
};

struct Table {
  const char* file;
  const char* what;
  std::vector<Column> columns;
};

const std::vector<Column> reach_columns{
    {"virtual_deg", "number", "deg", "direction of the virtual target from the start, left positive"},
    {"real_deg", "number", "deg", "direction of the real target from the start, left positive"},
    {"miss_deg", "number", "deg", "bearing of the end of the reach, minus that of the real target"},
    {"abs_miss_deg", "number", "deg", "absolute value of miss_deg"},
    {"miss_mm", "number", "mm", "distance of the end from the real target"},
    {"peak_felt_error_deg", "number", "deg",
     "largest perceived-direction error. Simulation: ground truth. Person: estimate by the controller under test; do "
     "not use it as an outcome"},
    {"is_truth", "boolean", "", "true: peak_felt_error_deg is ground truth"},
    {"duration_s", "number", "s", "duration of the motion"},
    {"samples", "integer", "", "number of samples of the reach, including dropouts"},
    {"dropped", "integer", "",
     "number of samples without a tracked finger; in simulated data without OpenXR, outliers are included"},
    {"tactile_weight", "number", "", "w_T as estimated by the controller at the end of the reach"},
    {"tracker_noise_m", "number", "m", "SD of the tracker's noise, as estimated by the plugin"},
    {"misfit", "number", "", "largest misfit of the plugin's model (hrt_command::misfit); limit 6"},
    {"flags", "integer", "", "warnings of the plugin: bits HRT_COMMAND_* (hrt_reach_summary::flags)"},
};

std::vector<Column> joined(std::vector<Column> first, const std::vector<Column>& middle,
                           const std::vector<Column>& last) {
  first.insert(first.end(), middle.begin(), middle.end());
  first.insert(first.end(), last.begin(), last.end());
  return first;
}

const std::vector<Column> trial_columns{
    {"block", "integer", "", "number of the block; 0 is practice"},
    {"kind", "text", "", "practice, reaches or noticeability"},
    {"pass", "integer", "", "pass of the block, from 1; a block restarts after a long pause"},
    {"trial", "integer", "", "planned position in the block, from 1"},
    {"condition", "text", "",
     "`practice` in practice. Before unblinding: a letter, assigned at random for each participant, or "
     "`noticeability`; after unblinding: the name of the condition"},
    {"is_catch", "integer", "", "1: no gap; the plate then rests, except in noticeability. Practice always has 1"},
    {"pair", "text", "", "name of the pair of targets; empty for noticeability"},
    {"reason", "text", "", "reason for which the attempt is invalid; empty: valid"},
    {"attempt", "integer", "", "number of the attempt; interrupted attempts count"},
    {"gap_deg", "number", "deg", "noticeability: gap of the retargeted reach; 0 in catch trials"},
    {"bent", "integer", "", "noticeability: 1 or 2, the reach that was retargeted"},
    {"run", "integer", "", "noticeability: number of the interleaved QUEST+ run, from 1"},
    {"bend_deg", "number", "deg",
     "noticeability: delivered bend, the stimulus of the threshold: angle between the ends of both reaches"},
    {"recording", "text", "",
     "name of the file in the folder `recordings` of the session, without extension; noticeability: also without "
     "`_part-1` or `_part-2`"},
};

const Table tables[] = {
    {"trials.csv", "One row per trial, with its last attempt",
     joined(trial_columns, reach_columns,
            {{"presented", "integer", "", "rank of the trial by the time at which it ended, from 1"},
             {"end", "text", "", "counted, missing (too many invalid attempts), or open (not finished)"},
             {"answer", "text", "", "answer to the question; noticeability: 1 or 2, the reach that seemed bent"},
             {"is_right", "integer", "", "noticeability: 1 if `answer` equals `bent`, else 0; empty in catch trials"},
             {"began_utc", "time", "", "start of the last attempt"}})},
    {"attempts.csv", "One row per reach of each attempt, including invalid attempts",
     joined(trial_columns, reach_columns,
            {{"part", "integer", "", "number of the reach in the trial, from 1; empty: interrupted attempt"},
             {"counts", "boolean", "", "true: valid by the rules of the design"},
             {"utc", "time", "", "end of the attempt, or start of an interrupted attempt"}})},
    {"people.csv",
     "One row per session",
     {{"end", "text", "", "done, stopped or open"},
      {"reason", "text", "", "why the session ended or was last interrupted"},
      {"library", "text", "", "library version at each start of the program, separated by spaces"},
      {"set_up_known", "boolean", "", "true: the set-up determined the tactile weight"},
      {"tactile_weight", "number", "", "w_T as estimated by the set-up"},
      {"tactile_weight_low", "number", "", "lower end of the 95 % interval of tactile_weight"},
      {"tactile_weight_high", "number", "", "upper end of the 95 % interval of tactile_weight"},
      {"threshold_deg", "number", "deg",
       "detection threshold of the delivered bend by QUEST+: Weibull scale (82 % correct, lapses excluded), "
       "exponential of the posterior mean of its logarithm"},
      {"threshold_low_deg", "number", "deg", "lower end of the 95 % interval of threshold_deg"},
      {"threshold_high_deg", "number", "deg", "upper end of the 95 % interval of threshold_deg"},
      {"threshold_answers", "integer", "", "number of answers from which the threshold is estimated"},
      {"run_thresholds_deg", "text", "deg",
       "threshold from each interleaved run, separated by spaces; -: the run has no answer"}}},
    {"questionnaires.csv",
     "One row per answer",
     {{"questionnaire", "text", "", "name of the questionnaire"},
      {"when", "text", "", "`before` or `after` the reaches, or `block N`, after block N"},
      {"condition", "text", "", "condition of the block; empty if the block has several"},
      {"item", "integer", "", "number of the item, from 1"},
      {"text", "text", "", "text of the item"},
      {"answer", "integer or text", "", "number between `low` and `high` of the design, or text"},
      {"utc", "time", "", "time of the last answer to the questionnaire"}}},
    {"events.csv",
     "One row per event of the kinds that the column `event` lists",
     {{"number", "integer", "", "number of the event in the journal"},
      {"utc", "time", "", "time of the event"},
      {"monotonic_ns", "integer", "ns",
       "monotonic clock since the computer was started; simulated: since the session began"},
      {"event", "text", "",
       "opened, closed (with the reason), consent, registered, checked, set_up, rest, note, plate_stopped, unblinded, "
       "block_again, end"},
      {"details", "text", "", "data of the event as JSON, without samples and files"}}},
};

std::string shown_condition(const Design& design, const State& state, unsigned block, unsigned condition,
                            bool unblinds) {
  const BlockKind kind = state.schedule.blocks[block].kind;
  return unblinds && kind != BlockKind::practice ? design.conditions[condition].name
                                                 : blinded_name(design, state.participant, kind, condition);
}

// Returns a row of trials.csv as JSON. Some of its keys are not columns of the table; a missing value has no key.
json trial_row(const Design& design, const State& state, unsigned block, std::size_t trial, bool unblinds) {
  const TrialRecord& record = state.trials[block][trial];
  const PlannedTrial& planned = state.schedule.blocks[block].trials[trial];
  json row = record.attempt.is_null() ? json::object() : record.attempt;
  const bool is_choice = row.contains("bent");
  const unsigned bent = row.value("bent", 0U);
  if (!record.reach.is_null()) {
    row["reason"] = record.reach["reason"];
    if (record.reach.contains("bend_deg")) row["bend_deg"] = record.reach["bend_deg"];
    // A trial of noticeability has the values of its bent reach.
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
  row["condition"] = shown_condition(design, state, block, planned.condition, unblinds);
  row["is_catch"] = int{planned.is_catch};
  row["end"] = std::array{"open", "counted", "missing"}[static_cast<std::size_t>(record.end)];
  if (is_choice) row["bent"] = bent + 1;
  if (record.answer) row["answer"] = is_choice ? json(*record.answer + 1) : json(design.answers[*record.answer]);
  if (record.answer && is_choice && !planned.is_catch) row["is_right"] = int{*record.answer == bent};
  if (record.attempts > 0) row["began_utc"] = utc_text(record.began_utc_ms);
  return row;
}

json person_row(const Design& design, const State& state, const std::vector<Event>& events) {
  json row{{"end", state.end.empty() ? "open" : state.end}, {"reason", ""}, {"library", ""}};
  for (const Event& event : events) {
    if (event.name == "end" || event.name == "closed") row["reason"] = event.data.at("reason");
    if (event.name == "consent" && !event.data.at("given").get<bool>()) row["reason"] = "consent was not given";
    if (event.name != "opened") continue;
    const std::string before = row["library"];
    row["library"] = before + (before.empty() ? "" : " ") + event.data.at("library").get<std::string>();
  }
  if (state.set_up) {
    row.update(*state.set_up);
    row["set_up_known"] = row["is_known"];
  }
  // Without answers the posterior is the prior, which is not a result.
  const app::QuestPlus::Threshold found = state.quest.threshold();
  if (state.quest.answers() > 0)
    row.update({{"threshold_deg", found.deg},
                {"threshold_low_deg", found.lower_deg},
                {"threshold_high_deg", found.upper_deg}});
  if (design.noticeability) row["threshold_answers"] = state.quest.answers();
  std::string runs;
  for (const app::QuestPlus& run : state.quest_runs)
    runs += (runs.empty() ? "" : " ") + (run.answers() == 0 ? "-" : format("%.4g", run.threshold().deg));
  row["run_thresholds_deg"] = runs;
  return row;
}

// Adds the rows of all tables except trials.csv and people.csv. `add` appends a row to a table.
void add_events(const Design& design, const State& state, const std::vector<Event>& events, bool unblinds,
                const std::function<void(const char*, json)>& add) {
  json attempt;
  for (const Event& event : events) {
    const json& data = event.data;
    const std::string utc = utc_text(event.utc_ms);
    if (event.name == "questionnaire") {
      const auto asked =
          std::find_if(design.questionnaires.begin(), design.questionnaires.end(),
                       [&](const Questionnaire& each) { return each.name == data.at("name").get<std::string>(); });
      const std::string when = data.at("when");
      std::string condition;
      if (when.starts_with("block ") && design.order != Order::random_in_blocks) {
        const auto block = static_cast<unsigned>(std::stoul(when.substr(6)));
        condition =
            shown_condition(design, state, block, state.schedule.blocks.at(block).trials.at(0).condition, unblinds);
      }
      for (std::size_t i = 0; i < data.at("answers").size(); ++i)
        add("questionnaires.csv", {{"questionnaire", data["name"]},
                                   {"when", when},
                                   {"condition", condition},
                                   {"item", i + 1},
                                   {"text", asked->items.at(i)},
                                   {"answer", data["answers"][i]},
                                   {"utc", utc}});
    } else if (event.name == "attempt" || event.name == "reach") {
      if (event.name == "attempt" && !attempt.is_null()) add("attempts.csv", attempt);  // the interrupted attempt
      if (event.name == "attempt") {
        attempt = data;
        const unsigned block = data.at("block"), trial = data.at("trial");
        const unsigned condition = state.schedule.blocks.at(block).trials.at(trial - 1).condition;
        attempt["condition"] = shown_condition(design, state, block, condition, unblinds);
        attempt["is_catch"] = int{data.at("is_catch").get<bool>()};
        if (data.contains("bent")) attempt["bent"] = data["bent"].get<unsigned>() + 1;
        attempt.update({{"reason", "interrupted"}, {"counts", false}, {"utc", utc}});
        continue;
      }
      attempt.update({{"reason", data.at("reason")}, {"counts", data.at("counts")}, {"utc", utc}});
      for (std::size_t i = 0; i < data.at("parts").size(); ++i) {
        json row = attempt;
        row.update(data["parts"][i]);
        if (data.contains("bend_deg")) row["bend_deg"] = data["bend_deg"];
        row["part"] = i + 1;
        row["abs_miss_deg"] = std::abs(row["miss_deg"].get<double>());
        add("attempts.csv", row);
      }
      attempt = nullptr;
    } else if (event.name != "slide" && event.name != "touch" && event.name != "answer") {
      json details = data;
      for (const char* file : {"profile", "registration"}) details.erase(file);
      add("events.csv", {{"number", event.number},
                         {"utc", utc},
                         {"monotonic_ns", event.monotonic_ns},
                         {"event", event.name},
                         {"details", details.dump(-1, ' ', false, json::error_handler_t::replace)}});
    }
  }
  if (!attempt.is_null()) add("attempts.csv", attempt);
}

std::string dictionary_of(const Design& design) {
  std::string text = "# Columns of the tables\n\nUTF-8; an empty field means unknown. Study: " + design.title +
                     ", SHA-256 " + design.sha256 + "\n";
  for (const Table& table : tables) {
    text += std::string("\n## ") + table.file + "\n\n" + table.what +
            ".\n\n| column | type | unit | |\n|---|---|---|---|\n";
    for (const Column& column : joined({std::begin(session_columns), std::end(session_columns)}, table.columns, {}))
      text +=
          std::string("| `") + column.name + "` | " + column.type + " | " + column.unit + " | " + column.what + " |\n";
  }
  return text;
}

}  // namespace

Tables export_study(const Design& design, const std::filesystem::path& study, bool unblinds) {
  Tables found{.files = {{"dictionary.md", dictionary_of(design)}}};
  json session_row;
  const auto add_line = [&](const Table& table, json row, bool is_header) {
    std::string line;
    row.update(session_row);
    for (const Column& column : joined({std::begin(session_columns), std::end(session_columns)}, table.columns, {}))
      line += (line.empty() ? "" : ",") + csv_field(is_header ? column.name : text_of(row[column.name]));
    found.files[table.file] += line + "\n";
  };
  const auto add = [&](const std::string& file, const json& row) {
    for (const Table& table : tables)
      if (file == table.file) add_line(table, row, false);
  };
  session_row = json::object();
  for (const Table& table : tables) add_line(table, json::object(), true);
  constexpr unsigned max_sessions = 99;
  for (unsigned participant = 1; participant <= 2 * design.participants; ++participant)
    for (unsigned session = 1; session <= max_sessions; ++session) {
      const auto file = folder_of({study, participant, session}) / "journal.jsonl";
      if (!std::filesystem::exists(file)) continue;
      const std::vector<Event> events = read_journal(content_of(file), file.string());
      if (events.empty()) continue;
      if (events.front().data.at("sha256") != design.sha256)
        throw Refusal(file.string() +
                      ": this session has another design than study.json (by SHA-256); restore the study's study.json");
      const Schedule schedule = schedule_of(design, participant);
      const State state = state_of(design, schedule, participant, events);
      ++found.sessions;
      session_row = {{"participant", participant},
                     {"session", session},
                     {"subject", events.front().data.at("subject")},
                     {"level", design.levels.empty() ? "" : design.levels[schedule.level]}};
      add("people.csv", person_row(design, state, events));
      add_events(design, state, events, unblinds, add);
      for (unsigned block = 0; block < state.trials.size(); ++block)
        for (std::size_t trial = 0; trial < state.trials[block].size(); ++trial)
          add("trials.csv", trial_row(design, state, block, trial, unblinds));
    }
  if (found.sessions == 0)
    throw Refusal(study.string() + ": this folder has no session; run hrt-experiment run or simulate with this --data");
  return found;
}

}  // namespace hrt::experiment
