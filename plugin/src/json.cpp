#include "plugin/src/json.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "plugin/src/checked.h"
#include "plugin/src/session_config.h"

namespace hrt::plugin {
namespace {

using Json = nlohmann::json;

constexpr std::string_view profile_format = "haptic retargeting profile";
constexpr std::size_t largest_text = 65536;

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

// An object, or an error.
hrt_result parse_object(std::string_view text, Json* out) {
  if (text.size() > largest_text)
    return fail(HRT_ERROR_BAD_FORMAT, "the text has ", text.size(), " bytes; allowed: up to ", largest_text);
  bool nested_too_deep = false;
  const auto callback = [&](int depth, Json::parse_event_t, Json&) {
    nested_too_deep |= depth > 4;
    return !nested_too_deep;
  };
  Json parsed = Json::parse(text, callback, false);
  if (nested_too_deep || !parsed.is_object())
    return fail(HRT_ERROR_BAD_FORMAT, "the text is not a JSON object");
  *out = std::move(parsed);
  return HRT_OK;
}

hrt_result read_number(const std::string& key, const Json& value, double* out) {
  if (!value.is_number()) return fail(HRT_ERROR_BAD_FORMAT, key, " is not a number");
  *out = value.get<double>();
  return HRT_OK;
}

hrt_result read_integer(const std::string& key, const Json& value, std::int64_t* out) {
  if (!value.is_number_integer() || (value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX))
    return fail(HRT_ERROR_BAD_FORMAT, key, " is not a whole number");
  *out = value.get<std::int64_t>();
  return HRT_OK;
}

hrt_result read_unsigned(const std::string& key, const Json& value, std::uint32_t* out) {
  std::int64_t number = 0;
  HRT_RETURN_IF_FAILED(read_integer(key, value, &number));
  HRT_RETURN_IF_FAILED(check_range<std::int64_t>(key.c_str(), number, 0, UINT32_MAX));
  *out = static_cast<std::uint32_t>(number);
  return HRT_OK;
}

hrt_result read_array(const std::string& key, const Json& value, std::size_t size, double* out) {
  if (!value.is_array() || value.size() != size)
    return fail(HRT_ERROR_BAD_FORMAT, key, " is not an array of ", size, " numbers");
  for (std::size_t i = 0; i < size; ++i) HRT_RETURN_IF_FAILED(read_number(key, value[i], out + i));
  return HRT_OK;
}

hrt_result read_field(const std::string& key, const Json& value, hrt_session_config* config) {
  if (key == "horizon") return read_unsigned(key, value, &config->horizon);
  if (key == "step_period_ns") return read_integer(key, value, &config->step_period_ns);
  if (key == "control") return read_unsigned(key, value, &config->control);
  if (key == "guidance") return read_unsigned(key, value, &config->guidance);
  if (key == "adaptation") return read_unsigned(key, value, &config->adaptation);
  if (key == "plate_latency_ns") return read_integer(key, value, &config->plate_latency_ns);
  for (const NumberField& field : number_fields()) {
    if (key == field.name) return read_number(key, value, &(config->*field.value));
  }
  for (const VectorField& field : vector_fields()) {
    if (key == field.name)
      return read_array(key, value, field.size,
                        reinterpret_cast<double*>(reinterpret_cast<char*>(config) + field.offset));
  }
  return fail(HRT_ERROR_BAD_FORMAT, "\"", key, "\" is not a field of a configuration");
}

}  // namespace

void write_config(const hrt_session_config& config, JsonText& out) {
  out << "{\"horizon\":" << config.horizon << ",\"step_period_ns\":" << config.step_period_ns
      << ",\"control\":" << config.control << ",\"guidance\":" << config.guidance
      << ",\"adaptation\":" << config.adaptation << ",\"plate_latency_ns\":" << config.plate_latency_ns;
  for (const NumberField& field : number_fields()) out << ",\"" << field.name << "\":" << config.*field.value;
  for (const VectorField& field : vector_fields()) {
    out << ",\"" << field.name << "\":";
    write_array(vector_of(config, field), field.size, out);
  }
  out << "}";
}

void write_target(const hrt_target_config& target, JsonText& out) {
  out << "{\"name\":";
  write_string(target.name, out);
  out << ",\"role\":" << target.role << ",\"place\":" << target.place
      << ",\"direction_deg\":" << target.direction_deg << ",\"distance_m\":" << target.distance_m
      << ",\"position_m\":";
  write_array(target.position_m, 3, out);
  out << "}";
}

hrt_result read_config(std::string_view text, hrt_session_config* out) {
  Json object;
  HRT_RETURN_IF_FAILED(parse_object(text, &object));
  constexpr std::size_t whole_number_fields = 6;
  const std::size_t fields = whole_number_fields + number_fields().size() + vector_fields().size();
  if (object.size() != fields)
    return fail(HRT_ERROR_BAD_FORMAT, "the configuration has ", object.size(), " fields; ", fields,
                " are needed");
  hrt_session_config config = default_session_config();
  for (const auto& [key, value] : object.items()) HRT_RETURN_IF_FAILED(read_field(key, value, &config));
  HRT_RETURN_IF_FAILED(check_session_config(config));
  *out = config;
  return HRT_OK;
}

void write_profile(const hrt_session_config& config, JsonText& out) {
  out << "{\"format\":\"" << profile_format << "\",\"version\":1";
  for (const NumberField& field : number_fields()) {
    if (field.of_participant) out << ",\"" << field.name << "\":" << config.*field.value;
  }
  out << "}\n";
}

hrt_result read_profile(std::string_view text, hrt_session_config* config) {
  Json object;
  HRT_RETURN_IF_FAILED(parse_object(text, &object));
  if (object.value("format", Json()) != profile_format)
    return fail(HRT_ERROR_BAD_FORMAT, "format is not \"", profile_format, "\"");
  if (object.value("version", Json()) != 1) return fail(HRT_ERROR_BAD_FORMAT, "version is not 1");
  object.erase("format");
  object.erase("version");
  hrt_session_config read = *config;
  for (const auto& [key, value] : object.items()) {
    const auto is_it = [&](const NumberField& field) { return field.of_participant && key == field.name; };
    if (std::none_of(number_fields().begin(), number_fields().end(), is_it))
      return fail(HRT_ERROR_BAD_FORMAT, "\"", key, "\" is not a field of a profile");
    HRT_RETURN_IF_FAILED(read_field(key, value, &read));
  }
  HRT_RETURN_IF_FAILED(check_session_config(read));
  *config = read;
  return HRT_OK;
}

}  // namespace hrt::plugin
