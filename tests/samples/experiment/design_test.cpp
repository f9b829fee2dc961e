#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "samples/experiment/data/disk.h"
#include "samples/experiment/design/design.h"
#include "tests/samples/experiment/study.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

TEST(ExperimentDesign, Sha256OfTheExampleOfTheStandard) {
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ExperimentDesign, ThePreregistrationHasEveryField) {
  const Design design = small_design(3);
  const std::string text = preregistration_text(design);
  for (const std::string& line : std::vector<std::string>{
           "- `repeats` (Number of trials of each pair in a block): 3\n",
           "- `rounds` (Number of blocks per condition; with random_in_blocks: number of blocks): 1 (default)\n",
           "  - `max_s` (Maximum duration, seconds): 8 (default)\n",
           "- `listed_orders` (Orders of the conditions, by name; participants get complete sets of orders, each set "
           "in "
           "random order): not given\n",
           "  - number 2\n    - `config` (", "SHA-256 of study.json: `" + design.sha256 + "`"})
    EXPECT_TRUE(has(text, line));
  for (const auto& [name, field] : design_schema()["properties"].items())
    EXPECT_TRUE(has(text, "- `" + name + "` (")) << name;
}

TEST(ExperimentDesign, ThePreregistrationStatesHypothesisAndPower) {
  const auto text_of = [](const json& analysis) {
    return preregistration_text(small_design(3, [&](json& study) { study["analysis"] = analysis; }));
  };
  EXPECT_TRUE(has(text_of({{"direction", "less"}}), "is less than that of hidden none."));
  EXPECT_TRUE(has(text_of({{"direction", "less"}}),
                  "one-sided t of `abs_miss_deg` for 1 condition, Holm's correction, family-wise level 0.05"));
  EXPECT_TRUE(
      has(text_of({{"hypothesis", "equivalence"}, {"margin", 2}}), "differs from that of hidden none by less than 2."));
  EXPECT_TRUE(has(text_of({{"hypothesis", "below_margin"}}), "t tests, margin 1, of `abs_miss_deg` for 2 conditions"));
  const Design design = small_design(3);
  const std::string table = "a table, SHA-256 " + design.sha256 + "\n";
  EXPECT_TRUE(has(preregistration_text(design, table), "```\n" + table + "```"));
  EXPECT_TRUE(has(preregistration_text(design), "after 10 invalid reaches in a row, or 120 minutes after consent"));
  EXPECT_NE(refusal_of([&] { preregistration_text(small_design(4), table); }), "");
}

// Each condition directly follows each other condition equally often, and is in each position equally often.
TEST(ExperimentDesign, WilliamsOrdersAreBalanced) {
  for (unsigned count = 1; count <= 12; ++count) {
    const auto orders = williams_orders(count);
    ASSERT_EQ(orders.size(), count % 2 == 0 || count == 1 ? count : 2 * count);
    std::map<std::pair<unsigned, unsigned>, unsigned> follows, places;
    for (const auto& order : orders) {
      ASSERT_EQ(std::set<unsigned>(order.begin(), order.end()).size(), count);
      for (unsigned i = 0; i < count; ++i) {
        ++places[{i, order[i]}];
        if (i > 0) ++follows[{order[i - 1], order[i]}];
      }
    }
    EXPECT_EQ(follows.size(), count * (count - 1));
    EXPECT_EQ(places.size(), count * count);
    for (const auto& [pair, times] : follows) EXPECT_EQ(times, orders.size() / count) << count;
    for (const auto& [place, times] : places) EXPECT_EQ(times, orders.size() / count) << count;
  }
}

// Expects every pair of each condition as often as planned, no pair 3 times in a row, and no catch trial first or after
// another one.
void expect_legal(const Design& design, const Block& block, std::size_t conditions) {
  std::map<std::pair<unsigned, unsigned>, unsigned> cells;
  std::size_t catches = 0;
  for (std::size_t i = 0; i < block.trials.size(); ++i) {
    const PlannedTrial& trial = block.trials[i];
    ASSERT_EQ(trial.number, i + 1);
    ASSERT_FALSE(trial.is_catch && (i == 0 || block.trials[i - 1].is_catch));
    ASSERT_FALSE(i > 1 && trial.pair == block.trials[i - 1].pair && trial.pair == block.trials[i - 2].pair);
    catches += std::size_t{trial.is_catch};
    if (!trial.is_catch) ++cells[{trial.condition, trial.pair}];
  }
  ASSERT_EQ(cells.size(), conditions * 2);
  for (const auto& [cell, times] : cells) ASSERT_EQ(times, design.repeats);
  ASSERT_EQ(catches, static_cast<std::size_t>(std::lround(0.2 * static_cast<double>(conditions * 2 * design.repeats))));
}

TEST(ExperimentDesign, TenThousandSeedsHaveLegalSequences) {
  for (unsigned seed = 0; seed < 10'000; ++seed) {
    const Design design = small_design(3, [&](json& study) {
      study["seed"] = seed;
      study["catch_share"] = 0.2;
      study["order"] = seed % 2 == 0 ? "williams" : "random_in_blocks";
    });
    const Schedule schedule = schedule_of(design, 1 + seed % 2);
    ASSERT_EQ(schedule.blocks.size(), seed % 2 == 0 ? 3U : 2U);
    for (std::size_t b = 1; b < schedule.blocks.size(); ++b)
      expect_legal(design, schedule.blocks[b], seed % 2 == 0 ? 1 : 2);
    if (HasFatalFailure()) FAIL() << seed;
  }
}

// Each level has each order equally often, and participants 2n - 1 and 2n have different levels. A replacement has the
// level and the order of the replaced participant.
TEST(ExperimentDesign, LevelsAreCrossedWithOrders) {
  const Design design = small_design(2, [](json& study) {
    study["participants"] = 8;
    study["between"] = {{"factor", "hand"}, {"levels", {"left", "right"}}};
  });
  std::map<std::pair<unsigned, std::vector<unsigned>>, unsigned> cells;
  for (unsigned p = 1; p <= 8; ++p) {
    const Schedule schedule = schedule_of(design, p), replacement = schedule_of(design, p + 8);
    ++cells[{schedule.level, schedule.order}];
    EXPECT_EQ(replacement.level, schedule.level);
    EXPECT_EQ(replacement.order, schedule.order);
    if (p % 2 == 0) {
      EXPECT_NE(schedule.level, schedule_of(design, p - 1).level) << p;
    }
  }
  EXPECT_EQ(cells.size(), 4U);
  for (const auto& [cell, times] : cells) EXPECT_EQ(times, 2U);
}

struct Wrong {
  const char* text;  // part of the error text
  std::function<void(json&)> change;
};

const Wrong wrongs[] = {
    {".title is missing", [](json& s) { s.erase("title"); }},
    {".titel is not known; known are \"analysis\", \"answers\"", [](json& s) { s["titel"] = "x"; }},
    {".repeats must be a whole number from 1 to 100", [](json& s) { s["repeats"] = 0; }},
    {".repeats must be a whole", [](json& s) { s["repeats"] = 2.5; }},
    {".participants must be a multiple of 2", [](json& s) { s["participants"] = 3; }},
    {".conditions[1].controller must be one of \"people\", \"paper\"",
     [](json& s) { s["conditions"][1]["controller"] = "mpc"; }},
    {".conditions[1].name is", [](json& s) { s["conditions"][1]["name"] = "secret people"; }},
    {".pairs[0].virtual_deg must be a number from -60 to 60", [](json& s) { s["pairs"][0]["virtual_deg"] = 61; }},
    {".pairs[0].name must be a text", [](json& s) { s["pairs"][0]["name"] = "a\nb"; }},
    {".pairs[1] must be an object", [](json& s) { s["pairs"][1] = 4; }},
    {".listed_orders is required", [](json& s) { s["order"] = "listed"; }},
    {".listed_orders[0] must have each",
     [](json& s) {
       s["order"] = "listed";
       s["listed_orders"] = json::parse(R"([["secret people", "secret people"]])");
     }},
    {".validity.max_s must be above min_s", [](json& s) { s["validity"] = {{"min_s", 2}, {"max_s", 1}}; }},
    {".noticeability.condition must be the name of a condition: \"secret people\", \"hidden none\"",
     [](json& s) { s["noticeability"] = {{"condition", "x"}}; }},
    {".noticeability.condition must be", [](json& s) { s["noticeability"] = {{"condition", "hidden none"}}; }},
    {".pairs[0].real_deg must be at most 75",
     [](json& s) { s["pairs"][0].update({{"virtual_deg", 40}, {"real_deg", -40}}); }},
    {".questionnaires[0].items is missing", [](json& s) { s["questionnaires"] = {{{"name", "SSQ"}}}; }},
    {".analysis.test needs at least 6", [](json& s) { s["analysis"] = {{"test", "sign_flip"}}; }},
    {".analysis.test needs at least 5",  // with 4 participants, the smallest p equals alpha
     [](json& s) {
       s["participants"] = 4;
       s["analysis"] = {{"test", "sign_flip"}, {"alpha", 0.125}};
     }},
    {".analysis.test must be t or sign_flip with the measure d_prime",
     [](json& s) {
       s["catch_share"] = 0.2;
       s["analysis"] = {{"test", "mixed_model"}, {"measure", "d_prime"}};
     }},
    {".analysis.test must be sign_flip", [](json& s) { s["analysis"] = {{"measure", "percent_within"}}; }},
    {".analysis.direction must be two-sided",
     [](json& s) { s["analysis"] = {{"hypothesis", "equivalence"}, {"direction", "less"}}; }},
    {".noticeability.control must be the name",
     [](json& s) { s["noticeability"] = {{"condition", "secret people"}, {"control", "x"}}; }},
    {".analysis.test must be t with the hypothesis equivalence",
     [](json& s) { s["analysis"] = {{"test", "sign_flip"}, {"hypothesis", "equivalence"}}; }},
    {".analysis.measure requires question", [](json& s) { s["analysis"] = {{"measure", "criterion"}}; }},
    {".conditions[0].config has the field \"person.weight\"",
     [](json& s) { s["conditions"][0]["config"] = {{{"field", "person.weight"}, {"value", 0.3}}}; }},
    {".conditions[0].config is refused: hrt_session_create",
     [](json& s) { s["conditions"][0]["config"] = {{{"field", "person.tactile_weight"}, {"value", 3}}}; }},
    {".conditions[0].config has person.tactile_weight",
     [](json& s) {
       s["set_up"] = "calibration";
       s["conditions"][0]["config"] = {{{"field", "person.tactile_weight"}, {"value", 0.3}}};
     }},
    {".analysis.measure must be one of", [](json& s) { s["analysis"] = {{"measure", "peak_felt_error_deg"}}; }},
    {".analysis.reference must be the name", [](json& s) { s["analysis"] = {{"reference", "x"}}; }}};

TEST(ExperimentDesign, ErrorsNameTheField) {
  for (const Wrong& wrong : wrongs) {
    const std::string why = refusal_of([&] { small_design(2, wrong.change); });
    EXPECT_TRUE(why.starts_with("study.json.") && why.find(wrong.text) != std::string::npos)
        << wrong.text << ": " << why;
  }
  EXPECT_TRUE(has(refusal_of([] { parse_design("{", "study.json"); }), "study.json"));
  EXPECT_EQ(refusal_of([] { parse_design(R"({"seed": 1, "seed": 2})", "study.json"); }),
            "study.json: \"seed\" occurs twice in one object; remove one of the two");
}

// The plan: 5 minutes for consent, 6 for the set-up, 6 items of 9 s, 3 trials of 12 s, a break of a minute.
TEST(ExperimentDesign, TheProtocolHasTheTimePlan) {
  const std::string text = protocol_text(read_design(HRT_EXPERIMENT_SOURCE "/example.json"));
  EXPECT_EQ(text.find_first_of("{}"), std::string::npos) << text;
  for (const char* part : {"| 5 | set-up", "| 11 | questionnaire SSQ", "| 12 | block 0: practice, 3 trials",
                           "| 14 | block 1: reaches, 13 trials", "last of 12 participants", "15 minutes, all trials"})
    EXPECT_TRUE(has(text, part));
}

TEST(ExperimentDesign, TextNamesNoCondition) {
  const std::string text = design_text(small_design(2));
  EXPECT_FALSE(has(text, "secret"));
  EXPECT_FALSE(has(text, "hidden"));
  EXPECT_TRUE(has(text, "follows each other condition 1 to 1 times"));
}

}  // namespace
}  // namespace hrt::experiment
