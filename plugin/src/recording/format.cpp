#include "plugin/src/recording/format.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

#include "plugin/src/recording/row.h"

namespace hrt::plugin {
namespace {

constexpr std::string_view explanation =
    "# Lines that begin with # are comments. Each other line is a call; cells that do not apply to it are empty.\n"
    "# Angles: degrees counter-clockwise from the plate's mid-line. Positions: x right, y up, z towards the user, or\n"
    "# in the engine's world if sample_flags has WORLD_POSITION. Flags and results: reach.h, base.h. Input columns:\n"
    "# call, time_ns to duration_s, and contact_*. Targets are given by their numbers in the comments; 0: no target.\n"
    "# Output columns: all others. In a row \"begin\", plate_orientation_deg is the orientation at that time.\n";

void write(const ConfigSet& set, hrt_result, RecordText& out) {
  out << config_comment;
  write_json(set.config, out);
  out << "\n";
}

constexpr std::string_view verbs[] = {"added", "set", "removed"};

void write(const TargetChanged& changed, hrt_result, RecordText& out) {
  out << target_comment << verbs[static_cast<std::size_t>(changed.change)] << " " << changed.number;
  if (changed.change != TargetChanged::Change::removed) {
    out << " ";
    write_json(changed.config, out);
  }
  out << "\n";
}

void write(const InitialPlateOrientation& plate, hrt_result, RecordText& out) {
  out << plate_comment << plate.orientation_deg << "\n";
}

void put(const ReachGeometry& reach, Row& row) {
  row.put(column("real_direction_deg"), reach.real_direction_deg);
  row.put(column("virtual_direction_deg"), reach.virtual_direction_deg);
  row.put(column("real_distance_m"), reach.real_distance_m);
  row.put(column("start_right_m"), reach.start_right_m);
  row.put(column("start_away_m"), reach.start_away_m);
}

void put_targets(std::uint64_t real_number, std::uint64_t virtual_number, Row& row) {
  row.put(column("real_target"), real_number);
  row.put(column("virtual_target"), virtual_number);
}

void write(const Retargeted& retargeted, hrt_result result, RecordText& out) {
  Row row(out, "retarget", result);
  put_targets(retargeted.real_number, retargeted.virtual_number, row);
  if (result == HRT_OK) put(retargeted.reach, row);
}

// If no flag is set, `position_m` has no meaning and is not written.
void write(const Touched& touched, hrt_result result, RecordText& out) {
  Row(out, "touched", result).put_fields(touched.contact, [&](std::string_view name) {
    return touched.contact.flags != 0 || name != "position_m";
  });
}

void write(const ReachCancelled&, hrt_result result, RecordText& out) { Row(out, "cancel", result); }

void write(const ReachBegun& begun, hrt_result result, RecordText& out) {
  Row row(out, "begin", result);
  if (begun.flags & HRT_REACH_PLATE_ORIENTATION) row.put(column("measured_plate_deg"), begun.plate_orientation_deg);
  row.put(column("reach_flags"), begun.flags);
  put_targets(begun.real_number, begun.virtual_number, row);
  row.put(column("duration_s"), begun.duration_s);
  if (result != HRT_OK) return;
  put(begun.reach, row);
  row.put(column("plate_orientation_deg"), begun.reach.plate_orientation_deg);
}

void write(const Updated& updated, hrt_result result, RecordText& out) {
  Row row(out, "update", result);
  put_sample(updated.sample, row);
  if (result != HRT_OK) return;
  if (updated.reach) put(*updated.reach, row);
  row.put_fields(updated.command);
}

void write(const ReachEnded& ended, hrt_result result, RecordText& out) {
  Row row(out, "end", result);
  if (result == HRT_OK) row.put_fields(ended.summary);
}

using SetupCell = Text<2048>;

void write_value(const hrt_interval& interval, SetupCell& cell) {
  cell << interval.value << ":" << interval.lower << ":" << interval.upper << ":" << interval.known;
}
template <class Number>
  requires std::is_arithmetic_v<Number>
void write_value(Number number, SetupCell& cell) {
  cell << number;
}
void write_value(const double (&place_m)[3], SetupCell& cell) {
  cell << place_m[0] << ":" << place_m[1] << ":" << place_m[2];
}
void write_value(const char (&)[HRT_TEXT_SIZE], SetupCell&) {}  // texts are not written

// Writes a struct as one cell of name=value pairs.
template <class Struct>
void put_setup(const Struct& values, Row& row, SetupCell& cell) {
  for_each_field<Struct>([&](const auto& field) {
    if (std::string_view(field.name) == "text" || std::string_view(field.name) == "reason") return;
    cell << (cell.view().empty() ? "" : " ") << field.name << "=";
    write_value(field.of(values), cell);
  });
  row.put(column("setup"), cell.view());
}

void write(const SetupBegun& begun, hrt_result, RecordText& out) {
  out << setup_comment << begun.what << " ";
  write_json(begun.config, out);
  out << "\n";
}

void write(const SetupUpdated& updated, hrt_result result, RecordText& out) {
  SetupCell cell;
  Row row(out, "setup_update", result);
  put_sample(updated.sample, row);
  if (result == HRT_OK) put_setup(updated.step, row, cell);
}

void write(const SetupFinished& finished, hrt_result result, RecordText& out) {
  SetupCell cell;
  Row row(out, "setup_finish", result);
  if (result == HRT_OK) put_setup(finished.result, row, cell);
}

void write(const SetupCancelled&, hrt_result result, RecordText& out) { Row(out, "setup_cancel", result); }

// Cells that differ as text are equal if they contain the same double: 1e+05 and 100000.
bool is_same_cell(std::string_view cell, std::string_view other) {
  constexpr std::string_view double_marks = ".e";
  if (cell == other) return true;
  if (cell.find_first_of(double_marks) == cell.npos && other.find_first_of(double_marks) == other.npos) return false;
  double number = 0.0, other_number = 0.0;
  return read_number(cell, &number) && read_number(other, &other_number) &&
         std::bit_cast<std::uint64_t>(number) == std::bit_cast<std::uint64_t>(other_number);
}

hrt_result read_targets(const Cells& cells, std::uint64_t* real_number, std::uint64_t* virtual_number) {
  HRT_RETURN_IF_FAILED(read_cell(cells, column("real_target"), real_number));
  return read_cell(cells, column("virtual_target"), virtual_number);
}

hrt_result read_begin(const Cells& cells, Record* out) {
  ReachBegun begun{};
  HRT_RETURN_IF_FAILED(read_cell(cells, column("measured_plate_deg"), &begun.plate_orientation_deg));
  HRT_RETURN_IF_FAILED(read_cell(cells, column("reach_flags"), &begun.flags));
  HRT_RETURN_IF_FAILED(read_targets(cells, &begun.real_number, &begun.virtual_number));
  HRT_RETURN_IF_FAILED(read_cell(cells, column("duration_s"), &begun.duration_s));
  out->call = begun;
  return HRT_OK;
}

hrt_result read_retarget(const Cells& cells, Record* out) {
  Retargeted retargeted{};
  HRT_RETURN_IF_FAILED(read_targets(cells, &retargeted.real_number, &retargeted.virtual_number));
  out->call = retargeted;
  return HRT_OK;
}

hrt_result read_touched(const Cells& cells, Record* out) {
  hrt_contact contact{};
  HRT_RETURN_IF_FAILED(read_fields(cells, &contact));
  out->call = Touched{contact};
  return HRT_OK;
}

template <class Call>
hrt_result read_sample(const Cells& cells, Record* out) {
  Call call{};
  HRT_RETURN_IF_FAILED(read_fields(cells, &call.sample));
  out->call = call;
  return HRT_OK;
}

template <class Call>
hrt_result read_nothing(const Cells&, Record* out) {
  out->call = Call{};
  return HRT_OK;
}

constexpr std::pair<std::string_view, hrt_result (*)(const Cells&, Record*)> calls_in_rows[] = {
    {"begin", read_begin},
    {"update", read_sample<Updated>},
    {"retarget", read_retarget},
    {"touched", read_touched},
    {"cancel", read_nothing<ReachCancelled>},
    {"end", read_nothing<ReachEnded>},
    {"setup_update", read_sample<SetupUpdated>},
    {"setup_finish", read_nothing<SetupFinished>},
    {"setup_cancel", read_nothing<SetupCancelled>},
};

// Removes the first cell of a line and its comma, and returns the cell.
std::string_view take_cell(std::string_view* line) {
  const std::size_t size = std::min(line->find(','), line->size());
  const std::string_view cell = line->substr(0, size);
  line->remove_prefix(std::min(size + 1, line->size()));
  return cell;
}

std::string column_names() {
  std::string names;
  for (const std::string_view name : recording_columns) (names += name) += ',';
  names.pop_back();
  return names;
}

}  // namespace

std::string recording_header() {
  return std::string(recording_begin) + std::string(explanation) + column_names() + "\n";
}

void write_record(const Record& record, RecordText& out) {
  std::visit([&](const auto& call) { write(call, record.result, out); }, record.call);
}

void write_end(std::uint64_t checksum, RecordText& out) { out << end_comment << checksum << "\n"; }

hrt_result check_column_names(std::string_view line) {
  if (line == column_names()) return HRT_OK;
  if (!line.starts_with("call,result,"))
    return fail(HRT_ERROR_BAD_FORMAT, "the line with the column names is missing before this row; record again");
  return fail(HRT_ERROR_BAD_FORMAT, "the column names are not those of version 4; record again");
}

hrt_result read_row(std::string_view line, Record* out) {
  const auto n = static_cast<std::size_t>(1 + std::count(line.begin(), line.end(), ','));
  if (n != columns)
    return fail(HRT_ERROR_BAD_FORMAT, "the row has ", n, " columns; allowed: ", columns, ". Record again");
  Cells cells;
  for (std::string_view& cell : cells) cell = take_cell(&line);
  HRT_RETURN_IF_FAILED(read_cell(cells, column("result"), &out->result));
  for (const auto& [call, read] : calls_in_rows)
    if (cells[0] == call) return read(cells, out);
  return fail(HRT_ERROR_BAD_FORMAT, "the row's call is \"", Shown{cells[0]},
              "\"; allowed: begin, update, retarget, touched, cancel, end, setup_update, setup_finish, setup_cancel. "
              "Record again");
}

bool is_same_row(std::string_view row, std::string_view other) {
  bool same = true;
  for (std::size_t i = 0; i < columns; ++i) same = is_same_cell(take_cell(&row), take_cell(&other)) && same;
  return same;
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
    return fail(HRT_ERROR_BAD_FORMAT, "the change of the target is \"", Shown{verb},
                "\"; allowed: added, set, removed. Record again");
  *out = {.change = static_cast<TargetChanged::Change>(known - verbs), .number = 0, .config = {}};
  HRT_RETURN_IF_FAILED(take_number("the target's number", next_word(), &out->number));
  return out->change == TargetChanged::Change::removed ? HRT_OK : read_json(rest, &out->config);
}

hrt_result read_initial_plate_orientation(std::string_view rest, InitialPlateOrientation* out) {
  HRT_RETURN_IF_FAILED(take_number("the plate's orientation", rest, &out->orientation_deg));
  return check_range("the plate's orientation", out->orientation_deg, -1e9, 1e9);
}

hrt_result read_setup_begun(std::string_view rest, SetupBegun* out) {
  const std::string_view what = rest.substr(0, rest.find(' '));
  HRT_RETURN_IF_FAILED(take_number("the set-up's parts", what, &out->what));
  rest.remove_prefix(what.size() == rest.size() ? what.size() : what.size() + 1);
  return read_json(rest, &out->config);
}

}  // namespace hrt::plugin
