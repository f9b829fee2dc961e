#include "samples/experiment/design/design.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "samples/app/text/format.h"
#include "samples/experiment/data/disk.h"
#include "samples/experiment/design/draws.h"

namespace hrt::experiment {
namespace {

unsigned index_of(const std::vector<Condition>& conditions, const std::string& where, const std::string& name) {
  std::vector<std::string> names;
  for (const Condition& condition : conditions) names.push_back(condition.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse(where, "must be a condition: " + quoted_list(names));
  return static_cast<unsigned>(found - names.begin());
}

void read_conditions(Members& f, Design& design) {
  f.each("conditions", {1, 12, "What is compared, within people"}, [&](Members& c) {
    Condition condition;
    condition.name = c.text("name", std::nullopt, "Name; shown to nobody before unblinding");
    condition.controller = c.choice<Controller>("controller",
                                                {{"people", Controller::people},
                                                 {"paper", Controller::paper},
                                                 {"fixed", Controller::fixed},
                                                 {"none", Controller::none}},
                                                nullptr,
                                                "people: the default controller; paper: the paper's; fixed: a "
                                                "plate at plate_deg; none: a plate at 0");
    condition.plate_deg = c.number("plate_deg", 0.0, -90, 90, "Plate orientation under fixed, degrees");
    for (const Condition& other : design.conditions)
      if (other.name == condition.name) refuse(c.where("name"), "is another condition's");
    design.conditions.push_back(condition);
  });
}

void read_pairs(Members& f, Design& design) {
  f.each("pairs", {1, 40, "Virtual targets, each with the real one that serves it"}, [&](Members& p) {
    Pair pair;
    pair.name = p.text("name", std::nullopt, "Name");
    pair.virtual_deg = p.number("virtual_deg", std::nullopt, -60, 60, "Direction of the virtual target");
    pair.real_deg = p.number("real_deg", std::nullopt, -60, 60, "Direction of the real target");
    pair.distance_m = 1e-3 * p.number("distance_mm", 100.0, 30, 120, "Distance of both from the start");
    pair.radius_m =
        1e-3 * p.number("radius_mm", 0.0, 0, 20, "Radius of the real object, whose contact ends a reach; 0: unknown");
    if (std::abs(pair.virtual_deg - pair.real_deg) > 75.0)  // 90 with the bias that a person may have
      refuse(p.where("real_deg"), "must be within 75 of virtual_deg");
    for (const Pair& other : design.pairs)
      if (other.name == pair.name) refuse(p.where("name"), "is another pair's");
    design.pairs.push_back(pair);
  });
}

void read_order(Members& f, Design& design) {
  design.order = f.choice<Order>(
      "order",
      {{"williams", Order::williams}, {"random_in_blocks", Order::random_in_blocks}, {"listed", Order::listed}},
      "williams",
      "williams: a block a condition, balanced for what precedes; random_in_blocks: all conditions in each block; "
      "listed: as in listed_orders");
  const auto lists = f.lists("listed_orders", {1, 26}, "Conditions of the participants, by name, in turn");
  if (!f.describes() && lists.empty() == (design.order == Order::listed))
    refuse(f.where("listed_orders"), "goes with order listed, and only with it");
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string place = f.where("listed_orders") + format("[%zu]", i);
    std::vector<unsigned> indices;
    indices.reserve(lists[i].size());
    for (const std::string& name : lists[i]) indices.push_back(index_of(design.conditions, place, name));
    if (std::set<unsigned>(indices.begin(), indices.end()).size() != design.conditions.size() ||
        indices.size() != design.conditions.size())
      refuse(place, "must have each condition once");
    design.listed.push_back(indices);
  }
}

void read_blocks(Members& f, Design& design) {
  f.object("between", "A factor between people", [&](Members& b) {
    design.factor = b.text("factor", std::nullopt, "Name");
    design.levels = b.texts("levels", true, {2, 8, "Levels, assigned in turn to whole sets of orders"});
  });
  design.rounds = f.count<unsigned>("rounds", 1, 1, 50, "Blocks of each condition; of random_in_blocks: blocks");
  design.repeats = f.count<unsigned>("repeats", std::nullopt, 1, 100, "Trials of each pair in a block");
  design.max_run = f.count<unsigned>("max_run", 2, 1, 100, "Most trials of one pair in a row");
  design.catch_share = f.number("catch_share", 0.0, 0, 0.5,
                                "Trials without a gap, with the plate at rest, added to each block; a share of it");
  design.practice_trials =
      f.count<unsigned>("practice_trials", 4, 0, 100, "Before the first block, without a controller");
  design.trial_s = f.number("trial_s", 12.0, 1, 120, "Expected duration of a trial");
  design.calibrates = f.choice<bool>("set_up", {{"calibration", true}, {"none", false}}, "calibration",
                                     "calibration: the plugin's set-up finds the illusion");
  design.question = f.text("question", "", "Asked after each reach");
  design.answers = f.texts("answers", false, {2, 9, "Answers to it, by digit from 1; default yes, no"});
  if (design.answers.empty()) design.answers = {"yes", "no"};
}

void read_rules(Members& f, Design& design) {
  design.validity = {0.3, 8.0, 0.1, 5};
  f.object("validity", "When a reach counts; one that does not returns later in its block", [&](Members& v) {
    Validity& rules = design.validity;
    rules.min_s = v.number("min_s", rules.min_s, 0.1, 5, "Shortest duration");
    rules.max_s = v.number("max_s", rules.max_s, 0.5, 30, "Longest duration");
    if (rules.max_s <= rules.min_s) refuse(v.where("max_s"), "must be above min_s");
    rules.max_dropped_share =
        v.number("max_dropped_share", rules.max_dropped_share, 0, 1, "Largest share of samples without a finger");
    rules.max_attempts = v.count<unsigned>("max_attempts", rules.max_attempts, 1, 20, "Then the trial is missing");
  });
  design.break_minutes = 1.0;
  design.max_pause_minutes = 15.0;
  f.object("breaks", "Between blocks", [&](Members& b) {
    design.break_minutes = b.number("minutes", 1.0, 0, 60, "Shortest");
    design.max_pause_minutes =
        b.number("max_pause_minutes", 15.0, 0.1, 1440, "After a longer interruption a block starts again");
  });
  design.max_invalid_in_a_row = 10;
  design.max_minutes = 120.0;
  f.object("stop", "When a session is stopped", [&](Members& s) {
    design.max_invalid_in_a_row = s.count<unsigned>("max_invalid_in_a_row", 10, 1, 100, "Reaches that do not count");
    design.max_minutes = s.number("max_minutes", 120.0, 1, 600, "Since consent");
  });
}

void read_noticeability(Members& f, Design& design) {
  Noticeability notice{};
  const bool there = f.object("noticeability", "Which of two reaches was bent? A last block", [&](Members& n) {
    notice.trials = n.count<unsigned>("trials", 60, 5, 500, "Pairs of reaches");
    const std::string name = n.text("condition", std::nullopt, "Whose controller bends the reach");
    if (!n.describes()) notice.condition = index_of(design.conditions, n.where("condition"), name);
    const Controller bends = n.describes() ? Controller::people : design.conditions[notice.condition].controller;
    if (bends == Controller::none || bends == Controller::fixed)
      refuse(n.where("condition"), "must be one whose controller is people or paper");
    notice.virtual_deg = n.number("virtual_deg", 0.0, -60, 60, "Direction of the virtual target");
    notice.distance_m = 1e-3 * n.number("distance_mm", 100.0, 30, 120, "Its distance from the start");
    notice.min_gap_deg = n.number("min_gap_deg", 1.0, 0.1, 30, "Smallest gap");
    notice.max_gap_deg = n.number("max_gap_deg", 30.0, 1, 45, "Largest gap");
    if (notice.max_gap_deg < 2.0 * notice.min_gap_deg && !n.describes())
      refuse(n.where("max_gap_deg"), "must be twice min_gap_deg or more");
  });
  if (there) design.noticeability = notice;
}

void read_questionnaires(Members& f, Design& design) {
  f.each("questionnaires", {0, 20, "Such as SSQ, raw TLX, agency"}, [&](Members& q) {
    Questionnaire paper;
    paper.name = q.text("name", std::nullopt, "Name");
    const std::string when = q.word("when", {"before", "after", "both"}, "after", "Of the session");
    paper.before = when != "after";
    paper.after = when != "before";
    paper.low = q.count<unsigned>("low", 0, 0, 100, "Smallest answer");
    paper.high = q.count<unsigned>("high", 3, 1, 100, "Largest answer");
    if (paper.high <= paper.low) refuse(q.where("high"), "must be above low");
    paper.items = q.texts("items", true, {1, 100, "Texts of the items"});
    design.questionnaires.push_back(paper);
  });
}

void read_analysis(Members& f, Design& design) {
  design.measure = "abs_miss_deg";
  design.test = "sign_flip";
  design.alpha = 0.05;
  design.margin = 1.0;
  const bool there = f.object("analysis", "Registered before the first participant", [&](Members& a) {
    design.measure =
        a.word("measure", {"abs_miss_deg", "miss_mm", "peak_felt_error_deg"}, "abs_miss_deg", "Of trials.csv");
    design.test = a.word("test", {"sign_flip", "mixed_model"}, "sign_flip",
                         "sign_flip: of people's differences; mixed_model: condition, intercept and slope by person");
    const std::string reference = a.text("reference", std::nullopt, "Condition with which the others are compared");
    if (!a.describes()) design.reference = index_of(design.conditions, a.where("reference"), reference);
    design.alpha = a.number("alpha", 0.05, 0.001, 0.2, "Level of the test, of all comparisons together (Holm)");
    design.margin = a.number("margin", 1.0, 0.01, 100, "A smaller difference is as good as none (equivalence)");
  });
  if (!there) design.reference = static_cast<unsigned>(design.conditions.size()) - 1;
}

// What no field says alone.
void check_whole(const Members& f, const Design& design) {
  const auto conditions = static_cast<unsigned>(design.conditions.size());
  unsigned rows = design.order == Order::listed ? static_cast<unsigned>(design.listed.size()) : 1;
  if (design.order == Order::williams) rows = conditions % 2 == 0 ? conditions : 2 * conditions;
  if (conditions == 1) rows = 1;
  const unsigned set = rows * std::max<unsigned>(1, static_cast<unsigned>(design.levels.size()));
  if (design.participants % set != 0)
    refuse(f.where("participants"), format("must be a multiple of %u: orders%s would not be balanced", set,
                                           design.levels.empty() ? "" : " times levels"));
  if (design.pairs.size() == 1 && design.order != Order::random_in_blocks && design.repeats > design.max_run)
    refuse(f.where("max_run"), "must be repeats or more, as there is only one pair");
}

Design read_all(Members& f) {
  Design design{};
  design.title = f.text("title", std::nullopt, "Of the study");
  design.seed = f.count<unsigned>("seed", 1, 0, UINT32_MAX, "Of all random draws");
  design.participants = f.count<unsigned>("participants", std::nullopt, 1, 1000, "Planned number");
  read_conditions(f, design);
  read_pairs(f, design);
  read_order(f, design);
  read_blocks(f, design);
  read_rules(f, design);
  read_noticeability(f, design);
  read_questionnaires(f, design);
  read_analysis(f, design);
  f.object("simulated", "Of simulated participants alone", [&](Members& s) {
    design.simulated.invalid_share = s.number("invalid_share", 0.0, 0, 0.5, "Reaches in which tracking is lost");
    design.simulated.lapse_share = s.number("lapse_share", 0.02, 0, 0.5, "Answers that are guesses");
    design.simulated.weights =
        s.word("weights", {"uniform", "normal", "skewed"}, "uniform", "Shares of touch, about 0.21 by 0.052");
  });
  return design;
}

}  // namespace

Design parse_design(const std::string& text, const std::string& name) {
  Json value;
  KeysAround keys;
  try {
    value = Json::parse(text, [&](int, Json::parse_event_t event, const Json& parsed) {
      keys.see(event, parsed);
      return true;
    });
  } catch (const std::exception& error) {
    throw Refusal(name + ": " + error.what());
  }
  Members fields(value, name);
  Design design = read_all(fields);
  fields.finish();
  check_whole(fields, design);
  design.text = text;
  design.sha256 = sha256_of(text);
  return design;
}

Design read_design(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(file)) throw Refusal(file.string() + ": cannot be read");
  return parse_design({std::istreambuf_iterator<char>(stream), {}}, file.filename().string());
}

Json design_schema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "Design of a study of haptic retargeting by touch"}};
  Members::describe(schema, std::nullopt, read_all);
  return schema;
}

std::string letter_of(const Design& design, unsigned condition) {
  std::vector<char> letters;
  for (unsigned i = 0; i < design.conditions.size(); ++i) letters.push_back(static_cast<char>('A' + i));
  Stream(Use::letters, {.seed = design.seed}).shuffle(letters);
  return {letters[condition]};
}

}  // namespace hrt::experiment
