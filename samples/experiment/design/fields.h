// The fields of a JSON object, read and described at once: what reads a design also writes its schema.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hrt::experiment {

/// A design or a file that is refused, with the place and what is allowed.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A range of numbers.
struct Range {
  double low;
  double high;
};

/// One object. Each call reads a field, checks it, and adds it to the schema. Without a value (null) nothing
/// is missing: the schema is all that is wanted.
class Fields {
 public:
  using Each = std::function<void(Fields&)>;

  /// `value` lives as long as the Fields; null: only describe. `place`: as in messages, "/pairs/0".
  Fields(const nlohmann::json* value, std::string place) : value_(value), place_(std::move(place)) {}

  /// Without a default the field must be there.
  double number(const char* name, Range range, std::optional<double> otherwise, const char* what);
  unsigned whole(const char* name, Range range, std::optional<unsigned> otherwise, const char* what);
  std::string text(const char* name, const std::optional<std::string>& otherwise, const char* what);
  std::string word(const char* name, const std::vector<std::string>& allowed, const char* otherwise, const char* what);
  std::vector<std::string> texts(const char* name, Range count, bool required, const char* what);
  std::vector<std::vector<std::string>> lists(const char* name, const char* what);
  /// True if the object is there, and then `read`.
  bool object(const char* name, const char* what, const Each& read);
  void objects(const char* name, Range count, const char* what, const Each& read);

  /// There is no value, so no name can be looked up.
  bool describes() const { return value_ == nullptr; }
  /// Refuses `name` in words, at its place.
  [[noreturn]] void refuse(const std::string& name, const std::string& why) const;

  /// Refuses the fields of the object that no call has read.
  void finish() const;
  /// As JSON schema: after all fields were read.
  const nlohmann::json& schema() const { return schema_; }

 private:
  const nlohmann::json* find(const char* name, bool required, nlohmann::json schema, const char* what);

  const nlohmann::json* value_;
  std::string place_;
  nlohmann::json schema_ = {{"type", "object"}, {"additionalProperties", false}};
};

}  // namespace hrt::experiment
