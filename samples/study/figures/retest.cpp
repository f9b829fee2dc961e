#include "samples/study/figures/retest.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "samples/study/cli/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

EstimatedTrait trait_of(const Calibration& calibration, std::string_view name) {
  const std::vector<EstimatedTrait> all = estimated_traits(calibration);
  return *std::find_if(all.begin(), all.end(), [&](const EstimatedTrait& each) { return each.name == name; });
}

std::string conclusion(const RetestReport& report) {
  std::string differing;
  std::size_t known = 0;
  for (const ComparedValue& value : report.values) {
    known += value.difference.difference.known ? 1 : 0;
    if (value.difference.differs) differing += (differing.empty() ? "" : "; ") + std::string(value.trait.words);
  }
  if (known == 0) return "No value is known from both calibrations: nothing can be compared";
  if (differing.empty())
    return "No difference is shown. That is no proof that nothing changed: the intervals say how much it may "
           "be";
  return "They differ: " + differing;
}

}  // namespace

RetestReport compare_calibrations(CalibrationReport first, CalibrationReport second) {
  RetestReport report{std::move(first), std::move(second), {}};
  const Calibration& a = report.first.calibration;
  const Calibration& b = report.second.calibration;
  std::vector<RepeatedValue> values;
  for (const char* const name : {"tactile_weight", "max_gap_deg", "bias_deg", "habit_deg", "tracker_noise_mm"}) {
    const EstimatedTrait first_value = trait_of(a, name);
    report.values.push_back({first_value, {}});
    values.push_back({first_value.interval, trait_of(b, name).interval});
  }
  const std::vector<RetestDifference> differences = compare(values);
  for (std::size_t i = 0; i < values.size(); ++i) report.values[i].difference = differences[i];
  return report;
}

std::string retest_text(const RetestReport& report) {
  std::string text = "\nRetest " + report.second.name + " less test " + report.first.name + "\n  " + left("", 36) +
                     right("difference", 15) + "   95 % interval\n";
  for (const ComparedValue& value : report.values) {
    const Interval& difference = value.difference.difference;
    text += "  " + left(value.trait.words, 36);
    text += difference.known ? right(fixed(difference.value, value.trait.decimals), 15) + "   " +
                                   between(difference.lower, difference.upper, value.trait.decimals, " to ") +
                                   (value.difference.differs ? ", differs" : "") + '\n'
                             : right("not determined", 15) + '\n';
  }
  return text + conclusion(report) +
         ". With all values together, 5 % of pairs of an unchanged person would show a difference.\n";
}

nlohmann::ordered_json retest_json(const RetestReport& report) {
  nlohmann::ordered_json page{{"test", report.first.name}, {"retest", report.second.name}};
  bool differs = false;
  for (const ComparedValue& value : report.values) {
    const RetestDifference& difference = value.difference;
    differs = differs || difference.differs;
    page["values"][value.trait.name] = {{"difference", difference.difference.value},
                                        {"interval", {difference.difference.lower, difference.difference.upper}},
                                        {"known", difference.difference.known},
                                        {"p", difference.p},
                                        {"differs", difference.differs}};
  }
  page["differs"] = differs;
  return page;
}

}  // namespace hrt::study
