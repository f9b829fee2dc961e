#include "samples/app/text/json_file.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace hrt {
namespace {

constexpr std::size_t max_text = 2000;

bool has_type(const Json& value, const Json& type) {
  if (type.is_array())
    return std::any_of(type.begin(), type.end(), [&](const Json& each) { return has_type(value, each); });
  return type == "integer" ? value.is_number_unsigned() : type == value.type_name();
}

bool is_line(const std::string& text) {
  return !text.empty() && text.size() <= max_text &&
         std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; });
}

bool is_in(const Json& value, const Json& list) { return std::find(list.begin(), list.end(), value) != list.end(); }

bool fits(const Json& value, const Json& schema) {
  if (schema.contains("type") && !has_type(value, schema["type"])) return false;
  if (schema.contains("enum") && !is_in(value, schema["enum"])) return false;
  if (value.is_string()) return is_line(value.get_ref<const std::string&>());
  if (value.is_array())
    return value.size() >= schema.value("minItems", std::size_t{0}) &&
           value.size() <= schema.value("maxItems", SIZE_MAX);
  if (!value.is_number()) return true;
  const auto number = value.get<double>();
  return number >= schema.value("minimum", number) && number <= schema.value("maximum", number);
}

// Returns text such as "a number from 0 to 1".
std::string range_in_words(const Json& schema, const char* what) {
  const std::string least = std::string(what) + " from " + schema["minimum"].dump();
  return schema.contains("maximum") ? least + " to " + schema["maximum"].dump() : least;
}

std::string array_in_words(const Json& schema) {
  const auto min = schema.value("minItems", 0), max = schema.value("maxItems", 0);
  const std::string least = min > 0 ? " of " + std::to_string(min) : "";
  const std::string most = max == min ? "" : max > 0 ? " to " + std::to_string(max) : " or more";
  const bool has_numbers = schema.value("/items/type"_json_pointer, "") == "number";
  const char* const what = min + max == 0 ? "" : has_numbers ? " numbers" : " entries";
  return "an array" + (min == 0 && max > 0 ? " of 0" : least) + most + what;
}

std::string in_words(const Json& schema, const Json& type) {
  if (schema.contains("enum")) return "one of " + quoted_list(schema["enum"]);
  if (type.is_array()) return in_words(schema, type[0]) + " or " + in_words(schema, type[1]);
  if (type == "number") return range_in_words(schema, "a number");
  if (type == "integer") return range_in_words(schema, "a whole number");
  if (type == "boolean") return "true or false";
  if (type == "string") return "a text of one line of 1 to " + std::to_string(max_text) + " bytes";
  return type == "array" ? array_in_words(schema) : type == "object" ? "an object" : "null";
}

// Returns a short value as text for the end of an error, such as "; it is 3".
std::string value_in_words(const Json& value) {
  constexpr std::size_t max_shown = 80;
  const std::string text = value.is_structured() ? "" : value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.empty() || text.size() > max_shown ? "" : "; it is " + text;
}

class Checker {
 public:
  explicit Checker(const Json& root) : root_(root) {}

  void check(Json& value, const Json& given, const std::string& where) const {
    Json schema = resolved(given);
    if (schema.contains("anyOf")) {
      const Json one = resolved(schema["anyOf"][0]);
      if (fits(value, one)) return;
      schema = schema["anyOf"][1];
      if (!fits(value, schema))
        refuse(where, "must be " + in_words(one, one["type"]) + ", or an array of them" + value_in_words(value));
    }
    if (!fits(value, schema)) refuse(where, "must be " + in_words(schema, schema["type"]) + value_in_words(value));
    if (value.is_object()) check_members(value, schema, where);
    for (std::size_t i = 0; value.is_array() && schema.contains("items") && i < value.size(); ++i)
      check(value[i], schema["items"], where + "[" + std::to_string(i) + "]");
  }

 private:
  // The schema merged with the definition that its $ref names.
  Json resolved(const Json& schema) const {
    if (!schema.contains("$ref")) return schema;
    Json whole = resolved(root_.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))));
    whole.update(schema, true);
    whole.erase("$ref");
    return whole;
  }

  static bool has_required(const Json& object, const Json& schema) {
    const Json required = schema.value("required", Json::array());
    return std::all_of(required.begin(), required.end(),
                       [&](const Json& key) { return object.contains(key.get<std::string>()); });
  }

  void check_members(Json& object, Json schema, const std::string& where) const {
    if (schema.contains("oneOf")) {
      const std::string key = schema["discriminator"]["propertyName"];
      Json chosen;
      for (const Json& each : schema["oneOf"])
        if (object.contains(key) && is_in(object[key], each["properties"][key]["enum"]) &&
            (chosen.is_null() || !has_required(object, chosen)))
          chosen = each;
      if (!chosen.is_null()) schema.update(chosen, true);
    }
    for (const std::string key : schema.value("required", Json::array()))
      if (!object.contains(key)) refuse(where + "." + key, "is missing");
    std::vector<std::string> known;
    for (const auto& [key, given] : schema["properties"].items()) {
      known.push_back(key);
      const Json property = resolved(given);
      if (!object.contains(key) && property.contains("default")) object[key] = property["default"];
      if (object.contains(key)) check(object[key], property, where + "." + key);
    }
    for (const auto& [key, value] : object.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        refuse(where + "." + key, "is not known; known are " + quoted_list(known));
  }

  const Json& root_;
};

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  std::vector<std::set<std::string>> keys;  // keys of the objects that enclose the parser's position
  const auto see = [&](int, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      refuse(parsed.dump(), "occurs twice in one object; remove one of the two");
    return true;
  };
  try {
    return Json::parse(text, see);
  } catch (const Refusal& refusal) {
    throw Refusal(name + ": " + refusal.what());
  } catch (const Json::exception& error) {  // also for a number that a double cannot represent
    throw Refusal(name + ": this is not valid JSON; correct it: " + error.what());
  }
}

void check_json(Json& value, const Json& schema, const std::string& where, const std::string& definition) {
  Checker(schema).check(value, definition.empty() ? schema : schema.at("$defs").at(definition), where);
}

std::string quoted_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "\"" : ", \"") + text + "\"";
  return list;
}

}  // namespace hrt
