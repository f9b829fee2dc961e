#include "plugin/src/recording/json.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"

namespace hrt::plugin {
namespace {

// Restores '.' as the decimal point of a number, in which the parser has put the decimal point of the locale.
std::string with_point(std::string number) {
  const std::size_t point = number.find_first_not_of("+-0123456789eE");
  if (point != number.npos) number[point] = '.';
  return number;
}

using Json = nlohmann::json;

constexpr const char* profile_format = "haptic retargeting profile";
constexpr std::size_t max_text = 65536;
constexpr std::size_t max_fields = 64;

template <class Values>
void visit_fields(Values& values, auto&& visit) {
  for_each_field<std::remove_const_t<Values>>([&](const auto& field) { visit(field.name, field.of(values)); });
}

void visit_fields(hrt_conditions& conditions, auto&& visit) {
  visit("measured_at_s", conditions.time_s);
  visit("plate", conditions.plate);
  visit("tracker", conditions.tracker);
}

class ObjectWriter {
 public:
  explicit ObjectWriter(JsonText& out) : out_(out) { out_ << "{"; }
  ~ObjectWriter() { out_ << "}"; }
  ObjectWriter(const ObjectWriter&) = delete;
  ObjectWriter& operator=(const ObjectWriter&) = delete;

  void operator()(std::string_view key, const auto& value) {
    out_ << separator_ << "\"" << key << "\":";
    separator_ = ",";
    put(value);
  }
  /// Writes a target as its number in the recording. Writes nothing if it is 0.
  void operator()(std::string_view key, hrt_target target) {
    if (target.value != 0) (*this)(key, target.value);
  }

 private:
  void put(auto number) { out_ << number; }
  void put(const char* text) {
    out_ << "\"";
    for (; *text != '\0'; ++text) {
      if (*text == '"' || *text == '\\') out_ << "\\";
      out_ << std::string_view(text, 1);
    }
    out_ << "\"";
  }
  template <std::size_t size>
  void put(const double (&values)[size]) {
    for (std::size_t i = 0; i < size; ++i) out_ << (i == 0 ? "[" : ",") << values[i];
    out_ << "]";
  }

  JsonText& out_;
  std::string_view separator_;
};

// A field of a JSON object: a number, a string, or an array of numbers.
struct JsonField {
  std::string key;
  bool is_array = false;
  bool is_text = false;
  bool is_whole = false;
  std::int64_t whole = 0;
  std::vector<double> numbers;
  std::string text;
};

// Reads a JSON object without nested objects. It does not use nlohmann::json values, because their destructors allocate
// and would terminate the process when memory is exhausted.
class FlatObjectReader : public nlohmann::json_sax<Json> {
 public:
  std::vector<JsonField> fields;

  bool start_object(std::size_t) override { return ++depth_ == 1 || refuse("an object"); }
  bool end_object() override { return true; }
  bool key(string_t& name) override {
    fields.push_back({.key = name});
    if (fields.size() > max_fields) set_error("the text has over ", max_fields, " fields; save it again");
    return fields.size() <= max_fields;
  }
  bool start_array(std::size_t) override {
    if (fields.empty() || in_array_) return refuse("an array in an array");
    in_array_ = fields.back().is_array = true;
    return true;
  }
  bool end_array() override {
    in_array_ = false;
    return true;
  }
  bool number_integer(number_integer_t value) override {
    // The parser calls this function for integers with a minus sign: a value of 0 was written as "-0".
    return number(value == 0 ? -0.0 : static_cast<double>(value), true, value);
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number(static_cast<double>(value), value <= INT64_MAX, static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t, const string_t& text) override {
    double value = 0.0;
    return read_number(with_point(text), &value) ? number(value, false, 0) : refuse("a number that is too large");
  }
  bool string(string_t& value) override {
    if (fields.empty() || in_array_) return refuse("a string in an array");
    fields.back().is_text = true;
    fields.back().text = value;
    return true;
  }
  bool null() override { return refuse("null"); }
  bool boolean(bool) override { return refuse("true or false"); }
  bool binary(binary_t&) override { return refuse("binary data"); }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception&) override {
    set_error("the text is not valid JSON at byte ", byte, "; save the text again and do not edit it");
    return false;
  }

 private:
  // Sets the error for a value that a JsonField cannot hold. Returns false.
  bool refuse(const char* kind) {
    if (fields.empty())
      set_error("the text is not a JSON object; save the text again and do not edit it");
    else
      set_error("\"", Shown{fields.back().key}, "\" is or contains ", kind,
                "; allowed: a number, a string or an array of numbers");
    return false;
  }
  bool number(double value, bool is_whole, std::int64_t whole) {
    if (fields.empty()) return refuse("a number");
    JsonField& field = fields.back();
    field.numbers.push_back(value);
    field.is_whole = is_whole && !in_array_;
    field.whole = whole;
    return true;
  }

  int depth_ = 0;
  bool in_array_ = false;
};

hrt_result parse_fields(std::string_view text, std::vector<JsonField>* out) {
  if (text.size() > max_text)
    return fail(HRT_ERROR_BAD_FORMAT, "the text has ", text.size(), " bytes; allowed: up to ", max_text);
  FlatObjectReader reader;
  if (!Json::sax_parse(text, &reader)) return HRT_ERROR_BAD_FORMAT;  // the reader has set the error
  for (const JsonField& field : reader.fields) {
    const auto same = [&](const JsonField& other) { return other.key == field.key; };
    if (std::count_if(reader.fields.begin(), reader.fields.end(), same) > 1)
      return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{field.key}, "\" appears twice; remove one of the two");
  }
  *out = std::move(reader.fields);
  return HRT_OK;
}

hrt_result read(const JsonField& field, double& out) {
  if (field.is_array || field.is_text)
    return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not a number; save the text again");
  out = field.numbers[0];
  return HRT_OK;
}

hrt_result read(const JsonField& field, std::int64_t& out) {
  if (!field.is_whole) return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not an integer; save the text again");
  out = field.whole;
  return HRT_OK;
}

hrt_result read(const JsonField& field, std::uint32_t& out) {
  std::int64_t number = 0;
  HRT_RETURN_IF_FAILED(read(field, number));
  HRT_RETURN_IF_FAILED(check_range<std::int64_t>(field.key.c_str(), number, 0, UINT32_MAX));
  out = static_cast<std::uint32_t>(number);
  return HRT_OK;
}

// Reads a target, which is written as its number in the recording.
hrt_result read(const JsonField& field, hrt_target& out) {
  std::int64_t number = 0;
  HRT_RETURN_IF_FAILED(read(field, number));
  HRT_RETURN_IF_FAILED(check_range<std::int64_t>(field.key.c_str(), number, 0, INT64_MAX));
  out.value = static_cast<std::uint64_t>(number);
  return HRT_OK;
}

template <std::size_t size>
hrt_result read(const JsonField& field, double (&out)[size]) {
  if (!field.is_array || field.numbers.size() != size)
    return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not an array of ", size, " numbers; save the text again");
  std::copy(field.numbers.begin(), field.numbers.end(), out);
  return HRT_OK;
}

hrt_result read(const JsonField& field, char (&out)[HRT_NAME_SIZE]) {
  if (!field.is_text || field.text.size() >= sizeof out)
    return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not a string of up to ", sizeof out - 1,
                " bytes; save the text again");
  std::memcpy(out, field.text.data(), field.text.size());
  return HRT_OK;
}

template <class Struct>
constexpr const char* name_of = "configuration";
template <>
constexpr const char* name_of<hrt_target_config> = "target";
template <>
constexpr const char* name_of<hrt_setup_config> = "set-up";

// Reads a field into the member of `*out` with the same name. `what` is a noun for the struct in error texts.
template <class Struct>
hrt_result read_into(const char* what, const JsonField& field, Struct* out) {
  std::optional<hrt_result> result;
  visit_fields(*out, [&](std::string_view key, auto& value) {
    if (key == field.key) result = read(field, value);
  });
  if (result) return *result;
  return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{field.key}, "\" is not a field of a ", what, "; remove this field");
}

bool is_in_profile(std::string_view key) {
  bool found = false;
  for_each_field<hrt_session_config>(
      [&](const auto& field) { found = found || (field.in_profile && key == field.name); });
  return found;
}

}  // namespace

template <class Struct>
void write_json(const Struct& values, JsonText& out) {
  Struct read = values;
  if constexpr (std::is_same_v<Struct, hrt_target_config>) {
    // Fields that `place` does not select may be uninitialised: they are written as 0.
    if (values.place == HRT_PLACE_DIRECTION)
      std::fill(std::begin(read.position_m), std::end(read.position_m), 0.0);
    else
      read.direction_deg = read.distance_m = 0.0;
  }
  visit_fields(std::as_const(read), ObjectWriter(out));
}

template <class Struct>
hrt_result read_json(std::string_view text, Struct* out) {
  std::vector<JsonField> fields;
  HRT_RETURN_IF_FAILED(parse_fields(text, &fields));
  Struct values = std::is_same_v<Struct, hrt_target_config> ? Struct{.struct_size = sizeof(Struct)} : defaults<Struct>;
  for (const JsonField& field : fields) HRT_RETURN_IF_FAILED(read_into(name_of<Struct>, field, &values));
  *out = values;
  return HRT_OK;
}

template void write_json(const hrt_session_config&, JsonText&);
template void write_json(const hrt_target_config&, JsonText&);
template void write_json(const hrt_setup_config&, JsonText&);
template hrt_result read_json(std::string_view, hrt_session_config*);
template hrt_result read_json(std::string_view, hrt_target_config*);
template hrt_result read_json(std::string_view, hrt_setup_config*);

void write_profile(const hrt_session_config& config, const hrt_conditions& conditions, JsonText& out) {
  {
    ObjectWriter write(out);
    write("format", profile_format);
    write("version", 1);
    for_each_field<hrt_session_config>([&](const auto& field) {
      if (field.in_profile && field.in_profile(config)) write(field.name, field.of(config));
    });
    if (conditions.time_s != 0) write("measured_at_s", conditions.time_s);
    if (conditions.plate[0] != '\0') write("plate", conditions.plate);
    if (conditions.tracker[0] != '\0') write("tracker", conditions.tracker);
  }
  out << "\n";
}

hrt_result read_profile(std::string_view text, hrt_session_config* config, hrt_conditions* conditions) {
  std::vector<JsonField> fields;
  HRT_RETURN_IF_FAILED(parse_fields(text, &fields));
  hrt_session_config known = *config;
  // Optional fields that the profile lacks are unknown for this user: they get their defaults.
  for_each_field<hrt_session_config>([&](const auto& field) {
    constexpr hrt_session_config unknown = defaults<hrt_session_config>;
    if (field.optional) std::memcpy(&field.of(known), &field.of(unknown), sizeof(field.of(known)));
  });
  hrt_conditions measured{};
  bool has_format = false, has_version = false;
  for (const JsonField& field : fields) {
    if (field.key == "format") {
      has_format = field.text == profile_format;
    } else if (field.key == "version") {
      has_version = field.is_whole && field.whole == 1;
    } else if (is_in_profile(field.key)) {
      HRT_RETURN_IF_FAILED(read_into("profile", field, &known));
    } else {
      HRT_RETURN_IF_FAILED(read_into("profile", field, &measured));
    }
  }
  if (!has_format)
    return fail(HRT_ERROR_BAD_FORMAT, "format is not \"", profile_format, "\"; pass the output of hrt_profile_save()");
  if (!has_version)
    return fail(HRT_ERROR_BAD_FORMAT, "version of the profile is not 1; pass the output of hrt_profile_save()");
  *config = known;
  *conditions = measured;
  return HRT_OK;
}

}  // namespace hrt::plugin
