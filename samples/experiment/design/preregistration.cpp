#include "samples/experiment/design/design.h"

#include "samples/app/text/format.h"
#include "samples/experiment/design/schedule.h"
#include "samples/experiment/protocol.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

// Returns a value as text without quotes, and a list as values separated by commas.
std::string in_words(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const json& item : value) text += (text.empty() ? "" : ", ") + in_words(item);
  return text;
}

// Returns one line per field, followed by the indented fields of an object or of each object in a list.
std::string fields_text(const json& schema, const json& given, const std::string& indent) {
  std::string text;
  for (const auto& [name, field] : schema["properties"].items()) {
    const bool is_given = given.contains(name);
    text += indent + "- `" + name + "` (" + field["description"].get<std::string>() + ")";
    if (field.contains("properties")) {
      text += is_given ? "\n" : ": not given, so these values apply:\n";
      text += fields_text(field, is_given ? given[name] : json::object(), indent + "  ");
    } else if (is_given && field.contains("items") && field["items"].contains("properties")) {
      text += "\n";
      for (std::size_t i = 0; i < given[name].size(); ++i)
        text +=
            indent + format("  - number %zu\n", i + 1) + fields_text(field["items"], given[name][i], indent + "    ");
    } else {
      text += ": " +
              (is_given                    ? in_words(given[name])
               : field.contains("default") ? in_words(field["default"]) + " (default)"
                                           : "not given") +
              "\n";
    }
  }
  return text;
}

std::string hypothesis_text(const Design& design) {
  const std::string reference = design.conditions[design.reference].name, measure = "`" + design.measure + "`";
  const std::string of_each = measure + " of each condition ";
  if (design.hypothesis == "difference" && design.direction == "two-sided")
    return of_each + "differs from that of " + reference + ", in either direction.";
  if (design.hypothesis == "difference") return of_each + "is " + design.direction + " than that of " + reference + ".";
  return of_each + "differs from " + (design.hypothesis == "equivalence" ? "that of " + reference : "0") +
         format(" by less than %g.", design.margin);
}

std::string test_text(const Design& design) {
  const bool is_absolute = design.hypothesis == "below_margin";
  const auto tests = static_cast<unsigned>(design.conditions.size()) - (is_absolute ? 0U : 1U);
  return (design.hypothesis != "difference" ? "two one-sided t tests, " + format("margin %g,", design.margin)
          : design.direction == "two-sided" ? "two-sided " + design.test
                                            : "one-sided " + design.test) +
         " of `" + design.measure + "`" +
         format(" for %u condition%s, Holm's correction, family-wise level %g; intervals at the corrected level.",
                tests, tests == 1 ? "" : "s", design.alpha);
}

std::string power_text(const Design& design, const std::string& power) {
  if (power.empty())
    return "\n\n[Power: `samples/experiment/power study.json >power.txt`, then `hrt-experiment preregister study.json "
           "--power power.txt`.]\n\n";
  if (power.find(design.sha256) == std::string::npos)
    throw Refusal(
        "--power: the table was computed for another design, as it does not contain the SHA-256 of this design, " +
        design.sha256 + "; run samples/experiment/power with this design again");
  return "\n\nPower, by simulation:\n\n```\n" + power + "```\n\n";
}

}  // namespace

std::string preregistration_text(const Design& design, const std::string& power) {
  return "# " + design.title + "\n\nSHA-256 of study.json: `" + design.sha256 +
         "`. After the first participant, hrt-experiment rejects any other design.\n"
         "The authors replace the texts in brackets and delete this line.\n\n"
         "## Hypotheses\n\n" +
         hypothesis_text(design) +
         " [Why, and which size of the effect matters.]\n\n"
         "## Participants\n\n" +
         format("%u. ", design.participants) +
         "Participant N who is excluded or withdraws is replaced by participant N" +
         format(" + %u, with the same level and order. ", design.participants) + "[Who may take part.]" +
         power_text(design, power) + "## Design and procedure\n\n" +
         fields_text(design_schema(), json::parse(design.text), "") + "\n```\n" + design_text(design) +
         "```\n\n## Blinding\n\nThe experimenter sees letters instead of conditions, assigned at random for each "
         "participant; practice and noticeability have no letter. The journal records when the experimenter is "
         "unblinded. The design, the motion of the plate and the page of `hrt-experiment --live`, which displays the "
         "finger's paths, can reveal a condition. [Who knows the conditions.]\n\n"
         "## Exclusions and stopping\n\nThe program decides by the rules of `validity` whether a reach is valid. The "
         "experimenter, who may see the plate, can mark a reach as invalid while it lasts; the report has the number "
         "of invalid reaches by condition and reason. The analysis excludes participants by the rules of "
         "`exclusions`. A session stops after " +
         format("%u invalid reaches in a row, or %g minutes after consent. ", design.max_invalid_in_a_row,
                design.max_minutes) +
         "The number of participants does not depend on the data. [Other exclusions.]\n\n"
         "## Analysis\n\n`samples/experiment/analyse`, after `hrt-experiment export --unblind`: " +
         test_text(design) +
         (design.levels.empty() ? "" : " By `" + design.factor + "`: Welch's test of each comparison.") +
         " [Exploratory analyses.]\n\n"
         "## Data\n\n[Where the data, recordings and this text will be.]\n";
}

std::string protocol_text(const Design& design) {
  std::string text = protocol;
  const auto fill = [&](const std::string& name, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += value.size())
      text.replace(at, name.size(), value);
  };
  fill("{plan}\n", plan_text(design, schedule_of(design, 1)));
  fill("{participants}", format("%u", design.participants));
  fill("{pause}", format("%g", design.max_pause_minutes));
  fill("{title}", design.title);
  return text;
}

}  // namespace hrt::experiment
