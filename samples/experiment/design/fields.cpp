#include "samples/experiment/design/fields.h"

#include <algorithm>
#include <cmath>

#include "samples/format.h"

namespace hrt::experiment {
namespace {

using nlohmann::json;

constexpr std::size_t max_text = 2000;

json schema_of_number(Range range) { return {{"type", "number"}, {"minimum", range.low}, {"maximum", range.high}}; }

json schema_of_texts(Range count) {
  return {{"type", "array"},
          {"items", {{"type", "string"}}},
          {"minItems", static_cast<unsigned>(count.low)},
          {"maxItems", static_cast<unsigned>(count.high)}};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

bool is_text(const json& value) {
  if (!value.is_string()) return false;
  const auto& text = value.get_ref<const std::string&>();
  return !text.empty() && text.size() <= max_text &&
         std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; });
}

}  // namespace

void Fields::refuse(const std::string& name, const std::string& why) const {
  throw Refusal(place_ + "/" + name + ": " + why);
}

const json* Fields::find(const char* name, bool required, json schema, const char* what) {
  schema["description"] = what;
  schema_["properties"][name] = std::move(schema);
  if (required) schema_["required"].push_back(name);
  if (value_ == nullptr) return nullptr;
  const auto found = value_->find(name);
  if (found != value_->end()) return &*found;
  if (required) refuse(name, std::string("is missing: ") + what);
  return nullptr;
}

double Fields::number(const char* name, Range range, std::optional<double> otherwise, const char* what) {
  json schema = schema_of_number(range);
  if (otherwise) schema["default"] = *otherwise;
  const json* value = find(name, !otherwise, std::move(schema), what);
  if (value == nullptr) return otherwise.value_or(range.low);
  const double number = value->is_number() ? value->get<double>() : std::nan("");
  if (!(number >= range.low && number <= range.high))
    refuse(name, value->dump() + format(" is not a number from %g to %g", range.low, range.high));
  return number;
}

unsigned Fields::whole(const char* name, Range range, std::optional<unsigned> otherwise, const char* what) {
  json schema = schema_of_number(range);
  schema["type"] = "integer";
  if (otherwise) schema["default"] = *otherwise;
  const json* value = find(name, !otherwise, std::move(schema), what);
  if (value == nullptr) return otherwise.value_or(static_cast<unsigned>(range.low));
  const double number = value->is_number_integer() ? value->get<double>() : std::nan("");
  if (!(number >= range.low && number <= range.high))
    refuse(name, value->dump() + format(" is not a whole number from %.0f to %.0f", range.low, range.high));
  return static_cast<unsigned>(number);
}

std::string Fields::text(const char* name, const std::optional<std::string>& otherwise, const char* what) {
  const json* value = find(name, !otherwise, {{"type", "string"}, {"minLength", 1}, {"maxLength", max_text}}, what);
  if (value == nullptr) return otherwise.value_or("");
  if (!is_text(*value)) refuse(name, "is not a text of one line of 1 to 2000 bytes");
  return value->get<std::string>();
}

std::string Fields::word(const char* name, const std::vector<std::string>& allowed, const char* otherwise,
                         const char* what) {
  json schema = {{"enum", allowed}};
  if (otherwise != nullptr) schema["default"] = otherwise;
  const json* value = find(name, otherwise == nullptr, std::move(schema), what);
  if (value == nullptr) return otherwise != nullptr ? otherwise : allowed.front();
  if (!value->is_string() || std::find(allowed.begin(), allowed.end(), value->get<std::string>()) == allowed.end())
    refuse(name, value->dump() + " is none of " + joined(allowed));
  return value->get<std::string>();
}

std::vector<std::string> Fields::texts(const char* name, Range count, bool required, const char* what) {
  const json* value = find(name, required, schema_of_texts(count), what);
  if (value == nullptr) return {};
  const bool is_list = value->is_array() && std::all_of(value->begin(), value->end(), is_text);
  if (!is_list || static_cast<double>(value->size()) < count.low || static_cast<double>(value->size()) > count.high)
    refuse(name, format("is not a list of %.0f to %.0f texts of one line", count.low, count.high));
  return value->get<std::vector<std::string>>();
}

std::vector<std::vector<std::string>> Fields::lists(const char* name, const char* what) {
  const json* value =
      find(name, false, {{"type", "array"}, {"items", schema_of_texts({1, 26})}, {"minItems", 1}}, what);
  std::vector<std::vector<std::string>> lists;
  if (value == nullptr) return lists;
  if (!value->is_array() || value->empty()) refuse(name, "is not a list of lists of names");
  for (const json& list : *value) {
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_text))
      refuse(name + format("/%zu", lists.size()), "is not a list of names");
    lists.push_back(list.get<std::vector<std::string>>());
  }
  return lists;
}

bool Fields::object(const char* name, const char* what, const Each& read) {
  const json* value = find(name, false, {}, what);
  if (value_ != nullptr && value == nullptr) return false;
  if (value != nullptr && !value->is_object()) refuse(name, "is not an object");
  Fields inner(value, place_ + "/" + name);
  read(inner);
  inner.finish();
  schema_["properties"][name].update(inner.schema());
  return value != nullptr;
}

void Fields::objects(const char* name, Range count, const char* what, const Each& read) {
  const json* value = find(name, count.low > 0,
                           {{"type", "array"},
                            {"minItems", static_cast<unsigned>(count.low)},
                            {"maxItems", static_cast<unsigned>(count.high)}},
                           what);
  if (value_ == nullptr) {
    Fields described(nullptr, {});
    read(described);
    schema_["properties"][name]["items"] = described.schema();
  }
  if (value == nullptr) return;
  if (!value->is_array() || static_cast<double>(value->size()) < count.low ||
      static_cast<double>(value->size()) > count.high)
    refuse(name, format("is not a list of %.0f to %.0f objects", count.low, count.high));
  for (std::size_t i = 0; i < value->size(); ++i) {
    if (!(*value)[i].is_object()) refuse(name + format("/%zu", i), "is not an object");
    Fields inner(&(*value)[i], place_ + "/" + name + format("/%zu", i));
    read(inner);
    inner.finish();
  }
}

void Fields::finish() const {
  if (value_ == nullptr) return;
  std::vector<std::string> known;
  if (schema_.contains("properties"))
    for (const auto& [name, field] : schema_["properties"].items()) known.push_back(name);
  for (const auto& [name, field] : value_->items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(name, "is unknown; there are " + joined(known));
}

}  // namespace hrt::experiment
