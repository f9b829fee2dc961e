// JSON text as a list of values, each before those within it. nlohmann's own tree is not used: its
// destructors allocate, and so end the process when memory runs out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace hrt {

/// A value of a document; valid as long as that is, wherever it is moved to.
class JsonValue {
 public:
  bool exists() const { return entry_->kind != Kind::absent; }
  bool is_object() const { return entry_->kind == Kind::object; }
  bool is_array() const { return entry_->kind == Kind::array; }
  bool is_string() const { return entry_->kind == Kind::string; }
  bool is_number() const { return entry_->kind == Kind::number || is_whole(); }
  /// A number that is written as digits alone.
  bool is_whole() const { return entry_->kind == Kind::whole; }

  /// Of a number; 0 of others.
  double number() const { return entry_->number; }
  /// Of a string; empty of others.
  std::string_view string() const { return is_string() ? text() : std::string_view(); }
  /// For messages: as written, or what it is.
  std::string shown() const;

  /// Members of an object or elements of an array, in the file's order; of others none.
  class Iterator;
  Iterator begin() const;
  Iterator end() const;
  std::size_t size() const { return entry_->size; }
  /// Of a member.
  std::string_view key() const { return {text_ + entry_->key_begin, entry_->key_size}; }
  /// The member of this name; one that does not exist if there is none.
  JsonValue find(std::string_view key) const;

 private:
  friend class JsonDocument;
  friend class JsonReader;

  enum class Kind : std::uint8_t { absent, null, boolean, whole, number, string, array, object };
  struct Entry {
    Kind kind = Kind::absent;
    std::uint32_t key_begin = 0;  // into the document's text
    std::uint32_t key_size = 0;
    std::uint32_t text_begin = 0;  // of strings, and of numbers that are not whole
    std::uint32_t text_size = 0;
    std::uint32_t size = 0;     // values that are directly within
    std::uint32_t entries = 1;  // this one and all within
    double number = 0.0;
  };
  static const Entry absent;

  JsonValue(const Entry* entry, const char* text) : entry_(entry), text_(text) {}
  std::string_view text() const { return {text_ + entry_->text_begin, entry_->text_size}; }

  const Entry* entry_;
  const char* text_;
};

class JsonValue::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = JsonValue;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = JsonValue;

  Iterator(const Entry* entry, const char* text) : entry_(entry), text_(text) {}
  JsonValue operator*() const { return {entry_, text_}; }
  Iterator& operator++() {
    entry_ += entry_->entries;
    return *this;
  }
  bool operator==(const Iterator& other) const { return entry_ == other.entry_; }

 private:
  const Entry* entry_;
  const char* text_;
};

class JsonDocument {
 public:
  /// Throws SceneError, its text starting with `file`, on what is not JSON, has a key twice in one object, or
  /// exceeds gltf_limits.
  JsonDocument(std::string_view json, const std::string& file);

  JsonValue root() const { return {entries_.data(), text_.data()}; }

 private:
  friend class JsonReader;

  std::vector<JsonValue::Entry> entries_;
  std::vector<char> text_;  // keys and texts, one after the other
};

}  // namespace hrt
