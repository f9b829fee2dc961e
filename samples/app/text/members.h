// Reading the members of a file's JSON objects. What reads a file also writes its schema. What is wrong is refused with
// its place and the allowed values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hrt {

using Json = nlohmann::json;

constexpr double hour_ms = 3'600'000.0;

/// Of what a file, a program or the system gives.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void refuse(const std::string& where, const std::string& why) { throw Refusal(where + " " + why); }

/// The objects around what a parser reads: their keys, and the latest of each. Of a key that stands twice in one object
/// the parser would keep the last: refused.
struct KeysAround {
  std::vector<std::pair<std::set<std::string>, std::string>> objects;

  void see(Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) objects.emplace_back();
    if (event == Json::parse_event_t::object_end) objects.pop_back();
    if (event != Json::parse_event_t::key) return;
    auto& [keys, latest] = objects.back();
    latest = parsed.get<std::string>();
    if (!keys.insert(latest).second) refuse(parsed.dump(), "stands twice in one object");
  }
};

inline std::string quoted_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "\"" : ", \"") + text + "\"";
  return list;
}

// A name in a file, and its meaning.
template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

template <typename Value>
std::vector<std::string> texts_of(const Names<Value>& names) {
  std::vector<std::string> texts;
  for (const auto& each : names) texts.push_back(each.first);
  return texts;
}

/// How long an array is, and what it is for, in the schema.
struct List {
  std::size_t min = 0;
  std::size_t max = std::numeric_limits<std::size_t>::max();
  const char* what = "";
};

// The members of one JSON object, read and described at once. Where a call has an optional `otherwise`, the member must
// be there without it; `what` is its description in the schema. finish() refuses members that were not read.
class Members {
 public:
  using Variant = std::optional<unsigned>;

  Members(const Json& object, std::string where) : object_(&object), where_(std::move(where)) {
    if (!object.is_object()) refuse(where_, "must be an object");
  }
  // Describes what would be read. Of the ways that a reader may take at a choice, or where a member may be
  // there or not, each variant goes one: all of them together describe all. Without a variant there is one way, and
  // the schema has what must be there.
  Members(Json& schema, Variant variant) : schema_(&schema), variant_(variant) {
    schema["type"] = "object";
    schema["additionalProperties"] = false;
  }
  static constexpr unsigned variants = 32;  // the most kinds of a choice, with and without optional members

  const std::string& where() const { return where_; }
  std::string where(const std::string& key) const { return where_ + "." + key; }
  /// There are no values.
  bool describes() const { return schema_ != nullptr; }
  bool has(const std::string& key) {
    const bool is_there = find(key, Json::object()) != nullptr;
    return describes() ? variant_.value_or(0) % 2 == 0 : is_there;
  }
  const Json& at(const std::string& key, const Json& schema = Json::object()) {
    static const Json none;
    const Json* value = needed(key, schema);
    return value == nullptr ? none : *value;
  }

  double number(const std::string& key, std::optional<double> otherwise, double min, double max,
                const char* what = "") {
    const Json* value = optional(key, otherwise, schema_of_number(min, max), what);
    return value == nullptr ? otherwise.value_or(min) : checked_number(*value, where(key), min, max);
  }
  std::int64_t nanoseconds(const std::string& key, double otherwise_ms, double min_ms = 0.0, double max_ms = hour_ms) {
    return std::llround(number(key, otherwise_ms, min_ms, max_ms) * 1e6);
  }
  template <typename Whole = std::uint64_t>
  Whole count(const std::string& key, std::optional<std::type_identity_t<Whole>> otherwise,
              std::type_identity_t<Whole> min, std::type_identity_t<Whole> max = std::numeric_limits<Whole>::max(),
              const char* what = "") {
    const bool is_bounded = max < std::numeric_limits<Whole>::max();
    Json schema = {{"type", "integer"}, {"minimum", min}};
    if (is_bounded) schema["maximum"] = max;
    const Json* value = optional(key, otherwise, schema, what);
    if (value == nullptr) return otherwise.value_or(min);
    if (!value->is_number_unsigned() || value->get<std::uint64_t>() < min || value->get<std::uint64_t>() > max)
      refuse(where(key),
             "must be a whole number from " + std::to_string(min) + (is_bounded ? " to " + std::to_string(max) : ""));
    return value->get<Whole>();
  }
  /// Without `otherwise` one must be there.
  template <typename Value>
  Value choice(const std::string& key, const Names<Value>& known, const char* otherwise = nullptr,
               const char* what = "") {
    const Json schema = schema_of_names(known);
    const Json usual = otherwise == nullptr ? Json() : Json(otherwise);
    const Json* found = otherwise == nullptr ? needed(key, schema, what) : find(key, schema, what, usual);
    if (describes()) return known[variant_.value_or(0) / 2 % known.size()].second;
    const Json& name = found == nullptr ? usual : *found;
    for (const auto& [text, value] : known)
      if (name == text) return value;
    refuse(where(key), "must be one of " + quoted_list(texts_of(known)));
  }
  /// One of these, as it stands there.
  std::string word(const std::string& key, const std::vector<std::string>& known, const char* otherwise,
                   const char* what) {
    Names<std::string> names;
    for (const std::string& each : known) names.emplace_back(each, each);
    return choice(key, names, otherwise, what);
  }
  bool boolean(const std::string& key, bool otherwise) {
    const Json* value = find(key, {{"type", "boolean"}});
    if (value == nullptr) return otherwise;
    if (!value->is_boolean()) refuse(where(key), "must be true or false");
    return value->get<bool>();
  }
  /// In one line.
  std::string text(const std::string& key, const std::optional<std::string>& otherwise, const char* what = "") {
    const Json schema = {{"type", "string"}, {"minLength", 1}, {"maxLength", max_text}};
    const Json* value = otherwise ? find(key, schema, what) : needed(key, schema, what);
    if (value == nullptr) return otherwise.value_or("");
    if (!is_text(*value)) refuse(where(key), "must be a text of one line of 1 to 2000 bytes");
    return value->get<std::string>();
  }
  std::vector<std::string> texts(const std::string& key, bool must_be_there, const List& list) {
    const Json schema = schema_of_texts(list);
    const Json* value = must_be_there ? needed(key, schema, list.what) : find(key, schema, list.what);
    return value == nullptr ? std::vector<std::string>() : checked_texts(*value, where(key), list);
  }
  std::vector<std::vector<std::string>> lists(const std::string& key, const List& each, const char* what) {
    const Json* value = find(key, {{"type", "array"}, {"items", schema_of_texts(each)}, {"minItems", 1}}, what);
    std::vector<std::vector<std::string>> lists;
    if (value == nullptr) return lists;
    if (!value->is_array() || value->empty()) refuse(where(key), "must be an array of arrays of texts");
    for (const Json& list : *value) lists.push_back(checked_texts(list, place(key, lists.size()), each));
    return lists;
  }
  std::vector<double> numbers(const std::string& key, std::size_t size, double min, double max) {
    const Json& value = at(key, schema_of_numbers(size, min, max));
    std::vector<double> result;
    if (describes()) {
      result.resize(size);
      result[0] = max;  // a rotation, too, has a length
      return result;
    }
    if (!value.is_array() || value.size() != size)
      refuse(where(key), "must be an array of " + std::to_string(size) + " numbers");
    for (const Json& element : value) result.push_back(checked_number(element, where(key), min, max));
    return result;
  }
  // An array of numbers, or one for all; empty if it is not there.
  std::vector<double> one_or_each(const std::string& key, std::size_t size, double min, double max) {
    const Json* value =
        find(key, {{"anyOf", Json::array({schema_of_number(min, max), schema_of_numbers(size, min, max)})}});
    if (value == nullptr) return {};
    if (value->is_array()) return numbers(key, size, min, max);
    return std::vector<double>(size, checked_number(*value, where(key), min, max));
  }

  // A number, or two between which it is drawn; `scale` converts to the unit of `range`.
  template <typename Range>
  bool range(const std::string& key, Range& range, double min, double max, double scale = 1.0) {
    const std::vector<double> ends = one_or_each(key, 2, min, max);
    if (ends.empty()) return false;
    if (ends[0] > ends[1]) refuse(where(key), "must have the smaller number first");
    range = {ends[0] * scale, ends[1] * scale};
    return true;
  }
  // A name, or several, of which one is drawn.
  template <typename Value>
  void one_of(const std::string& key, std::vector<Value>& values, const Names<Value>& known) {
    const Json one = schema_of_names(known);
    const Json* value = find(key, {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}}})}});
    if (value == nullptr) return;
    const Json names = value->is_array() ? *value : Json::array({*value});
    values.clear();
    for (const Json& name : names)
      for (const auto& [text, meaning] : known)
        if (name == text) values.push_back(meaning);
    if (values.size() == names.size() && !names.empty()) return;
    refuse(where(key), "must be one of, or an array of, " + quoted_list(texts_of(known)));
  }
  // Calls `read(members)` for every object of an array, which must be there unless it may be empty.
  template <typename Read>
  void each(const std::string& key, const List& list, Read read) {
    const Json schema = schema_of_list(list);
    const Json* value = list.min > 0 ? needed(key, schema, list.what) : find(key, schema, list.what);
    if (describes()) describe((*schema_)["properties"][key]["items"], variant_, read);
    if (value == nullptr) return;
    check_list(*value, where(key), list, "objects");
    std::size_t i = 0;
    for (const Json& element : *value) {
      Members members(element, place(key, i++));
      read(members);
      members.finish();
    }
  }
  // Calls `read(members)` for an object, if it is there, and returns whether it is.
  template <typename Read>
  bool object(const std::string& key, const char* what, Read read) {
    const Json* value = find(key, Json::object(), what);
    if (describes()) describe((*schema_)["properties"][key], variant_, read);
    if (value == nullptr) return false;
    Members members(*value, where(key));
    read(members);
    members.finish();
    return true;
  }
  template <typename Read>
  bool object(const std::string& key, Read read) {
    return object(key, "", read);
  }

  // What `read(members)` would read. There are no values, so it may refuse some: what it has asked for stays.
  template <typename Read>
  static void describe(Json& schema, Variant variant, Read read) {
    try {
      Members members(schema, variant);
      read(members);
    } catch (const Refusal&) {
    }
  }

  void finish() const {
    if (describes()) return;
    for (const auto& [key, value] : object_->items())
      if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        refuse(where(key), "is not known; known are " + quoted_list(asked_));
  }

 private:
  static constexpr std::size_t max_text = 2000;

  // The member; null if it is not there, or only described. `usual` is what stands for it then, in the schema.
  const Json* find(const std::string& key, Json schema, const char* what = "", const Json& usual = Json()) {
    if (describes()) {
      if (*what != '\0') schema["description"] = what;
      if (!usual.is_null() && *what != '\0') schema["default"] = usual;
      (*schema_)["properties"][key].update(schema);
      return nullptr;
    }
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
  }
  // The same of one that must be there.
  const Json* needed(const std::string& key, const Json& schema, const char* what = "") {
    const Json* value = find(key, schema, what);
    if (describes() && !variant_) (*schema_)["required"].push_back(key);
    if (value == nullptr && !describes()) refuse(where(key), "is missing");
    return value;
  }
  template <typename Number>
  const Json* optional(const std::string& key, const std::optional<Number>& otherwise, const Json& schema,
                       const char* what) {
    return otherwise ? find(key, schema, what, *otherwise) : needed(key, schema, what);
  }
  std::string place(const std::string& key, std::size_t i) const { return where(key) + "[" + std::to_string(i) + "]"; }

  static Json schema_of_number(double min, double max) {
    return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
  }
  static Json schema_of_list(const List& list) {
    Json schema = {{"type", "array"}};
    if (list.min > 0) schema["minItems"] = list.min;
    if (list.max < List().max) schema["maxItems"] = list.max;
    return schema;
  }
  static Json schema_of_texts(const List& list) {
    Json schema = schema_of_list(list);
    schema["items"] = {{"type", "string"}};
    return schema;
  }
  static Json schema_of_numbers(std::size_t size, double min, double max) {
    return {{"type", "array"}, {"items", schema_of_number(min, max)}, {"minItems", size}, {"maxItems", size}};
  }
  template <typename Value>
  static Json schema_of_names(const Names<Value>& known) {
    return {{"enum", texts_of(known)}};
  }

  static double checked_number(const Json& value, const std::string& where, double min, double max) {
    if (!value.is_number() || !(value.get<double>() >= min && value.get<double>() <= max)) {
      std::ostringstream why;
      why << "must be a number from " << min << " to " << max;
      refuse(where, why.str());
    }
    return value.get<double>();
  }
  static bool is_text(const Json& value) {
    if (!value.is_string()) return false;
    const auto& text = value.get_ref<const std::string&>();
    return !text.empty() && text.size() <= max_text &&
           std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; });
  }
  static void check_list(const Json& value, const std::string& where, const List& list, const std::string& of) {
    if (value.is_array() && value.size() >= list.min && value.size() <= list.max) return;
    if (list.max == List().max) refuse(where, "must be an array");
    refuse(where, "must be an array of " + std::to_string(list.min) + " to " + std::to_string(list.max) + " " + of);
  }
  static std::vector<std::string> checked_texts(const Json& value, const std::string& where, const List& list) {
    check_list(value, where, list, "texts");
    if (!std::all_of(value.begin(), value.end(), is_text)) refuse(where, "must be an array of texts of one line");
    return value.get<std::vector<std::string>>();
  }

  const Json* object_ = nullptr;
  Json* schema_ = nullptr;  // in place of an object
  Variant variant_;
  std::string where_;
  std::vector<std::string> asked_;
};

}  // namespace hrt
