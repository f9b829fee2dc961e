#include "samples/study/people/person_file.h"

#include <gtest/gtest.h>

#include "samples/study/cli/arguments.h"
#include "tests/samples/text.h"

namespace hrt::study {
namespace {

std::string person_refusal(std::string_view text) {
  try {
    static_cast<void>(parse_person("me", text));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refusal(std::string_view text, std::initializer_list<const char*> words) {
  const std::string message = person_refusal(text);
  EXPECT_FALSE(has(message, "\n"));
  for (const char* word : words) EXPECT_TRUE(has(message, word));
}

TEST(StudyPersonFile, MissingParametersHaveTheirDefault) {
  const PersonFile file = parse_person("me", R"({"illusion": "sine", "tactile_weight": 0.3,
      "tracker_white_mm": 2, "plate_latency_s": 0.06})");
  EXPECT_EQ(file.condition.person.illusion.family, IllusionFamily::sine);
  EXPECT_EQ(file.condition.person.illusion.tactile_weight, 0.3);
  EXPECT_EQ(file.condition.tracker.white_mm, 2.0);
  EXPECT_EQ(file.condition.plate.latency_ns, 60'000'000);
  EXPECT_EQ(file.condition.person.gain_per_s, Person{}.gain_per_s);
  EXPECT_FALSE(file.has_duration);
  EXPECT_TRUE(parse_person("me", R"({"duration_s": 0.8})").has_duration);
}

TEST(StudyPersonFile, WordsSelectTheValueOfTheirName) {
  const auto person = [](const std::string& parameter, const std::string& word) {
    return parse_person("me", "{\"" + parameter + "\": \"" + word + "\"}").condition.person;
  };
  EXPECT_EQ(person("illusion", "dead_band").illusion.family, IllusionFamily::dead_band);
  EXPECT_EQ(person("illusion", "unequal").illusion.family, IllusionFamily::unequal);
  EXPECT_EQ(person("illusion", "linear").illusion.family, IllusionFamily::linear);
  EXPECT_EQ(person("steering", "steps").steering, Steering::steps);
  EXPECT_EQ(person("steering", "crossings").steering, Steering::crossings);
  EXPECT_EQ(person("pace", "minimum_jerk").pace, Pace::minimum_jerk);
  EXPECT_EQ(person("pace", "reversal").pace, Pace::reversal);
}

TEST(StudyPersonFile, ErrorsNameParameterAndAllowedValues) {
  expect_refusal("", {"me", "not valid JSON"});
  expect_refusal("{}", {"no parameter", "tactile_weight"});
  expect_refusal("[1]", {"no parameter"});
  expect_refusal("{\"gain_per_s\": 9} {", {"not valid JSON"});
  expect_refusal("{\"\xff\": 1}", {"not valid JSON"});
  expect_refusal(R"({"gain_per_s": 1e999})", {"not valid JSON"});
  expect_refusal(R"({"tactile_weight": 0.7})", {"me, tactile_weight: '0.7'", "(0, 0.5)"});
  expect_refusal(R"({"tactile_weight": "0.2"})", {"me, tactile_weight", "(0, 0.5)"});
  expect_refusal(R"({"illusion": "cosine"})", {"illusion: 'cosine'", "one of linear, saturating"});
  expect_refusal(R"({"illusion": 3})", {"illusion: '3'", "one of linear, saturating"});
  expect_refusal(R"({"weight": 0.2})", {"'weight'", "one of illusion", "tactile_weight"});
  expect_refusal(R"({"gain_per_s": 9, "gain_per_s": 8})", {"gain_per_s", "twice"});
  for (const char* other : {"[9]", "{\"a\": 1}", "null"})
    expect_refusal(std::string("{\"gain_per_s\": ") + other + "}", {"gain_per_s", "a number in"});
  expect_refusal(R"({"real_direction_deg": 5})", {"real_direction_deg: '5'", "virtual_direction_deg"});
}

// Parses a file with the names and defaults that the help lists.
TEST(StudyPersonFile, HelpHasAllParameters) {
  std::string text;
  const std::string help = person_parameters();
  int count = 0;
  for (std::string_view page = help; !page.empty(); ++count) {
    const std::string_view line = page.substr(0, page.find('\n'));
    page.remove_prefix(line.size() + 1);
    const std::string_view name = line.substr(2, line.find(' ', 2) - 2);
    const std::string value(line.substr(line.rfind(' ') + 1));
    const bool is_word = value.find_first_not_of("0123456789.-e+") != std::string::npos;
    text += (count == 0 ? "{\"" : ", \"") + std::string(name) + "\": " + (is_word ? '"' + value + '"' : value);
  }
  const PersonCondition condition = parse_person("me", text + "}").condition;
  const PersonCondition standard;
  EXPECT_EQ(count, 34);
  EXPECT_EQ(condition.person.illusion.tactile_weight, standard.person.illusion.tactile_weight);
  EXPECT_EQ(condition.plate.latency_ns, standard.plate.latency_ns);
  EXPECT_EQ(condition.distance_mm, standard.distance_mm);
  EXPECT_EQ(condition.person.pace, standard.person.pace);
}

}  // namespace
}  // namespace hrt::study
