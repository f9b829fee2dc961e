#include "plugin/src/recording_format.h"

#include <array>

#include "plugin/src/checked.h"

namespace hrt::plugin {
namespace {

constexpr std::string_view header =
    "# haptic retargeting recording, version 1\n"
    "# Lines that begin with # are comments. Each other line is a call; what a call does not have is empty.\n"
    "# Angles: degrees counter-clockwise from the plate's mid-line. Positions: x right, y up, z towards the "
    "user\n"
    "# (or the engine's world, as sample_flags tells). Numbers are in full precision. Flags and results: "
    "reach.h,\n"
    "# base.h. Of a row \"begin\", measured_plate_deg is where the plate stood before the reach.\n"
    "call,result,time_ns,sample_flags,sample_direction_deg,sample_x_m,sample_y_m,sample_z_m,measured_plate_"
    "deg,"
    "plate_x_m,plate_y_m,plate_z_m,plate_qx,plate_qy,plate_qz,plate_qw,"
    "real_direction_deg,virtual_direction_deg,real_distance_m,start_right_m,start_away_m,"
    "command_flags,step,plate_orientation_deg,finger_direction_deg,perceived_direction_deg,aimed_direction_"
    "deg,"
    "distance_to_go_m,tactile_weight,tactile_weight_sd\n";

constexpr std::size_t columns = 30;

/// Writes one row, column by column.
class Row {
 public:
  explicit Row(RecordText& out) : out_(out) {}
  ~Row() { out_ << "\n"; }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  Row(Row&&) = delete;
  Row& operator=(Row&&) = delete;

  template <class Value>
  Row& put(const Value& value) {
    if (!first_) out_ << ",";
    first_ = false;
    out_ << value;
    return *this;
  }
  Row& skip(std::size_t n) {
    for (; n > 0; --n) put(std::string_view());
    return *this;
  }
  template <std::size_t n>
  Row& put_if(bool given, const double (&values)[n]) {
    if (!given) return skip(n);
    for (const double value : values) put(value);
    return *this;
  }

 private:
  RecordText& out_;
  bool first_ = true;
};

void write(const ConfigSet& set, hrt_result, RecordText& out) {
  JsonText json;
  write_config(set.config, json);
  out << config_comment << json.view() << "\n";
}

void write(const TargetChanged& changed, hrt_result, RecordText& out) {
  using Change = TargetChanged::Change;
  const char* verb = changed.change == Change::added ? "added"
                     : changed.change == Change::set ? "set"
                                                     : "removed";
  out << "# target " << verb << " " << changed.id;
  if (changed.change != Change::removed) {
    JsonText json;
    write_target(changed.config, json);
    out << " " << json.view();
  }
  out << "\n";
}

void write(const ReachBegun& begun, hrt_result result, RecordText& out) {
  const Reach& reach = begun.reach;
  Row row(out);
  row.put("begin").put(result).skip(6).put(reach.plate_orientation_deg).skip(7);
  row.put(reach.real_direction_deg).put(reach.virtual_direction_deg).put(reach.real_distance_m);
  row.put(reach.start.right_m).put(reach.start.away_m).skip(9);
}

void write(const Updated& updated, hrt_result result, RecordText& out) {
  const hrt_sample& sample = updated.sample;
  const auto has = [&](std::uint32_t flag) { return (sample.flags & flag) != 0; };
  Row row(out);
  row.put("update").put(result).put(sample.time_ns).put(sample.flags);
  row.put_if(has(HRT_SAMPLE_DIRECTION), {sample.finger_direction_deg});
  row.put_if(has(HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION), sample.finger_position_m);
  row.put_if(has(HRT_SAMPLE_PLATE_ORIENTATION), {sample.plate_orientation_deg});
  row.put_if(has(HRT_SAMPLE_PLATE_POSE), sample.plate_position_m);
  row.put_if(has(HRT_SAMPLE_PLATE_POSE), sample.plate_rotation);
  row.skip(5);
  if (result != HRT_OK) {
    row.skip(9);
    return;
  }
  const hrt_command& command = updated.command;
  row.put(command.flags)
      .put(command.step)
      .put(command.plate_orientation_deg)
      .put(command.finger_direction_deg);
  row.put(command.perceived_direction_deg).put(command.aimed_direction_deg).put(command.distance_to_go_m);
  row.put(command.tactile_weight).put(command.tactile_weight_sd);
}

void write(const ReachEnded& ended, hrt_result result, RecordText& out) {
  Row row(out);
  row.put("end").put(result).skip(19);
  if (result != HRT_OK) {
    row.skip(9);
    return;
  }
  const hrt_reach_summary& summary = ended.summary;
  row.skip(1).put(summary.steps + summary.predicted_steps).skip(1).put(summary.final_direction_deg);
  row.put(summary.perceived_direction_deg).skip(1).put(summary.distance_to_target_m);
  row.put(summary.tactile_weight).put(summary.tactile_weight_sd);
}

template <class Number>
hrt_result read_cell(std::size_t column, std::string_view cell, Number* out) {
  if (cell.empty()) return HRT_OK;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), *out);
  if (error != std::errc() || end != cell.data() + cell.size())
    return fail(HRT_ERROR_BAD_FORMAT, "column ", column + 1, " is \"", cell.substr(0, 40),
                "\", which is not a number");
  return HRT_OK;
}

using Cells = std::array<std::string_view, columns>;

hrt_result split(std::string_view line, Cells* cells) {
  std::size_t n = 0;
  for (std::size_t from = 0; from <= line.size(); ++n) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    if (n < columns) (*cells)[n] = line.substr(from, comma - from);
    from = comma + 1;
  }
  if (n == columns) return HRT_OK;
  return fail(HRT_ERROR_BAD_FORMAT, "the row has ", n, " columns; ", columns, " are needed");
}

template <std::size_t n>
hrt_result read_cells(const Cells& cells, std::size_t first, double (&out)[n]) {
  for (std::size_t i = 0; i < n; ++i) HRT_RETURN_IF_FAILED(read_cell(first + i, cells[first + i], &out[i]));
  return HRT_OK;
}

hrt_result read_begin(const Cells& cells, Record* out) {
  Reach reach{};
  HRT_RETURN_IF_FAILED(read_cell(8, cells[8], &reach.plate_orientation_deg));
  HRT_RETURN_IF_FAILED(read_cell(16, cells[16], &reach.real_direction_deg));
  HRT_RETURN_IF_FAILED(read_cell(17, cells[17], &reach.virtual_direction_deg));
  HRT_RETURN_IF_FAILED(read_cell(18, cells[18], &reach.real_distance_m));
  HRT_RETURN_IF_FAILED(read_cell(19, cells[19], &reach.start.right_m));
  HRT_RETURN_IF_FAILED(read_cell(20, cells[20], &reach.start.away_m));
  out->call = ReachBegun{reach};
  return HRT_OK;
}

hrt_result read_update(const Cells& cells, Record* out) {
  hrt_sample sample{};
  sample.struct_size = sizeof sample;
  HRT_RETURN_IF_FAILED(read_cell(2, cells[2], &sample.time_ns));
  HRT_RETURN_IF_FAILED(read_cell(3, cells[3], &sample.flags));
  HRT_RETURN_IF_FAILED(read_cell(4, cells[4], &sample.finger_direction_deg));
  HRT_RETURN_IF_FAILED(read_cells(cells, 5, sample.finger_position_m));
  HRT_RETURN_IF_FAILED(read_cell(8, cells[8], &sample.plate_orientation_deg));
  HRT_RETURN_IF_FAILED(read_cells(cells, 9, sample.plate_position_m));
  HRT_RETURN_IF_FAILED(read_cells(cells, 12, sample.plate_rotation));
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

hrt_result read_row(std::string_view line, Record* out) {
  Cells cells;
  HRT_RETURN_IF_FAILED(split(line, &cells));
  HRT_RETURN_IF_FAILED(read_cell(1, cells[1], &out->result));
  if (cells[0] == "begin") return read_begin(cells, out);
  if (cells[0] == "update") return read_update(cells, out);
  if (cells[0] == "end") {
    out->call = ReachEnded{};
    return HRT_OK;
  }
  return fail(HRT_ERROR_BAD_FORMAT, "the row's call is \"", cells[0].substr(0, 40),
              "\"; allowed: begin, update, end");
}

}  // namespace hrt::plugin
