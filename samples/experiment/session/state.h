// The state of a session: a fold over its journal, and nothing else.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "samples/app/person/quest.h"
#include "samples/experiment/data/journal.h"
#include "samples/experiment/design/schedule.h"

namespace hrt::experiment {

/// Outcome of a trial.
struct TrialRecord {
  enum class End { open, counted, missing } end = End::open;
  unsigned attempts = 0;   ///< begun
  unsigned refused = 0;    ///< ended, and did not count: interrupted ones are not the person's
  unsigned presented = 0;  ///< order in which trials of the session ended, from 1
  std::int64_t began_utc_ms = 0;
  nlohmann::json attempt;  ///< the last one's event, and its reach
  nlohmann::json reach;
  std::optional<unsigned> answer;  ///< from 0
};

/// The next task of a session.
struct Task {
  enum class Kind { consent, registration, check, set_up, questionnaire, rest, trial, answer, end } kind;
  unsigned block = 0;
  unsigned trial = 0;     ///< index in the block; of a questionnaire: its index in the design
  std::string when = {};  ///< of a questionnaire: before, after, or "block 2"
};

struct State {
  State(const Design& design, const Schedule& schedule, unsigned participant);

  void apply(const Event& event);
  Task next() const;
  /// Largest gap that the plate can sustain for this participant, by the set-up; infinite if it is unknown.
  double max_gap_deg() const;
  /// Time since the last event; by the calendar if the machine was started again, when it may be negative.
  std::int64_t since_last_ns(const Now& now, const std::string& boot_now) const;

  const Design& design;
  const Schedule& schedule;
  unsigned participant;

  bool has_consent = false;
  bool registers = false;
  bool is_placed = false;                        ///< the plate, by touches since the last start
  std::string registration;                      ///< empty: not registered
  std::set<std::string> registrations;           ///< that there were
  std::vector<nlohmann::json> touches;           ///< of one that is not finished
  std::optional<nlohmann::json> set_up;          ///< its result, once it is done
  std::vector<nlohmann::json> slides;            ///< of a set-up that is not
  std::set<std::string> questionnaires;          ///< names such as "before SSQ"
  std::vector<std::vector<TrialRecord>> trials;  ///< of each block
  std::vector<unsigned> passes;                  ///< of each block, from 1: it starts again after a long pause
  unsigned block = 0;
  std::vector<unsigned> pending;  ///< indices of the block's trials, the next one first
  bool rest_due = false;
  bool is_open = false;  ///< an attempt is
  bool awaits_answer = false;
  unsigned reaches = 0;  ///< ended, counted or not
  unsigned presented = 0;
  unsigned refused_in_a_row = 0;
  std::vector<std::string> beliefs;        ///< profile of each condition after its last reach; empty: the set-up's
  app::QuestPlus quest;                    ///< of all answers: the threshold
  std::vector<app::QuestPlus> quest_runs;  ///< of the interleaved runs, which choose the gaps
  std::string end;                         ///< "done" or "stopped"; empty: neither
  std::int64_t passed_ns = 0;              ///< from consent to the last event, also while the machine was off
  std::string boot;                        ///< of the last start
  std::optional<Now> last;                 ///< when the journal was last written

 private:
  void end_trial(TrialRecord::End end);
  void apply_reach(const Event& event);
  void apply_answer(unsigned answer);
  void begin_block(unsigned number);
};

/// The fold of a journal.
State state_of(const Design& design, const Schedule& schedule, unsigned participant, const std::vector<Event>& events);

}  // namespace hrt::experiment
