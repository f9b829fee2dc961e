#include "plugin/src/recording/json.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/number.h"
#include "plugin/src/conditions.h"
#include "plugin/src/session_config.h"
#include "plugin/src/streamed_calibration.h"
#include "plugin/src/targets.h"

namespace hrt::plugin {
namespace {

using Json = nlohmann::json;

constexpr std::string_view profile_format = "haptic retargeting profile";
constexpr std::size_t largest_text = 65536;
constexpr std::size_t most_fields = 64;

void write_string(std::string_view text, JsonText& out) {
  out << "\"";
  for (const char& c : text) {
    if (c == '"' || c == '\\') out << "\\";
    out << std::string_view(&c, 1);
  }
  out << "\"";
}

void write_array(const double* values, std::size_t size, JsonText& out) {
  for (std::size_t i = 0; i < size; ++i) out << (i == 0 ? "[" : ",") << values[i];
  out << "]";
}

const double* vector_of(const hrt_session_config& config, const VectorField& field) {
  return reinterpret_cast<const double*>(reinterpret_cast<const char*>(&config) + field.offset);
}

// A field of a flat object: a number, a string, or an array of numbers.
struct Field {
  std::string key;
  bool is_array = false;
  bool is_text = false;
  bool is_whole = false;
  std::int64_t whole = 0;
  std::vector<double> numbers;
  std::string text;
};

// Takes a flat object in, field by field. The library's own tree of values is not used: its destructors
// allocate, and so end the process when memory runs out.
class FlatObjectReader : public nlohmann::json_sax<Json> {
 public:
  std::vector<Field> fields;

  bool start_object(std::size_t) override { return ++depth_ == 1; }
  bool end_object() override { return true; }
  bool key(string_t& name) override {
    fields.push_back({.key = name});
    return fields.size() <= most_fields;
  }
  bool start_array(std::size_t) override {
    if (depth_ == 0 || fields.empty() || in_array_) return false;
    in_array_ = fields.back().is_array = true;
    return true;
  }
  bool end_array() override {
    in_array_ = false;
    return true;
  }
  bool number_integer(number_integer_t value) override {
    // Called for what has a sign: 0 is "-0".
    return number(value == 0 ? -0.0 : static_cast<double>(value), true, value);
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number(static_cast<double>(value), value <= INT64_MAX, static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t, const string_t& text) override {
    // The parser has put the locale's decimal point into the text, and read its value by that.
    std::string token = text;
    const std::size_t point = token.find_first_not_of("+-0123456789eE");
    if (point != token.npos) token[point] = '.';
    double value = 0.0;
    return read_number(token, &value) && number(value, false, 0);
  }
  bool string(string_t& value) override {
    if (depth_ == 0 || fields.empty() || in_array_) return false;
    fields.back().is_text = true;
    fields.back().text = value;
    return true;
  }
  bool null() override { return false; }
  bool boolean(bool) override { return false; }
  bool binary(binary_t&) override { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  bool number(double value, bool is_whole, std::int64_t whole) {
    if (depth_ == 0 || fields.empty()) return false;
    Field& field = fields.back();
    field.numbers.push_back(value);
    field.is_whole = is_whole && !in_array_;
    field.whole = whole;
    return true;
  }

  int depth_ = 0;
  bool in_array_ = false;
};

hrt_result parse_fields(std::string_view text, std::vector<Field>* out) {
  if (text.size() > largest_text)
    return fail(HRT_ERROR_BAD_FORMAT, "the text has ", text.size(), " bytes; allowed: up to ", largest_text);
  FlatObjectReader reader;
  if (!Json::sax_parse(text, &reader))
    return fail(HRT_ERROR_BAD_FORMAT,
                "the text is not a JSON object of numbers, arrays of numbers and strings");
  for (const Field& field : reader.fields) {
    const auto same = [&](const Field& other) { return other.key == field.key; };
    if (std::count_if(reader.fields.begin(), reader.fields.end(), same) > 1)
      return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{field.key}, "\" is there twice");
  }
  *out = std::move(reader.fields);
  return HRT_OK;
}

hrt_result read_number(const Field& field, double* out) {
  if (field.is_array || field.is_text) return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not a number");
  *out = field.numbers[0];
  return HRT_OK;
}

hrt_result read_integer(const Field& field, std::int64_t* out) {
  if (!field.is_whole) return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not a whole number");
  *out = field.whole;
  return HRT_OK;
}

hrt_result read_unsigned(const Field& field, std::uint32_t* out) {
  std::int64_t number = 0;
  HRT_RETURN_IF_FAILED(read_integer(field, &number));
  HRT_RETURN_IF_FAILED(check_range<std::int64_t>(field.key.c_str(), number, 0, UINT32_MAX));
  *out = static_cast<std::uint32_t>(number);
  return HRT_OK;
}

hrt_result read_array(const Field& field, std::size_t size, double* out) {
  if (!field.is_array || field.numbers.size() != size)
    return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not an array of ", size, " numbers");
  std::copy(field.numbers.begin(), field.numbers.end(), out);
  return HRT_OK;
}

hrt_result read_name(const Field& field, char (&out)[HRT_NAME_SIZE]) {
  if (!field.is_text || field.text.size() >= sizeof out)
    return fail(HRT_ERROR_BAD_FORMAT, field.key, " is not a text of up to ", sizeof out - 1, " bytes");
  std::memcpy(out, field.text.data(), field.text.size());
  return HRT_OK;
}

hrt_result read_field(const Field& field, hrt_session_config* config) {
  const std::string& key = field.key;
  if (key == "horizon") return read_unsigned(field, &config->horizon);
  if (key == "step_period_ns") return read_integer(field, &config->step_period_ns);
  if (key == "control") return read_unsigned(field, &config->control);
  if (key == "guidance") return read_unsigned(field, &config->guidance);
  if (key == "adaptation") return read_unsigned(field, &config->adaptation);
  if (key == "plate_latency_ns") return read_integer(field, &config->plate_latency_ns);
  if (key == "tracker_latency_ns") return read_integer(field, &config->tracker_latency_ns);
  if (key == "max_registration_age_ns") return read_integer(field, &config->max_registration_age_ns);
  if (key == "registration_time_ns") return read_integer(field, &config->registration_time_ns);
  if (key == "flags") return read_unsigned(field, &config->flags);
  for (const NumberField& number : number_fields()) {
    if (key == number.name) return read_number(field, &(config->*number.value));
  }
  for (const VectorField& vector : vector_fields()) {
    if (key == vector.name)
      return read_array(field, vector.size,
                        reinterpret_cast<double*>(reinterpret_cast<char*>(config) + vector.offset));
  }
  return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{key}, "\" is not a field of a configuration");
}

bool is_of_participant(const std::string& key) {
  return std::any_of(
             number_fields().begin(), number_fields().end(),
             [&](const NumberField& number) { return number.of_participant && key == number.name; }) ||
         std::any_of(vector_fields().begin(), vector_fields().end(),
                     [&](const VectorField& vector) { return vector.of_participant && key == vector.name; });
}

}  // namespace

void write_config(const hrt_session_config& config, JsonText& out) {
  out << "{\"horizon\":" << config.horizon << ",\"step_period_ns\":" << config.step_period_ns
      << ",\"control\":" << config.control << ",\"guidance\":" << config.guidance
      << ",\"adaptation\":" << config.adaptation << ",\"plate_latency_ns\":" << config.plate_latency_ns
      << ",\"tracker_latency_ns\":" << config.tracker_latency_ns
      << ",\"registration_time_ns\":" << config.registration_time_ns
      << ",\"max_registration_age_ns\":" << config.max_registration_age_ns << ",\"flags\":" << config.flags;
  for (const NumberField& field : number_fields()) out << ",\"" << field.name << "\":" << config.*field.value;
  for (const VectorField& field : vector_fields()) {
    out << ",\"" << field.name << "\":";
    write_array(vector_of(config, field), field.size, out);
  }
  out << "}";
}

void write_target(const hrt_target_config& target, JsonText& out) {
  // Fields that the place does not name are not read, and may hold anything.
  const bool by_direction = target.place == HRT_PLACE_DIRECTION;
  constexpr double unread_m[3] = {};
  out << "{\"name\":";
  write_string(target.name, out);
  out << ",\"role\":" << target.role << ",\"place\":" << target.place
      << ",\"direction_deg\":" << (by_direction ? target.direction_deg : 0.0)
      << ",\"distance_m\":" << (by_direction ? target.distance_m : 0.0) << ",\"position_m\":";
  write_array(by_direction ? unread_m : target.position_m, 3, out);
  out << "}";
}

hrt_result read_config(std::string_view text, hrt_session_config* out) {
  std::vector<Field> fields;
  HRT_RETURN_IF_FAILED(parse_fields(text, &fields));
  constexpr std::size_t whole_number_fields = 10;
  const std::size_t needed = whole_number_fields + number_fields().size() + vector_fields().size();
  if (fields.size() != needed)
    return fail(HRT_ERROR_BAD_FORMAT, "the configuration has ", fields.size(), " fields; ", needed,
                " are needed");
  hrt_session_config config = default_session_config();
  for (const Field& field : fields) HRT_RETURN_IF_FAILED(read_field(field, &config));
  HRT_RETURN_IF_FAILED(check_session_config(config));
  *out = config;
  return HRT_OK;
}

hrt_result read_target(std::string_view text, hrt_target_config* out) {
  std::vector<Field> fields;
  HRT_RETURN_IF_FAILED(parse_fields(text, &fields));
  constexpr std::size_t needed = 6;
  if (fields.size() != needed)
    return fail(HRT_ERROR_BAD_FORMAT, "the target has ", fields.size(), " fields; ", needed, " are needed");
  hrt_target_config target{};
  target.struct_size = sizeof target;
  for (const Field& field : fields) {
    if (field.key == "name") {
      HRT_RETURN_IF_FAILED(read_name(field, target.name));
    } else if (field.key == "role") {
      HRT_RETURN_IF_FAILED(read_unsigned(field, &target.role));
    } else if (field.key == "place") {
      HRT_RETURN_IF_FAILED(read_unsigned(field, &target.place));
    } else if (field.key == "direction_deg") {
      HRT_RETURN_IF_FAILED(read_number(field, &target.direction_deg));
    } else if (field.key == "distance_m") {
      HRT_RETURN_IF_FAILED(read_number(field, &target.distance_m));
    } else if (field.key == "position_m") {
      HRT_RETURN_IF_FAILED(read_array(field, 3, target.position_m));
    } else {
      return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{field.key}, "\" is not a field of a target");
    }
  }
  HRT_RETURN_IF_FAILED(check_target_fields(&target));
  *out = target;
  return HRT_OK;
}

void write_calibration_config(const hrt_calibration_config& config, JsonText& out) {
  out << "{\"max_trials\":" << config.max_trials << ",\"max_samples\":" << config.max_samples
      << ",\"goal_direction_deg\":" << config.goal_direction_deg
      << ",\"lower_plate_deg\":" << config.lower_plate_deg
      << ",\"upper_plate_deg\":" << config.upper_plate_deg
      << ",\"enough_weight_width\":" << config.enough_weight_width << "}";
}

hrt_result read_calibration_config(std::string_view text, hrt_calibration_config* out) {
  std::vector<Field> fields;
  HRT_RETURN_IF_FAILED(parse_fields(text, &fields));
  constexpr std::size_t needed = 6;
  if (fields.size() != needed)
    return fail(HRT_ERROR_BAD_FORMAT, "the calibration has ", fields.size(), " fields; ", needed,
                " are needed");
  hrt_calibration_config config = default_calibration_config();
  for (const Field& field : fields) {
    if (field.key == "max_trials") {
      HRT_RETURN_IF_FAILED(read_unsigned(field, &config.max_trials));
    } else if (field.key == "max_samples") {
      HRT_RETURN_IF_FAILED(read_unsigned(field, &config.max_samples));
    } else if (field.key == "goal_direction_deg") {
      HRT_RETURN_IF_FAILED(read_number(field, &config.goal_direction_deg));
    } else if (field.key == "lower_plate_deg") {
      HRT_RETURN_IF_FAILED(read_number(field, &config.lower_plate_deg));
    } else if (field.key == "upper_plate_deg") {
      HRT_RETURN_IF_FAILED(read_number(field, &config.upper_plate_deg));
    } else if (field.key == "enough_weight_width") {
      HRT_RETURN_IF_FAILED(read_number(field, &config.enough_weight_width));
    } else {
      return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{field.key}, "\" is not a field of a calibration");
    }
  }
  HRT_RETURN_IF_FAILED(check_calibration_config(config));
  *out = config;
  return HRT_OK;
}

void write_profile(const hrt_session_config& config, const hrt_conditions& conditions, JsonText& out) {
  out << "{\"format\":\"" << profile_format << "\",\"version\":1";
  for (const NumberField& field : number_fields()) {
    if (!field.of_participant || (field.known_by && !(config.*field.known_by > 0.0))) continue;
    out << ",\"" << field.name << "\":" << config.*field.value;
  }
  for (const VectorField& field : vector_fields()) {
    if (!field.of_participant || !knows_person(config)) continue;
    out << ",\"" << field.name << "\":";
    write_array(vector_of(config, field), field.size, out);
  }
  if (conditions.time_s != 0) out << ",\"measured_at_s\":" << conditions.time_s;
  for (const auto& [key, name] : {std::pair{"plate", conditions.plate}, {"tracker", conditions.tracker}}) {
    if (*name == '\0') continue;
    out << ",\"" << key << "\":";
    write_string(name, out);
  }
  out << "}\n";
}

hrt_result read_profile(std::string_view text, hrt_session_config* config, hrt_conditions* conditions) {
  std::vector<Field> fields;
  HRT_RETURN_IF_FAILED(parse_fields(text, &fields));
  hrt_session_config read = *config;
  // A profile that says nothing of these is of a person of whom nothing was learnt in reaches.
  forget_person(&read);
  for (const NumberField& field : number_fields())
    if (field.known_by) read.*field.known_by = 0.0;
  hrt_conditions measured{};
  bool has_format = false, has_version = false;
  for (const Field& field : fields) {
    if (field.key == "format") {
      has_format = field.text == profile_format;
    } else if (field.key == "version") {
      has_version = field.is_whole && field.whole == 1;
    } else if (field.key == "measured_at_s") {
      HRT_RETURN_IF_FAILED(read_integer(field, &measured.time_s));
    } else if (field.key == "plate") {
      HRT_RETURN_IF_FAILED(read_name(field, measured.plate));
    } else if (field.key == "tracker") {
      HRT_RETURN_IF_FAILED(read_name(field, measured.tracker));
    } else if (is_of_participant(field.key)) {
      HRT_RETURN_IF_FAILED(read_field(field, &read));
    } else {
      return fail(HRT_ERROR_BAD_FORMAT, "\"", Shown{field.key}, "\" is not a field of a profile");
    }
  }
  if (!has_format) return fail(HRT_ERROR_BAD_FORMAT, "format is not \"", profile_format, "\"");
  if (!has_version) return fail(HRT_ERROR_BAD_FORMAT, "version is not 1");
  HRT_RETURN_IF_FAILED(check_session_config(read));
  HRT_RETURN_IF_FAILED(check_conditions(&measured));
  *config = read;
  *conditions = measured;
  return HRT_OK;
}

}  // namespace hrt::plugin
