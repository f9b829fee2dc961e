#include "plugin/src/recording/calibration_format.h"

#include <cstddef>

namespace hrt::plugin {
namespace {

using R = hrt_calibration_result;

struct IntervalName {
  const char* name;
  hrt_interval R::* interval;
};
constexpr IntervalName intervals[] = {
    {"tactile_weight", &R::tactile_weight},
    {"bias_deg", &R::bias_deg},
    {"tracker_noise_m", &R::tracker_noise_m},
    {"person_weight", &R::person_weight},
    {"person_curve", &R::person_curve},
    {"max_gap_deg", &R::max_gap_deg},
    {"habit_deg", &R::habit_deg},
    {"correlated_noise_m", &R::correlated_noise_m},
    {"noise_correlation_s", &R::noise_correlation_s},
    {"steering_rate_per_s", &R::steering_rate_per_s},
    {"steering_delay_s", &R::steering_delay_s},
};
constexpr std::pair<const char*, std::uint32_t R::*> counts[] = {
    {"trials", &R::trials},
    {"trials_used", &R::trials_used},
    {"illusion", &R::illusion},
    {"lack_of_fit", &R::lack_of_fit},
    {"slides_outlying", &R::slides_outlying},
    {"slides_along_ridges", &R::slides_along_ridges},
    {"slides_turning", &R::slides_turning},
};
constexpr std::pair<const char*, double R::*> numbers[] = {
    {"illusion_scale_deg", &R::illusion_scale_deg},
    {"peak_offset_deg", &R::peak_offset_deg},
    {"weight_curve_correlation", &R::weight_curve_correlation},
    {"angle_p", &R::angle_p},
    {"order_p", &R::order_p},
    {"path_p", &R::path_p},
    {"steering_p", &R::steering_p},
};
static_assert(sizeof(R) == 4 + std::size(intervals) * sizeof(hrt_interval) + std::size(counts) * 4 +
                               std::size(numbers) * 8,
              "a field of the result is not recorded");

// A row as far as the calibration's number.
Row& begin_row(std::string_view call, hrt_result result, std::uint64_t number, Row& row) {
  return row.put(call).put(result).skip_to(calibration_column).put(number);
}

constexpr std::string_view begin_call = "calibration_begin_trial";
constexpr std::string_view sample_call = "calibration_add_sample";
constexpr std::string_view end_call = "calibration_end_trial";
constexpr std::string_view cancel_call = "calibration_cancel_trial";
constexpr std::string_view angle_call = "calibration_next_angle";
constexpr std::string_view solve_call = "calibration_solve";

}  // namespace

void write(const TrialBegun& begun, hrt_result result, RecordText& out) {
  Row row(out);
  row.put(begin_call).put(result).skip_to(measured_plate_column).put(begun.plate_orientation_deg);
  row.skip_to(calibration_column).put(begun.number);
}

void write(const TrialSampled& sampled, hrt_result result, RecordText& out) {
  Row row(out);
  row.put(sample_call).put(result);
  put_sample(sampled.sample, row);
  row.skip_to(calibration_column).put(sampled.number);
}

void write(const TrialEnded& ended, hrt_result result, RecordText& out) {
  Row row(out);
  begin_row(end_call, result, ended.number, row);
}

void write(const TrialCancelled& cancelled, hrt_result result, RecordText& out) {
  Row row(out);
  begin_row(cancel_call, result, cancelled.number, row);
}

void write(const AngleChosen& chosen, hrt_result result, RecordText& out) {
  Row row(out);
  row.put(angle_call).put(result);
  if (result == HRT_OK) row.skip_to(command_column + 2).put(chosen.plate_orientation_deg);
  row.skip_to(calibration_column).put(chosen.number);
  if (result == HRT_OK) row.put(chosen.enough != 0 ? "enough=1" : "enough=0");
}

// The result is one cell, of names and numbers; an interval is value:lower:upper:known.
void write(const CalibrationSolved& solved, hrt_result result, RecordText& out) {
  Row row(out);
  begin_row(solve_call, result, solved.number, row);
  if (result != HRT_OK) return;
  Text<4096> cell;
  for (const auto& [name, count] : counts)
    cell << (cell.view().empty() ? "" : " ") << name << "=" << solved.result.*count;
  for (const auto& [name, number] : numbers) cell << " " << name << "=" << solved.result.*number;
  for (const auto& [name, member] : intervals) {
    const hrt_interval& interval = solved.result.*member;
    cell << " " << name << "=" << interval.value << ":" << interval.lower << ":" << interval.upper << ":"
         << interval.known;
  }
  row.put(cell.view());
}

bool is_calibration_call(std::string_view call) {
  for (const std::string_view known :
       {begin_call, sample_call, end_call, cancel_call, angle_call, solve_call})
    if (call == known) return true;
  return false;
}

hrt_result read_calibration_call(const Cells& cells, Record* out) {
  std::uint64_t number = 0;
  HRT_RETURN_IF_FAILED(read_cell(cells, calibration_column, &number));
  const std::string_view call = cells[0];
  if (call == begin_call) {
    TrialBegun begun{number, 0.0};
    HRT_RETURN_IF_FAILED(read_cell(cells, measured_plate_column, &begun.plate_orientation_deg));
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
