#include "samples/experiment/design/design.h"

#include <haptic_retargeting/haptic_retargeting.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "samples/app/text/format.h"
#include "samples/experiment/data/disk.h"
#include "samples/experiment/design/draws.h"
#include "samples/experiment/study_schema.h"

namespace hrt::experiment {
namespace {

#include "samples/experiment/config_fields.h"

unsigned index_of(const std::vector<Condition>& conditions, const std::string& where, const std::string& name) {
  std::vector<std::string> names;
  for (const Condition& condition : conditions) names.push_back(condition.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse(where, "must be the name of a condition: " + quoted_list(names));
  return static_cast<unsigned>(found - names.begin());
}

void read_conditions(const Json& file, const std::string& name, Design& design) {
  static const Names<Controller> controllers{{"people", Controller::people},
                                             {"paper", Controller::paper},
                                             {"fixed", Controller::fixed},
                                             {"none", Controller::none}};
  for (const Json& c : file["conditions"]) {
    for (const Condition& other : design.conditions)
      if (other.name == c["name"].get<std::string>())
        refuse(name + format(".conditions[%zu].name", design.conditions.size()),
               "is the name of another condition; each condition needs a different name");
    Condition condition{c["name"], meaning(c["controller"], controllers), c["plate_deg"], c["gap_share"], {}};
    const std::string where = name + format(".conditions[%zu].config", design.conditions.size());
    for (const Json& each : c["config"]) {
      condition.config.emplace_back(each["field"].get<std::string>(), each["value"].get<double>());
      if (condition.config.back().first.starts_with("person.") && file["set_up"] != "none")
        refuse(where, "has " + condition.config.back().first +
                          ", which the set-up overwrites: remove this field, or use set_up \"none\"");
    }
    hrt_session_config config{};
    try {
      config = config_of(condition);
    } catch (const Refusal& unknown) {
      refuse(where, unknown.what());
    }
    hrt_session session{};
    if (hrt_session_create(HRT_VERSION, &config, &session) != HRT_OK)
      refuse(where, std::string("is refused: ") + hrt_last_error());
    hrt_session_destroy(session);
    design.conditions.push_back(condition);
  }
}

void read_pairs(const Json& file, const std::string& name, Design& design) {
  for (const Json& p : file["pairs"]) {
    const std::string where = name + format(".pairs[%zu]", design.pairs.size());
    const Pair pair{p["name"], p["virtual_deg"], p["real_deg"], 1e-3 * p["distance_mm"].get<double>(),
                    1e-3 * p["radius_mm"].get<double>()};
    if (std::abs(pair.virtual_deg - pair.real_deg) > 75.0)  // the plugin's limit is 90; 15 remain for the bias
      refuse(where + ".real_deg", format("must be at most 75 degrees from virtual_deg, which is %g; it is %g",
                                         pair.virtual_deg, pair.real_deg));
    for (const Pair& other : design.pairs)
      if (other.name == pair.name)
        refuse(where + ".name", "is the name of another pair; each pair needs a different name");
    design.pairs.push_back(pair);
  }
}

void read_order(const Json& file, const std::string& name, Design& design) {
  static const Names<Order> orders{
      {"williams", Order::williams}, {"random_in_blocks", Order::random_in_blocks}, {"listed", Order::listed}};
  design.order = meaning(file["order"], orders);
  if (file.contains("listed_orders") != (design.order == Order::listed))
    refuse(name + ".listed_orders", "is required with order \"listed\", and not allowed with another order");
  for (const Json& list : file.value("listed_orders", Json::array())) {
    const std::string where = name + format(".listed_orders[%zu]", design.listed.size());
    std::vector<unsigned> indices;
    for (const Json& condition : list) indices.push_back(index_of(design.conditions, where, condition));
    if (std::set<unsigned>(indices.begin(), indices.end()).size() != design.conditions.size() ||
        indices.size() != design.conditions.size())
      refuse(where, "must have each condition exactly once");
    design.listed.push_back(indices);
  }
}

void read_blocks(const Json& file, Design& design) {
  if (file.contains("between")) {
    design.factor = file["between"]["factor"];
    design.levels = file["between"]["levels"];
  }
  design.rounds = file["rounds"];
  design.repeats = file["repeats"];
  design.max_run = file["max_run"];
  design.catch_share = file["catch_share"];
  design.practice_trials = file["practice_trials"];
  design.trial_s = file["trial_s"];
  design.calibrates = file["set_up"] == "calibration";
  design.question = file.value("question", "");
  design.answers = file["answers"];
}

void read_rules(const Json& file, const std::string& name, Design& design) {
  const Json& v = file["validity"];
  design.validity = {v["min_s"], v["max_s"], v["max_dropped_share"], v["max_attempts"]};
  if (design.validity.max_s <= design.validity.min_s)
    refuse(name + ".validity.max_s",
           format("must be above min_s, which is %g; it is %g", design.validity.min_s, design.validity.max_s));
  design.break_minutes = file["breaks"]["minutes"];
  design.max_pause_minutes = file["breaks"]["max_pause_minutes"];
  design.max_invalid_in_a_row = file["stop"]["max_invalid_in_a_row"];
  design.max_minutes = file["stop"]["max_minutes"];
}

void read_noticeability(const Json& n, const std::string& where, Design& design) {
  const Noticeability notice{n["trials"],
                             index_of(design.conditions, where + ".condition", n["condition"]),
                             index_of(design.conditions, where + ".control", n.value("control", n["condition"])),
                             n["runs"],
                             n["virtual_deg"],
                             1e-3 * n["distance_mm"].get<double>(),
                             n["min_gap_deg"],
                             n["max_gap_deg"]};
  const Controller controller = design.conditions[notice.condition].controller;
  if (controller == Controller::none || controller == Controller::fixed)
    refuse(where + ".condition", "must be a condition whose controller is people or paper");
  if (notice.max_gap_deg < 2.0 * notice.min_gap_deg)
    refuse(where + ".max_gap_deg",
           format("must be at least twice min_gap_deg, which is %g; it is %g", notice.min_gap_deg, notice.max_gap_deg));
  design.noticeability = notice;
}

void read_questionnaires(const Json& file, const std::string& name, Design& design) {
  for (const Json& q : file.value("questionnaires", Json::array())) {
    const Questionnaire paper{q["name"], q["when"], q["answers"] == "text", q["low"], q["high"], q["items"]};
    if (paper.high <= paper.low)
      refuse(name + format(".questionnaires[%zu].high", design.questionnaires.size()),
             format("must be above low, which is %u; it is %u", paper.low, paper.high));
    design.questionnaires.push_back(paper);
  }
}

void read_analysis(const Json& a, const std::string& where, Design& design) {
  design.measure = a["measure"];
  design.test = a["test"];
  design.hypothesis = a["hypothesis"];
  design.direction = a["direction"];
  design.reference = static_cast<unsigned>(design.conditions.size()) - 1;
  if (a.contains("reference")) design.reference = index_of(design.conditions, where + ".reference", a["reference"]);
  design.alpha = a["alpha"];
  design.margin = a["margin"];
  if ((design.measure == "d_prime" || design.measure == "criterion") &&
      (design.question.empty() || design.catch_share <= 0.0))
    refuse(where + ".measure",
           "requires question and catch_share: " + design.measure + " compares answers in reaches and in catch trials");
  const bool is_of_trials = design.measure.ends_with("miss_deg") || design.measure == "miss_mm";
  if (design.test == "mixed_model" && !is_of_trials)
    refuse(where + ".test",
           "must be t or sign_flip with the measure " + design.measure + ", which single trials do not have");
  if (design.test != "t" && design.hypothesis != "difference")
    refuse(where + ".test",
           "must be t with the hypothesis " + design.hypothesis + ", which uses two one-sided t tests");
  if (design.measure == "percent_within" && (design.test != "sign_flip" || design.hypothesis != "difference"))
    refuse(
        where + ".test",
        "must be sign_flip, with hypothesis difference, for percent_within: a t test is invalid if most participants "
        "have 0 or 100 %");
  const bool has_direction = design.direction != "two-sided";
  if (has_direction && design.hypothesis != "difference")
    refuse(where + ".direction", "must be two-sided with the hypothesis " + design.hypothesis);
  // The smallest p of a sign flip test with n participants is 1 / 2^n, or 2 / 2^n if two-sided. Holm's first step
  // requires p < alpha / comparisons.
  const double level = design.alpha / std::max(1.0, static_cast<double>(design.conditions.size()) - 1.0);
  const double flips = (has_direction ? 0.0 : 1.0) - std::log2(level);
  const unsigned needed = design.test == "sign_flip" ? static_cast<unsigned>(std::floor(flips)) + 1 : 2U;
  if (design.conditions.size() > 1 && design.participants < needed)
    refuse(where + ".test", format("needs at least %u participants: with %u, no result can be significant", needed,
                                   design.participants));
}

void check_field_combinations(const std::string& name, const Design& design) {
  const auto conditions = static_cast<unsigned>(design.conditions.size());
  unsigned rows = design.order == Order::listed ? static_cast<unsigned>(design.listed.size()) : 1;
  if (design.order == Order::williams) rows = conditions % 2 == 0 ? conditions : 2 * conditions;
  if (conditions == 1) rows = 1;
  const unsigned set = rows * std::max<unsigned>(1, static_cast<unsigned>(design.levels.size()));
  if (design.participants % set != 0)
    refuse(name + ".participants",
           format("must be a multiple of %u, the number of orders%s, for balance; it is %u", set,
                  design.levels.empty() ? "" : " times the number of levels", design.participants));
  if (design.pairs.size() == 1 && design.order != Order::random_in_blocks && design.repeats > design.max_run)
    refuse(name + ".max_run", format("must be at least repeats, %u, because there is only one pair; it is %u",
                                     design.repeats, design.max_run));
}

}  // namespace

Design parse_design(const std::string& text, const std::string& name) {
  Json file = parse_json(text, name);
  check_json(file, design_schema(), name);
  Design design{};
  design.title = file["title"];
  design.seed = file["seed"];
  design.participants = file["participants"];
  read_conditions(file, name, design);
  read_pairs(file, name, design);
  read_order(file, name, design);
  read_blocks(file, design);
  read_rules(file, name, design);
  if (file.contains("noticeability")) read_noticeability(file["noticeability"], name + ".noticeability", design);
  read_questionnaires(file, name, design);
  read_analysis(file["analysis"], name + ".analysis", design);
  design.start_text = file["instructions"].value("start", "");
  design.block_text = file["instructions"].value("block", "");
  for (const Json& entry : file.value("texts", Json::array()))
    design.texts[entry["text"].get<std::string>()] = entry["instead"];
  const Json& simulated = file["simulated"];
  design.simulated = {simulated["invalid_share"], simulated["lapse_share"], simulated["weights"]};
  check_field_combinations(name, design);
  design.text = text;
  design.sha256 = sha256_of(text);
  return design;
}

Design read_design(const std::filesystem::path& file) {
  return parse_design(content_of(file), file.filename().string());
}

hrt_session_config config_of(const Condition& condition) {
  hrt_session_config config = hrt_session_config_init();
  const bool learns = condition.controller == Controller::people;
  config.adaptation = learns ? HRT_ADAPTATION_CARRIED : HRT_ADAPTATION_OFF;
  if (condition.controller == Controller::paper) config.guidance = HRT_GUIDANCE_FIXED_DIRECTION;
  if (condition.controller == Controller::fixed || condition.controller == Controller::none) {
    config.control = HRT_CONTROL_FIXED_PLATE;
    config.fixed_plate_orientation_deg = condition.controller == Controller::fixed ? condition.plate_deg : 0.0;
  }
  for (const auto& [name, value] : condition.config) {
    const auto field = config_fields.find(name);
    if (field == config_fields.end())
      throw Refusal("has the field \"" + name +
                    "\", which is not a field of hrt_session_config with a floating-point number; remove it");
    std::memcpy(reinterpret_cast<char*>(&config) + field->second, &value, sizeof value);
  }
  return config;
}

const Json& design_schema() {
  static const Json schema = Json::parse(study_schema);
  return schema;
}

std::string letter_of(const Design& design, unsigned participant, unsigned condition) {
  std::vector<char> letters;
  for (unsigned i = 0; i < design.conditions.size(); ++i) letters.push_back(static_cast<char>('A' + i));
  Stream(Use::letters, {.seed = design.seed, .participant = participant}).shuffle(letters);
  return {letters[condition]};
}

}  // namespace hrt::experiment
