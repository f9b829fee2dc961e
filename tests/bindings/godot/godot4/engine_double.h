// A double of Godot 4, as far as the extension talks to it: strings, variants, Dictionaries, a register of
// classes and objects of them. It is not the engine: it shows that the extension keeps to the interface as
// gdextension.h declares it, not that the declarations are the engine's.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "../../../../plugin/bindings/godot/godot4/gdextension.h"

namespace godot4_double {

struct Object;
struct DictionaryData;

using Vector3 = std::array<float, 3>;
using Transform3D = std::array<float, 12>;
using Dictionary = std::shared_ptr<DictionaryData>;
struct StringName {
  std::string text;
};
using Any = std::variant<std::monostate, bool, int64_t, double, std::string, Vector3, Transform3D, Object*,
                         Dictionary, StringName>;

struct DictionaryData {
  ~DictionaryData();
  std::map<std::string, gde_variant> values;
  Any at(const std::string& key) const;
};

struct Object {
  std::string class_name;  ///< of the extension's class, once it is set
  void* instance = nullptr;
  bool inside_tree = true;
  Transform3D transform{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  std::vector<std::pair<std::string, Any>> emitted;
};

struct Property {
  int32_t type = 0;
  std::string name, hint_string;
  uint32_t hint = 0, usage = 0;
};

struct Method {
  gde_method info{};
  int32_t return_type = GDE_NIL;
  std::vector<Property> arguments;
};

struct Class {
  std::string parent;
  gde_class2 info{};
  std::map<std::string, Method> methods;
  std::map<std::string, std::pair<std::string, std::string>> accessors;  ///< setter and getter of a property
  std::map<std::string, Property> properties;
  std::map<std::string, std::vector<Property>> signals;
  std::map<std::string, std::pair<std::string, int64_t>> constants;  ///< enumeration and value
};

/** There is one at a time. */
class Engine {
 public:
  Engine();
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /** Loads the extension as the engine does; false if its entry refuses. */
  bool load(const std::string& path);
  void unload();

  Object* create(const std::string& class_name);
  void free(Object* object);
  /** As an untyped script calls: by variants. */
  Any call(Object* object, const std::string& method, const std::vector<Any>& arguments);
  /** As a typed script calls: by values of the registered types, which the arguments must have. */
  Any ptrcall(Object* object, const std::string& method, const std::vector<Any>& arguments);
  void set(Object* object, const std::string& property, const Any& value);
  Any get(Object* object, const std::string& property);

  std::map<std::string, Class> classes;
  std::vector<std::string> errors;
  std::string lacking;  ///< a function that this engine does not have
  int64_t live_values = 0;

 private:
  void* library_ = nullptr;
  gde_initialization initialization_{};
};

}  // namespace godot4_double
