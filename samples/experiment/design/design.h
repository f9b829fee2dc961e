// The design of a study: study.json, checked as a whole.
#pragma once

#include <haptic_retargeting/session.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "samples/app/text/json_file.h"

namespace hrt::experiment {

enum class Controller { people, paper, fixed, none };

struct Condition {
  std::string name;
  Controller controller;
  double plate_deg = 0.0;                                   ///< orientation under `fixed`
  double gap_share = 1.0;                                   ///< of the pair's gap
  std::vector<std::pair<std::string, double>> config = {};  ///< fields of hrt_session_config
};

/// The displayed and the touched target, as seen from the start.
struct Pair {
  std::string name;
  double virtual_deg;
  double real_deg;
  double distance_m;
  double radius_m;  ///< of the real object; 0: unknown
};

enum class Order { williams, random_in_blocks, listed };

/// When a reach counts.
struct Validity {
  double min_s;
  double max_s;
  double max_dropped_share;
  unsigned max_attempts;  ///< then the trial is missing
};

/// Which of two reaches was bent? The gap is chosen by QUEST+.
struct Noticeability {
  unsigned trials;
  unsigned condition;  ///< whose controller retargets
  unsigned control;    ///< of the reach without a gap
  unsigned runs;       ///< interleaved
  double virtual_deg;
  double distance_m;
  double min_gap_deg;
  double max_gap_deg;
};

struct Questionnaire {
  std::string name;
  std::string when;  ///< before, after, both or block
  bool is_text;
  unsigned low;
  unsigned high;
  std::vector<std::string> items;
};

/// Traits of simulated people that the library's own lack.
struct SimulatedTraits {
  double invalid_share;  ///< of reaches in which the tracker loses the finger
  double lapse_share;    ///< of answers that are guesses
  std::string weights;   ///< how people's shares of touch are distributed
};

struct Design {
  std::string title;
  unsigned seed;
  unsigned participants;
  std::vector<Condition> conditions;
  std::vector<Pair> pairs;
  Order order;
  std::vector<std::vector<unsigned>> listed;  ///< conditions, one list after the other for the participants
  std::string factor;                         ///< between people; empty: none
  std::vector<std::string> levels;
  unsigned rounds;   ///< blocks of each condition; of random_in_blocks: blocks
  unsigned repeats;  ///< of each pair in a block
  unsigned max_run;  ///< of one pair in a row
  double catch_share;
  unsigned practice_trials;
  bool calibrates;
  std::string question;  ///< after each reach; empty: none
  std::vector<std::string> answers;
  Validity validity;
  double break_minutes;
  double max_pause_minutes;
  unsigned max_invalid_in_a_row;
  double max_minutes;
  double trial_s;
  std::optional<Noticeability> noticeability;
  std::vector<Questionnaire> questionnaires;
  std::string start_text, block_text;        ///< instructions; empty: none
  std::map<std::string, std::string> texts;  ///< in other words
  std::string measure;                       ///< column of trials.csv that the analysis is of
  std::string test;
  std::string hypothesis;
  std::string direction;
  unsigned reference;  ///< condition
  double alpha;
  double margin;  ///< of equivalence, in the measure's unit
  SimulatedTraits simulated;
  std::string text;    ///< the file
  std::string sha256;  ///< hash of `text`
};

/// Throws Refusal naming the place and what is allowed. `name`: of the file, for messages.
Design parse_design(const std::string& text, const std::string& name);
Design read_design(const std::filesystem::path& file);

/// The configuration of a session of the plugin under a condition. Throws Refusal for a field that it does not have.
hrt_session_config config_of(const Condition& condition);

/// The JSON Schema of a design: study.schema.json.
const Json& design_schema();

/// The letter that stands for a condition until it is unblinded. Drawn for each participant, so what is known of one
/// participant's letters says nothing about another's.
std::string letter_of(const Design& design, unsigned participant, unsigned condition);

/// Returns the text of a registered report in Markdown: hypotheses, power, every field of the design with its meaning,
/// blinding, stopping and analysis; what its authors must add is in brackets. `power`: output of
/// samples/experiment/power; empty: none. Throws Refusal if it is of another design.
std::string preregistration_text(const Design& design, const std::string& power = "");

/// PROTOCOL.md with the design's numbers in it.
std::string protocol_text(const Design& design);

}  // namespace hrt::experiment
