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

// The members of one JSON object; finish() refuses members that were not read.
class Members {
 public:
  Members(const Json& object, std::string where) : object_(object), where_(std::move(where)) {
    if (!object.is_object()) refuse(where_, "must be an object");
  }

  const std::string& where() const { return where_; }
  std::string where(const std::string& key) const { return where_ + "." + key; }
  bool has(const std::string& key) {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
    return object_.contains(key);
  }
  const Json& at(const std::string& key) {
    if (!has(key)) refuse(where(key), "is missing");
    return object_[key];
  }

  double number(const std::string& key, double otherwise, double min, double max) {
    return has(key) ? checked_number(object_[key], where(key), min, max) : otherwise;
  }
  std::int64_t nanoseconds(const std::string& key, double otherwise_ms, double min_ms = 0.0, double max_ms = hour_ms) {
    return std::llround(number(key, otherwise_ms, min_ms, max_ms) * 1e6);
  }
  std::uint64_t count(const std::string& key, std::uint64_t otherwise, std::uint64_t min) {
    if (!has(key)) return otherwise;
    const Json& value = object_[key];
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < min)
      refuse(where(key), "must be a whole number from " + std::to_string(min));
    return value.get<std::uint64_t>();
  }
  template <typename Value>
  Value choice(const std::string& key, const Names<Value>& known) {
    const Json& name = at(key);
    for (const auto& [text, value] : known)
      if (name == text) return value;
    refuse(where(key), "must be one of " + quoted_list(known));
  }
  bool boolean(const std::string& key, bool otherwise) {
    if (!has(key)) return otherwise;
    if (!object_[key].is_boolean()) refuse(where(key), "must be true or false");
    return object_[key].get<bool>();
  }
  std::vector<double> numbers(const std::string& key, std::size_t size, double min, double max) {
    const Json& value = at(key);
    if (!value.is_array() || value.size() != size)
      refuse(where(key), "must be an array of " + std::to_string(size) + " numbers");
    std::vector<double> result;
    for (const Json& element : value) result.push_back(checked_number(element, where(key), min, max));
    return result;
  }
  Eigen::Vector3d vector(const std::string& key, double max) {
    const std::vector<double> xyz = numbers(key, 3, -max, max);
    return {xyz[0], xyz[1], xyz[2]};
  }

  // A number, or two between which it is drawn; `scale` converts to the unit of `range`.
  bool range(const std::string& key, Range& range, double min, double max, double scale = 1.0) {
    if (!has(key)) return false;
    std::vector<double> ends;
    if (object_[key].is_array()) {
      ends = numbers(key, 2, min, max);
      if (ends[0] > ends[1]) refuse(where(key), "must have the smaller number first");
    } else {
      ends.assign(2, checked_number(object_[key], where(key), min, max));
    }
    range = {ends[0] * scale, ends[1] * scale};
    return true;
  }
  // A name, or several, of which one is drawn.
  template <typename Value>
  void one_of(const std::string& key, std::vector<Value>& values, const Names<Value>& known) {
    if (!has(key)) return;
    const Json names = object_[key].is_array() ? object_[key] : Json::array({object_[key]});
    values.clear();
    for (const Json& name : names)
      for (const auto& [text, value] : known)
        if (name == text) values.push_back(value);
    if (values.size() == names.size() && !names.empty()) return;
    refuse(where(key), "must be one of, or an array of, " + quoted_list(known));
  }
  // Calls `read(members)` for every object of an array.
  template <typename Read>
  void each(const std::string& key, Read read) {
    if (!has(key)) return;
    if (!object_[key].is_array()) refuse(where(key), "must be an array");
    std::size_t i = 0;
    for (const Json& element : object_[key]) {
      Members members(element, where(key) + "[" + std::to_string(i++) + "]");
      read(members);
      members.finish();
    }
  }
  // Calls `read(members)` for an object, if it is there.
  template <typename Read>
  void object(const std::string& key, Read read) {
    if (!has(key)) return;
    Members members(object_[key], where(key));
    read(members);
    members.finish();
  }

  void finish() const {
    for (const auto& [key, value] : object_.items())
      if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        refuse(where(key), "is not known; known are " + quoted_list(asked_));
  }

 private:
  static double checked_number(const Json& value, const std::string& where, double min, double max) {
    if (!value.is_number() || !(value.get<double>() >= min && value.get<double>() <= max)) {
      std::ostringstream why;
      why << "must be a number from " << min << " to " << max;
      refuse(where, why.str());
    }
    return value.get<double>();
  }

  const Json& object_;
  std::string where_;
  std::vector<std::string> asked_;
};

}  // namespace hrt::mock
