// The state of a session, computed from the design and the journal.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "samples/app/person/quest.h"
#include "samples/experiment/data/journal.h"
#include "samples/experiment/design/schedule.h"

namespace hrt::experiment {

struct TrialRecord {
  enum class End { open, counted, missing } end = End::open;
  unsigned attempts = 0;   ///< attempts that were started, in all passes of the block
  unsigned refused = 0;    ///< attempts of this pass whose reach was invalid
  unsigned presented = 0;  ///< number of ended trials of the session when this one ended; 0: not ended
  std::int64_t began_utc_ms = 0;
  nlohmann::json attempt;          ///< data of the last event "attempt"
  nlohmann::json reach;            ///< data of the last event "reach"
  std::optional<unsigned> answer;  ///< index of the answer; noticeability: of the reach that seemed bent
};

struct Task {
  enum class Kind { consent, registration, check, set_up, questionnaire, rest, trial, answer, end } kind;
  unsigned block = 0;
  unsigned trial = 0;     ///< index in the block; questionnaire: index in the design
  std::string when = {};  ///< time of a questionnaire: "before" or "after" all blocks, or "block 2", after block 2
};

struct State {
  State(const Design& design, const Schedule& schedule, unsigned participant);

  void apply(const Event& event);
  Task next() const;
  /// Largest feasible gap of this participant, from the set-up; infinite if unknown.
  double max_gap_deg() const;
  /// Returns the time since the last event. After a restart of the computer, this is a difference of the wall clock,
  /// which may be negative.
  std::int64_t since_last_ns(const Now& now, const std::string& boot_now) const;

  const Design& design;
  const Schedule& schedule;
  unsigned participant;

  bool has_consent = false;
  bool registers = false;
  bool is_placed = false;                        ///< touches in this run of the program confirm the registration
  std::string registration;                      ///< current registration; empty: not registered
  std::set<std::string> registrations;           ///< all registrations of the session
  std::vector<nlohmann::json> touches;           ///< touches of an unfinished registration
  std::optional<nlohmann::json> set_up;          ///< result of the finished set-up
  std::vector<nlohmann::json> slides;            ///< slides of an unfinished set-up
  std::set<std::string> questionnaires;          ///< answered questionnaires, such as "before SSQ"
  std::vector<std::vector<TrialRecord>> trials;  ///< by block and trial
  std::vector<unsigned> passes;                  ///< pass of each block, from 1; a block restarts after a long pause
  unsigned block = 0;
  std::vector<unsigned> pending;  ///< indices of the remaining trials of the block, next one first
  bool rest_due = false;
  bool awaits_answer = false;
  unsigned reaches = 0;  ///< number of ended reaches, valid or not
  unsigned presented = 0;
  unsigned refused_in_a_row = 0;
  std::vector<std::string> profiles;  ///< by condition: profile after the last valid reach; empty: that of the set-up
  app::QuestPlus quest;               ///< posterior of the answers of all runs, for the threshold
  std::vector<app::QuestPlus> quest_runs;  ///< interleaved runs, which select the gaps
  std::string end;                         ///< "done" or "stopped"; empty: the session has not ended
  std::int64_t passed_ns = 0;  ///< time from consent to the last event, including time while the computer was off
  std::string boot;            ///< identifier of the computer's boot at the program's last start
  std::optional<Now> last;     ///< time of the last event

 private:
  void end_trial(TrialRecord::End end);
  void apply_reach(const Event& event);
  void apply_answer(unsigned answer);
  void begin_block(unsigned number);
};

State state_of(const Design& design, const Schedule& schedule, unsigned participant, const std::vector<Event>& events);

}  // namespace hrt::experiment
