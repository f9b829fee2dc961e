#include "plugin/src/recording/row.h"

namespace hrt::plugin {
namespace {

constexpr std::string_view update_call = "setup_update";
constexpr std::string_view finish_call = "setup_finish";
constexpr std::string_view cancel_setup_call = "setup_cancel";

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
void write_value(const char (&)[HRT_TEXT_SIZE], SetupCell&) {}  // texts follow from the numbers

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

}  // namespace

void write(const SetupBegun& begun, hrt_result, RecordText& out) {
  JsonText json;
  write_setup_config(begun.config, json);
  out << setup_comment << begun.what << " " << json.view() << "\n";
}

void write(const SetupUpdated& updated, hrt_result result, RecordText& out) {
  SetupCell cell;
  Row row(out, update_call, result);
  put_sample(updated.sample, row);
  if (result == HRT_OK) put_setup(updated.step, row, cell);
}

void write(const SetupFinished& finished, hrt_result result, RecordText& out) {
  SetupCell cell;
  Row row(out, finish_call, result);
  if (result == HRT_OK) put_setup(finished.result, row, cell);
}

void write(const SetupCancelled&, hrt_result result, RecordText& out) { Row(out, cancel_setup_call, result); }

bool is_setup_call(std::string_view call) {
  return call == update_call || call == finish_call || call == cancel_setup_call;
}

hrt_result read_setup_call(const Cells& cells, Record* out) {
  if (cells[0] == finish_call) {
    out->call = SetupFinished{};
  } else if (cells[0] == cancel_setup_call) {
    out->call = SetupCancelled{};
  } else {
    SetupUpdated updated{};
    HRT_RETURN_IF_FAILED(read_fields(cells, &updated.sample));
    out->call = updated;
  }
  return HRT_OK;
}

hrt_result read_setup_begun(std::string_view rest, SetupBegun* out) {
  const std::string_view what = rest.substr(0, rest.find(' '));
  HRT_RETURN_IF_FAILED(take_number("the set-up's parts", what, &out->what));
  rest.remove_prefix(what.size() == rest.size() ? what.size() : what.size() + 1);
  return read_setup_config(rest, &out->config);
}

}  // namespace hrt::plugin
