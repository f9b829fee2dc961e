#include "samples/experiment/design/design.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "samples/experiment/data/disk.h"
#include "samples/experiment/design/draws.h"
#include "samples/format.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

unsigned index_of(const std::vector<Condition>& conditions, const Fields& fields, const std::string& field,
                  const std::string& name) {
  std::string all;
  for (unsigned i = 0; i < conditions.size(); ++i) {
    if (conditions[i].name == name) return i;
    all += (i == 0 ? "" : ", ") + conditions[i].name;
  }
  fields.refuse(field, "\"" + name + "\" is no condition; there are " + all);
}

void read_conditions(Fields& f, Design& design) {
  f.objects("conditions", {1, 12}, "What is compared, within people", [&](Fields& c) {
    Condition condition;
    condition.name = c.text("name", std::nullopt, "Name; shown to nobody before unblinding");
    const std::vector<std::string> names{"people", "paper", "fixed", "none"};
    const std::string controller = c.word("controller", names, nullptr,
                                          "people: the default controller; paper: the paper's; fixed: a "
                                          "plate at plate_deg; none: a plate at 0");
    condition.controller = static_cast<Controller>(std::find(names.begin(), names.end(), controller) - names.begin());
    condition.plate_deg = c.number("plate_deg", {-90, 90}, 0.0, "Plate orientation under fixed, degrees");
    for (const Condition& other : design.conditions)
      if (other.name == condition.name) c.refuse("name", "\"" + other.name + "\" is another condition's");
    design.conditions.push_back(condition);
  });
}

void read_pairs(Fields& f, Design& design) {
  f.objects("pairs", {1, 40}, "Virtual targets, each with the real one that serves it", [&](Fields& p) {
    Pair pair;
    pair.name = p.text("name", std::nullopt, "Name");
    pair.virtual_deg = p.number("virtual_deg", {-60, 60}, std::nullopt, "Direction of the virtual target");
    pair.real_deg = p.number("real_deg", {-60, 60}, std::nullopt, "Direction of the real target");
    pair.distance_m = 1e-3 * p.number("distance_mm", {30, 120}, 100.0, "Distance of both from the start");
    pair.radius_m =
        1e-3 * p.number("radius_mm", {0, 20}, 0.0, "Radius of the real object, whose contact ends a reach; 0: unknown");
    for (const Pair& other : design.pairs)
      if (other.name == pair.name) p.refuse("name", "\"" + other.name + "\" is another pair's");
    design.pairs.push_back(pair);
  });
}

void read_order(Fields& f, Design& design) {
  const std::vector<std::string> orders{"williams", "random_in_blocks", "listed"};
  const std::string order = f.word("order", orders, "williams",
                                   "williams: a block a condition, balanced for what precedes; random_in_blocks: "
                                   "all conditions in each block; listed: as in listed_orders");
  design.order = static_cast<Order>(std::find(orders.begin(), orders.end(), order) - orders.begin());
  const auto lists = f.lists("listed_orders", "Conditions of the participants, by name, in turn");
  if (!f.describes() && lists.empty() == (design.order == Order::listed))
    f.refuse("listed_orders", "goes with order listed, and only with it");
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string place = format("listed_orders/%zu", i);
    std::vector<unsigned> indices;
    indices.reserve(lists[i].size());
    for (const std::string& name : lists[i]) indices.push_back(index_of(design.conditions, f, place, name));
    if (std::set<unsigned>(indices.begin(), indices.end()).size() != design.conditions.size() ||
        indices.size() != design.conditions.size())
      f.refuse(place, "does not have each condition once");
    design.listed.push_back(indices);
  }
}

void read_blocks(Fields& f, Design& design) {
  f.object("between", "A factor between people", [&](Fields& b) {
    design.factor = b.text("factor", std::nullopt, "Name");
    design.levels = b.texts("levels", {2, 8}, true, "Levels, assigned in turn to whole sets of orders");
  });
  design.rounds = f.whole("rounds", {1, 50}, 1, "Blocks of each condition; of random_in_blocks: blocks");
  design.repeats = f.whole("repeats", {1, 100}, std::nullopt, "Trials of each pair in a block");
  design.max_run = f.whole("max_run", {1, 100}, 2, "Most trials of one pair in a row");
  design.catch_share = f.number("catch_share", {0, 0.5}, 0.0,
                                "Trials without a gap, with the plate at rest, added to each block; a share of it");
  design.practice_trials = f.whole("practice_trials", {0, 100}, 4, "Before the first block, without a controller");
  design.trial_s = f.number("trial_s", {1, 120}, 12.0, "Expected duration of a trial");
  design.calibrates = f.word("set_up", {"calibration", "none"}, "calibration",
                             "calibration: the plugin's set-up finds the illusion") == "calibration";
  design.question = f.text("question", "", "Asked after each reach");
  design.answers = f.texts("answers", {2, 9}, false, "Answers to it, by digit from 1; default yes, no");
  if (design.answers.empty()) design.answers = {"yes", "no"};
}

void read_rules(Fields& f, Design& design) {
  design.validity = {0.3, 8.0, 0.1, 5};
  f.object("validity", "When a reach counts; one that does not returns later in its block", [&](Fields& v) {
    Validity& rules = design.validity;
    rules.min_s = v.number("min_s", {0.1, 5}, rules.min_s, "Shortest duration");
    rules.max_s = v.number("max_s", {0.5, 30}, rules.max_s, "Longest duration");
    if (rules.max_s <= rules.min_s) v.refuse("max_s", "is not above min_s");
    rules.max_dropped_share =
        v.number("max_dropped_share", {0, 1}, rules.max_dropped_share, "Largest share of samples without a finger");
    rules.max_attempts = v.whole("max_attempts", {1, 20}, rules.max_attempts, "Then the trial is missing");
  });
  design.break_minutes = 1.0;
  design.max_pause_minutes = 15.0;
  f.object("breaks", "Between blocks", [&](Fields& b) {
    design.break_minutes = b.number("minutes", {0, 60}, 1.0, "Shortest");
    design.max_pause_minutes =
        b.number("max_pause_minutes", {0.1, 1440}, 15.0, "After a longer interruption a block starts again");
  });
  design.max_invalid_in_a_row = 10;
  design.max_minutes = 120.0;
  f.object("stop", "When a session is stopped", [&](Fields& s) {
    design.max_invalid_in_a_row = s.whole("max_invalid_in_a_row", {1, 100}, 10, "Reaches that do not count");
    design.max_minutes = s.number("max_minutes", {1, 600}, 120.0, "Since consent");
  });
}

void read_noticeability(Fields& f, Design& design) {
  Noticeability notice{};
  const bool there = f.object("noticeability", "Which of two reaches was bent? A last block", [&](Fields& n) {
    notice.trials = n.whole("trials", {5, 500}, 60, "Pairs of reaches");
    const std::string name = n.text("condition", std::nullopt, "Whose controller bends the reach");
    if (!n.describes()) notice.condition = index_of(design.conditions, n, "condition", name);
    notice.virtual_deg = n.number("virtual_deg", {-60, 60}, 0.0, "Direction of the virtual target");
    notice.distance_m = 1e-3 * n.number("distance_mm", {30, 120}, 100.0, "Its distance from the start");
    notice.min_gap_deg = n.number("min_gap_deg", {0.1, 30}, 1.0, "Smallest gap");
    notice.max_gap_deg = n.number("max_gap_deg", {1, 45}, 30.0, "Largest gap");
    if (notice.max_gap_deg < 2.0 * notice.min_gap_deg && !n.describes())
      n.refuse("max_gap_deg", "is not twice min_gap_deg or more");
  });
  if (there) design.noticeability = notice;
}

void read_questionnaires(Fields& f, Design& design) {
  f.objects("questionnaires", {0, 20}, "Such as SSQ, raw TLX, agency", [&](Fields& q) {
    Questionnaire paper;
    paper.name = q.text("name", std::nullopt, "Name");
    const std::string when = q.word("when", {"before", "after", "both"}, "after", "Of the session");
    paper.before = when != "after";
    paper.after = when != "before";
    paper.low = q.whole("low", {0, 100}, 0, "Smallest answer");
    paper.high = q.whole("high", {1, 100}, 3, "Largest answer");
    if (paper.high <= paper.low) q.refuse("high", "is not above low");
    paper.items = q.texts("items", {1, 100}, true, "Texts of the items");
    design.questionnaires.push_back(paper);
  });
}

void read_analysis(Fields& f, Design& design) {
  design.measure = "abs_miss_deg";
  design.test = "sign_flip";
  design.alpha = 0.05;
  design.margin = 1.0;
  const bool there = f.object("analysis", "Registered before the first participant", [&](Fields& a) {
    design.measure =
        a.word("measure", {"abs_miss_deg", "miss_mm", "peak_felt_error_deg"}, "abs_miss_deg", "Of trials.csv");
    design.test = a.word("test", {"sign_flip", "mixed_model"}, "sign_flip",
                         "sign_flip: of people's differences; mixed_model: condition, intercept and slope by person");
    const std::string reference = a.text("reference", std::nullopt, "Condition with which the others are compared");
    if (!a.describes()) design.reference = index_of(design.conditions, a, "reference", reference);
    design.alpha = a.number("alpha", {0.001, 0.2}, 0.05, "Level of the test, of all comparisons together (Holm)");
    design.margin = a.number("margin", {0.01, 100}, 1.0, "A smaller difference is as good as none (equivalence)");
  });
  if (!there) design.reference = static_cast<unsigned>(design.conditions.size()) - 1;
}

// What no field says alone.
void check_whole(const Fields& f, const Design& design) {
  const auto conditions = static_cast<unsigned>(design.conditions.size());
  unsigned rows = design.order == Order::listed ? static_cast<unsigned>(design.listed.size()) : 1;
  if (design.order == Order::williams) rows = conditions % 2 == 0 ? conditions : 2 * conditions;
  if (conditions == 1) rows = 1;
  const unsigned set = rows * std::max<unsigned>(1, static_cast<unsigned>(design.levels.size()));
  if (design.participants % set != 0)
    f.refuse("participants", format("%u is not a multiple of %u: orders%s would not be balanced", design.participants,
                                    set, design.levels.empty() ? "" : " times levels"));
  if (design.pairs.size() == 1 && design.order != Order::random_in_blocks && design.repeats > design.max_run)
    f.refuse("max_run", format("%u is below repeats, and there is only one pair", design.max_run));
}

Design read_all(Fields& f) {
  Design design{};
  design.title = f.text("title", std::nullopt, "Of the study");
  design.seed = f.whole("seed", {0, 4294967295.0}, 1, "Of all random draws");
  design.participants = f.whole("participants", {1, 1000}, std::nullopt, "Planned number");
  read_conditions(f, design);
  read_pairs(f, design);
  read_order(f, design);
  read_blocks(f, design);
  read_rules(f, design);
  read_noticeability(f, design);
  read_questionnaires(f, design);
  read_analysis(f, design);
  f.object("simulated", "Of simulated participants alone", [&](Fields& s) {
    design.simulated.invalid_share = s.number("invalid_share", {0, 0.5}, 0.0, "Reaches in which tracking is lost");
    design.simulated.lapse_share = s.number("lapse_share", {0, 0.5}, 0.02, "Answers that are guesses");
    design.simulated.weights =
        s.word("weights", {"uniform", "normal", "skewed"}, "uniform", "Shares of touch, about 0.21 by 0.052");
  });
  return design;
}

}  // namespace

Design parse_design(const std::string& text, const std::string& name) {
  json value;
  try {
    value = json::parse(text);
  } catch (const json::parse_error& error) {
    throw Refusal(name + ": " + error.what());
  }
  if (!value.is_object()) throw Refusal(name + ": is not a JSON object");
  Fields fields(&value, name + ":");
  Design design = read_all(fields);
  fields.finish();
  check_whole(fields, design);
  design.text = text;
  design.sha256 = sha256_of(text);
  return design;
}

Design read_design(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Refusal(file.string() + ": cannot be read");
  return parse_design({std::istreambuf_iterator<char>(stream), {}}, file.filename().string());
}

json design_schema() {
  Fields fields(nullptr, {});
  read_all(fields);
  json schema = fields.schema();
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Design of a study of haptic retargeting by touch";
  return schema;
}

std::string letter_of(const Design& design, unsigned condition) {
  std::vector<char> letters;
  for (unsigned i = 0; i < design.conditions.size(); ++i) letters.push_back(static_cast<char>('A' + i));
  Stream(Use::letters, {.seed = design.seed}).shuffle(letters);
  return {letters[condition]};
}

}  // namespace hrt::experiment
