#include "samples/study/figures/retest.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "samples/study/cli/output.h"
#include "samples/text.h"

namespace hrt::study {
namespace {

Quantity quantity_of(const Calibration& calibration, std::string_view name) {
  std::vector<Quantity> all = quantities(calibration);
  for (const Quantity& quantity : steering_quantities(calibration.steering)) all.push_back(quantity);
  return *std::find_if(all.begin(), all.end(), [&](const Quantity& each) { return each.name == name; });
}

std::string conclusion(const RetestReport& report) {
  std::string differing;
  std::size_t known = 0;
  for (const ComparedValue& value : report.values) {
    known += value.difference.difference.known ? 1 : 0;
    if (value.difference.differs)
      differing += (differing.empty() ? "" : "; ") + std::string(value.quantity.words);
  }
  if (known == 0) return "No value is known from both calibrations: nothing can be compared";
  if (differing.empty())
    return "No difference is shown. That is no proof that nothing changed: the intervals say how much it may "
           "be";
  return "They differ: " + differing;
}

// In gnuplot's quotes: a line a clause.
std::string in_lines(std::string text) {
  for (const char* end : {". ", ": the "}) {
    const std::size_t at = text.find(end);
    if (at != std::string::npos) text.replace(at + 1, 1, "\\n");
  }
  return text;
}

// The difference over the half of its interval that reaches towards 0: beyond 1 it excludes 0.
double relative(const Interval& difference) {
  const double half =
      difference.value > 0.0 ? difference.value - difference.lower : difference.upper - difference.value;
  return half > 0.0 ? difference.value / half : 0.0;
}

}  // namespace

RetestReport compare_calibrations(CalibrationReport first, CalibrationReport second) {
  RetestReport report{std::move(first), std::move(second), {}};
  const Calibration& a = report.first.calibration;
  const Calibration& b = report.second.calibration;
  std::vector<const char*> names{"tactile_weight", "max_gap_deg", "bias_deg", "habit_deg",
                                 "tracker_noise_mm"};
  if (a.steering.slides > 0 && b.steering.slides > 0)
    names.insert(names.end(), {"steering_rate_per_s", "steering_delay_ms"});
  std::vector<RepeatedValue> values;
  for (const char* const name : names) {
    const Quantity first_value = quantity_of(a, name);
    report.values.push_back({first_value, {}});
    values.push_back({first_value.interval, quantity_of(b, name).interval});
  }
  const std::vector<RetestDifference> differences = compare(values);
  for (std::size_t i = 0; i < values.size(); ++i) report.values[i].difference = differences[i];
  return report;
}

std::string retest_text(const RetestReport& report) {
  std::string text = "\nRetest " + report.second.name + " less test " + report.first.name + "\n  " +
                     left("", 36) + right("difference", 15) + "   95 % interval\n";
  for (const ComparedValue& value : report.values) {
    const Interval& difference = value.difference.difference;
    text += "  " + left(value.quantity.words, 36);
    text += difference.known
                ? right(fixed(difference.value, value.quantity.decimals), 15) + "   " +
                      between(difference.lower, difference.upper, value.quantity.decimals, " to ") +
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
    page["values"][value.quantity.name] = {
        {"difference", difference.difference.value},
        {"interval", {difference.difference.lower, difference.difference.upper}},
        {"known", difference.difference.known},
        {"p", difference.p},
        {"differs", difference.differs}};
  }
  page["differs"] = differs;
  return page;
}

Figure retest_figure(const RetestReport& report) {
  Figure figure{
      .name = "retest", .title = "Test and retest", .caption = "", .width_px = 640, .height_px = 800};
  const auto band = [&](const char* name, const Calibration& calibration) {
    figure.script += std::string("$") + name + " << EOD\n";
    for (const CurvePoint& point : calibration.band)
      figure.script += number(point.offset_deg) + ' ' + number(point.shift_deg.value) + ' ' +
                       number(point.shift_deg.lower) + ' ' + number(point.shift_deg.upper) + '\n';
    figure.script += "EOD\n";
  };
  band("test", report.first.calibration);
  band("retest", report.second.calibration);
  // One row a value, from the top down.
  std::string names;
  figure.script += "$values << EOD\n";
  for (std::size_t i = 0; i < report.values.size(); ++i) {
    const ComparedValue& value = report.values[i];
    const Interval& difference = value.difference.difference;
    const std::string row = std::to_string(report.values.size() - i);
    names += (i == 0 ? "" : ", ") + ("'" + std::string(value.quantity.words) + "' " + row);
    if (difference.known)
      figure.script +=
          number(relative(difference)) + ' ' + row + " \"" +
          with_minus_signs(fixed(difference.value, value.quantity.decimals) + " (" +
                           between(difference.lower, difference.upper, value.quantity.decimals, " to ") +
                           ")") +
          "\"\n";
    else
      figure.script += "0 " + row + " \"not determined\"\n";
  }
  figure.script +=
      "EOD\nset grid back lt 1 lw 0.6 lc rgb '#dddddd'\nset multiplot\nset origin 0,0.45\nset size 1,0.55\n"
      "set title 'Illusion, test and retest' font ',12'\nset key top left\nset xrange [-80:80]\nset xtics "
      "15\n"
      "set xlabel 'ridge normal less motion, °'\nset ylabel 'felt shift, °'\nset style fill transparent "
      "solid 0.5 noborder\n"
      "plot $test using 1:3:4 with filledcurves fc rgb '#c6dbef' title 'test, 95 %', "
      "$retest using 1:3:4 with filledcurves fc rgb '#fdd0a2' title 'retest, 95 %', "
      "$test using 1:2 with lines lw 2 lc rgb '#08306b' notitle, "
      "$retest using 1:2 with lines lw 2 dt 2 lc rgb '#b35806' notitle\n"
      "set origin 0,0\nset size 1,0.45\nset title \"" +
      in_lines(conclusion(report)) +
      "\" font ',11'\nunset key\nset lmargin 28\nset rmargin 4\nset xrange [-4:4]\nset xtics 1\nset yrange "
      "[0.4:" +
      std::to_string(report.values.size()) + ".8]\nset ytics (" + names +
      ")\nset xlabel 'difference over half its 95 % interval'\nunset ylabel\n"
      "set arrow from -1,graph 0 to -1,graph 1 nohead dt 2 lc rgb '#555555'\n"
      "set arrow from 1,graph 0 to 1,graph 1 nohead dt 2 lc rgb '#555555'\n"
      "plot $values using (strcol(3) eq 'not determined'?NaN:$1<-3.8?-3.8:($1>3.8?3.8:$1)):2 with points pt "
      "7 ps 1.2 lc rgb '#08306b', "
      "$values using ($1<-3.8?-3.8:($1>3.8?3.8:$1)):($2+0.32):3 with labels font ',10'\nunset multiplot\n";
  return figure;
}

}  // namespace hrt::study
