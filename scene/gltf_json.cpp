#include "scene/gltf_json.h"

#include <array>
#include <new>
#include <set>
#include <utility>
#include <vector>

#include "scene/scene_error.h"

namespace hrt {
namespace {

using nlohmann::json;

constexpr std::array sections{"asset", "scene", "scenes", "nodes", "extensionsRequired", "buffers", "images"};

std::uint32_t little_endian(std::string_view four_bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(four_bytes[static_cast<std::size_t>(i)]);
  return value;
}

// The parser's reason, without its name for the error, and without what it read last: that may be all of the
// file.
std::string reason(std::string_view what) {
  const std::size_t name_end = what.find("] ");
  if (name_end != what.npos) what.remove_prefix(name_end + 2);
  return printable(what.substr(0, what.find("; last read")));
}

// Reads a file without keeping it, for what the JSON library leaves open: limits, and keys that are there
// twice.
class JsonCheck : public nlohmann::json_sax<json> {
 public:
  explicit JsonCheck(const std::string& file) : file_(file) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return false; }
  bool key(string_t& name) override {
    Level& level = open_.back();
    // glTF allows each key once in an object; readers differ in which of two they take.
    if (!level.keys.insert(name).second) refuse(file_, "{} has the key {} twice", place(), in_quotes(name));
    level.key = name;
    return true;
  }
  bool start_object(std::size_t) override { return open(false); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    refuse(file_, "not a glTF file: {}", reason(error.what()));
  }

  std::size_t values() const { return values_; }
  std::size_t nodes() const { return nodes_; }

 private:
  // An object or array that has begun.
  struct Level {
    bool is_array;
    std::size_t size = 0;        // values directly within, so far
    std::string key;             // of an object, the last one
    std::set<std::string> keys;  // of an object
  };

  bool value() {
    if (++values_ > gltf_limits::json_values)
      refuse(file_, "its JSON has more than {} values", gltf_limits::json_values);
    if (!open_.empty()) ++open_.back().size;
    return true;
  }

  bool open(bool is_array) {
    if (open_.size() == gltf_limits::json_depth)
      refuse(file_, "its JSON is nested deeper than {} levels", gltf_limits::json_depth);
    value();
    if (open_.size() == 2 && open_[0].key == "nodes") ++nodes_;
    open_.push_back({.is_array = is_array, .key = {}, .keys = {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  // Of the innermost open object: its JSON, or "nodes[3].extras".
  std::string place() const {
    std::string path;
    for (std::size_t depth = 0; depth + 1 < open_.size(); ++depth) {
      const Level& level = open_[depth];
      if (level.is_array)
        path += "[" + std::to_string(level.size - 1) + "]";
      else
        path += (path.empty() ? "" : ".") + level.key;
    }
    return path.empty() ? "its JSON" : in_quotes(path);
  }

  const std::string& file_;
  std::vector<Level> open_;
  std::size_t values_ = 0;
  std::size_t nodes_ = 0;
};

// At most what the JSON, its copy for tinygltf, tinygltf's own and its model take at a time. Neither library
// survives a lack of memory: their destructors allocate.
std::size_t memory_bound(std::size_t text_bytes, const JsonCheck& check) {
  constexpr std::size_t texts = 6;
  constexpr std::size_t bytes_a_value = 1000;
  constexpr std::size_t bytes_a_node = 2400;
  return texts * text_bytes + bytes_a_value * check.values() + bytes_a_node * check.nodes();
}

}  // namespace

JsonExtent json_extent(std::string_view head, std::uint64_t file_bytes, const std::string& file) {
  const bool is_binary = head.starts_with("glTF");
  JsonExtent extent{.offset = 0, .size = 0};
  std::uint64_t json_bytes = file_bytes;
  if (is_binary) {
    if (head.size() < glb_head_bytes) refuse(file, "the binary glTF header is cut short");
    const std::uint32_t version = little_endian(head.substr(4));
    const std::uint32_t claimed_bytes = little_endian(head.substr(8));
    if (version != 2) refuse(file, "the binary glTF header has version {}; glTF 2 is read", version);
    if (claimed_bytes != file_bytes)
      refuse(file, "the binary glTF header claims {} bytes, and there are {}", claimed_bytes, file_bytes);
    if (head.substr(16) != "JSON") refuse(file, "the first chunk of a binary glTF must be JSON");
    json_bytes = little_endian(head.substr(12));
    if (json_bytes > file_bytes - glb_head_bytes) {
      refuse(file, "the JSON chunk claims {} bytes, and {} are left", json_bytes, file_bytes - glb_head_bytes);
    }
    extent.offset = glb_head_bytes;
  }
  if (json_bytes > gltf_limits::json_bytes) refuse(file, "its JSON is larger than {} bytes", gltf_limits::json_bytes);
  extent.size = static_cast<std::size_t>(json_bytes);
  return extent;
}

json read_json(std::string_view text, const std::string& file) {
  JsonCheck check(file);
  json::sax_parse(text, &check);
  ::operator delete(::operator new(memory_bound(text.size(), check)));
  // Filtered afterwards: the library's own filter looks at an array's every value after each of them.
  json parsed = json::parse(text);
  json kept = json::object();
  for (const char* section : sections)
    if (parsed.contains(section)) kept[section] = std::move(parsed[section]);
  return parsed.is_object() ? kept : parsed;
}

}  // namespace hrt
