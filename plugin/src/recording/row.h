#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/text.h"
#include "plugin/src/recording/format.h"

namespace hrt::plugin {

inline constexpr std::size_t columns = std::size(recording_columns);

consteval std::size_t column(std::string_view name) {
  std::size_t i = 0;
  while (recording_columns[i] != name) ++i;  // an unknown name does not compile
  return i;
}

using Cells = std::array<std::string_view, columns>;

/// Collects the cells of one row and writes them on destruction. Cells that are not set are empty.
class Row {
 public:
  Row(RecordText& out, std::string_view call, hrt_result result) : out_(out) {
    put(column("call"), call);
    put(column("result"), result);
  }
  ~Row() {  // NOLINT(bugprone-exception-escape): std::visit() does not throw, because cells are never valueless
    for (std::size_t i = 0; i < columns; ++i) {
      if (i > 0) out_ << ",";
      std::visit([&](const auto& cell) { out_ << cell; }, cells_[i]);
    }
    out_ << "\n";
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  template <class Value>
  void put(std::size_t at, const Value& value) {
    if constexpr (std::is_convertible_v<const Value&, std::string_view>) {
      cells_[at] = std::string_view(value);
    } else if constexpr (std::is_array_v<Value>) {
      for (const auto& element : value) put(at++, element);
    } else {
      cells_[at] = Wide<Value>(value);
    }
  }
  /// Sets the cells of the fields whose names `is_given` accepts.
  template <class S, class Given>
  void put_fields(const S& values, Given&& is_given) {
    std::size_t i = 0;
    for_each_field<S>([&](const auto& field) {
      const std::size_t at = columns_of<S>[i++];
      if (is_given(field.name)) put(at, field.of(values));
    });
  }
  template <class S>
  void put_fields(const S& values) {
    put_fields(values, [](std::string_view) { return true; });
  }

 private:
  template <class Value>
  using Wide = std::conditional_t<std::is_floating_point_v<Value>, double,
                                  std::conditional_t<std::is_signed_v<Value>, std::int64_t, std::uint64_t>>;

  RecordText& out_;
  std::array<std::variant<std::string_view, std::int64_t, std::uint64_t, double>, columns> cells_;
};

template <class What, class Number>
hrt_result take_number(const What& what, std::string_view text, Number* out) {
  if (read_number(text, out)) return HRT_OK;
  return fail(HRT_ERROR_BAD_FORMAT, what, " is \"", Shown{text}, "\", which is not a number; record again");
}

/// Reads a number from its cell, or an array from successive cells. Empty cells change nothing.
template <class Value>
hrt_result read_cell(const Cells& cells, std::size_t at, Value* out) {
  if constexpr (std::is_array_v<Value>) {
    for (auto& element : *out) HRT_RETURN_IF_FAILED(read_cell(cells, at++, &element));
    return HRT_OK;
  } else {
    return cells[at].empty() ? HRT_OK : take_number(recording_columns[at], cells[at], out);
  }
}

/// Sets the cells of a sample. The cell of a field that requires a flag is empty without this flag.
inline void put_sample(const hrt_sample& sample, Row& row) {
  row.put_fields(sample, [&](std::string_view name) {
    const auto has = [&](std::uint32_t flags) { return (sample.flags & flags) != 0; };
    if (name == "finger_direction_deg") return has(HRT_SAMPLE_DIRECTION);
    if (name == "finger_position_m") return has(HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION);
    if (name == "plate_orientation_deg") return has(HRT_SAMPLE_PLATE_ORIENTATION);
    if (name == "plate_position_m" || name == "plate_rotation") return has(HRT_SAMPLE_PLATE_POSE);
    if (name == "joint_rotation") return has(HRT_SAMPLE_JOINT_ROTATION);
    return true;
  });
}

/// Reads a struct that has a column for each field. Fields with empty cells are unchanged.
template <class S>
hrt_result read_fields(const Cells& cells, S* values) {
  values->struct_size = sizeof *values;
  hrt_result result = HRT_OK;
  std::size_t i = 0;
  for_each_field<S>([&](const auto& field) {
    const std::size_t at = columns_of<S>[i++];
    if (result == HRT_OK) result = read_cell(cells, at, &field.of(*values));
  });
  return result;
}

}  // namespace hrt::plugin
