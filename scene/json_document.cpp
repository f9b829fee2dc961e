#include "scene/json_document.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/gltf_limits.h"
#include "scene/json_number.h"
#include "scene/refuse.h"

namespace hrt {

using nlohmann::json;

namespace {

// The parser's reason, without its name for the error, and without what it read last: that may be all of the
// file.
std::string reason(std::string_view what) {
  const std::size_t name_end = what.find("] ");
  if (name_end != what.npos) what.remove_prefix(name_end + 2);
  return printable(what.substr(0, what.find("; last read")));
}

}  // namespace

/// Fills a document, value by value.
class JsonReader : public nlohmann::json_sax<json> {
 public:
  JsonReader(JsonDocument& document, const std::string& file)
      : entries_(document.entries_), text_(document.text_), file_(file) {}

  bool null() override { return add(Kind::null); }
  bool boolean(bool) override { return add(Kind::boolean); }
  bool number_integer(number_integer_t value) override {
    return add(Kind::number, {}, static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add(Kind::whole, {}, static_cast<double>(value));
  }
  bool number_float(number_float_t, const string_t& text) override {
    const std::string digits = with_point(text);
    double value = 0.0;
    fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (!std::isfinite(value))
      refuse(file_, "not a glTF file: the number {} is too large", in_quotes(digits));
    return add(Kind::number, digits, value);
  }
  bool string(string_t& value) override { return add(Kind::string, value); }
  bool binary(binary_t&) override { return false; }
  bool key(string_t& name) override {
    key_begin_ = keep(name);
    key_size_ = static_cast<std::uint32_t>(name.size());
    return true;
  }
  bool start_object(std::size_t) override { return open(Kind::object); }
  bool end_object() override {
    check_keys();
    return close();
  }
  bool start_array(std::size_t) override { return open(Kind::array); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    refuse(file_, "not a glTF file: {}", reason(error.what()));
  }

 private:
  using Kind = JsonValue::Kind;
  using Entry = JsonValue::Entry;

  std::uint32_t keep(std::string_view text) {
    const auto begin = static_cast<std::uint32_t>(text_.size());
    text_.insert(text_.end(), text.begin(), text.end());
    return begin;
  }

  bool add(Kind kind, std::string_view text = {}, double number = 0.0) {
    if (entries_.size() == gltf_limits::json_values)
      refuse(file_, "its JSON has more than {} values", gltf_limits::json_values);
    entries_.push_back({.kind = kind,
                        .key_begin = key_begin_,
                        .key_size = key_size_,
                        .text_begin = keep(text),
                        .text_size = static_cast<std::uint32_t>(text.size()),
                        .number = number});
    key_begin_ = key_size_ = 0;
    if (!open_.empty()) ++entries_[open_.back()].size;
    return true;
  }

  bool open(Kind kind) {
    if (open_.size() == gltf_limits::json_depth)
      refuse(file_, "its JSON is nested deeper than {} levels", gltf_limits::json_depth);
    add(kind);
    open_.push_back(entries_.size() - 1);
    return true;
  }

  bool close() {
    entries_[open_.back()].entries = static_cast<std::uint32_t>(entries_.size() - open_.back());
    open_.pop_back();
    return true;
  }

  JsonValue value(std::size_t index) const { return {&entries_[index], text_.data()}; }

  // glTF allows each key once in an object; readers differ in which of two they take.
  void check_keys() {
    keys_.clear();
    for (std::size_t i = open_.back() + 1; i < entries_.size(); i += entries_[i].entries)
      keys_.push_back(value(i).key());
    std::sort(keys_.begin(), keys_.end());
    const auto twice = std::adjacent_find(keys_.begin(), keys_.end());
    if (twice != keys_.end()) refuse(file_, "{} has the key {} twice", place(), in_quotes(*twice));
  }

  // Of the innermost open object: its JSON, or "nodes[3].extras".
  std::string place() const {
    std::string path;
    for (std::size_t depth = 1; depth < open_.size(); ++depth) {
      const JsonValue parent = value(open_[depth - 1]);
      if (parent.is_array())
        path += "[" + std::to_string(parent.size() - 1) + "]";
      else
        path += (path.empty() ? "" : ".") + std::string(value(open_[depth]).key());
    }
    return path.empty() ? "its JSON" : in_quotes(path);
  }

  std::vector<Entry>& entries_;
  std::vector<char>& text_;
  const std::string& file_;
  std::uint32_t key_begin_ = 0;  // of the next value
  std::uint32_t key_size_ = 0;
  std::vector<std::size_t> open_;  // objects and arrays that have begun
  std::vector<std::string_view> keys_;
};

JsonDocument::JsonDocument(std::string_view text, const std::string& file) {
  JsonReader reader(*this, file);
  json::sax_parse(text, &reader);
}

constinit const JsonValue::Entry JsonValue::absent{};

std::string JsonValue::shown() const {
  switch (entry_->kind) {
    case Kind::absent:
      return "nothing";
    case Kind::null:
      return "null";
    case Kind::boolean:
      return "a boolean";
    case Kind::whole:
      return fmt::format("{:g}", number());
    case Kind::number:
      return text().empty() ? fmt::format("{:g}", number()) : std::string(text());
    case Kind::string:
      return "\"" + std::string(text()) + "\"";
    case Kind::array:
      return "an array";
    case Kind::object:
      return "an object";
  }
  return "";
}

JsonValue::Iterator JsonValue::begin() const {
  return {entry_ + 1, text_};
}

JsonValue::Iterator JsonValue::end() const {
  return {entry_ + entry_->entries, text_};
}

JsonValue JsonValue::find(std::string_view key) const {
  if (is_object()) {
    for (const JsonValue member : *this)
      if (member.key() == key) return member;
  }
  return {&absent, text_};
}

}  // namespace hrt
