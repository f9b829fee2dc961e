#include "samples/study/people/replay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "samples/study/numbers/csv.h"
#include "samples/study/people/participants.h"

namespace hrt::study {
namespace {

constexpr std::string_view recording_start = "# haptic retargeting recording, version ";
constexpr std::string_view readable_version = "4";
constexpr std::string_view config_start = "# config ";

// Flags of a sample, from plugin/include/haptic_retargeting/reach.h.
constexpr unsigned direction_flag = 1;
constexpr unsigned plate_position_flag = 2;
constexpr unsigned measured_plate_flag = 4;
constexpr unsigned lifted_flag = 8;
constexpr unsigned world_position_flag = 16;

constexpr const char* recorded_columns =
    "call,result,time_ns,sample_flags,sample_x_m,sample_y_m,sample_z_m,measured_plate_deg,"
    "real_direction_deg,virtual_direction_deg,real_distance_m,start_right_m,start_away_m,"
    "plate_orientation_deg";

class PathsReader {
 public:
  PathsReader(const std::string& name, std::string_view text) : name_(name), csv_(name, text) {}

  RecordedPaths read() {
    while (csv_.next()) {
      if (csv_.line().starts_with(config_start))
        read_config(csv_.line().substr(config_start.size()));
      else if (csv_.line().starts_with('#'))
        continue;
      else if (csv_.has_header())
        read_row();
      else
        csv_.take_header(recorded_columns, "the header of a recording");
    }
    end_reach();
    return std::move(recorded_);
  }

 private:
  void read_config(std::string_view text) {
    const auto config = nlohmann::json::parse(text, nullptr, false);
    const auto value = [&](const char* key, NumberRange range, double standard) {
      if (!config.contains(key)) return standard;
      const nlohmann::json& field = config[key];
      if (!field.is_number() || !range.contains(field.get<double>()))
        throw csv_.wrong(std::string("config, ") + key, field.dump(), range.text());
      return field.get<double>();
    };
    if (!config.is_object()) throw csv_.wrong("config", text, "a JSON object");
    const auto or_infinite = [](double limit) { return limit > 0.0 ? limit : std::numeric_limits<double>::infinity(); };
    PlateDynamics& dynamics = recorded_.plate;
    dynamics.max_speed_deg_s = or_infinite(value("plate_max_speed_deg_s", {0.0, 1e9}, 0.0));
    dynamics.max_acceleration_deg_s2 = or_infinite(value("plate_max_acceleration_deg_s2", {0.0, 1e9}, 0.0));
    dynamics.latency_ns = std::llround(value("plate_latency_ns", {0.0, 8e8}, 0.0));
    recorded_.tracker_latency_ns = std::llround(value("tracker_latency_ns", {0.0, 5e8}, 0.0));
    lift_height_m_ = value("lift_height_m", {0.0, 10.0}, 0.015);
  }

  double number_in(std::string_view column, const NumberRange& range) const {
    return csv_.text(column).empty() ? 0.0 : csv_.number(column, range);  // recordings omit zeros
  }

  void read_row() {
    csv_.take_row();
    const std::string_view what = csv_.text("call");
    if (number_in("result", {-1e9, 1e9}) != 0.0) return;  // the call failed
    if (what == "begin") return begin();
    if (what == "update") return update();
    if (what == "end" || what == "cancel") return end_reach();
    if (what == "retarget") why_ = "its targets moved";
  }

  void begin() {
    end_reach();
    path_ = RecordedPath{.file = name_, .number = ++number_};
    aim();
    path_->reach.plate_orientation_deg = number_in("plate_orientation_deg", plate_range);
    plate_.emplace(recorded_.plate, path_->reach.plate_orientation_deg);
    measured_ = 0;
  }

  // Reads the targets from a row that begins a reach or starts one at the finger.
  void aim() {
    Reach& reach = path_->reach;
    reach.real_direction_deg = number_in("real_direction_deg", direction_range);
    reach.virtual_direction_deg = number_in("virtual_direction_deg", direction_range);
    reach.start = {mm_per_m * number_in("start_right_m", place_range),
                   mm_per_m * number_in("start_away_m", place_range)};
    reach.real_distance_mm = mm_per_m * number_in("real_distance_m", place_range);
    if (!is_valid(reach, reach.virtual_direction_deg)) why_ = "its targets are not those of a reach";
  }

  void update() {
    if (!path_) return;
    if (!csv_.text("real_distance_m").empty()) aim();
    const double time_ns = number_in("time_ns", {-9e18, 9e18});
    const auto sample_flags = static_cast<unsigned>(number_in("sample_flags", {.low = 0, .high = 1e9, .whole = true}));
    FingerSample sample{.time_ns = static_cast<std::int64_t>(time_ns)};
    if (!path_->samples.empty() && sample.time_ns < path_->samples.back().time_ns)
      throw csv_.wrong("time_ns", "not before that of the row before");
    const double right_m = number_in("sample_x_m", place_range);
    const double height_m = number_in("sample_y_m", place_range);
    const double towards_m = number_in("sample_z_m", place_range);
    if ((sample_flags & world_position_flag) != 0) why_ = "its positions are in the engine's world";
    if ((sample_flags & direction_flag) != 0) why_ = "it has directions and no positions";
    if ((sample_flags & lifted_flag) != 0) {
      sample.observation = Observation::lifted;
    } else if ((sample_flags & plate_position_flag) != 0) {
      sample.observation = height_m > lift_height_m_ ? Observation::lifted : Observation::position;
      sample.position = {.right_mm = mm_per_m * right_m, .away_mm = -mm_per_m * towards_m};
    }
    plate_->advance(sample.time_ns);
    if ((sample_flags & measured_plate_flag) != 0) {
      plate_->report(number_in("measured_plate_deg", plate_range));
      ++measured_;
    }
    sample.plate_orientation_deg = plate_->orientation_deg();
    plate_->command(number_in("plate_orientation_deg", plate_range));
    path_->samples.push_back(sample);
  }

  void end_reach() {
    if (!path_) return;
    const auto positions = std::count_if(path_->samples.begin(), path_->samples.end(), [](const FingerSample& sample) {
      return sample.observation == Observation::position;
    });
    if (why_.empty() && positions < 2) why_ = "it has fewer than two positions";
    path_->plate_source = 2 * measured_ > path_->samples.size() ? PlateSource::measured : PlateSource::commanded;
    if (why_.empty())
      recorded_.paths.push_back(std::move(*path_));
    else
      recorded_.left_out.push_back(name_ + ", reach " + std::to_string(path_->number) + ": left out, " + why_);
    path_.reset();
    why_.clear();
  }

  static constexpr NumberRange plate_range{-1e9, 1e9};
  static constexpr NumberRange place_range{-10.0, 10.0};

  const std::string& name_;
  CsvReader csv_;
  double lift_height_m_ = 0.015;
  int number_ = 0;
  RecordedPaths recorded_;
  std::optional<RecordedPath> path_;
  std::optional<PlateModel> plate_;
  std::size_t measured_ = 0;
  std::string why_;  // reason for which the reach is skipped; empty: used
};

RecordedPaths read_calibration(const std::string& name, std::string_view text) {
  RecordedPaths recorded;
  recorded.plate = {.max_speed_deg_s = 400.0, .latency_ns = 30'000'000};
  int number = 0;
  for (const CalibrationTrial& trial : parse_calibration_csv(name, text)) {
    ++number;
    if (trial.samples.size() < 2) {
      recorded.left_out.push_back(name + ", slide " + std::to_string(number) +
                                  ": left out, it has fewer than two positions");
      continue;
    }
    RecordedPath path{.file = name, .number = number, .plate_source = PlateSource::resting};
    path.reach = {.real_direction_deg = -assumed_gap_deg,
                  .virtual_direction_deg = 0.0,
                  .plate_orientation_deg = trial.plate_orientation_deg,
                  .start = trial.samples.front().position,
                  .real_distance_mm = assumed_distance_mm};
    for (const TimedPoint& point : trial.samples)
      path.samples.push_back({.time_ns = std::llround(1e9 * point.time_s),
                              .observation = Observation::position,
                              .position = point.position,
                              .plate_orientation_deg = trial.plate_orientation_deg});
    recorded.paths.push_back(std::move(path));
  }
  return recorded;
}

}  // namespace

RecordedPaths parse_recorded_paths(const std::string& name, std::string_view text) {
  if (!text.starts_with(recording_start)) return read_calibration(name, text);
  const std::string_view version = text.substr(recording_start.size(), 1);
  if (version != readable_version)
    throw UsageError(not_allowed(name + ", line 1, version", version, std::string(readable_version)));
  return PathsReader(name, text).read();
}

}  // namespace hrt::study
