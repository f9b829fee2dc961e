// The design of a study: study.json, parsed and validated.
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
  double plate_deg = 0.0;                                   ///< plate orientation under Controller::fixed
  double gap_share = 1.0;                                   ///< gap, as a fraction of the pair's gap
  std::vector<std::pair<std::string, double>> config = {};  ///< names and values of fields of hrt_session_config
};

/// Virtual and real target, as seen from the start. Directions are measured from the mid-line, left positive.
struct Pair {
  std::string name;
  double virtual_deg;
  double real_deg;
  double distance_m;
  double radius_m;  ///< radius of the real object; 0: unknown
};

enum class Order { williams, random_in_blocks, listed };

struct Validity {
  double min_s;
  double max_s;
  double max_dropped_share;
  unsigned max_attempts;  ///< the trial is missing after this number of invalid attempts
};

/// Two-interval forced choice: which of two reaches was bent? QUEST+ selects the gap.
struct Noticeability {
  unsigned trials;
  unsigned condition;  ///< index of the tested condition
  unsigned control;    ///< index of the condition of the reach without a gap
  unsigned runs;       ///< number of interleaved QUEST+ runs
  double virtual_deg;
  double distance_m;
  double min_gap_deg;
  double max_gap_deg;
};

struct Questionnaire {
  std::string name;
  std::string when;  ///< "before" or "after" the blocks, "both", or "block": after each block of reaches
  bool is_text;
  unsigned low;
  unsigned high;
  std::vector<std::string> items;
};

/// Traits of simulated participants in addition to those of core/simulation.
struct SimulatedTraits {
  double invalid_share;  ///< fraction of reaches in which the tracker loses the finger
  double lapse_share;    ///< fraction of answers that are guesses
  std::string weights;   ///< distribution of the tactile weights: uniform, normal or skewed
};

struct Design {
  std::string title;
  unsigned seed;
  unsigned participants;
  std::vector<Condition> conditions;
  std::vector<Pair> pairs;
  Order order;
  std::vector<std::vector<unsigned>> listed;  ///< orders of the conditions
  std::string factor;                         ///< name of the between-participants factor; empty: no such factor
  std::vector<std::string> levels;
  unsigned rounds;   ///< blocks per condition; random_in_blocks: number of blocks
  unsigned repeats;  ///< trials of each pair in a block
  unsigned max_run;  ///< maximum number of trials of one pair in a row
  double catch_share;
  unsigned practice_trials;
  bool calibrates;
  std::string question;  ///< asked after each valid reach, except in noticeability; empty: none
  std::vector<std::string> answers;
  Validity validity;
  double break_minutes;
  double max_pause_minutes;
  unsigned max_invalid_in_a_row;
  double max_minutes;
  double trial_s;
  std::optional<Noticeability> noticeability;
  std::vector<Questionnaire> questionnaires;
  std::string start_text, block_text;        ///< instructions at the start and before each block; empty: none
  std::map<std::string, std::string> texts;  ///< texts of the program, and those that replace them
  std::string measure;                       ///< outcome that the analysis compares
  std::string test;
  std::string hypothesis;
  std::string direction;
  unsigned reference;  ///< index of the condition with which the others are compared
  double alpha;
  double margin;  ///< margin of the hypotheses equivalence and below_margin, in the measure's unit
  SimulatedTraits simulated;
  std::string text;  ///< content of study.json
  std::string sha256;
};

/// Parses and checks a design. Throws Refusal, which names an invalid field and what is allowed. `name`: file name for
/// messages.
Design parse_design(const std::string& text, const std::string& name);
Design read_design(const std::filesystem::path& file);

/// Returns the plugin's session configuration of a condition. Throws Refusal if `condition.config` names a field that
/// is not a double of hrt_session_config.
hrt_session_config config_of(const Condition& condition);

const Json& design_schema();

/// Returns the letter of a condition before unblinding. Letters are assigned at random for each participant.
std::string letter_of(const Design& design, unsigned participant, unsigned condition);

/// Returns the text of a registered report in Markdown: hypotheses, power, every field of the design with its meaning,
/// blinding, stopping and analysis. Brackets mark text that the authors must write. `power`: output of
/// samples/experiment/power; empty: none. Throws Refusal if `power` was computed for another design.
std::string preregistration_text(const Design& design, const std::string& power = "");

/// Returns PROTOCOL.md with the numbers of the design filled in.
std::string protocol_text(const Design& design);

}  // namespace hrt::experiment
