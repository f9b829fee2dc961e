// Reads calibration data and checks all of it.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "samples/study/arguments.h"
#include "samples/study/output.h"
#include "samples/study/participants.h"

namespace hrt::study {
namespace {

struct Column {
  const char* name;
  NumberRange range;
};

constexpr std::array<Column, 5> columns{{
    {"trial", {.low = 0.0, .high = 1e9, .whole = true}},
    {"time_s", {.low = -1e9, .high = 1e9}},
    {"right_m", {.low = -10.0, .high = 10.0}},
    {"away_m", {.low = -10.0, .high = 10.0}},
    {"plate_orientation_deg", {.low = -3600.0, .high = 3600.0}},
}};
enum { trial, time, right_of_midline, away, plate };

// A plate "at rest" as its own sensor may see it.
constexpr double rest_tolerance_deg = 1.0;
constexpr std::size_t longest_shown = 40;

// Fields without the blanks around them.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields = split(line, ',');
  for (std::string_view& field : fields) {
    field.remove_prefix(std::min(field.find_first_not_of(" \t"), field.size()));
    field.remove_suffix(field.size() - (field.find_last_not_of(" \t") + 1));
  }
  return fields;
}

class Reader {
 public:
  explicit Reader(const std::string& name) : name_(name) {}

  void read_line(std::string_view line) {
    ++line_;
    if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') return;
    const std::vector<std::string_view> fields = fields_of(line);
    has_header_ ? read_row(fields) : read_header(fields);
  }

  std::vector<CalibrationTrial> finish() {
    if (!has_header_)
      throw UsageError(name_ + ": there is no header; it must name " + std::string(calibration_header));
    if (trials_.empty()) throw UsageError(name_ + ": there is no row under the header");
    end_trial();
    return std::move(trials_);
  }

 private:
  UsageError wrong(const std::string& column, std::string_view text, const std::string& allowed) const {
    std::string shown(text.substr(0, longest_shown));
    if (text.size() > longest_shown) shown += "...";
    return UsageError(not_allowed(name_ + ", line " + std::to_string(line_) + ", " + column, shown, allowed));
  }

  void read_header(const std::vector<std::string_view>& fields) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto found = std::find(fields.begin(), fields.end(), columns[i].name);
      const std::string column = std::string("column ") + columns[i].name;
      const std::string allowed = std::string("a header that names ") + calibration_header;
      if (found == fields.end())
        throw UsageError(name_ + ", line " + std::to_string(line_) + ", " + column +
                         ": it is missing; the line must be " + allowed);
      if (std::find(found + 1, fields.end(), *found) != fields.end())
        throw wrong(column, *found, allowed + ", each once");
      places_[i] = static_cast<std::size_t>(found - fields.begin());
    }
    fields_ = fields.size();
    has_header_ = true;
  }

  double parse(std::size_t column, std::string_view text) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole_text = error == std::errc() && end == text.data() + text.size();
    if (!whole_text || !columns[column].range.contains(value))
      throw wrong(std::string("column ") + columns[column].name, text, columns[column].range.text());
    return value;
  }

  void read_row(const std::vector<std::string_view>& fields) {
    if (fields.size() != fields_)
      throw wrong("columns", std::to_string(fields.size()),
                  "as many as the header has, " + std::to_string(fields_));
    std::array<double, columns.size()> values;
    for (std::size_t i = 0; i < columns.size(); ++i) values[i] = parse(i, fields[places_[i]]);
    if (trials_.empty() || values[trial] != number_) begin_trial(values[trial], values[plate]);
    add(values, fields[places_[time]]);
  }

  void begin_trial(double number_of_trial, double plate_deg) {
    if (!seen_.insert(number_of_trial).second)
      throw wrong("column trial", number(number_of_trial),
                  "a number that no trial before has; the rows of a trial stand together");
    end_trial();
    number_ = number_of_trial;
    first_plate_deg_ = plate_deg;
    plate_sum_deg_ = 0.0;
    turns_ = false;
    trials_.emplace_back();
  }

  void add(const std::array<double, columns.size()>& values, std::string_view time_text) {
    std::vector<TimedPoint>& samples = trials_.back().samples;
    const std::int64_t time_ns = std::llround(values[time] * 1e9);
    if (!samples.empty() && time_ns <= samples.back().time_ns)
      throw wrong("column time_s", time_text, "later than in the row before, by a nanosecond or more");
    turns_ = turns_ || std::abs(values[plate] - first_plate_deg_) > rest_tolerance_deg;
    trials_.back().plate_deg.push_back(values[plate]);
    samples.push_back({time_ns, {values[right_of_midline], values[away]}});
    plate_sum_deg_ += values[plate] - first_plate_deg_;
  }

  void end_trial() {
    if (trials_.empty()) return;
    CalibrationTrial& last = trials_.back();
    last.plate_orientation_deg = first_plate_deg_ + plate_sum_deg_ / static_cast<double>(last.samples.size());
    if (!turns_) last.plate_deg.clear();
  }

  const std::string& name_;
  std::size_t line_ = 0;
  bool has_header_ = false;
  std::size_t fields_ = 0;
  std::array<std::size_t, columns.size()> places_{};
  std::vector<CalibrationTrial> trials_;
  std::set<double> seen_;
  double number_ = 0.0;
  double first_plate_deg_ = 0.0;
  double plate_sum_deg_ = 0.0;
  bool turns_ = false;  // the plate, in this trial
};

}  // namespace

std::vector<CalibrationTrial> parse_calibration_csv(const std::string& name, std::string_view text) {
  Reader reader(name);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.finish();
}

}  // namespace hrt::study
