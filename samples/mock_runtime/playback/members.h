// Reading the members of a script's JSON objects. What is wrong is refused with its place and the allowed
// values.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "samples/mock_runtime/error.h"
#include "samples/mock_runtime/world/people.h"

namespace hrt::mock {

using Json = nlohmann::json;

constexpr double hour_ms = 3'600'000.0;

[[noreturn]] inline void refuse(const std::string& where, const std::string& why) {
  throw Error{XR_ERROR_VALIDATION_FAILURE, "script: " + where + " " + why};
}

inline std::string quoted_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "\"" : ", \"") + text + "\"";
  return list;
}

// A name of the script, and its meaning.
template <typename Value>
using Names = std::vector<std::pair<std::string, Value>>;

template <typename Value>
std::string quoted_list(const Names<Value>& names) {
  std::vector<std::string> texts;
  for (const auto& each : names) texts.push_back(each.first);
  return quoted_list(texts);
}

// The members of one JSON object, read and described at once: what reads a script also writes its schema.
// finish() refuses members that were not read.
class Members {
 public:
  Members(const Json& object, std::string where) : object_(&object), where_(std::move(where)) {
    if (!object.is_object()) refuse(where_, "must be an object");
  }
  // Describes what would be read. Of the ways that a reader may take at a choice, or where a member may be
  // there or not, each variant goes one: all of them together describe all.
  Members(Json& schema, unsigned variant) : schema_(&schema), variant_(variant) {
    schema["type"] = "object";
    schema["additionalProperties"] = false;
  }
  static constexpr unsigned variants = 32;  // the most kinds of a choice, with and without optional members

  const std::string& where() const { return where_; }
  std::string where(const std::string& key) const { return where_ + "." + key; }
  bool has(const std::string& key) {
    const bool is_there = find(key, Json::object()) != nullptr;
    return schema_ != nullptr ? variant_ % 2 == 0 : is_there;
  }
  const Json& at(const std::string& key, const Json& schema = Json::object()) {
    static const Json none;
    const Json* value = find(key, schema);
    if (value == nullptr && schema_ == nullptr) refuse(where(key), "is missing");
    return value == nullptr ? none : *value;
  }

  double number(const std::string& key, double otherwise, double min, double max) {
    const Json* value = find(key, schema_of_number(min, max));
    return value == nullptr ? otherwise : checked_number(*value, where(key), min, max);
  }
  std::int64_t nanoseconds(const std::string& key, double otherwise_ms, double min_ms = 0.0, double max_ms = hour_ms) {
    return std::llround(number(key, otherwise_ms, min_ms, max_ms) * 1e6);
  }
  std::uint64_t count(const std::string& key, std::uint64_t otherwise, std::uint64_t min) {
    const Json* value = find(key, {{"type", "integer"}, {"minimum", min}});
    if (value == nullptr) return otherwise;
    if (!value->is_number_unsigned() || value->get<std::uint64_t>() < min)
      refuse(where(key), "must be a whole number from " + std::to_string(min));
    return value->get<std::uint64_t>();
  }
  template <typename Value>
  Value choice(const std::string& key, const Names<Value>& known) {
    const Json& name = at(key, schema_of_names(known));
    if (schema_ != nullptr) return known[variant_ / 2 % known.size()].second;
    for (const auto& [text, value] : known)
      if (name == text) return value;
    refuse(where(key), "must be one of " + quoted_list(known));
  }
  bool boolean(const std::string& key, bool otherwise) {
    const Json* value = find(key, {{"type", "boolean"}});
    if (value == nullptr) return otherwise;
    if (!value->is_boolean()) refuse(where(key), "must be true or false");
    return value->get<bool>();
  }
  std::vector<double> numbers(const std::string& key, std::size_t size, double min, double max) {
    const Json& value = at(key, schema_of_numbers(size, min, max));
    std::vector<double> result;
    if (schema_ != nullptr) {
      result.resize(size);
      result[0] = max;  // a rotation, too, has a length
      return result;
    }
    if (!value.is_array() || value.size() != size)
      refuse(where(key), "must be an array of " + std::to_string(size) + " numbers");
    for (const Json& element : value) result.push_back(checked_number(element, where(key), min, max));
    return result;
  }
  Eigen::Vector3d vector(const std::string& key, double max) {
    const std::vector<double> xyz = numbers(key, 3, -max, max);
    return {xyz[0], xyz[1], xyz[2]};
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
    refuse(where(key), "must be one of, or an array of, " + quoted_list(known));
  }
  // Calls `read(members)` for every object of an array.
  template <typename Read>
  void each(const std::string& key, Read read) {
    const Json* value = find(key, {{"type", "array"}});
    if (schema_ != nullptr) describe((*schema_)["properties"][key]["items"], variant_, read);
    if (value == nullptr) return;
    if (!value->is_array()) refuse(where(key), "must be an array");
    std::size_t i = 0;
    for (const Json& element : *value) {
      Members members(element, where(key) + "[" + std::to_string(i++) + "]");
      read(members);
      members.finish();
    }
  }
  // Calls `read(members)` for an object, if it is there.
  template <typename Read>
  void object(const std::string& key, Read read) {
    const Json* value = find(key, Json::object());
    if (schema_ != nullptr) describe((*schema_)["properties"][key], variant_, read);
    if (value == nullptr) return;
    Members members(*value, where(key));
    read(members);
    members.finish();
  }

  // What `read(members)` would read. There are no values, so it may refuse some: what it has asked for stays.
  template <typename Read>
  static void describe(Json& schema, unsigned variant, Read read) {
    try {
      Members members(schema, variant);
      read(members);
    } catch (const Error&) {
    }
  }

  void finish() const {
    for (const auto& [key, value] : object_->items())
      if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        refuse(where(key), "is not known; known are " + quoted_list(asked_));
  }

 private:
  // The member; null if it is not there, or only described.
  const Json* find(const std::string& key, const Json& schema) {
    if (schema_ != nullptr) {
      (*schema_)["properties"][key].update(schema);
      return nullptr;
    }
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
  }
  static Json schema_of_number(double min, double max) {
    return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
  }
  static Json schema_of_numbers(std::size_t size, double min, double max) {
    return {{"type", "array"}, {"items", schema_of_number(min, max)}, {"minItems", size}, {"maxItems", size}};
  }
  template <typename Value>
  static Json schema_of_names(const Names<Value>& known) {
    Json names = Json::array();
    for (const auto& each : known) names.push_back(each.first);
    return {{"enum", names}};
  }
  static double checked_number(const Json& value, const std::string& where, double min, double max) {
    if (!value.is_number() || !(value.get<double>() >= min && value.get<double>() <= max)) {
      std::ostringstream why;
      why << "must be a number from " << min << " to " << max;
      refuse(where, why.str());
    }
    return value.get<double>();
  }

  const Json* object_ = nullptr;
  Json* schema_ = nullptr;  // in place of an object
  unsigned variant_ = 0;
  std::string where_;
  std::vector<std::string> asked_;
};

}  // namespace hrt::mock
