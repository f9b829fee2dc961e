#include "samples/study/people/person_file.h"

#include <gtest/gtest.h>

#include "samples/study/cli/arguments.h"
#include "tests/samples/text.h"

namespace hrt::study {
namespace {

std::string refusal(std::string_view text) {
  try {
    static_cast<void>(parse_person("me", text));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refusal(std::string_view text, std::initializer_list<const char*> words) {
  const std::string message = refusal(text);
  EXPECT_FALSE(has(message, "\n"));
  for (const char* word : words) EXPECT_TRUE(has(message, word));
}

TEST(StudyPersonFile, CsvAndJsonSayTheSame) {
  const PersonFile csv =
      parse_person("me",
                   "\xEF\xBB\xBF# me\r\nname, value\r\n\r\nillusion,sine\r\n tactile_weight , "
                   "0.3\r\ntracker_white_mm,2\r\nplate_latency_s,0.06\r\n");
  const PersonFile json = parse_person("me",
                                       " {\"illusion\": \"sine\", \"tactile_weight\": "
                                       "0.3,\n\"tracker_white_mm\": 2, \"plate_latency_s\": 6e-2}");
  for (const PersonFile* file : {&csv, &json}) {
    EXPECT_EQ(file->condition.person.illusion.family, IllusionFamily::sine);
    EXPECT_EQ(file->condition.person.illusion.tactile_weight, 0.3);
    EXPECT_EQ(file->condition.tracker.white_m, 0.002);
    EXPECT_EQ(file->condition.plate.latency_ns, 60'000'000);
    EXPECT_EQ(file->condition.person.gain_per_s, Person{}.gain_per_s);
    EXPECT_FALSE(file->has_duration);
  }
  EXPECT_TRUE(parse_person("me", "name,value\nduration_s,0.8").has_duration);
}

// Each word of each parameter stands for the value of its name.
TEST(StudyPersonFile, WordsByHand) {
  const auto person = [](const std::string& line) {
    return parse_person("me", "name,value\n" + line).condition.person;
  };
  EXPECT_EQ(person("illusion,dead_band").illusion.family, IllusionFamily::dead_band);
  EXPECT_EQ(person("illusion,unequal").illusion.family, IllusionFamily::unequal);
  EXPECT_EQ(person("illusion,linear").illusion.family, IllusionFamily::linear);
  EXPECT_EQ(person("steering,steps").steering, Steering::steps);
  EXPECT_EQ(person("steering,crossings").steering, Steering::crossings);
  EXPECT_EQ(person("pace,minimum_jerk").pace, Pace::minimum_jerk);
  EXPECT_EQ(person("pace,reversal").pace, Pace::reversal);
}

TEST(StudyPersonFile, RefusalsNameLineAndAllowedValues) {
  expect_refusal("", {"me", "no parameter", "tactile_weight"});
  expect_refusal("name,value\n", {"me", "no parameter"});
  expect_refusal("tactile_weight,0.2\n", {"me, line 1", "name,value"});
  expect_refusal("# x\nname,value\ntactile_weight,0.7\n", {"me, line 3, tactile_weight: '0.7'", "(0, 0.5)"});
  expect_refusal("name,value\ntactile_weight,nan\n", {"line 2", "(0, 0.5)"});
  expect_refusal("name,value\ntactile_weight,0.2x\n", {"line 2, tactile_weight: '0.2x'"});
  expect_refusal("name,value\ntactile_weight\n", {"line 2", "a comma and a value"});
  expect_refusal("name,value\nillusion,cosine\n",
                 {"line 2, illusion: 'cosine'", "one of linear, saturating"});
  expect_refusal("name,value\nweight,0.2\n", {"line 2", "'weight'", "one of illusion", "tactile_weight"});
  expect_refusal("name,value\ngain_per_s,9\ngain_per_s,8\n", {"line 3", "gain_per_s", "no line before"});
  expect_refusal("name,value\nreal_direction_deg,5\n", {"real_direction_deg: '5'", "virtual_direction_deg"});
  expect_refusal("{\n\"gain_per_s\": 9,\n\"tactile_weight\": 0.7}",
                 {"line 3, tactile_weight: '0.7'", "(0, 0.5)"});
  expect_refusal("{\n\"gain_per_s\": 9,\n\"gain_per_s\": 8}", {"line 3", "no line before"});
  expect_refusal("{\"gain_per_s\": [9]}", {"line 1", "gain_per_s", "a number or a word"});
  expect_refusal("{\"gain_per_s\": {\"a\": 1}}", {"line 1", "a number or a word"});
  expect_refusal("{\"gain_per_s\": null}", {"line 1", "gain_per_s", "a number or a word"});
  expect_refusal("{\n\"gain_per_s\": 9,\n", {"line 3", "not JSON"});
  expect_refusal("{\"gain_per_s\": 1e999}", {"line 1", "too large"});
  expect_refusal("{\"gain_per_s\": 9} {", {"not JSON"});
  expect_refusal("{}", {"no parameter"});
  expect_refusal("{\"\xff\": 1}", {"line 1"});
}

// Every name of the help is one that is taken, with its default.
TEST(StudyPersonFile, HelpHasAllParameters) {
  std::string text = "name,value\n";
  std::string_view page;
  const std::string help = person_parameters();
  page = help;
  int count = 0;
  while (!page.empty()) {
    const std::string_view line = page.substr(0, page.find('\n'));
    page.remove_prefix(line.size() + 1);
    const std::string_view name = line.substr(2, line.find(' ', 2) - 2);
    text += std::string(name) + ',' + std::string(line.substr(line.rfind(' ') + 1)) + '\n';
    ++count;
  }
  const PersonCondition condition = parse_person("me", text).condition;
  const PersonCondition standard;
  EXPECT_EQ(count, 33);
  EXPECT_EQ(condition.person.illusion.tactile_weight, standard.person.illusion.tactile_weight);
  EXPECT_EQ(condition.plate.latency_ns, standard.plate.latency_ns);
  EXPECT_EQ(condition.distance_m, standard.distance_m);
  EXPECT_EQ(condition.person.pace, standard.person.pace);
}

}  // namespace
}  // namespace hrt::study
