// A row of a recording's table: its columns, written and read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/number.h"
#include "plugin/src/recording/format.h"

namespace hrt::plugin {

// The columns, by what they are of.
inline constexpr std::size_t sample_columns = 14;   // from time_ns
inline constexpr std::size_t begin_columns = 4;     // from reach_flags
inline constexpr std::size_t refused_columns = 2;   // from refused_argument
inline constexpr std::size_t reach_columns = 5;     // from real_direction_deg
inline constexpr std::size_t command_columns = 14;  // from command_flags
inline constexpr std::size_t summary_columns = 24;  // from samples
inline constexpr std::size_t measured_plate_column = 8;
inline constexpr std::size_t begin_column = 2 + sample_columns;
inline constexpr std::size_t refused_column = begin_column + begin_columns;
inline constexpr std::size_t command_column = refused_column + refused_columns + reach_columns;
inline constexpr std::size_t output_columns = reach_columns + command_columns + summary_columns;
inline constexpr std::size_t calibration_column = refused_column + refused_columns + output_columns;
inline constexpr std::size_t columns = calibration_column + 2;

/// Writes one row, column by column; those after the last that is written are empty.
class Row {
 public:
  explicit Row(RecordText& out) : out_(out) {}
  ~Row() {
    skip(columns - cells_);
    out_ << "\n";
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  Row(Row&&) = delete;
  Row& operator=(Row&&) = delete;

  template <class Value>
  Row& put(const Value& value) {
    if (cells_++ > 0) out_ << ",";
    out_ << value;
    return *this;
  }
  Row& skip(std::size_t n) {
    for (; n > 0; --n) put(std::string_view());
    return *this;
  }
  Row& skip_to(std::size_t column) { return skip(column - cells_); }
  template <std::size_t n>
  Row& put_if(bool given, const double (&values)[n]) {
    if (!given) return skip(n);
    for (const double value : values) put(value);
    return *this;
  }

 private:
  RecordText& out_;
  std::size_t cells_ = 0;
};

template <class What, class Number>
hrt_result take_number(const What& what, std::string_view text, Number* out) {
  if (read_number(text, out)) return HRT_OK;
  return fail(HRT_ERROR_BAD_FORMAT, what, " is \"", Shown{text}, "\", which is not a number");
}

using Cells = std::array<std::string_view, columns>;

inline hrt_result split(std::string_view line, std::size_t expected, Cells* cells) {
  std::size_t n = 0;
  for (std::size_t from = 0; from <= line.size(); ++n) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    if (n < expected) (*cells)[n] = line.substr(from, comma - from);
    from = comma + 1;
  }
  if (n == expected) return HRT_OK;
  return fail(HRT_ERROR_BAD_FORMAT, "the row has ", n, " columns; ", expected, " are needed");
}

/// Leaves `*out` as it is if the cell is empty.
template <class Number>
hrt_result read_cell(const Cells& cells, std::size_t column, Number* out) {
  if (cells[column].empty()) return HRT_OK;
  Text<32> what;
  what << "column " << column + 1;
  return take_number(what.view(), cells[column], out);
}

template <std::size_t n>
hrt_result read_cells(const Cells& cells, std::size_t first, double (&out)[n]) {
  for (std::size_t i = 0; i < n; ++i) HRT_RETURN_IF_FAILED(read_cell(cells, first + i, &out[i]));
  return HRT_OK;
}

/// The columns of a sample; those that its flags do not name are empty.
inline void put_sample(const hrt_sample& sample, Row& row) {
  const auto has = [&](std::uint32_t flag) { return (sample.flags & flag) != 0; };
  row.put(sample.time_ns).put(sample.flags);
  row.put_if(has(HRT_SAMPLE_DIRECTION), {sample.finger_direction_deg});
  row.put_if(has(HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION), sample.finger_position_m);
  row.put_if(has(HRT_SAMPLE_PLATE_ORIENTATION), {sample.plate_orientation_deg});
  row.put_if(has(HRT_SAMPLE_PLATE_POSE), sample.plate_position_m);
  row.put_if(has(HRT_SAMPLE_PLATE_POSE), sample.plate_rotation);
}

inline hrt_result read_sample(const Cells& cells, hrt_sample* sample) {
  sample->struct_size = sizeof *sample;
  HRT_RETURN_IF_FAILED(read_cell(cells, 2, &sample->time_ns));
  HRT_RETURN_IF_FAILED(read_cell(cells, 3, &sample->flags));
  HRT_RETURN_IF_FAILED(read_cell(cells, 4, &sample->finger_direction_deg));
  HRT_RETURN_IF_FAILED(read_cells(cells, 5, sample->finger_position_m));
  HRT_RETURN_IF_FAILED(read_cell(cells, measured_plate_column, &sample->plate_orientation_deg));
  HRT_RETURN_IF_FAILED(read_cells(cells, 9, sample->plate_position_m));
  return read_cells(cells, 12, sample->plate_rotation);
}

}  // namespace hrt::plugin
