// JSON that people and programs write, checked against a JSON Schema.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hrt {

using Json = nlohmann::json;

/// Thrown for invalid input, and by hrt-experiment for other errors, too. Its text names the mistake and the place.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void refuse(const std::string& where, const std::string& why) { throw Refusal(where + " " + why); }

/// Parses `text`. Throws Refusal for a syntax error, or a key that occurs twice in one object.
Json parse_json(std::string_view text, const std::string& name);

/// Checks `value` against `schema`, or against `definition` of its $defs, and inserts the defaults of missing members.
/// Throws Refusal with the place, as in "script.events[0].hand", and what is allowed there. A text must be one line of
/// 1 to 2000 bytes; an integer must be at least 0. A member that the schema does not describe is refused.
///
/// Keywords: type, enum, minimum, maximum, minItems, maxItems, items, properties, required, default, $ref to $defs
/// (other keywords of the same schema take precedence), and
/// - anyOf: two schemas, the second of which is an array of values of the first;
/// - oneOf with discriminator.propertyName (OpenAPI), a member's name: among the schemas whose enum for this member has
///   its value, the first whose required members are present, or else the last.
void check_json(Json& value, const Json& schema, const std::string& where, const std::string& definition = {});

/// Returns text such as: "a", "b", "c"
std::string quoted_list(const std::vector<std::string>& texts);

/// Names in a file, and their meanings.
template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

/// The meaning of a name that the schema allows.
template <typename Value>
Value meaning(const Json& name, const Names<Value>& names) {
  for (const auto& [text, value] : names)
    if (name == text) return value;
  throw std::logic_error("the schema allows " + name.dump() + ", which has no meaning");
}
/// The meanings of one name or of an array of names.
template <typename Value>
std::vector<Value> meanings(const Json& given, const Names<Value>& names) {
  std::vector<Value> values;
  for (const Json& name : given.is_array() ? given : Json::array({given})) values.push_back(meaning(name, names));
  return values;
}

}  // namespace hrt
