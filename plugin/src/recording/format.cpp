#include "plugin/src/recording/format.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include "plugin/src/abi/checks.h"
#include "plugin/src/recording/calibration_format.h"
#include "plugin/src/recording/row.h"
#include "plugin/src/session/reach_numbers.h"

namespace hrt::plugin {
namespace {

constexpr std::string_view header =
    "# haptic retargeting recording, version 3\n"
    "# Lines that begin with # are comments. Each other line is a call; what a call does not have is empty.\n"
    "# Angles: degrees counter-clockwise from the plate's mid-line. Positions: x right, y up, z towards the "
    "user\n"
    "# (or the engine's world, as sample_flags says). Numbers are in full precision. Flags and results: "
    "reach.h,\n"
    "# base.h. Columns up to struct_size hold what went in: targets by their numbers in the comments, 0 for "
    "none;\n"
    "# refused_argument is one that was null or, with struct_size, had a wrong size. The others hold what "
    "came "
    "out;\n"
    "# plate_orientation_deg of a row \"begin\" is where the plate stood.\n"
    "call,result,time_ns,sample_flags,sample_direction_deg,sample_x_m,sample_y_m,sample_z_m,measured_plate_"
    "deg,plate_x_m,plate_y_m,plate_z_m,plate_qx,plate_qy,plate_qz,plate_qw,"
    "reach_flags,real_target,virtual_target,duration_s,refused_argument,struct_size,"
    "real_direction_deg,virtual_direction_deg,real_distance_m,start_right_m,start_away_m,"
    "command_flags,step,plate_orientation_deg,finger_direction_deg,perceived_direction_deg,aimed_direction_"
    "deg,distance_to_go_m,tactile_weight,tactile_weight_sd,time_to_go_s,felt_error_deg,predicted_miss_deg,"
    "normalised_innovation,bearing_error_sd_deg,"
    "samples,dropped_samples,steps,predicted_steps,saturated_steps,rate_limited_steps,"
    "final_miss_deg,perceived_error_deg,tracker_noise_m,motor_variance_deg2,motor_variance_sd_deg2,"
    "summary_flags,bearing_error_deg,peak_felt_error_deg,rms_felt_error_deg,illusion_curve,illusion_curve_sd,"
    "gain_per_s,gain_sd_per_s,bias_deg,bias_sd_deg,habit_deg,habit_sd_deg,duration_learnt_s"
    ",calibration,calibration_result\n";

struct ArgumentName {
  Refused::Argument argument;
  std::string_view name;
  std::string_view call;
};
constexpr ArgumentName argument_names[] = {
    {Refused::Argument::config, "config", "begin"},
    {Refused::Argument::sample, "sample", "update"},
    {Refused::Argument::out_command, "out_command", "update"},
    {Refused::Argument::out_summary, "out_summary", "end"},
};

void write(const ConfigSet& set, hrt_result, RecordText& out) {
  JsonText json;
  write_config(set.config, json);
  out << config_comment << json.view() << "\n";
}

constexpr std::string_view verbs[] = {"added", "set", "removed"};

void write(const TargetChanged& changed, hrt_result, RecordText& out) {
  out << target_comment << verbs[static_cast<std::size_t>(changed.change)] << " " << changed.number;
  if (changed.change != TargetChanged::Change::removed) {
    JsonText json;
    write_target(changed.config, json);
    out << " " << json.view();
  }
  out << "\n";
}

void write(const CalibrationChanged& changed, hrt_result, RecordText& out) {
  out << calibration_comment << (changed.added ? "added " : "destroyed ") << changed.number;
  if (changed.added) {
    JsonText json;
    write_calibration_config(changed.config, json);
    out << " " << json.view();
  }
  out << "\n";
}

void write(const PlateStands& plate, hrt_result, RecordText& out) {
  out << plate_comment << plate.orientation_deg << "\n";
}

void write(const Refused& refused, hrt_result result, RecordText& out) {
  const ArgumentName& argument = argument_names[static_cast<std::size_t>(refused.argument)];
  Row row(out);
  row.put(argument.call).put(result).skip(sample_columns + begin_columns).put(argument.name);
  if (result != HRT_ERROR_NULL_ARGUMENT) row.put(refused.struct_size);
}

void put(const Reach& reach, Row& row) {
  row.put(reach.real_direction_deg).put(reach.virtual_direction_deg).put(reach.real_distance_m);
  row.put(reach.start.right_m).put(reach.start.away_m);
}

void write(const Retargeted& retargeted, hrt_result result, RecordText& out) {
  Row row(out);
  row.put("retarget").put(result).skip(sample_columns + 1);
  row.put(retargeted.real_number).put(retargeted.virtual_number).skip(1 + refused_columns);
  if (result == HRT_OK) put(retargeted.reach, row);
}

void write(const ReachCancelled&, hrt_result result, RecordText& out) {
  Row(out).put("cancel").put(result);
}

void write(const ReachBegun& begun, hrt_result result, RecordText& out) {
  Row row(out);
  row.put("begin").put(result).skip(measured_plate_column - 2);
  row.put_if((begun.flags & HRT_REACH_PLATE_ORIENTATION) != 0, {begun.plate_orientation_deg});
  row.skip(begin_column - measured_plate_column - 1);
  row.put(begun.flags).put(begun.real_number).put(begun.virtual_number).put(begun.duration_s);
  row.skip(refused_columns);
  if (result != HRT_OK) return;
  put(begun.reach, row);
  row.skip(2).put(begun.reach.plate_orientation_deg);
}

static_assert(command_columns == 2 + command_numbers.size());

void write(const Updated& updated, hrt_result result, RecordText& out) {
  Row row(out);
  row.put("update").put(result);
  put_sample(updated.sample, row);
  row.skip(begin_columns + refused_columns);
  if (result != HRT_OK) return;
  if (updated.reach) {
    put(*updated.reach, row);
  } else {
    row.skip(reach_columns);
  }
  const hrt_command& command = updated.command;
  row.put(command.flags).put(command.step);
  for (double hrt_command::* number : command_numbers) row.put(command.*number);
}

void write(const ReachEnded& ended, hrt_result result, RecordText& out) {
  Row row(out);
  row.put("end").put(result).skip(sample_columns + begin_columns + refused_columns + reach_columns);
  if (result != HRT_OK) return;
  const hrt_reach_summary& summary = ended.summary;
  row.skip(3).put(summary.final_direction_deg).put(summary.perceived_direction_deg).skip(1);
  row.put(summary.distance_to_target_m).put(summary.tactile_weight).put(summary.tactile_weight_sd);
  row.skip(3).put(summary.normalised_innovation).put(summary.bearing_error_sd_deg);
  row.put(summary.samples).put(summary.dropped_samples).put(summary.steps).put(summary.predicted_steps);
  row.put(summary.saturated_steps).put(summary.rate_limited_steps);
  row.put(summary.final_miss_deg).put(summary.perceived_error_deg).put(summary.tracker_noise_m);
  row.put(summary.motor_variance_deg2).put(summary.motor_variance_sd_deg2).put(summary.flags);
  row.put(summary.bearing_error_deg).put(summary.peak_felt_error_deg).put(summary.rms_felt_error_deg);
  row.put(summary.illusion_curve)
      .put(summary.illusion_curve_sd)
      .put(summary.gain_per_s)
      .put(summary.gain_sd_per_s);
  row.put(summary.bias_deg).put(summary.bias_sd_deg).put(summary.habit_deg).put(summary.habit_sd_deg);
  row.put(summary.duration_s);
}

// Doubles may be spelled in other ways: other releases have written 1e+05 where this one writes 100000.
bool is_same_cell(std::string_view cell, std::string_view other) {
  constexpr std::string_view of_doubles = ".e";
  if (cell == other) return true;
  if (cell.find_first_of(of_doubles) == cell.npos && other.find_first_of(of_doubles) == other.npos)
    return false;
  double number = 0.0, other_number = 0.0;
  return read_number(cell, &number) && read_number(other, &other_number) &&
         std::bit_cast<std::uint64_t>(number) == std::bit_cast<std::uint64_t>(other_number);
}

hrt_result read_begin(const Cells& cells, Record* out) {
  ReachBegun begun{};
  HRT_RETURN_IF_FAILED(read_cell(cells, measured_plate_column, &begun.plate_orientation_deg));
  HRT_RETURN_IF_FAILED(read_cell(cells, begin_column, &begun.flags));
  HRT_RETURN_IF_FAILED(read_cell(cells, begin_column + 1, &begun.real_number));
  HRT_RETURN_IF_FAILED(read_cell(cells, begin_column + 2, &begun.virtual_number));
  HRT_RETURN_IF_FAILED(read_cell(cells, begin_column + 3, &begun.duration_s));
  out->call = begun;
  return HRT_OK;
}

hrt_result read_retarget(const Cells& cells, Record* out) {
  Retargeted retargeted{};
  HRT_RETURN_IF_FAILED(read_cell(cells, begin_column + 1, &retargeted.real_number));
  HRT_RETURN_IF_FAILED(read_cell(cells, begin_column + 2, &retargeted.virtual_number));
  out->call = retargeted;
  return HRT_OK;
}

// A refused call, if the row has an argument for which it was.
hrt_result read_refused(const Cells& cells, Record* out) {
  const std::string_view name = cells[refused_column];
  for (const ArgumentName& known : argument_names) {
    if (known.name != name || known.call != cells[0]) continue;
    Refused refused{known.argument, 0};
    HRT_RETURN_IF_FAILED(read_cell(cells, refused_column + 1, &refused.struct_size));
    out->call = refused;
    return HRT_OK;
  }
  return fail(HRT_ERROR_BAD_FORMAT, "the refused argument is \"", Shown{name}, "\", which \"",
              Shown{cells[0]}, "\" does not have");
}

hrt_result read_update(const Cells& cells, Record* out) {
  hrt_sample sample{};
  HRT_RETURN_IF_FAILED(read_sample(cells, &sample));
  out->call = Updated{.sample = sample, .command = {}};
  return HRT_OK;
}

}  // namespace

std::string_view recording_header() {
  return header;
}

void write_record(const Record& record, RecordText& out) {
  std::visit([&](const auto& call) { write(call, record.result, out); }, record.call);
}

void write_end(std::uint64_t checksum, RecordText& out) {
  out << end_comment << checksum << "\n";
}

hrt_result read_row(std::string_view line, Record* out) {
  Cells cells;
  HRT_RETURN_IF_FAILED(split(line, columns, &cells));
  HRT_RETURN_IF_FAILED(read_cell(cells, 1, &out->result));
  if (!cells[refused_column].empty()) return read_refused(cells, out);
  if (cells[0] == "begin") return read_begin(cells, out);
  if (cells[0] == "update") return read_update(cells, out);
  if (cells[0] == "retarget") return read_retarget(cells, out);
  if (cells[0] == "cancel") {
    out->call = ReachCancelled{};
    return HRT_OK;
  }
  if (cells[0] == "end") {
    out->call = ReachEnded{};
    return HRT_OK;
  }
  if (is_calibration_call(cells[0])) return read_calibration_call(cells, out);
  return fail(HRT_ERROR_BAD_FORMAT, "the row's call is \"", Shown{cells[0]},
              "\"; allowed: begin, update, retarget, cancel, end", calibration_calls);
}

bool is_same_row(std::string_view row, std::string_view other) {
  const auto next_cell = [](std::string_view& rest) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view cell = rest.substr(0, comma);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    return cell;
  };
  while (!row.empty() && !other.empty()) {
    if (!is_same_cell(next_cell(row), next_cell(other))) return false;
  }
  return row.empty() && other.empty();
}

hrt_result read_target_changed(std::string_view rest, TargetChanged* out) {
  const auto next_word = [&rest] {
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    return word;
  };
  const std::string_view verb = next_word();
  const auto known = std::find(std::begin(verbs), std::end(verbs), verb);
  if (known == std::end(verbs))
    return fail(HRT_ERROR_BAD_FORMAT, "the target is \"", Shown{verb}, "\"; allowed: added, set, removed");
  *out = {.change = static_cast<TargetChanged::Change>(known - verbs), .number = 0, .config = {}};
  HRT_RETURN_IF_FAILED(take_number("the target's number", next_word(), &out->number));
  return out->change == TargetChanged::Change::removed ? HRT_OK : read_target(rest, &out->config);
}

hrt_result read_calibration_changed(std::string_view rest, CalibrationChanged* out) {
  const bool added = rest.starts_with("added ");
  if (!added && !rest.starts_with("destroyed "))
    return fail(HRT_ERROR_BAD_FORMAT, "the calibration is \"", Shown{rest}, "\"; allowed: added, destroyed");
  rest.remove_prefix(rest.find(' ') + 1);
  const std::string_view number = rest.substr(0, rest.find(' '));
  *out = {.added = added, .number = 0, .config = {}};
  HRT_RETURN_IF_FAILED(take_number("the calibration's number", number, &out->number));
  if (!added) return HRT_OK;
  rest.remove_prefix(std::min(number.size() + 1, rest.size()));
  return read_calibration_config(rest, &out->config);
}

hrt_result read_plate_stands(std::string_view rest, PlateStands* out) {
  HRT_RETURN_IF_FAILED(take_number("the plate's orientation", rest, &out->orientation_deg));
  return check_range("the plate's orientation", out->orientation_deg, -1e9, 1e9);
}

}  // namespace hrt::plugin
