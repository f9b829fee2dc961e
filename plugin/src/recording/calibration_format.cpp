#include "plugin/src/recording/calibration_format.h"

namespace hrt::plugin {
namespace {

// A row as far as the calibration's number.
struct CalibrationRow : Row {
  CalibrationRow(RecordText& out, std::string_view call, hrt_result result, std::uint64_t number)
      : Row(out, call, result) {
    put(column("calibration"), number);
  }
};

constexpr std::string_view begin_call = "calibration_begin_trial";
constexpr std::string_view sample_call = "calibration_add_sample";
constexpr std::string_view end_call = "calibration_end_trial";
constexpr std::string_view cancel_call = "calibration_cancel_trial";
constexpr std::string_view angle_call = "calibration_next_angle";
constexpr std::string_view solve_call = "calibration_solve";

}  // namespace

void write(const TrialBegun& begun, hrt_result result, RecordText& out) {
  CalibrationRow row(out, begin_call, result, begun.number);
  row.put(column("measured_plate_deg"), begun.plate_orientation_deg);
}

void write(const TrialSampled& sampled, hrt_result result, RecordText& out) {
  CalibrationRow row(out, sample_call, result, sampled.number);
  put_sample(sampled.sample, row);
}

void write(const TrialEnded& ended, hrt_result result, RecordText& out) {
  CalibrationRow(out, end_call, result, ended.number);
}

void write(const TrialCancelled& cancelled, hrt_result result, RecordText& out) {
  CalibrationRow(out, cancel_call, result, cancelled.number);
}

void write(const AngleChosen& chosen, hrt_result result, RecordText& out) {
  CalibrationRow row(out, angle_call, result, chosen.number);
  if (result != HRT_OK) return;
  row.put(column("plate_orientation_deg"), chosen.plate_orientation_deg);
  row.put(column("calibration_result"), chosen.enough != 0 ? "enough=1" : "enough=0");
}

// The result is one cell, of names and numbers; an interval is value:lower:upper:known.
void write(const CalibrationSolved& solved, hrt_result result, RecordText& out) {
  Text<4096> cell;
  CalibrationRow row(out, solve_call, result, solved.number);
  if (result != HRT_OK) return;
  for_each_field<hrt_calibration_result>([&](const auto& field) {
    const auto& value = solved.result.*field.member;
    cell << (cell.view().empty() ? "" : " ") << field.name << "=";
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
      cell << value;
    } else {
      cell << value.value << ":" << value.lower << ":" << value.upper << ":" << value.known;
    }
  });
  row.put(column("calibration_result"), cell.view());
}

bool is_calibration_call(std::string_view call) {
  for (const std::string_view known :
       {begin_call, sample_call, end_call, cancel_call, angle_call, solve_call})
    if (call == known) return true;
  return false;
}

std::string without_former_values(std::string_view row) {
  std::string kept(row);
  if (!row.starts_with(solve_call)) return kept;
  for (std::size_t at; (at = kept.find(" steering_")) != std::string::npos;)
    kept.erase(at, kept.find_first_of(" ,", at + 1) - at);
  return kept;
}

hrt_result read_calibration_call(const Cells& cells, Record* out) {
  std::uint64_t number = 0;
  HRT_RETURN_IF_FAILED(read_cell(cells, column("calibration"), &number));
  const std::string_view call = cells[0];
  if (call == begin_call) {
    TrialBegun begun{number, 0.0};
    HRT_RETURN_IF_FAILED(read_cell(cells, column("measured_plate_deg"), &begun.plate_orientation_deg));
    out->call = begun;
  } else if (call == sample_call) {
    TrialSampled sampled{number, {}};
    HRT_RETURN_IF_FAILED(read_sample(cells, &sampled.sample));
    out->call = sampled;
  } else if (call == end_call) {
    out->call = TrialEnded{number};
  } else if (call == cancel_call) {
    out->call = TrialCancelled{number};
  } else if (call == angle_call) {
    out->call = AngleChosen{number, 0.0, 0};
  } else {
    out->call = CalibrationSolved{number, {}};
  }
  return HRT_OK;
}

}  // namespace hrt::plugin
